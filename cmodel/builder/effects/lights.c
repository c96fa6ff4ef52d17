/* lights.c - which lights the machine gets; see effects.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdio.h>

#include "builder/effects/effects.h"
#include "builder/emit.h"
#include "builder/grid/light.h"

/* Why a light of the scene reaches nothing; 0 if it may reach something. */
static int explain_dark(const struct sph_survey *s, int light, int shadow, char *why, size_t size) {
    const struct sph_light *lamp = &s->scene->lights[light];
    int32_t at[3];
    if (s->options->unmet && s->options->unmet->lights >> light & 1) {
        sph_note(why, size, "left out: %s lights nothing that this frame shows",
                 sph_light_place(s->scene, light).text);
        return 1;
    }
    if (sph_light_black(lamp)) {
        sph_note(why, size, "%s is black", sph_light_place(s->scene, light).text);
        return 1;
    }
    if (!shadow || s->refracts || s->passes) return 0;    /* what shuts it in may be seen through */
    if (sph_grid_light(s->grid, lamp->pos, at)) return 0; /* far away from all spheres */
    uint32_t ball = sph_dark_ball(&s->world, at);
    if (ball == s->world.n) return 0;
    sph_note(why, size, "%s is shut in by the sphere %s", sph_light_place(s->scene, light).text,
             sph_sphere_place(s->scene, ball).text);
    return 1;
}

void sph_choose_lights(const struct sph_survey *s, struct sph_lights *lights,
                       struct sph_effect_report *report) {
    int n = s->scene->n_lights, asked = s->options->lights;
    char dark[sizeof report->why] = "";
    *lights = (struct sph_lights){0};
    for (int l = 0; l < n; l++) {
        char why[sizeof report->why] = "";
        int shines = !explain_dark(s, l, s->options->shadow != SPH_OFF, why, sizeof why);
        int taken = asked == SPH_AUTO ? shines : l < asked;
        if (!shines) sph_note(dark, sizeof dark, "; %s", why);
        if (shines && !taken)
            sph_note(dark, sizeof dark, "; left out: %s", sph_light_place(s->scene, l).text);
        if (taken) lights->index[lights->count++] = l;
        if (taken && shines) lights->shining[lights->n_shining++] = l;
        lights->called += shines;
    }
    report->on = lights->count;
    report->called = lights->called;
    report->left_out = asked == SPH_AUTO && s->options->unmet && s->options->unmet->lights;
    if (asked != SPH_AUTO) sph_note(report->why, sizeof report->why, "as asked; ");
    sph_note(report->why, sizeof report->why, n ? "%d of the scene's %d" : "the scene has none",
             lights->count, n);
    sph_note(report->why, sizeof report->why, "%s", dark);
}

void sph_emit_lights(const struct sph_survey *s, const struct sph_lights *lights,
                     struct sph_machine *machine, struct sph_build_report *report) {
    machine->regs[SPH_REG_N_LIGHTS] = lights->count;
    for (int l = 0; l < lights->count; l++) {
        const struct sph_light *lamp = &s->scene->lights[lights->index[l]];
        report->lights[l] = lights->index[l];
        int32_t *regs = machine->regs + SPH_REG_LIGHT0_X + SPH_LIGHT_STRIDE * l, at[3];
        int shift = sph_grid_light(s->grid, lamp->pos, at);
        for (int i = 0; i < 3; i++) {
            regs[i] = at[i];
            regs[SPH_REG_LIGHT0_R - SPH_REG_LIGHT0_X + i] = sph_u1_15(lamp->rgb[i]);
        }
        regs[SPH_REG_LIGHT0_R - SPH_REG_LIGHT0_X] |= shift << SPH_LIGHT_SHIFT_LSB;
    }
}
