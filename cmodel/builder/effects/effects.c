/* effects.c - which effects a scene calls for, and which the machine gets; see effects.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * Each effect that is off is proved to change no pixel of this scene: docs/design/builder.md.
 */
#include "builder/effects/effects.h"

#include "builder/emit.h"
#include "builder/grid/light.h"

#define WHY(entry, ...) sph_note((entry)->why, sizeof(entry)->why, __VA_ARGS__)

static void find_shadow(const struct sph_survey *s, const struct sph_lights *lights,
                        struct sph_effect_report *entry) {
    int32_t at[SPH_MAX_LIGHTS][3];
    struct sph_witness w;
    int far = -1;
    for (int l = 0; l < lights->n_shining; l++)
        if (sph_grid_light(s->grid, s->scene->lights[lights->shining[l]].pos, at[l]))
            far = lights->shining[l];
    int any = s->world.n > 0 || s->world.facets->n > 0;
    if (!lights->n_shining || !any) {
        WHY(entry, any ? "no light shines" : "there is no sphere");
        return;
    }
    if (s->refracts) {
        entry->called = 1;
        WHY(entry, "what refracts is seen from inside too, and shades itself");
        return;
    }
    if (s->passes) {
        entry->called = 1;
        WHY(entry, "what shadow rays pass hides nothing behind it");
        return;
    }
    if (s->world.facets->n) {
        sph_find_facet_shadow(s, entry);
        return;
    }
    if (far >= 0) {
        entry->called = 1;
        WHY(entry, "the light %s is far away", sph_light_place(s->scene, far).text);
        return;
    }
    int how = sph_occlusion(&s->world, (const int32_t(*)[3])at, lights->n_shining, &w);
    entry->called = how != SPH_NOTHING_OCCLUDES;
    if (how == SPH_OCCLUDES)
        WHY(entry, "the sphere %s may shade %s from the light %s",
            sph_sphere_place(s->scene, w.occluder).text,
            sph_sphere_place(s->scene, w.receiver).text,
            sph_light_place(s->scene, lights->shining[w.light]).text);
    else if (how == SPH_OCCLUDES_OWN)
        WHY(entry, "the sphere %s is around the eye, the light %s outside of it",
            sph_sphere_place(s->scene, w.occluder).text,
            sph_light_place(s->scene, lights->shining[w.light]).text);
    else if (how == SPH_OCCLUDES_UNSURE)
        WHY(entry, "there are too many spheres to try every pair");
    else
        WHY(entry, "no sphere can come between a light and what it lights");
}

/* Two spheres that are near each other. 1, 0, or -1. */
static int find_near(const struct sph_survey *s, struct sph_effect_report *entry,
                     struct sph_error *err) {
    static const char *const how[] = {"", "nearly touch", "touch", "overlap", "are one in another"};
    const struct sph_world *w = &s->world;
    uint32_t pair[2];
    int found = sph_near_pair(w->balls, w->n, w->profile, pair, err);
    if (found < 0) return -1;
    if (found)
        WHY(entry, "the spheres %s and %s %s", sph_sphere_place(s->scene, pair[0]).text,
            sph_sphere_place(s->scene, pair[1]).text,
            how[sph_nearness(&w->balls[pair[0]], &w->balls[pair[1]], w->profile)]);
    else if (w->n < 2)
        WHY(entry, w->n ? "there is only one sphere" : "there is no sphere");
    else
        WHY(entry, "no two spheres come within %.4g grid units",
            (double)sph_point_error(w->profile) / (double)(1 << sph_error_bits(w->profile)));
    return found;
}

/* INSIDE, FIRST and INTERPENETRATE: all hang on spheres that are near each other. */
static int find_inside(const struct sph_survey *s, struct sph_build_report *report,
                       struct sph_error *err) {
    struct sph_effect_report *inside = &report->effects[SPH_REPORT_INSIDE],
                             *first = &report->effects[SPH_REPORT_FIRST],
                             *cut = &report->effects[SPH_REPORT_INTERPENETRATE], near = {0};
    const struct sph_build_options *o = s->options;
    uint32_t around = sph_eye_ball(&s->world);
    near.called = find_near(s, &near, err);
    if (near.called < 0) return -1;

    first->on = first->called = o->traverse == SPH_BUILD_FIRST;
    WHY(first, first->on ? "as asked: a primary ray ends at the first visit that hits"
                         : "the nearest hit is looked for");

    cut->called = first->on && near.called;
    WHY(cut, "%s", first->on ? near.why : "the nearest hit is right where spheres overlap");
    sph_settle(cut, o->interpenetrate);
    if (cut->on && o->inside == SPH_OFF) { /* not as asked: that is refused */
        cut->on = 0;
        WHY(cut, "; but it needs inside, which is off as asked");
    }

    inside->called = around < s->world.n || near.called;
    if (around < s->world.n)
        WHY(inside, "the eye is in the sphere %s", sph_sphere_place(s->scene, around).text);
    else if (!near.called && sph_find_facet_inside(s, inside))
        inside->called = 1;
    else
        WHY(inside, "%s%s", near.why, near.called || !s->world.n ? "" : ", and the eye is in none");
    if (inside->called && o->unmet && o->unmet->inside)
        sph_leave_out(inside, "no ray of this frame starts in one");
    sph_settle(inside, o->inside);
    if (cut->on && !inside->on) {
        inside->on = 1;
        inside->left_out = 0;
        WHY(inside, "; interpenetrate needs it");
    }
    if (s->refracts && !inside->on) {
        inside->on = 1;
        inside->left_out = 0;
        WHY(inside, "; refract needs it");
    }
    return 0;
}

