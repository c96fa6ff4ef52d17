/* kinds.h - what is known of a kind of primitive by its number alone; kinds stand in machine.def
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_MACHINE_KINDS_H
#define SPH_MACHINE_KINDS_H

#include <stdint.h>

#include "machine/layout.h"

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
