/* profile.h - the widths that fix what accuracy costs (docs/reference/machine_file.md)
 * SPDX-License-Identifier: Apache-2.0
 *
 * Four profiles have names. Any other is written as one of them with widths of its own,
 * NAME:key=value,... such as "standard:pq=12,ng=1"; keys are the fields below.
 */
#ifndef SPH_PROFILE_H
#define SPH_PROFILE_H

#include <stdint.h>

#include "common/error.h"

/* All widths in bits. W + 1 <= WD, so that light - point is an exact direction. */
struct sph_profile {
    char name[64];
    int w;  /* coordinate, two's complement grid units */
    int wd; /* direction component, two's complement */
    int pq; /* significant bits of the quotient t */
    int ng; /* guard bits of the hit point that only the normal sees */
    int fw; /* node filter coordinate: the top fw of the w bits */
    int pr; /* significant bits of the root; 0: all w + wd */
};

enum { SPH_DRAFT, SPH_STANDARD, SPH_FINE, SPH_REFERENCE, SPH_PROFILES };

extern const struct sph_profile sph_profiles[SPH_PROFILES];

/* Index of the profile called name, or -1. */
int sph_profile_find(const char *name);

/* Reads NAME or NAME:key=value,...; widths that are those of a named profile get its name. -1 with
 * a message for unknown names and keys, and for widths that model or RTL cannot hold. */
int sph_profile_parse(const char *text, struct sph_profile *p, struct sph_error *err);

/* -1 with the width and the reason if model or RTL cannot hold the widths. */
int sph_profile_check(const struct sph_profile *p, struct sph_error *err);

/* Register PROFILE (machine.def), and back; unpacking gives the name too: that of the named profile
 * with the fewest other widths, the first of equals, and these. */
uint32_t sph_profile_pack(const struct sph_profile *p);
struct sph_profile sph_profile_unpack(uint32_t packed);

/* D, the least screen distance of primary rays, hence the least |dir| of a ray whose point is
 * needed: a mirror ray has a component of WD-1 bits, 2^(WD-2) >= D. So
 * t < (sqrt(3) + 1) 2^W / D < 2^(W+1.45) / D, and since mant >= 2^(PQ-2),
 * 2^exp = mant / t > 2^(NG-0.45): exp >= NG, t * dir is shifted right only. */
int64_t sph_min_screen(const struct sph_profile *p);

#endif
