/* materials.c - what materials call for; see effects.h, docs/design/builder.md
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/effects/effects.h"
#include "builder/emit.h"

#define WHY(entry, ...) sph_note((entry)->why, sizeof(entry)->why, __VA_ARGS__)

static int is_sum(const struct sph_material *material) {
    return material->sum.on;
}

static int passes(const struct sph_material *material) {
    return material->passes;
}

/* The used material for which `weight` is the largest, the first of equals; NULL if all are 0.
 * met: of those that rays of the frame meet. */
static const struct sph_material *best(const struct sph_survey *s,
                                       int (*weight)(const struct sph_material *), int met) {
    const struct sph_scene *scene = s->scene;
    const struct sph_world *w = &s->world;
    const struct sph_material *best = NULL;
    for (uint32_t id = 0; id < w->n + w->facets->n; id++) {
        struct sph_grid_prim prim = sph_grid_prim_of(w->balls, w->n, w->facets, id);
        const struct sph_material *m =
            &scene->materials[sph_grid_appearance(scene, &prim).material];
        if (m == best || weight(m) <= (best ? weight(best) : 0)) continue;
        if (!met || !sph_is_unmet(scene, s->options, &prim)) best = m;
    }
    return best;
}

static const char UNMET[] = "no ray of this frame meets it";
static const char UNLEFT[] = "no ray of this frame leaves it";

/* What calls for an effect; if rays of the frame meet none of it, *unmet, what they do not meet. */
static const struct sph_material *caller(const struct sph_survey *s,
                                         int (*weight)(const struct sph_material *), int *unmet) {
    const struct sph_material *met = best(s, weight, 1), *any = met ? met : best(s, weight, 0);
    *unmet = any && !met;
    return any;
}

static struct sph_place place(const struct sph_survey *s, const struct sph_material *m) {
    return sph_place_of(s->scene, (uint32_t)m->line, "material",
                        (uint32_t)(m - s->scene->materials));
}

void sph_find_reflect(const struct sph_survey *s, struct sph_effect_report *entry) {
    int depth = s->options->max_depth, asked = s->options->reflect, unmet;
    const struct sph_material *mirror = caller(s, sph_material_kr, &unmet);
    if (!mirror)
        WHY(entry, "no used material mirrors (ks is 0)");
    else
        WHY(entry, "%s mirrors %d/256, depth %d", place(s, mirror).text, sph_material_kr(mirror),
            depth);
    entry->called = mirror ? depth : 0;
    if (mirror && depth && (unmet || !sph_depth(s->options)))
        sph_leave_out(entry, unmet ? UNMET : UNLEFT);
    sph_settle(entry, asked == SPH_ON ? depth : asked);
}

int sph_find_refract(const struct sph_survey *s, struct sph_effect_report *entry,
                     struct sph_error *err) {
    int depth = s->options->max_depth, unmet;
    const struct sph_material *glass = caller(s, sph_material_kt, &unmet);
    if (!glass)
        WHY(entry, "no used material transmits");
    else
        WHY(entry, "%s transmits %d/256, depth %d", place(s, glass).text, sph_material_kt(glass),
            depth);
    entry->called = glass && depth;
    if (glass && depth && (unmet || !sph_depth(s->options)))
        sph_leave_out(entry, unmet ? UNMET : UNLEFT);
    sph_settle(entry, s->options->refract);
    if (!entry->on) return 0;
    struct sph_place at = {""};
    if (glass) at = place(s, glass);
    const char *where = glass ? at.text : s->scene->path;
    if (s->options->traverse == SPH_BUILD_FIRST)
        return sph_fail(err, "%s: traverse first is for scenes without refraction", where);
    if (s->options->inside == SPH_OFF)
        return sph_fail(err, "%s: refract: it needs inside, which is off", where);
    if (s->world.profile->wd > SPH_REFRACT_WD)
        return sph_fail(err, "%s: refract: wd is %d, at most %d", where, s->world.profile->wd,
                        SPH_REFRACT_WD);
    return 0;
}

void sph_find_specular(const struct sph_survey *s, const struct sph_lights *lights,
                       struct sph_effect_report *entry) {
    int unmet;
    const struct sph_material *shiny = caller(s, sph_material_ks, &unmet);
    if (!shiny)
        WHY(entry, "no used material has highlights");
    else if (!lights->n_shining)
        WHY(entry, "no light shines");
    else
        WHY(entry, "%s has highlights of %d/255, power %g", place(s, shiny).text,
            sph_material_ks(shiny), shiny->shine);
    entry->called = shiny && lights->n_shining;
    if (unmet && lights->n_shining) sph_leave_out(entry, UNMET);
    sph_settle(entry, s->options->specular);
}

void sph_find_sum(const struct sph_survey *s, struct sph_effect_report *entry) {
    int unmet;
    const struct sph_material *sum = caller(s, is_sum, &unmet);
    entry->called = sum != NULL;
    if (sum)
        WHY(entry, "%s is shaded by Whitted's sum", place(s, sum).text);
    else
        WHY(entry, "every used material blends");
    if (unmet) sph_leave_out(entry, UNMET);
    entry->on = entry->called;
}

/* Whether CLEAR is left out. */
static int unpassed(const struct sph_survey *s) {
    return s->options->clear == SPH_AUTO && s->options->unmet && s->options->unmet->clear;
}

int sph_may_pass(const struct sph_survey *s) {
    return s->options->clear != SPH_OFF && !unpassed(s) && best(s, passes, 0);
}

void sph_find_clear(const struct sph_survey *s, int shadow, struct sph_effect_report *entry) {
    const struct sph_material *clear = best(s, passes, 0);
    entry->called = clear && shadow;
    if (!clear)
        WHY(entry, "no used material lets shadow rays pass");
    else
        WHY(entry, "%s lets shadow rays pass%s", place(s, clear).text,
            shadow ? "" : ", but there are none");
    if (entry->called && unpassed(s)) sph_leave_out(entry, "no ray of this frame passes it");
    sph_settle(entry, s->options->clear);
    if (entry->on && !shadow) sph_drop(entry, "it needs shadow, which is off");
}
