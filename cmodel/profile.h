/* profile.h - the widths that fix what accuracy costs (docs/number_formats.md)
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_PROFILE_H
#define SPH_PROFILE_H

/* All widths in bits. W + 1 <= WD, so that light - point is an exact direction. */
struct sph_profile {
    const char *name;
    int w;  /* coordinate, two's complement grid units */
    int wd; /* direction component, two's complement */
    int pq; /* significant bits of the quotient t */
    int ng; /* guard bits of the hit point that only the normal sees */
    int fw; /* node filter coordinate: the top fw of the w bits */
};

enum { SPH_DRAFT, SPH_STANDARD, SPH_FINE, SPH_REFERENCE, SPH_PROFILES };

extern const struct sph_profile sph_profiles[SPH_PROFILES];

/* Index of the profile called name, or -1. */
int sph_profile_find(const char *name);

#endif
