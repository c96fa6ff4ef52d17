/* fnv.h - FNV-1a of numbers taken as little-endian bytes
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_FNV_H
#define SPH_FNV_H

#include <stdint.h>

#define SPH_FNV_START 0xcbf29ce484222325u
#define SPH_FNV_PRIME 0x100000001b3u

static inline uint64_t sph_fnv(uint64_t hash, uint64_t value, int bytes) {
    for (int i = 0; i < bytes; i++)
        hash = (hash ^ (value >> 8 * i & 255)) * SPH_FNV_PRIME;
    return hash;
}

#endif
