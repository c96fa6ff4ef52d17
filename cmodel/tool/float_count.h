/* float_count.h - the tests of a frame's rays in exact integers, and again in floating point
 * SPDX-License-Identifier: Apache-2.0
 *
 * The model traces each ray and decides each test. The textbook formulas of reference/floats.h then
 * get the same integers. Their rays meet what the model tested, and nothing else.
 */
#ifndef SPH_TOOL_FLOAT_COUNT_H
#define SPH_TOOL_FLOAT_COUNT_H

#include "common/error.h"
#include "core/frame.h"
#include "machine/machine.h"

enum { FLOAT_KINDS = 4 }; /* of rays: SPH_PRIMARY and so on */
enum { FLOAT_ALL, FLOAT_32, FLOAT_64, FLOAT_ROWS };

/* Of FLOAT_ALL how many there are, of the others how many are wrong. */
struct float_counts {
    uint64_t rays;  /* wrong: another primitive is nearest, of another key; a light that is hidden
                       is seen, or the reverse */
    uint64_t tests; /* as the counters of the frame have them; FLOAT_ALL alone, as rules */
    uint64_t rules; /* tests that are not judged: of what a ray starts on, which is no arithmetic */
    uint64_t hits;  /* wrong: a miss is a hit, or the reverse */
    uint64_t roots; /* of hits that have a key; wrong: a*t is off the key by more than the model's
                       own rounding: 1, and 2^(2-PQ) of it */
    uint64_t pairs; /* of hits of a ray with keys that differ; wrong: in the other order */
    uint64_t equal; /* pairs of equal keys, which no answer is wrong of; wrong: keys differ, but
                       the two are said to be equally far away */
};

struct float_tally {
    struct float_counts of[FLOAT_KINDS][FLOAT_ROWS];
    uint64_t pixels[FLOAT_ROWS]; /* that see another primitive; FLOAT_ALL: by both */
};

/* Traces the window of the machine into *tally. frame, which may be NULL, gets the pixels, and in
 * `visits` of each bits 1 << FLOAT_32 and 1 << FLOAT_64 where these see another primitive; it has
 * the size of the machine's frame. 0, or -1 with a message if memory is out. */
int float_count(const struct sph_machine *m, struct sph_frame *frame, struct float_tally *tally,
                struct sph_error *err);

#endif
