/* records.h - where leaf records stand
 * SPDX-License-Identifier: Apache-2.0
 *
 * With FACETS a record has a whole line, else half of one.
 */
#ifndef SPH_MACHINE_RECORDS_H
#define SPH_MACHINE_RECORDS_H

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

#endif
