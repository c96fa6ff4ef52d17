/* colours.c - real numbers to the machine's colours and weights; see emit.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "builder/effects/effects.h"
#include "builder/emit.h"
#include "scene/nesting.h"

void sph_note(char *text, size_t size, const char *format, ...) {
    size_t used = strlen(text);
    va_list ap;
    va_start(ap, format);
    vsnprintf(text + used, size - used, format, ap);
    va_end(ap);
}

/* A share of 0..1 in parts of one. */
static int share(double value, int one) {
    return (int)lround(one * fmin(fmax(value, 0), 1));
}

int sph_material_kr(const struct sph_material *material) {
    return share(material->sum.on ? material->sum.kr : material->ks, 256);
}

int sph_material_kt(const struct sph_material *material) {
    return material->sum.on ? share(material->trans, 256) : 0;
}

int sph_material_ks(const struct sph_material *material) {
    return material->sum.on ? share(material->ks, 255) : 0;
}

/* A number of low..high in parts of one, limited to them. */
static uint32_t between(double value, int one, int low, int high) {
    return (uint32_t)lround(fmin(fmax(one * value, low), high));
}

void sph_emit_sum(uint32_t *line, const struct sph_material *m) {
    uint32_t ks = (uint32_t)sph_material_ks(m), kt = (uint32_t)sph_material_kt(m);
    sph_field_set(line, SPH_PRIM_SUM_LSB, SPH_PRIM_SUM_BITS, 1);
    sph_field_set(line, SPH_PRIM_KA_LSB, SPH_PRIM_KA_BITS, (uint32_t)share(m->sum.ka, 256));
    sph_field_set(line, SPH_PRIM_KD_LSB, SPH_PRIM_KD_BITS, (uint32_t)share(m->kd, 256));
    sph_field_set(line, SPH_PRIM_KS_LSB, SPH_PRIM_KS_BITS, ks);
    sph_field_set(line, SPH_PRIM_KT_LSB, SPH_PRIM_KT_BITS, kt);
    if (ks)
        sph_field_set(line, SPH_PRIM_POWER_LSB, SPH_PRIM_POWER_BITS,
                      between(m->shine, SPH_POWER_ONE, SPH_POWER_ONE * SPH_SHINE_MIN,
                              SPH_POWER_ONE * SPH_SHINE_MAX));
    if (kt)
        sph_field_set(line, SPH_PRIM_INDEX_LSB, SPH_PRIM_INDEX_BITS,
                      between(sph_index_ratio(m), SPH_INDEX_ONE, SPH_INDEX_MIN, SPH_INDEX_MAX));
}

double sph_material_weight(const struct sph_material *material) {
    if (material->sum.on) return 1;
    double ks = fmin(fmax(material->ks, 0), 1), kd = fmax(material->kd, 0);
    return fmin(1, ks < 1 ? kd / (1 - ks) : kd);
}

int32_t sph_u1_15(double c) {
    return (int32_t)lround(SPH_COLOUR_ONE * fmin(fmax(c, 0), SPH_COLOUR_MOST));
}

void sph_emit_colours(const struct sph_scene *scene, struct sph_machine *machine) {
    int32_t *regs = machine->regs;
    for (int i = 0; i < 3; i++) {
        double c = fmin(fmax(scene->background[i], 0), 1);
        regs[SPH_REG_AMBIENT_R + i] = sph_u1_15(scene->ambient[i]);
        regs[SPH_REG_BG_COLOUR] |= (int32_t)(lround(255 * c) << 8 * i);
    }
}
