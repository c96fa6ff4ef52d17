/* untold.h - what packets of rays do not tell of a frame: the tree's work
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef UNTOLD_H
#define UNTOLD_H

#include "core/frame.h"
#include "machine/layout.h"

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
