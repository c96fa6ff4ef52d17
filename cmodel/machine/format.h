/* format.h - the machine file's fixed part; drawn in docs/reference/machine_file.md
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_FORMAT_H
#define SPH_FORMAT_H

#include <stddef.h>
#include <stdint.h>

#include "common/fnv.h"
#include "machine/machine.h"

#define SPH_MAGIC "SPHAERA1"

enum {
    SPH_FILE_VERSION = 7,
    SPH_AT_MAGIC = 0,
    SPH_AT_VERSION = 8,
    SPH_AT_HEADER = 12, /* bytes before memory */
    SPH_AT_N_REGS = 16,
    SPH_AT_LINE_WORDS = 20,
    SPH_AT_LINES = 24,
    SPH_AT_GRID_LOG2 = 28,
    SPH_AT_PROFILE = 32, /* w, wd, pq, ng, fw, pr */
    SPH_N_WIDTHS = 6,
    SPH_AT_NAME = 56, /* 128 bytes, zero at the end */
    SPH_NAME_BYTES = 128,
    SPH_AT_ORIGIN = 184,   /* 3 doubles */
    SPH_AT_ROTATION = 208, /* 9 doubles */
    SPH_AT_REGS = 280,
    SPH_HEADER_BYTES = SPH_AT_REGS + 4 * SPH_N_REGS,
    SPH_CHECKSUM_BYTES = 8
};

/* Little-endian bytes. */
static inline void sph_put32(unsigned char *to, uint32_t v) {
    for (int i = 0; i < 4; i++)
        to[i] = (unsigned char)(v >> 8 * i);
}

static inline uint32_t sph_get32(const unsigned char *from) {
    return from[0] | (uint32_t)from[1] << 8 | (uint32_t)from[2] << 16 | (uint32_t)from[3] << 24;
}

static inline void sph_put64(unsigned char *to, uint64_t v) {
    sph_put32(to, (uint32_t)v);
    sph_put32(to + 4, (uint32_t)(v >> 32));
}

static inline uint64_t sph_get64(const unsigned char *from) {
    return sph_get32(from) | (uint64_t)sph_get32(from + 4) << 32;
}

/* FNV-1a, 64 bits, continued over n more bytes. */
static inline uint64_t sph_fnv_bytes(uint64_t sum, const unsigned char *bytes, size_t n) {
    for (size_t i = 0; i < n; i++)
        sum = sph_fnv(sum, bytes[i], 1);
    return sum;
}

#endif
