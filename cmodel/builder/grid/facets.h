/* facets.h - triangles and planes on the grid
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_BUILD_FACETS_H
#define SPH_BUILD_FACETS_H

#include "builder/grid/grid.h"

struct sph_grid_facet {
    int kind;              /* SPH_TRIANGLE, SPH_PLANE: not SPH_SPHERE */
    int32_t v[3][3];       /* corners, sW; plane: [0] a point of it, [1] its normal, s24 */
    int32_t normal[3];     /* of the primitive record, s24 */
    struct sph_ball ball;  /* grid units: around the corners; plane: around the grid */
    uint32_t scene;        /* index into the scene's facets */
    uint8_t before, after; /* facets of its group that stand before and behind it */
};

struct sph_facets {
    struct sph_grid_facet *list; /* as in the file; malloc */
    uint32_t n, n_loose;         /* loose: without bounds */
    /* Triangles that are not in list: without area on the grid, second of two in the scene, and
     * second of two on the grid of each profile that is no coarser. */
    uint32_t n_empty, first_empty, n_twice, first_twice, n_merged, first_merged;
};

/* Puts the facets on the grid: corners and points to nearest, normals of planes to 24 bits.
 * Triangles without area there are left out (no ray meets them, and what they joined stays closed),
 * and triangles that stand in the scene, or on the grid of this and every finer profile, a second
 * time. -1 if two other facets are the same on the grid, with line and the finer profile that
 * helps, or memory is out. *facets is to be freed in any case. */
int sph_grid_facets(const struct sph_grid *grid, const struct sph_scene *scene,
                    const struct sph_profile *profile, struct sph_facets *facets,
                    struct sph_error *err);

void sph_facets_free(struct sph_facets *facets);

/* Writes before and after: facets of one polygon, and single triangles that follow each other, lie
 * in one plane exactly and share an edge; at most SPH_MAX_GROUP in one. */
void sph_group_facets(const struct sph_scene *scene, struct sph_facets *facets);

#endif
