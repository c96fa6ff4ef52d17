/* triangle.c - a triangle on the grid; see build.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>
#include <string.h>

#include "builder/prim/build.h"
#include "prim/facet.h"

/* A ball around three points: the smallest, up to the rounding of its centre. */
static struct sph_ball triangle_ball(const int32_t (*v)[3]) {
    static const uint32_t index[3] = {0, 1, 2};
    struct sph_ball corner[3] = {{.r = 0}}, out;
    double sphere[4];
    int64_t most = 0;
    for (int k = 0; k < 3; k++)
        memcpy(corner[k].c, v[k], sizeof corner[k].c);
    sph_enclose(corner, index, 3, sphere);
    for (int i = 0; i < 3; i++)
        out.c[i] = (int32_t)lround(sphere[i]);
    for (int k = 0; k < 3; k++) {
        int64_t sum = 0;
        for (int i = 0; i < 3; i++) {
            int64_t d = (int64_t)v[k][i] - out.c[i];
            sum += d * d;
        }
        if (sum > most) most = sum;
    }
    out.r = (int32_t)sph_ceil_sqrt(most);
    return out;
}

static int quantise(const struct sph_grid *grid, const struct sph_scene *scene,
                    const struct sph_profile *profile, struct sph_grid_facet *out) {
    (void)profile;
    for (int k = 0; k < 3; k++)
        sph_grid_point(grid, scene->facets[out->scene].v[k], out->v[k]);
    if (!sph_triangle_normal((const int32_t(*)[3])out->v, out->normal)) return 0;
    out->ball = triangle_ball((const int32_t(*)[3])out->v);
    return 1;
}

static int compare(const int32_t a[3], const int32_t b[3]) {
    for (int i = 0; i < 3; i++)
        if (a[i] != b[i]) return a[i] < b[i] ? -1 : 1;
    return 0;
}

/* The corners of a triangle in rising order. */
static void sorted(const struct sph_grid_facet *f, int32_t v[3][3]) {
    memcpy(v, f->v, sizeof f->v);
    for (int i = 0; i < 3; i++) {
        int a = i == 1, b = a + 1; /* 0-1, 1-2, 0-1 */
        int32_t swap[3];
        if (compare(v[a], v[b]) <= 0) continue;
        memcpy(swap, v[a], sizeof swap);
        memcpy(v[a], v[b], sizeof swap);
        memcpy(v[b], swap, sizeof swap);
    }
}

/* The same corners. */
static int same(const struct sph_grid_facet *a, const struct sph_grid_facet *b) {
    int32_t p[3][3], q[3][3];
    sorted(a, p), sorted(b, q);
    return !memcmp(p, q, sizeof p);
}

/* Mixes the corners. */
static uint64_t hash(const struct sph_grid_facet *f) {
    int32_t v[3][3];
    uint64_t h = 0;
    sorted(f, v);
    for (int i = 0; i < 9; i++) {
        h = (h ^ (uint32_t)v[i / 3][i % 3]) * 0xbf58476d1ce4e5b9u;
        h ^= h >> 29;
    }
    return h * 0x94d049bb133111ebu >> 20;
}

static void record(const struct sph_grid_prim *prim, uint32_t *line) {
    sph_put_head(prim, line);
    sph_put_vector(line, SPH_TRIANGLE_V0_X_LSB, prim->facet->v[0]);
    sph_put_vector(line, SPH_TRIANGLE_V1_X_LSB, prim->facet->v[1]);
    sph_put_vector(line, SPH_TRIANGLE_V2_X_LSB, prim->facet->v[2]);
}

static void box(const struct sph_grid_prim *prim, struct sph_aabb *box) {
    for (int i = 0; i < 3; i++) {
        box->lo[i] = box->hi[i] = prim->facet->v[0][i];
        for (int k = 1; k < 3; k++) {
            int32_t at = prim->facet->v[k][i];
            if (at < box->lo[i]) box->lo[i] = at;
            if (at > box->hi[i]) box->hi[i] = at;
        }
    }
}

static int hull(const struct sph_grid_prim *prim, struct sph_ball hull[3]) {
    for (int k = 0; k < 3; k++) {
        hull[k].r = 0;
        memcpy(hull[k].c, prim->facet->v[k], sizeof hull[k].c);
    }
    return 3;
}

static int map(const struct sph_texture_job *job, const struct sph_grid_prim *prim,
               const struct sph_mip *mip, uint32_t *map, struct sph_error *err) {
    return sph_map_triangle(job, &job->scene->facets[prim->index], prim->facet->v, mip, map, err);
}

const struct sph_prim_build sph_prim_build_triangle = {.joins = 1,
                                                       .quantise = quantise,
                                                       .same = same,
                                                       .hash = hash,
                                                       .record = record,
                                                       .prim = sph_put_normal,
                                                       .box = box,
                                                       .hull = hull,
                                                       .near = sph_triangle_near,
                                                       .map = map};
