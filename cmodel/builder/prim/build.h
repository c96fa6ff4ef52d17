/* build.h - what build asks of a primitive on the grid, of whatever kind it is
 * SPDX-License-Identifier: Apache-2.0
 *
 * builder/prim/NAME.c has the operations of each kind.
 */
#ifndef SPH_PRIM_BUILD_H
#define SPH_PRIM_BUILD_H

#include "builder/tree/bih.h"
#include "builder/grid/facets.h"
#include "builder/texture/map.h"

/* A primitive on the grid. */
struct sph_grid_prim {
    uint32_t kind, id;
    const struct sph_ball *ball;        /* holds it; what a sphere is */
    const struct sph_grid_facet *facet; /* NULL: of a sphere */
    uint32_t index;                     /* among the scene's spheres, or facets */
};

struct sph_prim_build {
    /* May be one polygon with those that stand beside it in the same plane. */
    int joins;
    /* A scene's facet on the grid, `out` of zeros but for kind and scene. 0 if nothing is left of
     * it there. A sphere has sph_grid_spheres(). */
    int (*quantise)(const struct sph_grid *grid, const struct sph_scene *scene,
                    const struct sph_profile *profile, struct sph_grid_facet *out);
    /* Whether two are the same points; equal ones have the same hash. */
    int (*same)(const struct sph_grid_facet *a, const struct sph_grid_facet *b);
    uint64_t (*hash)(const struct sph_grid_facet *f);
    /* Writes its leaf record but for `clear`, and the part of its primitive record that is no
     * material. */
    void (*record)(const struct sph_grid_prim *prim, uint32_t *words);
    void (*prim)(const struct sph_grid_prim *prim, uint32_t *line);
    /* The box around it, and at most three balls whose hull holds it: how many. */
    void (*box)(const struct sph_grid_prim *prim, struct sph_aabb *box);
    int (*hull)(const struct sph_grid_prim *prim, struct sph_ball hull[3]);
    /* Whether a point of it may come within sph_facet_error() of the ball or lie in it; "no" is
     * exact. Of facets. */
    int (*near)(const struct sph_grid_facet *facet, const struct sph_ball *ball,
                const struct sph_profile *profile);
    /* Writes its mapping record (map.h). */
    int (*map)(const struct sph_texture_job *job, const struct sph_grid_prim *prim,
               const struct sph_mip *mip, uint32_t *map, struct sph_error *err);
};

/* The operations of a kind, SPH_SPHERE and so on. */
const struct sph_prim_build *sph_prim_build_of(uint32_t kind);

/* Primitive id of n_spheres spheres and of the facets behind them; balls[id] of all. */
struct sph_grid_prim sph_grid_prim_of(const struct sph_ball *balls, uint32_t n_spheres,
                                      const struct sph_facets *facets, uint32_t id);

/* What a primitive looks like, and where it stands in the file. */
struct sph_grid_appearance {
    uint32_t material, texture, line; /* texture: index + 1, or 0 */
};
struct sph_grid_appearance sph_grid_appearance(const struct sph_scene *scene,
                                               const struct sph_grid_prim *prim);

/* Writes the leaf record of a primitive; and its primitive record but for what it looks like. */
void sph_put_record(const struct sph_scene *scene, const struct sph_grid_prim *prim,
                    uint32_t *words);
void sph_put_prim(const struct sph_scene *scene, const struct sph_grid_prim *prim, uint32_t *line);

#endif
