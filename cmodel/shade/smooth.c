/* smooth.c - see smooth.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "shade/smooth.h"

#include <stddef.h>

#include "math/fx.h"
#include "machine/records.h"

void sph_smooth_normal(const struct sph_profile *p, const uint32_t *record,
                       const int64_t guarded[3], int64_t normal[3]) {
    int e = (int)sph_field(record, SPH_SMOOTH_E_LSB, SPH_SMOOTH_E_BITS), limited;
    int64_t d[3]; /* s(W+NG) */
    for (int k = 0; k < 3; k++) {
        int64_t base = sph_field_signed(
            record, SPH_SMOOTH_B_X_LSB + (SPH_SMOOTH_B_Y_LSB - SPH_SMOOTH_B_X_LSB) * k, p->w);
        d[k] = sph_saturate(guarded[k] - base * (1 << p->ng), p->w + p->ng, &limited);
    }
    for (int i = 0; i < 3; i++) {
        int64_t sum = 0; /* s(W+NG+16) */
        for (int k = 0; k < 3; k++)
            sum += d[k] * sph_field_signed(record,
                                           SPH_SMOOTH_M_XX_LSB + SPH_SMOOTH_M_STEP * (3 * i + k),
                                           SPH_SMOOTH_M_XX_BITS);
        int64_t n = sph_field_signed(
            record, SPH_SMOOTH_N_X_LSB + (SPH_SMOOTH_N_Y_LSB - SPH_SMOOTH_N_X_LSB) * i,
            SPH_SMOOTH_N_X_BITS);
        normal[i] = sph_saturate(n + sph_round(sum, e), SPH_SMOOTH_BITS, &limited);
    }
}

const uint32_t *sph_smooth_record(const struct sph_machine *m, const uint32_t *prim, int *outside) {
    uint32_t number = sph_field(prim, SPH_PRIM_SMOOTH_LSB, SPH_PRIM_SMOOTH_BITS);
    *outside = 0;
    if (!sph_machine_effect(m, SPH_EFFECT_SMOOTH) || sph_prim_kind(m, prim) == SPH_SPHERE ||
        !number)
        return NULL;
    uint64_t line = (uint64_t)(uint32_t)m->regs[SPH_REG_SMOOTH_BASE] + number - 1;
    if (line < (uint32_t)m->regs[SPH_REG_MEM_LINES]) return sph_line(m, line);
    *outside = 1;
    return NULL;
}
