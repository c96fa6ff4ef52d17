/* work.h - arithmetic that a way of background separation costs before the frame starts
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_WORK_H
#define SPH_WORK_H

#include <stdint.h>

/* Counted where it is done, as it is done. */
struct sph_work {
    uint64_t add; /* additions and subtractions */
    uint64_t mul, div, trig;
    uint64_t compare; /* comparisons, each end of a span that is moved included */
};

static inline void sph_work_add(struct sph_work *to, const struct sph_work *more) {
    to->add += more->add;
    to->mul += more->mul;
    to->div += more->div;
    to->trig += more->trig;
    to->compare += more->compare;
}

#endif
