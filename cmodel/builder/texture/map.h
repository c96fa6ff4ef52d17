/* map.h - mapping records: how an image lies on a triangle, a plane, a sphere
 * SPDX-License-Identifier: Apache-2.0
 *
 * Drawn in machine.def; formats in docs/design/textures.md. All put coordinates and base into a
 * line of zeros and return 0, or -1 with "file:line: ...".
 */
#ifndef SPH_TEXTURE_MAP_H
#define SPH_TEXTURE_MAP_H

#include "builder/grid/grid.h"
#include "builder/texture/keep.h"
#include "machine/machine.h"
#include "scene/scene.h"
#include "texture/texel.h"

/* What all records of a machine share. */
struct sph_texture_job {
    const struct sph_scene *scene;
    const struct sph_grid *grid;
    const struct sph_profile *profile;
    struct sph_texture_bases *bases; /* their view is the machine's */
    uint32_t id;                     /* of the primitive that is put: the scene's spheres, facets */
};

/* corner: grid units, as the machine has them. */
int sph_map_triangle(const struct sph_texture_job *job, const struct sph_facet *facet,
                     const int32_t corner[3][3], const struct sph_mip *mip, uint32_t *map,
                     struct sph_error *err);

/* point: of the plane, grid units; s and t start there. */
int sph_map_plane(const struct sph_texture_job *job, const struct sph_facet *facet,
                  const int32_t point[3], const struct sph_mip *mip, uint32_t *map,
                  struct sph_error *err);

/* rad: grid units. */
int sph_map_sphere(const struct sph_texture_job *job, const struct sph_sphere *sphere, int64_t rad,
                   const struct sph_mip *mip, uint32_t *map, struct sph_error *err);

#endif
