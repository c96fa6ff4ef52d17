/* colours.c - real numbers to the machine's colours and weights; see emit.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "build/effects.h"
#include "build/emit.h"

void sph_note(char *text, size_t size, const char *format, ...) {
    size_t used = strlen(text);
    va_list ap;
    va_start(ap, format);
    vsnprintf(text + used, size - used, format, ap);
    va_end(ap);
}

int sph_material_kr(const struct sph_material *material) {
    return (int)lround(256 * fmin(fmax(material->ks, 0), 1));
}

double sph_material_weight(const struct sph_material *material) {
    double ks = fmin(fmax(material->ks, 0), 1), kd = fmax(material->kd, 0);
    return fmin(1, ks < 1 ? kd / (1 - ks) : kd);
}

int32_t sph_u1_15(double c, int *clamped) {
    double limit = 65535.0 / SPH_COLOUR_ONE;
    *clamped += c > limit || c < 0;
    return (int32_t)lround(SPH_COLOUR_ONE * fmin(fmax(c, 0), limit));
}

void sph_emit_colours(const struct sph_scene *scene, struct sph_machine *machine,
                      struct sph_build_report *report) {
    int32_t *regs = machine->regs;
    int clamped = 0;
    for (int i = 0; i < 3; i++) {
        double c = fmin(fmax(scene->background[i], 0), 1);
        regs[SPH_REG_AMBIENT_R + i] = sph_u1_15(scene->ambient[i], &clamped);
        regs[SPH_REG_BG_COLOUR] |= (int32_t)(lround(255 * c) << 8 * i);
    }
    if (clamped)
        sph_note(report->warning, sizeof report->warning,
                 "%s: %d ambient colours are outside 0..1.99997 and were clamped\n", scene->path,
                 clamped);
}
