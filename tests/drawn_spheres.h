/* drawn_spheres.h - scenes of spheres on the grid, as what builds a tree may get them
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TEST_DRAWN_SPHERES_H
#define SPH_TEST_DRAWN_SPHERES_H

#include "build/build_tree.h"
#include "machine/layout.h"
#include "machine/machine.h"
#include "number.h"

enum drawn_kind {
    DRAWN_EVEN,   /* anywhere, small */
    DRAWN_SMALL,  /* all in a small part of the grid: keys count from the least centre */
    DRAWN_EQUAL,  /* of few centres: many equal keys, which are ordered by number */
    DRAWN_ENDS,   /* at the ends of the grid, radii up to the largest */
    DRAWN_LARGER, /* in a row, each larger than the one before: a tree as deep as it can be */
    DRAWN_NEARER, /* in a row, each nearer to the next: what waits fills the stack */
    DRAWN_KINDS
};

/* Draws n spheres; next(): 64 random bits. */
static inline void drawn_spheres(enum drawn_kind kind, struct sph_bt_leaf *leaves, uint32_t n,
                                 const struct sph_profile *p, uint64_t (*next)(void *), void *of) {
    int64_t half = 1ll << (p->w - 1), all = 2 * half;
    int64_t at = -half;
    for (uint32_t i = 0; i < n; i++) {
        struct sph_bt_leaf *leaf = &leaves[i];
        for (int k = 0; k < 3; k++) {
            uint64_t r = next(of);
            switch (kind) {
            case DRAWN_SMALL:
                leaf->ctr[k] = (int32_t)(half / 2 - (int64_t)(r % (uint64_t)(half / 8)));
                break;
            case DRAWN_EQUAL:
                leaf->ctr[k] = (int32_t)(r % 3);
                break;
            case DRAWN_ENDS:
                leaf->ctr[k] = (int32_t)(r & 1 ? half - 1 - (int64_t)(r >> 8) % 2 : -half);
                break;
            case DRAWN_LARGER:
                leaf->ctr[k] = k ? 0 : (int32_t)((int64_t)i - half / 2);
                break;
            case DRAWN_NEARER:
                leaf->ctr[k] = k ? 0 : (int32_t)at;
                break;
            default:
                leaf->ctr[k] = (int32_t)((int64_t)(r % (uint64_t)all) - half);
            }
        }
        uint64_t r = next(of);
        leaf->rad = kind == DRAWN_ENDS     ? (int32_t)(1 + r % (uint64_t)(all - 1))
                    : kind == DRAWN_LARGER ? (int32_t)(1 + 4 * (int64_t)i % (all - 1))
                    : kind == DRAWN_NEARER ? 1
                                           : (int32_t)(1 + r % (uint64_t)(all / 64));
        at += n > i ? (all - 2) * (n - i) * 2 / ((int64_t)n * (n + 1)) : 0;
        if (at > half - 1) at = half - 1;
    }
}

/* The primitive record of a sphere; what else it holds is of no account. */
static inline void drawn_record(uint32_t *line, uint32_t id, const struct sph_bt_leaf *leaf,
                                uint64_t noise) {
    for (int i = 0; i < SPH_LINE_WORDS; i++)
        line[i] = 0;
    for (int k = 0; k < 3; k++)
        sph_field_set(line, SPH_LEAF_CTR_X_LSB + 24 * k, 24, (uint32_t)leaf->ctr[k]);
    sph_field_set(line, SPH_LEAF_RAD_LSB, SPH_LEAF_RAD_BITS, (uint32_t)leaf->rad);
    sph_field_set(line, SPH_LEAF_ID_LSB, SPH_LEAF_ID_BITS, id);
    sph_field_set(line, SPH_LEAF_CLEAR_LSB, SPH_LEAF_CLEAR_BITS, noise & 1);
    sph_field_set(line, SPH_PRIM_RED_LSB, SPH_PRIM_RED_BITS, noise >> 1 & 255);
}

#endif
