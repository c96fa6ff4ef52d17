/* exhaustive.c - every operand of three bits, every kind of ray; see hard.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * The rays are rays of profile draft, whose outputs are defined; three bits of coordinates lie at
 * the low end of its grid, so that points leave the grid on that side.
 */
#include <string.h>

#include "hard.h"

enum { BITS = 3, MOST = (1 << BITS) - 1, SIDE = 2 * MOST + 1 };

/* Disc at widths of three bits: no more than 2W+2WD+2 bits. */
static int fits(const struct hard_case *c) {
    struct sph_ray ray = c->ray;
    ray.a = (uint64_t)(ray.dir[0] * ray.dir[0] + ray.dir[1] * ray.dir[1] + ray.dir[2] * ray.dir[2]);
    struct sph_leaf_result r = sph_leaf_test(&ray, &c->sphere[0]);
    int64_t end = 1 << (4 * BITS + 1);
    return r.disc < end && r.disc >= -end;
}

uint64_t hard_exhaustive(int slice, uint64_t share, struct hard_tally *t, FILE *out) {
    const struct sph_profile *p = &sph_profiles[SPH_DRAFT];
    int64_t low = -(1ll << (p->w - 1));
    uint64_t operands = 0, wrong = 0;
    for (int i = slice; i < SIDE * SIDE * SIDE; i += HARD_SLICES) {
        struct hard_case c = {.n = 1};
        int64_t oc[3] = {i % SIDE - MOST, i / SIDE % SIDE - MOST, i / SIDE / SIDE - MOST};
        c.sphere[0].id = HARD_ID;
        for (int j = 0; j < 3; j++) {
            c.ray.org[j] = low + (oc[j] >= 0 ? 0 : MOST);
            c.sphere[0].ctr[j] = c.ray.org[j] + oc[j];
        }
        for (int64_t d = 0; d < 1 << 3 * BITS; d++) {
            for (int j = 0; j < 3; j++)
                c.ray.dir[j] = (d >> (BITS * j) & MOST) - (1 << (BITS - 1));
            for (int rad = 0; rad <= MOST; rad++, operands++) {
                if (operands % share) continue;
                c.sphere[0].rad = rad;
                for (int kind = 0; kind < 6; kind++) { /* some in GMP too */
                    c.ray.kind = kind & 1 ? SPH_SHADOW : SPH_REFLECTED;
                    c.ray.skip = (struct sph_skip){kind & 2 ? HARD_ID : SPH_ID_NONE, 1};
                    c.ray.inside = kind < 4;
                    FILE *say = wrong < 3 ? out : NULL;
                    int naive = operands / share % 509 == (uint64_t)kind;
                    wrong += (uint64_t)hard_check(p, &c, naive, t, say);
                }
                if (fits(&c)) continue;
                wrong++;
                t->wrong[HARD_DISC]++;
                if (out && wrong < 3) hard_print(out, p, &c);
            }
        }
    }
    return wrong;
}
