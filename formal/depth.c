/* depth.c - proof for every input of small widths: no depth limit is below the hit that set it
 * SPDX-License-Identifier: Apache-2.0
 *
 * Every key a hit can have and every direction of DIR bits: sph_ray_depth() is at least the depth
 * of the hit, t |d| / 2^k with d the component of dir along the axis. Every shadow ray starts with
 * a limit that no point before its light exceeds. In the profile of W, FW and 9 bits of direction.
 *
 * Exit: 0 all hold, 1 one does not.
 */
#include <stdio.h>

#include "core/ray.h"
#include "trace/setup.h"

#ifndef W
#define W 6
#define FW 4
#define DIR 4
#endif
enum { K = W - FW, BITS = 9 };

static const struct sph_profile profile = {.name = "small", .w = W, .wd = BITS, .fw = FW};
static uint64_t tests, sharp; /* sharp: one less would be too little */

static int check_dir(const int64_t dir[3]) {
    struct sph_ray ray = {.dir = {dir[0], dir[1], dir[2]}, .kind = SPH_PRIMARY};
    sph_ray_setup(&profile, &ray);
    struct sph_ray shadow = ray;
    shadow.kind = SPH_SHADOW;
    sph_ray_setup(&profile, &shadow);
    uint64_t span = (uint64_t)(dir[ray.axis] < 0 ? -dir[ray.axis] : dir[ray.axis]);
    uint64_t limit = (uint64_t)sph_depth_limit(&profile);
    uint64_t light = (uint64_t)shadow.depth_max;
    if (ray.depth_max != (int32_t)limit || (light != limit && light << K < span)) {
        printf("fails: first limit %llu of dir %d %d %d\n", (unsigned long long)light, (int)dir[0],
               (int)dir[1], (int)dir[2]);
        return 1;
    }
    for (uint64_t key = 1; key < (12ull << (W + BITS)) / 5; key++) {
        uint64_t depth = (uint64_t)sph_ray_depth(&profile, &ray, key);
        tests++;
        if (depth == limit) continue;
        if ((depth << K) * ray.a < key * span) { /* depth < (key / a) * span / 2^k */
            printf("fails: depth %llu of key %llu, dir %d %d %d\n", (unsigned long long)depth,
                   (unsigned long long)key, (int)dir[0], (int)dir[1], (int)dir[2]);
            return 1;
        }
        sharp += ((depth - 1) << K) * ray.a < key * span;
    }
    return 0;
}

int main(void) {
    const int end = 1 << (DIR - 1);
    for (int x = -end; x < end; x++)
        for (int y = -end; y < end; y++)
            for (int z = -end; z < end; z++) {
                const int64_t dir[3] = {x, y, z};
                if ((x || y || z) && check_dir(dir)) return 1;
            }
    printf("%llu cases; one less would be too little in %llu\n", (unsigned long long)tests,
           (unsigned long long)sharp);
    return 0;
}
