/* hit.h - the naive model's primitives, hits and points
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_NAIVE_HIT_H
#define SPH_NAIVE_HIT_H

#include "naive/naive.h"

struct sph_naive_prim {
    struct sph_leaf sphere; /* of a facet: ctr is the normal */
    int facet;
    uint32_t smooth; /* 1 + number of the record of its normals */
    uint32_t rgb[3], kr;
    uint32_t kt, ka, kd, ks, power, index; /* as they stand in the record */
    uint32_t tex, bend;                    /* too */
    int sum;
};

struct sph_naive_found {
    struct sph_naive_leaf how;
    struct sph_naive_prim prim;
};

struct sph_naive_point {      /* where a ray ends */
    int64_t at[3], behind[3]; /* start of mirror rays; of refracted ones */
    int64_t guarded[3];       /* the first before it was rounded to the grid */
    int64_t normal[3], unit[3];
    int bent; /* the normal is interpolated, and side that of the facet */
    int64_t side[3];
};

/* The first hit in the order of keys, then ids; any hit of a shadow ray. */
struct sph_naive_found sph_naive_trace(const struct sph_machine *m, const struct sph_ray *ray);

/* Whether another sphere than `own` that the ray hits holds its origin. */
int sph_naive_within(const struct sph_machine *m, const struct sph_ray *ray, uint32_t own);

/* Of the nodes from `line` down, each before its children, the first with a leaf that is hit. */
struct sph_naive_found sph_naive_first(const struct sph_machine *m, const struct sph_ray *ray,
                                       uint32_t line);

/* org + t*dir with guard bits; the normal points to the side that the ray came from. */
struct sph_naive_point sph_naive_point_of(const struct sph_machine *m, const struct sph_ray *ray,
                                          const struct sph_naive_found *f);

/* Sets out to direction - 2 * (direction . normal) / (normal . normal) * normal, free of division.
 */
void sph_naive_mirror(const int64_t d[3], const int64_t n[3], int wd, int64_t out[3]);

#endif