/* An effect that no material, light or sphere calls for. */
static void find_none(const struct sph_survey *s, int effect, struct sph_build_report *report) {
    WHY(&report->effects[effect], "nothing of a scene calls for it");
    sph_settle(&report->effects[effect], s->options->asked[effect]);
}

/* Warns of what is called for and left out; lights are counted by those that shine. */
static void warn_missing(const struct sph_scene *scene, const struct sph_lights *lights,
                         struct sph_build_report *report) {
    for (int i = 0; i < SPH_REPORTS; i++) {
        const struct sph_effect_report *e = &report->effects[i];
        if ((i == SPH_REPORT_LIGHTS ? lights->n_shining : e->on) < e->called)
            sph_note(report->warning, sizeof report->warning, "%s: %s %s: %s\n", scene->path,
                     e->name, e->on ? "fewer than the scene calls for" : "off", e->why);
    }
}

int sph_emit_effects(const struct sph_survey *survey, struct sph_machine *machine,
                     struct sph_build_report *report, struct sph_error *err) {
    struct sph_effect_report *effects = report->effects;
    struct sph_survey found = *survey, *s = &found;
    struct sph_lights lights;
    int32_t *regs = machine->regs;
    for (int i = 0; i < SPH_REPORTS; i++)
        effects[i] = (struct sph_effect_report){.name = sph_parts[i].word};
    if (sph_find_refract(s, &effects[SPH_REPORT_REFRACT], err)) return -1;
    s->refracts = effects[SPH_REPORT_REFRACT].on;
    s->passes = sph_may_pass(s);
    sph_choose_lights(s, &lights, &effects[SPH_REPORT_LIGHTS]);
    sph_emit_lights(s, &lights, machine, report);
    find_shadow(s, &lights, &effects[SPH_REPORT_SHADOW]);
    if (effects[SPH_REPORT_SHADOW].called && s->options->unmet && s->options->unmet->shadow)
        sph_leave_out(&effects[SPH_REPORT_SHADOW],
                      "nothing that this frame shows lies in a shadow");
    sph_settle(&effects[SPH_REPORT_SHADOW], s->options->shadow);
    sph_find_clear(s, effects[SPH_REPORT_SHADOW].on, &effects[SPH_REPORT_CLEAR]);
    sph_find_reflect(s, &effects[SPH_REPORT_REFLECT]);
    sph_find_specular(s, &lights, &effects[SPH_REPORT_SPECULAR]);
    sph_find_sum(s, &effects[SPH_REPORT_SUM]);
    if (effects[SPH_REPORT_SPECULAR].on) effects[SPH_REPORT_SUM].on = 1; /* it is part of it */
    if (find_inside(s, report, err)) return -1;
    sph_find_facets(s, &effects[SPH_REPORT_FACETS]);
    sph_find_smooth(s, &effects[SPH_REPORT_SMOOTH]);
    effects[SPH_REPORT_TURNED].on = effects[SPH_REPORT_TURNED].called =
        s->grid->axes == SPH_AXES_SCENE;
    WHY(&effects[SPH_REPORT_TURNED], "the grid has the axes of the %s",
        s->grid->axes == SPH_AXES_SCENE ? "scene" : "camera");
    for (int i = 0; i < SPH_REPORTS; i++)
        if (sph_parts[i].option == SPH_OPTION_WHEN && !effects[i].why[0] && i != SPH_REPORT_SPREAD)
            find_none(s, i, report); /* spread is settled behind textures */
    warn_missing(s->scene, &lights, report);
    regs[SPH_REG_MAX_DEPTH] = s->refracts ? s->options->max_depth : effects[SPH_REPORT_REFLECT].on;
    int least = s->options->least_weight;
    if (least < 0 || least > SPH_LEAST_WEIGHT_MAX)
        return sph_fail(err, "least_weight %d is not in 0..%d", least, SPH_LEAST_WEIGHT_MAX);
    regs[SPH_REG_LEAST_WEIGHT] = regs[SPH_REG_MAX_DEPTH] ? least : 0;
    regs[SPH_REG_EFFECTS] = 0;
    for (int i = 0; i < SPH_REPORTS; i++)
        if (sph_parts[i].bit >= 0) regs[SPH_REG_EFFECTS] |= (effects[i].on > 0) << sph_parts[i].bit;
    return sph_validate_effects(machine, err);
}
