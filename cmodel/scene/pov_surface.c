/* pov_surface.c - materials of a scene for POV-Ray; see pov_surface.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * POV-Ray lessens ambient and diffuse light by what goes through a surface, our rules do not: they
 * are divided by it beforehand.
 */
#include "scene/pov_surface.h"

#include <math.h>
#include <stdlib.h>

#include "common/number.h"
#include "scene/nesting.h"

#define MOST_CLEAR 0.9999 /* of what goes through: the rest carries the light of the surface */

void sph_pov_number(FILE *file, double value) {
    char text[40];
    double back = NAN;
    snprintf(text, sizeof text, "%.15g", value);
    if (sph_parse_number(text, &back) == -1 || back != value)
        snprintf(text, sizeof text, "%.17g", value);
    fputs(text, file);
}

void sph_pov_vector(FILE *file, const double v[3]) {
    for (int i = 0; i < 3; i++) {
        putc(i ? ',' : '<', file);
        sph_pov_number(file, v[i]);
    }
    putc('>', file);
}

static void field(FILE *file, const char *word, double value) {
    fprintf(file, " %s ", word);
    sph_pov_number(file, value);
}

/* Under blend own is 1 - mirror share, under sum 1: what is written is ambient and diffuse light of
 * a surface, the mirror share as it is. */
static void put_material(const struct sph_scene *s, const struct sph_material *m, FILE *f) {
    double kr = m->sum.on ? m->sum.kr : m->ks, kt = sph_material_clear(m) ? m->trans : 0;
    double kd = m->sum.on ? m->kd : kr < 1 ? fmin(1, m->kd / (1 - kr)) : m->kd;
    double through = fmin(kt, MOST_CLEAR), ka = m->sum.on ? m->sum.ka : kd, ambient[3];
    for (int i = 0; i < 3; i++)
        ambient[i] = ka * s->ambient[i] / (1 - through);
    fputs("texture { pigment { rgb ", f);
    sph_pov_vector(f, m->rgb);
    field(f, "transmit", through);
    fputs(" } finish { emission ", f);
    sph_pov_vector(f, ambient);
    if (!m->sum.on && kr > 0) fprintf(f, "*(Whole ? 1 : %.17g)", 1 - kr);
    field(f, "diffuse", kd / (1 - through));
    if (!m->sum.on && kr > 0) fprintf(f, "*(Whole ? 1 : %.17g)", 1 - kr);
    if (m->sum.on && m->ks > 0) {
        field(f, "phong", m->ks);
        field(f, "phong_size", m->shine);
    }
    if (kr > 0) {
        fputs(" reflection {", f);
        field(f, "rgb", kr);
        fputs(" }", f);
    }
    fputs(" } }\n", f);
}

void sph_pov_surfaces(const struct sph_scene *s, FILE *f) {
    fprintf(f, "#declare Looks = array[%u]\n#declare Index = array[%u]\n", s->n_materials + 1,
            s->n_materials + 1);
    for (uint32_t i = 0; i < s->n_materials; i++) {
        fprintf(f, "#declare Looks[%u] = ", i);
        put_material(s, &s->materials[i], f);
        fprintf(f, "#declare Index[%u] = ", i);
        sph_pov_number(f, sph_material_clear(&s->materials[i]) ? sph_index_inside(&s->materials[i])
                                                               : 1);
        fputs(";\n", f);
    }
    fputs("#macro Look(M, N)\n"
          "  #if (Ids) texture { pigment { rgb <mod(N, 256), mod(floor(N / 256), 256),\n"
          "      floor(N / 65536)> / 255 } finish { emission 1 } }\n"
          "  #else texture { Looks[M] } #end\n"
          "#end\n"
          "#macro Inside(M) interior { ior Index[M] } #end\n"
          "#macro Shade() texture { pigment { rgb 0 } } no_image no_reflection #end\n",
          f);
}
