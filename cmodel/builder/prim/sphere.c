/* sphere.c - a sphere on the grid; see build.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/prim/build.h"

static void record(const struct sph_grid_prim *prim, uint32_t *words) {
    const struct sph_ball *ball = prim->ball;
    for (int i = 0; i < 3; i++)
        sph_field_set(words, SPH_LEAF_CTR_X_LSB + SPH_LEAF_CTR_X_BITS * i, SPH_LEAF_CTR_X_BITS,
                      (uint32_t)ball->c[i]);
    sph_field_set(words, SPH_LEAF_RAD_LSB, SPH_LEAF_RAD_BITS, (uint32_t)ball->r);
    sph_field_set(words, SPH_LEAF_ID_LSB, SPH_LEAF_ID_BITS, prim->id);
}

static void box(const struct sph_grid_prim *prim, struct sph_aabb *box) {
    for (int i = 0; i < 3; i++) {
        box->lo[i] = prim->ball->c[i] - prim->ball->r;
        box->hi[i] = prim->ball->c[i] + prim->ball->r;
    }
}

static int hull(const struct sph_grid_prim *prim, struct sph_ball hull[3]) {
    hull[0] = *prim->ball;
    return 1;
}

static int map(const struct sph_texture_job *job, const struct sph_grid_prim *prim,
               const struct sph_mip *mip, uint32_t *map, struct sph_error *err) {
    return sph_map_sphere(job, &job->scene->spheres[prim->index], prim->ball->r, mip, map, err);
}

/* A primitive record begins with the leaf record. */
const struct sph_prim_build sph_prim_build_sphere = {
    .record = record, .prim = record, .box = box, .hull = hull, .map = map};
