/* profile.c - see profile.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "profile.h"

#include <string.h>

#include "machine/layout.h"

const struct sph_profile sph_profiles[SPH_PROFILES] = {SPH_PROFILE_TABLE};

int sph_profile_find(const char *name) {
    for (int i = 0; i < SPH_PROFILES; i++)
        if (!strcmp(name, sph_profiles[i].name)) return i;
    return -1;
}
