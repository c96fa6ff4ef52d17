/* material.c - see material.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "shade/material.h"

#include "math/fx.h"
#include "shade/colour.h"

enum { ONE = 256 };

/* A share of the record, u1.8: more than 1 counts as 1. */
static uint32_t share(const uint32_t *prim, int lsb, int bits) {
    uint32_t s = sph_field(prim, lsb, bits);
    return s < ONE ? s : ONE;
}

uint32_t sph_shading_mirror(const uint32_t *prim) {
    return share(prim, SPH_PRIM_KR_LSB, SPH_PRIM_KR_BITS);
}

struct sph_shading sph_shading_read(const struct sph_machine *m, const uint32_t *prim) {
    struct sph_shading l = {.ka = ONE, .kd = ONE};
    for (int i = 0; i < 3; i++)
        l.rgb[i] = sph_field(prim, SPH_PRIM_RED_LSB + 8 * i, 8);
    if (sph_machine_effect(m, SPH_EFFECT_REFLECT)) l.kr = sph_shading_mirror(prim);
    if (sph_machine_effect(m, SPH_EFFECT_REFRACT)) {
        l.kt = share(prim, SPH_PRIM_KT_LSB, SPH_PRIM_KT_BITS);
        l.index = sph_field(prim, SPH_PRIM_INDEX_LSB, SPH_PRIM_INDEX_BITS);
    }
    if (!sph_machine_effect(m, SPH_EFFECT_SUM)) return l;
    l.sum = (int)sph_field(prim, SPH_PRIM_SUM_LSB, SPH_PRIM_SUM_BITS);
    if (!l.sum) return l;
    l.ka = share(prim, SPH_PRIM_KA_LSB, SPH_PRIM_KA_BITS);
    l.kd = share(prim, SPH_PRIM_KD_LSB, SPH_PRIM_KD_BITS);
    if (sph_machine_effect(m, SPH_EFFECT_SPECULAR)) {
        l.ks = sph_field(prim, SPH_PRIM_KS_LSB, SPH_PRIM_KS_BITS);
        l.power = sph_field(prim, SPH_PRIM_POWER_LSB, SPH_PRIM_POWER_BITS);
    }
    return l;
}

void sph_shading_note(struct sph_stages *s, const struct sph_shading *l) {
    SPH_NOTE(s, SPH_STAGE_MATERIAL, 0, SPH_THREE(l->rgb), l->kr, l->kt, l->sum, l->ka, l->kd, l->ks,
             l->power, l->index);
}

uint32_t sph_shading_worth(uint32_t weight, uint32_t part, uint32_t least) {
    return sph_share(weight, part) >> 8 < least ? 0 : part;
}

uint32_t sph_shading_light(const struct sph_shading *shading, uint32_t ambient, uint32_t lights) {
    uint32_t sum = (uint32_t)(sph_round((int64_t)shading->ka * ambient, 8) +
                              sph_round((int64_t)shading->kd * lights, 8));
    return sum < 131071 ? sum : 131071;
}

uint32_t sph_shading_own(const struct sph_shading *shading, uint32_t kr, uint32_t kt) {
    if (shading->sum) return ONE;
    return kr + kt < ONE ? ONE - kr - kt : 0;
}
