/* machine.h - all that the hardware sees: registers and an image of memory
 * SPDX-License-Identifier: Apache-2.0
 *
 * The layout of words is drawn in machine.def. The model and the RTL read the same bytes.
 */
#ifndef SPH_MACHINE_H
#define SPH_MACHINE_H

#include <stddef.h>
#include <stdint.h>

#include "common/error.h"
#include "machine/layout.h"
#include "machine/profile.h"

struct sph_machine {
    int32_t regs[SPH_N_REGS];
    uint32_t *mem; /* lines * SPH_LINE_WORDS words */
    uint32_t lines;
    struct sph_profile profile; /* register PROFILE in words: sph_machine_set_profile() */
    /* Information that the hardware does not see: */
    char name[128];     /* scene */
    int32_t grid_log2;  /* a grid unit is 2^grid_log2 units of the scene file */
    double origin[3];   /* coordinates of grid point 0 along these axes */
    double rotation[9]; /* rows: the grid's x, y, z axes in the scene's frame */
};

static inline const struct sph_profile *sph_machine_profile(const struct sph_machine *m) {
    return &m->profile;
}

/* The widths p, in the register too. */
static inline void sph_machine_set_profile(struct sph_machine *m, const struct sph_profile *p) {
    m->profile = *p;
    m->regs[SPH_REG_PROFILE] = (int32_t)sph_profile_pack(p);
}

/* 1 if the machine asks for an effect, SPH_EFFECT_*. */
static inline int sph_machine_effect(const struct sph_machine *m, int effect) {
    return m->regs[SPH_REG_EFFECTS] >> effect & 1;
}

/* 1 if a tree is a bounding interval hierarchy, or the one leaf of brute force. */
static inline int sph_tree_bih(int tree) {
    return tree == SPH_TREE_BIH || tree == SPH_TREE_BRUTE;
}

/* A tree's name; tree: SPH_TREE_PAPER .. SPH_TREE_LAST. */
static inline const char *sph_tree_name(int tree) {
    static const char *const names[SPH_TREE_LAST + 1] = {"",      "paper",      "balanced", "bih",
                                                         "brute", "reinserted", "box4",     "hw"};
    return names[tree];
}

/* That of a valid machine. */
static inline const char *sph_machine_tree_name(const struct sph_machine *m) {
    return sph_tree_name(m->regs[SPH_REG_TREE]);
}

/* 1 if the machine holds such a one. */
static inline int sph_machine_bih(const struct sph_machine *m) {
    return sph_tree_bih(m->regs[SPH_REG_TREE]);
}

/* The words of a line of memory. */
static inline uint32_t *sph_line(const struct sph_machine *m, size_t line) {
    return m->mem + line * SPH_LINE_WORDS;
}

/* Bits lsb .. lsb+width-1 (width 1..32) of a line, unsigned. */
static inline uint32_t sph_field(const uint32_t *line, int lsb, int width) {
    uint64_t two = line[lsb >> 5];
    if ((lsb & 31) + width > 32) two |= (uint64_t)line[(lsb >> 5) + 1] << 32;
    return (uint32_t)(two >> (lsb & 31) & ((1ull << width) - 1));
}

/* The same, two's complement. */
static inline int32_t sph_field_signed(const uint32_t *line, int lsb, int width) {
    return (int32_t)(sph_field(line, lsb, width) << (32 - width)) >> (32 - width);
}

/* Stores the low width bits of value. */
static inline void sph_field_set(uint32_t *line, int lsb, int width, uint32_t value) {
    uint64_t mask = ((1ull << width) - 1) << (lsb & 31);
    uint64_t bits = (uint64_t)value << (lsb & 31) & mask;
    uint32_t *word = &line[lsb >> 5];
    word[0] = (word[0] & ~(uint32_t)mask) | (uint32_t)bits;
    if (mask >> 32) word[1] = (word[1] & ~(uint32_t)(mask >> 32)) | (uint32_t)(bits >> 32);
}

/* Writes a machine file (docs/reference/machine_file.md): header, registers, memory, checksum; to a
 * temporary name, then renamed. 0, or -1 with a message. */
int sph_machine_write(const struct sph_machine *m, const char *path, struct sph_error *err);

/* Reads the bytes of a machine file: magic, version, sizes, checksum, profile, place of the grid.
 * What its memory says is looked at by sph_machine_read() of validate/validate.h. 0, or -1 with a
 * message; on failure there is nothing to free. */
int sph_machine_load(const char *path, struct sph_machine *m, struct sph_error *err);

void sph_machine_free(struct sph_machine *m);

#endif
