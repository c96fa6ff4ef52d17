/* sphaera_file.h - a machine file that lies in memory, as far as the driver looks into it
 * SPDX-License-Identifier: Apache-2.0
 *
 * The file is drawn in docs/reference/machine_file.md. Of the checks there these are made: magic,
 * version, number of registers, size. The checksum is that of whoever brought the file here.
 */
#ifndef SPHAERA_FILE_H
#define SPHAERA_FILE_H

#include <stdint.h>

#include "sphaera_regs.h"

enum {
    SPHAERA_FILE_VERSION = 7,
    SPHAERA_AT_VERSION = 8, /* bytes from the start */
    SPHAERA_AT_HEADER = 12,
    SPHAERA_AT_REGISTERS = 16,
    SPHAERA_AT_LINES = 24,
    SPHAERA_HEADER_LEAST = 280, /* bytes before the registers */
    SPHAERA_LINE_BYTES = 32,
    SPHAERA_CHECKSUM_BYTES = 8
};

struct sphaera_file {
    const uint8_t *registers, *memory;
    uint32_t memory_bytes;
};

static inline uint32_t sphaera_file_word(const uint8_t *at) {
    return at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}

/* Register `number` of the machine. */
static inline uint32_t sphaera_file_register(const struct sphaera_file *f, uint32_t number) {
    return sphaera_file_word(f->registers + 4 * number);
}

/* What the machine asks of a core beside its effects, as CORE_PARTS has it: as much of DEPTH,
 * LIGHTS, CONES, RECT and SPANS or more; the very COARSE, ACCEL and BOXES. */
static inline uint32_t sphaera_file_asks(const struct sphaera_file *f) {
    const uint32_t depth = sphaera_file_register(f, SPHAERA_REG_MAX_DEPTH);
    const uint32_t lights = sphaera_file_register(f, SPHAERA_REG_N_LIGHTS);
    const uint32_t coarse = sphaera_file_register(f, SPHAERA_REG_COARSE);
    const uint32_t tree = sphaera_file_register(f, SPHAERA_REG_TREE);
    const uint32_t way = sphaera_file_register(f, SPHAERA_REG_BG_MODE) & 3;
    const uint32_t cones = sphaera_file_register(f, SPHAERA_REG_BG_COUNT);
    uint32_t asks = (depth << SPHAERA_CORE_PARTS_DEPTH_LSB & SPHAERA_CORE_PARTS_DEPTH) |
                    (lights << SPHAERA_CORE_PARTS_LIGHTS_LSB & SPHAERA_CORE_PARTS_LIGHTS) |
                    (coarse << SPHAERA_CORE_PARTS_COARSE_LSB & SPHAERA_CORE_PARTS_COARSE);
    if (tree == SPHAERA_TREE_BIH || tree == SPHAERA_TREE_BRUTE) asks |= SPHAERA_CORE_PARTS_ACCEL;
    if (tree == SPHAERA_TREE_BOX4) asks |= SPHAERA_CORE_PARTS_BOXES;
    if (way == 1) asks |= SPHAERA_CORE_PARTS_RECT;
    if (way == 2) asks |= SPHAERA_CORE_PARTS_SPANS;
    if (way == 3)
        asks |= (cones ? cones : 1) << SPHAERA_CORE_PARTS_CONES_LSB & SPHAERA_CORE_PARTS_CONES;
    return asks;
}

/* 1 if these bytes are a machine file, whose parts are then in *f. */
static inline int sphaera_file_read(struct sphaera_file *f, const uint8_t *file, uint32_t bytes) {
    static const char magic[] = "SPHAERA1";
    const uint32_t header = SPHAERA_HEADER_LEAST + 4 * SPHAERA_MACHINE_REGISTERS;
    if (bytes < header + SPHAERA_CHECKSUM_BYTES) return 0;
    for (int i = 0; i < 8; i++)
        if (file[i] != (uint8_t)magic[i]) return 0;
    uint32_t lines = sphaera_file_word(file + SPHAERA_AT_LINES);
    uint32_t room = bytes - header - SPHAERA_CHECKSUM_BYTES;
    if (sphaera_file_word(file + SPHAERA_AT_VERSION) != SPHAERA_FILE_VERSION ||
        sphaera_file_word(file + SPHAERA_AT_HEADER) != header ||
        sphaera_file_word(file + SPHAERA_AT_REGISTERS) != SPHAERA_MACHINE_REGISTERS ||
        room % SPHAERA_LINE_BYTES != 0 || lines != room / SPHAERA_LINE_BYTES)
        return 0;
    f->registers = file + SPHAERA_HEADER_LEAST;
    f->memory = file + header;
    f->memory_bytes = room;
    return 1;
}

#endif
