/* edit.c - see edit.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "scene/edit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "scene/vector.h"
#include "scene/window.h"

#define FIRST_SIZE 64u /* elements of the first allocation; a power of two */

/* Makes room for element number n of an array that only ever grew through this function.
 * Its size is FIRST_SIZE doubled until n fits, so it needs growing when n is such a size.
 * Returns the array, which may have moved, or NULL (the old array is still valid). */
static void *grow(void *array, uint32_t n, size_t element) {
    if (n == 0) return malloc(FIRST_SIZE * element);
    if (n < FIRST_SIZE || (n & (n - 1)) != 0) return array;
    return realloc(array, 2 * (size_t)n * element);
}

int sph_scene_add_sphere(struct sph_scene *scene, struct sph_vec ctr, double rad, uint32_t material,
                         uint32_t line, struct sph_error *err) {
    if (scene->n_spheres >= SPH_MAX_SPHERES)
        return sph_fail(err, "%s:%u: more than %u spheres", scene->path, line, SPH_MAX_SPHERES);
    struct sph_sphere *room = grow(scene->spheres, scene->n_spheres, sizeof *scene->spheres);
    if (!room)
        return sph_fail(err, "%s:%u: no memory for more than %u spheres", scene->path, line,
                        scene->n_spheres);
    scene->spheres = room;
    room[scene->n_spheres++] = (struct sph_sphere){ctr, rad, material, line, 0, 0};
    return 0;
}

int sph_scene_add_material(struct sph_scene *scene, const struct sph_material *material,
                           struct sph_error *err) {
    uint32_t n = scene->n_materials;
    struct sph_material *room = grow(scene->materials, n, sizeof *scene->materials);
    if (!room)
        return sph_fail(err, "%s:%d: no memory for more than %u materials", scene->path,
                        material->line, n);
    scene->materials = room;
    room[scene->n_materials++] = *material;
    return 0;
}

int sph_scene_add_facet(struct sph_scene *scene, const struct sph_facet *facet,
                        struct sph_error *err) {
    uint32_t n = scene->n_facets;
    if (n >= SPH_MAX_FACETS)
        return sph_fail(err, "%s:%u: more than %d triangles and planes", scene->path, facet->line,
                        SPH_MAX_FACETS);
    struct sph_facet *room = grow(scene->facets, n, sizeof *scene->facets);
    if (!room)
        return sph_fail(err, "%s:%u: no memory for more than %u triangles", scene->path,
                        facet->line, n);
    scene->facets = room;
    room[scene->n_facets++] = *facet;
    return 0;
}

int sph_scene_keep_frustum(struct sph_scene *scene, const struct sph_frustum *cone,
                           struct sph_error *err) {
    uint32_t n = scene->n_frusta;
    struct sph_frustum *room = grow(scene->frusta, n, sizeof *scene->frusta);
    if (!room)
        return sph_fail(err, "%s:%u: no memory for more than %u cones", scene->path, cone->line, n);
    scene->frusta = room;
    room[scene->n_frusta++] = *cone;
    return 0;
}

int sph_scene_add_texture(struct sph_scene *scene, const struct sph_texture *texture,
                          struct sph_error *err) {
    uint32_t n = scene->n_textures;
    if (n >= SPH_MAX_TEXTURES)
        return sph_fail(err, "%s:%u: more than %d textures", scene->path, texture->line,
                        SPH_MAX_TEXTURES);
    struct sph_texture *room = grow(scene->textures, n, sizeof *scene->textures);
    if (!room)
        return sph_fail(err, "%s:%u: no memory for more than %u textures", scene->path,
                        texture->line, n);
    scene->textures = room;
    room[scene->n_textures++] = *texture;
    return 0;
}

int sph_scene_add_light(struct sph_scene *scene, struct sph_vec pos, double red, double green,
                        double blue, struct sph_error *err) {
    if (scene->n_lights >= SPH_MAX_LIGHTS)
        return sph_fail(err, "%s: more than %d lights", scene->path, SPH_MAX_LIGHTS);
    scene->lights[scene->n_lights++] = (struct sph_light){pos, {red, green, blue}, 0};
    return 0;
}

void sph_scene_set_path(struct sph_scene *scene, const char *path) {
    snprintf(scene->path, sizeof scene->path, "%s", path);
    const char *slash = strrchr(path, '/');
    snprintf(scene->name, sizeof scene->name, "%s", slash ? slash + 1 : path);
    for (int endings = 1; endings > 0; endings--) { /* two of a packed file: x.pdb.gz */
        char *dot = strrchr(scene->name, '.');
        if (!dot || dot == scene->name) return;
        if (!strcasecmp(dot, ".gz")) endings++;
        *dot = 0;
    }
}

void sph_scene_count(const struct sph_scene *scene, uint32_t *facets, uint32_t *cones) {
    *facets = *cones = 0;
    for (uint32_t i = 0; i < scene->n_facets; i++) {
        uint32_t of = scene->facets[i].frustum;
        *facets += !of;
        *cones += of && (!i || scene->facets[i - 1].frustum != of);
    }
}

void sph_scene_free(struct sph_scene *scene) {
    free(scene->materials);
    free(scene->spheres);
    free(scene->facets);
    free(scene->textures);
    free(scene->motions);
    free(scene->flights);
    free(scene->frusta);
    for (uint32_t i = 0; i < scene->n_files; i++)
        free(scene->files[i]);
    free(scene->files);
    memset(scene, 0, sizeof *scene);
}

int sph_camera_check(const struct sph_camera *camera, const char *where, struct sph_error *err) {
    const struct sph_vec f = camera->from, a = camera->at, u = camera->up;
    struct sph_vec dir = {a.x - f.x, a.y - f.y, a.z - f.z};
    struct sph_vec side = {dir.y * u.z - dir.z * u.y, dir.z * u.x - dir.x * u.z,
                           dir.x * u.y - dir.y * u.x};
    double dist = sph_vec_length(dir), up = sph_vec_length(u);
    if (!(dist > 1e-12 * fmax(sph_vec_length(f), sph_vec_length(a))))
        return sph_fail(err, "%s: camera: `from` and `at` are the same point", where);
    if (!(up > 0)) return sph_fail(err, "%s: camera: `up` is zero", where);
    if (!(sph_vec_length(side) > 1e-9 * dist * up))
        return sph_fail(err, "%s: camera: `up` is parallel to the view", where);
    if (!(camera->angle > 0 && camera->angle < 180))
        return sph_fail(err, "%s: camera: `angle` %g is not between 0 and 180 degrees", where,
                        camera->angle);
    for (int i = 0; i < 2; i++)
        if (!(fabs(camera->shift[i]) <= SPH_SHIFT_MAX))
            return sph_fail(err, "%s: camera: `shift` %g is not between %d and %d heights", where,
                            camera->shift[i], -SPH_SHIFT_MAX, SPH_SHIFT_MAX);
    if (camera->width < 1 || camera->width > SPH_MAX_RESOLUTION || camera->height < 1 ||
        camera->height > SPH_MAX_RESOLUTION)
        return sph_fail(err, "%s: camera: `resolution` %d %d is not within 1 to %d", where,
                        camera->width, camera->height, SPH_MAX_RESOLUTION);
    return 0;
}
