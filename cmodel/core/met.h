/* met.h - what the rays of a frame meet, gathered while the golden model draws it
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_MET_H
#define SPH_MET_H

#include <stdint.h>

#include "machine/layout.h"

/* Threads add to one of these at a time; which comes first changes nothing. */
struct sph_met {
    uint32_t *prims;  /* of each primitive of the machine, by id: SPH_MET_* */
    uint32_t lit;     /* bit l: light l of the machine reaches a surface that faces it */
    uint32_t blocked; /* bit l: something stands between it and such a surface */
    uint32_t inside;  /* 1: a ray found, from inside, what it may start in */
    uint32_t passed;  /* 1: a ray to a light passed what would be in its way without CLEAR */
    uint32_t depths;  /* bit n: n rays one after another followed the primary one */
};

/* Bit l: a ray to light l found the primitive; and: the colour of its surface was asked for. */
enum { SPH_MET_SHADED = 1 << SPH_MAX_LIGHTS };

static inline void sph_met_add(uint32_t *to, uint32_t bits) {
    if (bits & ~__atomic_load_n(to, __ATOMIC_RELAXED))
        __atomic_fetch_or(to, bits, __ATOMIC_RELAXED);
}

#endif
