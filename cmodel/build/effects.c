/* effects.c - colours, lights and which effects a scene needs; see emit.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

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

/* lround(32768 * c) for c in [0, 65535/32768]; *clamped counts what was outside. */
static int32_t u1_15(double c, int *clamped) {
    double limit = 65535.0 / SPH_COLOUR_ONE;
    *clamped += c > limit || c < 0;
    return (int32_t)lround(SPH_COLOUR_ONE * fmin(fmax(c, 0), limit));
}

void sph_emit_colours(const struct sph_scene *scene, const struct sph_grid *grid,
                      struct sph_machine *machine, struct sph_build_report *report) {
    int32_t *regs = machine->regs;
    int clamped = 0;
    regs[SPH_REG_N_LIGHTS] = scene->n_lights;
    for (int l = 0; l < scene->n_lights; l++) {
        int32_t at[3];
        sph_grid_point(grid, scene, scene->lights[l].pos, at);
        for (int i = 0; i < 3; i++) {
            regs[SPH_REG_LIGHT0_X + SPH_LIGHT_STRIDE * l + i] = at[i];
            regs[SPH_REG_LIGHT0_R + SPH_LIGHT_STRIDE * l + i] =
                u1_15(scene->lights[l].rgb[i], &clamped);
        }
    }
    for (int i = 0; i < 3; i++) {
        double c = fmin(fmax(scene->background[i], 0), 1);
        regs[SPH_REG_AMBIENT_R + i] = u1_15(scene->ambient[i], &clamped);
        regs[SPH_REG_BG_COLOUR] |= (int32_t)(lround(255 * c) << 8 * i);
    }
    if (clamped)
        sph_note(report->warning, sizeof report->warning,
                 "%s: %d light or ambient colours are outside 0..1.99997 and were clamped\n",
                 scene->path, clamped);
}

/* The used material with the largest mirror weight; NULL if none has any. */
static const struct sph_material *best_mirror(const struct sph_scene *scene) {
    const struct sph_material *best = NULL;
    for (uint32_t i = 0; i < scene->n_spheres; i++) {
        const struct sph_material *m = &scene->materials[scene->spheres[i].material];
        if (m != best && sph_material_kr(m) > (best ? sph_material_kr(best) : 0)) best = m;
    }
    return best;
}

/* Whether shadows are on; the reason goes to the report. */
static int shadow(const struct sph_scene *scene, int asked, int eye_inside,
                  struct sph_build_report *report) {
    char *text = report->effects;
    size_t size = sizeof report->effects;
    if (asked >= 0)
        sph_note(text, size, "shadow %s: as asked\n", asked ? "on" : "off");
    else if (!scene->n_lights)
        sph_note(text, size, "shadow off: no lights\n");
    else if (scene->n_spheres >= 2)
        sph_note(text, size, "shadow on: %d light%s and %u spheres\n", scene->n_lights,
                 scene->n_lights > 1 ? "s" : "", scene->n_spheres);
    else if (scene->n_spheres && eye_inside)
        sph_note(text, size, "shadow on: the eye is inside a sphere\n");
    else
        sph_note(text, size, "shadow off: %u sphere%s cast none\n", scene->n_spheres,
                 scene->n_spheres == 1 ? "" : "s");
    if (asked >= 0) return asked;
    return scene->n_lights && (scene->n_spheres >= 2 || (scene->n_spheres && eye_inside));
}

/* Whether reflections are on; the reason goes to the report. */
static int reflect(const struct sph_scene *scene, int asked, int max_depth,
                   struct sph_build_report *report) {
    const struct sph_material *mirror = best_mirror(scene);
    char *text = report->effects;
    size_t size = sizeof report->effects;
    if (!max_depth)
        sph_note(text, size, "reflect off: no reflection is to be followed\n");
    else if (asked >= 0)
        sph_note(text, size, "reflect %s: as asked, depth %d\n", asked ? "on" : "off", max_depth);
    else if (mirror)
        sph_note(text, size, "reflect on: %s:%d mirrors %d/256, depth %d\n", scene->path,
                 mirror->line, sph_material_kr(mirror), max_depth);
    else
        sph_note(text, size, "reflect off: no used material mirrors (ks is 0)\n");
    if (!max_depth || asked >= 0) return max_depth && asked;
    return mirror != NULL;
}

void sph_emit_effects(const struct sph_scene *scene, const struct sph_build_options *options,
                      int eye_inside, struct sph_machine *machine,
                      struct sph_build_report *report) {
    int with_shadow = shadow(scene, options->shadow, eye_inside, report);
    int with_reflect = reflect(scene, options->reflect, options->max_depth, report);
    machine->regs[SPH_REG_EFFECTS] = with_shadow << SPH_EFFECT_SHADOW |
                                     with_reflect << SPH_EFFECT_REFLECT | 1 << SPH_EFFECT_INSIDE;
    machine->regs[SPH_REG_MAX_DEPTH] = with_reflect ? options->max_depth : 0;
}
