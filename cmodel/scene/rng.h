/* rng.h - seeded random numbers: SplitMix64 (Steele, Lea, Flood, OOPSLA 2014)
 * SPDX-License-Identifier: Apache-2.0
 *
 * The same seed gives the same numbers on every machine. Draw one number a statement: C does
 * not fix the order in which arguments of a call are computed.
 */
#ifndef SPH_SCENE_RNG_H
#define SPH_SCENE_RNG_H

#include <stdint.h>

struct sph_rng {
    uint64_t state; /* the seed, at first */
};

/* 64 random bits. */
static inline uint64_t sph_rng_next(struct sph_rng *rng) {
    uint64_t z = rng->state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/* A random number, low <= number < high. */
static inline double sph_rng_range(struct sph_rng *rng, double low, double high) {
    double unit = (double)(sph_rng_next(rng) >> 11) * 0x1p-53;
    return low + (high - low) * unit;
}

#endif
