/* drawn.h - random numbers for tests of the fast walk
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef DRAWN_H
#define DRAWN_H

#include <stdint.h>
#include <stdlib.h>

#include "core/frame.h"
#include "machine/layout.h"
#include "number.h"
#include "scene/rng.h"

/* SEED, 1 unless it is set. */
static inline uint64_t seed(void) {
    return test_seed();
}

/* A number -n .. n. */
static inline int64_t small(struct sph_rng *rng, int n) {
    return (int64_t)(sph_rng_next(rng) >> 8) % (2 * n + 1) - n;
}

/* A number of at most `bits` bits and a sign, of any length. */
static inline int64_t any(struct sph_rng *rng, int bits) {
    uint64_t r = sph_rng_next(rng) >> 2;
    int length = (int)(sph_rng_next(rng) >> 8) % (bits + 1);
    int64_t size = (int64_t)(r & ((1ull << (length < 0 ? -length : length)) - 1));
    return sph_rng_next(rng) >> 9 & 1 ? -size : size;
}

/* A corner or an origin: of few bits, so that each comparison meets both sides equal, of any
 * length, or at an end of the grid. */
static inline int64_t coordinate(struct sph_rng *rng, int w, int way) {
    int64_t half = 1ll << (w - 1);
    if (way == 0) return small(rng, 2);
    if (way == 1) return any(rng, w - 1);
    return sph_rng_next(rng) >> 9 & 1 ? half - 1 : -half;
}

/* ---- what packets of rays do not tell of a frame: the tree's work ---- */

/* Makes 0 of it, as in a frame of packets; a list of its own, not that of render.c. */
static inline void untell(struct sph_frame *frame, struct sph_counters *c) {
    static const int work[] = {SPH_COUNT_NODE_VISITS, SPH_COUNT_CHILD_TESTS, SPH_COUNT_LEAF_TESTS,
                               SPH_COUNT_ROOTS,       SPH_COUNT_FACET_TESTS, SPH_COUNT_DIVISIONS};
    for (int i = 0; i < frame->width * frame->height; i++)
        frame->pixels[i].visits = 0;
    for (size_t i = 0; i < sizeof work / sizeof *work; i++)
        c->count[work[i]] = 0;
}

#endif
