/* prim.c - see prim.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "scene/prim.h"

#include <string.h>

#define EXTERN(name) extern const struct sph_prim_scene sph_prim_scene_##name;
SPH_EACH_KIND(EXTERN)
#define KIND(name) &sph_prim_scene_##name,
static const struct sph_prim_scene *const kinds[SPH_KINDS] = {SPH_EACH_KIND(KIND)};

const struct sph_prim_scene *sph_prim_scene_of(uint32_t kind) {
    return kinds[kind];
}

const struct sph_nff_word *sph_prim_word(const char *word) {
    for (int kind = 0; kind < SPH_KINDS; kind++)
        for (const struct sph_nff_word *w = kinds[kind]->words; w->word; w++)
            if (!strcmp(w->word, word)) return w;
    return NULL;
}
