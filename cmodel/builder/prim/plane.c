/* plane.c - a plane on the grid; see build.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>
#include <string.h>

#include "builder/prim/build.h"

/* A direction in the camera's axes, its largest component as large as 24 bits allow. */
static void plane_normal(const struct sph_grid *grid, struct sph_vec n, int32_t out[3]) {
    const double *m = grid->rotation, top = (1 << (SPH_PLANE_N_X_BITS - 1)) - 1;
    double turned[3], size = fmax(fabs(n.x), fmax(fabs(n.y), fabs(n.z))), most = 0;
    for (int i = 0; i < 3; i++) {
        turned[i] =
            m[3 * i] * (n.x / size) + m[3 * i + 1] * (n.y / size) + m[3 * i + 2] * (n.z / size);
        most = fmax(most, fabs(turned[i]));
    }
    for (int i = 0; i < 3; i++)
        out[i] = (int32_t)lround(turned[i] / most * top);
}

static int quantise(const struct sph_grid *grid, const struct sph_scene *scene,
                    const struct sph_profile *profile, struct sph_grid_facet *out) {
    const struct sph_facet *f = &scene->facets[out->scene];
    sph_grid_point(grid, f->v[0], out->v[0]);
    plane_normal(grid, f->v[1], out->v[1]);
    memcpy(out->normal, out->v[1], sizeof out->normal);
    out->ball = sph_grid_whole(profile);
    return 1;
}

/* Parallel normals, less than a grid unit apart. */
static int same(const struct sph_grid_facet *a, const struct sph_grid_facet *b) {
    int64_t off = 0, square = 0;
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3;
        if ((int64_t)a->v[1][i] * b->v[1][j] != (int64_t)a->v[1][j] * b->v[1][i]) return 0;
        off += (int64_t)a->v[1][i] * (b->v[0][i] - a->v[0][i]);
        square += (int64_t)a->v[1][i] * a->v[1][i];
    }
    return (__int128)off * off < square;
}

/* One for all: there are few. */
static uint64_t hash(const struct sph_grid_facet *f) {
    (void)f;
    return 0;
}

static void record(const struct sph_grid_prim *prim, uint32_t *line) {
    sph_put_head(prim, line);
    sph_put_vector(line, SPH_PLANE_P_X_LSB, prim->facet->v[0]);
    sph_put_vector(line, SPH_PLANE_N_X_LSB, prim->facet->v[1]);
}

static int map(const struct sph_texture_job *job, const struct sph_grid_prim *prim,
               const struct sph_mip *mip, uint32_t *map, struct sph_error *err) {
    return sph_map_plane(job, &job->scene->facets[prim->index], prim->facet->v[0], mip, map, err);
}

/* It has neither box nor hull. */
const struct sph_prim_build sph_prim_build_plane = {.quantise = quantise,
                                                    .same = same,
                                                    .hash = hash,
                                                    .record = record,
                                                    .prim = sph_put_normal,
                                                    .near = sph_plane_near,
                                                    .map = map};
