/* disc.c - proof for every input of small widths: the discriminant fits, and no narrower word does
 * SPDX-License-Identifier: Apache-2.0
 *
 * Every difference of two coordinates of W bits, every radius and every direction of WD bits:
 * sph_leaf_test()'s disc, in 128 bits, lies in s(2W+2WD+2) and below 2^(2W+2WD), b and k in their
 * words; so disc is the sum of its terms modulo 2^(2W+2WD+2). Some disc leaves s(2W+2WD+1). For
 * all widths: disc.smt2 and docs/results/hard_cases.md.
 *
 * Exit: 0 all hold, 1 one does not.
 */
#include <stdio.h>

#include "machine/layout.h"
#include "prim/sphere.h"

#ifndef W
#define W 2
#define WD 3
#endif
enum { DW = 2 * W + 2 * WD + 2 };

/* Does v fit `bits` bits of two's complement? */
static int fits(sph_i128 v, int bits) {
    sph_i128 end = (sph_i128)1 << (bits - 1);
    return v >= -end && v < end;
}

/* The low `bits` bits of v, as a number of two's complement. */
static sph_i128 wrap(sph_u128 v, int bits) {
    return (sph_i128)(v << (128 - bits)) >> (128 - bits);
}

static uint64_t tests, wider; /* wider: outside s(2W+2WD+1) */

static int check(const int64_t oc[3], const int64_t d[3], int64_t rad) {
    struct sph_ray ray = {.dir = {d[0], d[1], d[2]},
                          .kind = SPH_PRIMARY,
                          .inside = 1,
                          .skip = {SPH_ID_NONE, 0},
                          .a = (uint64_t)(d[0] * d[0] + d[1] * d[1] + d[2] * d[2])};
    struct sph_leaf leaf = {{oc[0], oc[1], oc[2]}, rad, 1};
    struct sph_leaf_result r = sph_leaf_test(&ray, &leaf);
    sph_i128 sum = wrap((sph_u128)wrap((sph_u128)((sph_i128)r.k * (sph_i128)ray.a), DW) +
                            (sph_u128)wrap((sph_u128)((sph_i128)r.b * r.b), DW),
                        DW);
    tests++;
    wider += (uint64_t)!fits(r.disc, DW - 1);
    if (fits(r.disc, DW) && r.disc < (sph_i128)1 << (DW - 2) && sum == r.disc &&
        fits(r.b, W + WD + 2) && fits(r.k, 2 * W + 3))
        return 0;
    printf("fails: oc %d %d %d, dir %d %d %d, radius %d: disc %lld\n", (int)oc[0], (int)oc[1],
           (int)oc[2], (int)d[0], (int)d[1], (int)d[2], (int)rad, (long long)r.disc);
    return 1;
}

int main(void) {
    const int far = (1 << W) - 1, end = 1 << (WD - 1);
    for (int x = -far; x <= far; x++)
        for (int y = -far; y <= far; y++)
            for (int z = -far; z <= far; z++)
                for (int dx = -end; dx < end; dx++)
                    for (int dy = -end; dy < end; dy++)
                        for (int dz = -end; dz < end; dz++)
                            for (int rad = 0; rad <= far; rad++) {
                                const int64_t oc[3] = {x, y, z}, d[3] = {dx, dy, dz};
                                if (check(oc, d, rad)) return 1;
                            }
    printf("%llu cases, %llu of them need all %d bits\n", (unsigned long long)tests,
           (unsigned long long)wider, DW);
    return wider ? 0 : 1;
}
