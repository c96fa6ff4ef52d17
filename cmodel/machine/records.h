/* records.h - where leaf records stand, and of which kind they are
 * SPDX-License-Identifier: Apache-2.0
 *
 * With FACETS a record has a whole line, else half of one.
 */
#ifndef SPH_MACHINE_RECORDS_H
#define SPH_MACHINE_RECORDS_H

#include <stdint.h>

#include "machine/layout.h"
#include "machine/machine.h"

/* Whether records of the machine have whole lines. */
static inline int sph_whole(const struct sph_machine *m) {
    return sph_machine_effect(m, SPH_EFFECT_FACETS);
}

/* Lines of n records that stand together. */
static inline uint64_t sph_record_lines(int whole, uint64_t n) {
    return whole ? n : (n + 1) / 2;
}

/* The words of record i of those that begin with line `base`. */
static inline uint32_t *sph_record(const struct sph_machine *m, int whole, size_t base,
                                   uint32_t i) {
    if (whole) return sph_line(m, base + i);
    return sph_line(m, base + i / 2) + i % 2 * (SPH_LEAF_STRIDE / 32);
}

/* The kind of a leaf record, which has a whole line or is a sphere, and of a primitive record. */
static inline uint32_t sph_record_kind(int whole, const uint32_t *line) {
    if (!whole) return SPH_SPHERE;
    uint32_t kind = sph_field(line, SPH_FACET_KIND_LSB, SPH_FACET_KIND_BITS);
    if (kind < (1u << SPH_FACET_KIND_BITS) - 1) return kind;
    return kind + sph_field(line, SPH_FACET_MORE_LSB, SPH_FACET_MORE_BITS);
}
/* The bit of a leaf record of that kind which marks it as clear; whether it is. */
static inline int sph_record_clear_lsb(uint32_t kind) {
    return kind == SPH_SPHERE ? SPH_LEAF_CLEAR_LSB : SPH_FACET_CLEAR_LSB;
}
static inline int sph_record_clear(uint32_t kind, const uint32_t *line) {
    return (int)sph_field(line, sph_record_clear_lsb(kind), SPH_LEAF_CLEAR_BITS);
}

static inline uint32_t sph_prim_kind(const struct sph_machine *m, const uint32_t *prim) {
    if (!sph_machine_effect(m, SPH_EFFECT_FACETS)) return SPH_SPHERE;
    return sph_field(prim, SPH_PRIM_KIND_LSB, SPH_PRIM_KIND_BITS);
}

/* ---- what is known of a kind of primitive by its number alone; kinds stand in machine.def ---- */

/* "sphere" and so on; NULL of a number that no kind has. */
static inline const char *sph_kind_name(uint32_t kind) {
#define SPH_KIND_NAME(name) #name,
    static const char *const names[SPH_KINDS] = {SPH_EACH_KIND(SPH_KIND_NAME)};
#undef SPH_KIND_NAME
    return kind < SPH_KINDS ? names[kind] : 0;
}

/* 1 if nothing bounds it: no node holds it. It is a leaf child of the root, and stands in front of
 * the records of a BIH. */
static inline int sph_kind_unbounded(uint32_t kind) {
    return kind < SPH_KINDS && SPH_KINDS_UNBOUNDED >> kind & 1;
}

#endif
