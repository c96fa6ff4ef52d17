/* build.h - what build asks of a primitive on the grid, of whatever kind it is
 * SPDX-License-Identifier: Apache-2.0
 *
 * builder/prim/NAME.c has the operations of each kind.
 */
#ifndef SPH_PRIM_BUILD_H
#define SPH_PRIM_BUILD_H

#include "builder/grid/facets.h"
#include "builder/texture/map.h"
#include "builder/tree/bih.h"

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

/* ---- what triangles and planes share on the grid; see build.h ---- */

/* Three numbers in fields of 24 bits from bit `at` on. */
static inline void sph_put_vector(uint32_t *line, int at, const int32_t v[3]) {
    for (int i = 0; i < 3; i++)
        sph_field_set(line, at + SPH_LEAF_CTR_Y_LSB * i, SPH_LEAF_CTR_Y_BITS, (uint32_t)v[i]);
}

/* Kind, id and group of a leaf line; a kind that needs more bits has no group. */
static inline void sph_put_head(const struct sph_grid_prim *prim, uint32_t *line) {
    const uint32_t more = (1u << SPH_FACET_KIND_BITS) - 1;
    sph_field_set(line, SPH_FACET_ID_LSB, SPH_FACET_ID_BITS, prim->id);
    if (prim->kind >= more) {
        sph_field_set(line, SPH_FACET_KIND_LSB, SPH_FACET_KIND_BITS, more);
        sph_field_set(line, SPH_FACET_MORE_LSB, SPH_FACET_MORE_BITS, prim->kind - more);
        return;
    }
    sph_field_set(line, SPH_FACET_BEFORE_LSB, SPH_FACET_BEFORE_BITS, prim->facet->before);
    sph_field_set(line, SPH_FACET_AFTER_LSB, SPH_FACET_AFTER_BITS, prim->facet->after);
    sph_field_set(line, SPH_FACET_KIND_LSB, SPH_FACET_KIND_BITS, prim->kind);
}

/* As sph_prim_build.prim: the normal in place of a centre, and the kind. */
static inline void sph_put_normal(const struct sph_grid_prim *prim, uint32_t *line) {
    sph_put_vector(line, SPH_LEAF_CTR_X_LSB, prim->facet->normal);
    sph_field_set(line, SPH_LEAF_ID_LSB, SPH_LEAF_ID_BITS, prim->id);
    sph_field_set(line, SPH_PRIM_KIND_LSB, SPH_PRIM_KIND_BITS, prim->kind);
}

/* As sph_prim_build.near. */
int sph_triangle_near(const struct sph_grid_facet *facet, const struct sph_ball *ball,
                      const struct sph_profile *profile);
int sph_plane_near(const struct sph_grid_facet *facet, const struct sph_ball *ball,
                   const struct sph_profile *profile);

#endif
