/* buried.c - spheres that no picture shows and no shadow needs; see occlude.h,
 * docs/design/builder.md
 * SPDX-License-Identifier: Apache-2.0
 */
#include <string.h>

#include "builder/effects/occlude.h"

/* The only ball near `host`; n if there is none or more than one. */
static uint32_t only_neighbour(const struct sph_world *world, uint32_t host) {
    uint32_t found = world->n;
    for (uint32_t i = 0; i < world->n; i++) {
        if (i == host) continue;
        if (sph_nearness(&world->balls[host], &world->balls[i], world->profile) == SPH_APART)
            continue;
        if (found < world->n) return world->n;
        found = i;
    }
    return found;
}

int sph_deep(const struct sph_ball *host, const struct sph_ball *ball,
             const struct sph_profile *p) {
    int64_t unit = 1ll << sph_error_bits(p), more = sph_point_error(p) + unit, apart = 0;
    int64_t room = (7ll * host->r - 8ll * ball->r) * unit - 8 * more;
    for (int i = 0; i < 3; i++) {
        int64_t d = (int64_t)host->c[i] - ball->c[i];
        apart += d * d;
    }
    __int128 reach = (__int128)64 * unit * unit * apart;
    return host->r * unit >= 4 * more && room >= 0 && reach <= (__int128)room * room;
}

void sph_buried(const struct sph_world *world, const int32_t (*lights)[3], int count,
                uint8_t *buried) {
    memset(buried, 0, world->n);
    if (!world->mended) return;
    for (uint32_t i = 0; i < world->n; i++) {
        const struct sph_ball *host = &world->balls[i];
        int empty = sph_ball_side(host, world->eye) < 0;
        for (int l = 0; l < count; l++)
            empty = empty && sph_ball_side(host, lights[l]) < 0;
        uint32_t in = empty ? only_neighbour(world, i) : world->n;
        if (in < world->n && sph_deep(host, &world->balls[in], world->profile)) buried[in] = 1;
    }
}
