/* edit.h - building a scene piece by piece: for readers, importers and generators
 * SPDX-License-Identifier: Apache-2.0
 *
 * A scene starts as all zero bytes. Arrays grow by doubling; sph_scene_free releases them.
 */
#ifndef SPH_SCENE_EDIT_H
#define SPH_SCENE_EDIT_H

#include "scene/scene.h"

#define SPH_MAX_RESOLUTION 16383 /* pixels in either direction, as a machine: SPH_MAX_SIDE */

/* Adds a sphere (scene units) of materials[material]. line: of the file, for messages, 0 if
 * generated. -1 with a message if there are SPH_MAX_SPHERES already or memory is short. */
int sph_scene_add_sphere(struct sph_scene *scene, struct sph_vec ctr, double rad, uint32_t material,
                         uint32_t line, struct sph_error *err);

/* Adds a material at the end. -1 with a message if memory is short. */
int sph_scene_add_material(struct sph_scene *scene, const struct sph_material *material,
                           struct sph_error *err);

/* Adds a triangle or a plane at the end. -1 with a message if there are SPH_MAX_FACETS already or
 * memory is short. */
int sph_scene_add_facet(struct sph_scene *scene, const struct sph_facet *facet,
                        struct sph_error *err);

/* Adds a cone at the end, without triangles (frustum.h). -1 with a message if memory is short. */
int sph_scene_keep_frustum(struct sph_scene *scene, const struct sph_frustum *cone,
                           struct sph_error *err);

/* Adds a texture at the end. -1 with a message if there are SPH_MAX_TEXTURES already or
 * memory is short. */
int sph_scene_add_texture(struct sph_scene *scene, const struct sph_texture *texture,
                          struct sph_error *err);

/* Adds a point light. -1 with a message if there are SPH_MAX_LIGHTS already. */
int sph_scene_add_light(struct sph_scene *scene, struct sph_vec pos, double red, double green,
                        double blue, struct sph_error *err);

/* Stores path in the scene (cut to fit), and its last part without the ending as the name, of a
 * packed file without both. */
void sph_scene_set_path(struct sph_scene *scene, const char *path);

/* Is the camera usable: eye and target apart, up not parallel to the view, angle within
 * 0..180 degrees, shift as window.h has it, resolution 1..SPH_MAX_RESOLUTION? where: start of the
 * message, such as "file:line". 0, or -1 with a message. */
int sph_camera_check(const struct sph_camera *camera, const char *where, struct sph_error *err);

/* Looks for two spheres with the same centre and radius (a ray cannot tell them apart).
 * 1 if found: *first < *second are their indices, second being the least possible; 0 if there
 * are none; -1 with a message if memory is short. Hashed: linear time. */
int sph_scene_duplicate(const struct sph_scene *scene, uint32_t *first, uint32_t *second,
                        struct sph_error *err);

/* Drops every sphere whose centre, and for SPH_READ_SPHERE_TWICE radius, are exactly those of a
 * sphere before it, and notes it in the ledger as `kind`. No sphere may be added afterwards (the
 * array keeps its size). 0, or -1 with a message if memory is short, or under `strict`. */
int sph_scene_drop_twice(struct sph_scene *scene, enum sph_read kind, struct sph_error *err);

static inline struct sph_vec sph_vec_of(double x, double y, double z) {
    return (struct sph_vec){x, y, z};
}

#endif
