/* known.c - see known.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "trial/known.h"

#include <string.h>

#include "trial/known_table.h"

const struct sph_known_core *sph_known_core(const char *profile, const char *effects, int pipes) {
    static const struct sph_known_core cores[] = {SPH_KNOWN_CORES};
    for (size_t i = 0; i < sizeof cores / sizeof *cores; i++)
        if (!strcmp(cores[i].profile, profile) && !strcmp(cores[i].effects, effects) &&
            cores[i].pipes == pipes)
            return &cores[i];
    return NULL;
}
