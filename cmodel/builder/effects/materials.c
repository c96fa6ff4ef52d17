/* materials.c - what materials call for; see effects.h, docs/design/builder.md
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/effects/effects.h"
#include "builder/emit.h"
#include "builder/prim/build.h"

#define WHY(entry, ...) sph_note((entry)->why, sizeof(entry)->why, __VA_ARGS__)

static int is_sum(const struct sph_material *material) {
    return material->sum.on;
}

static int passes(const struct sph_material *material) {
    return material->passes;
}

/* The used material for which `weight` is the largest, the first of equals; NULL if all are 0. */
static const struct sph_material *best(const struct sph_survey *s,
                                       int (*weight)(const struct sph_material *)) {
    const struct sph_scene *scene = s->scene;
    const struct sph_world *w = &s->world;
    const struct sph_material *best = NULL;
    for (uint32_t id = 0; id < w->n + w->facets->n; id++) {
        struct sph_grid_prim prim = sph_grid_prim_of(w->balls, w->n, w->facets, id);
        const struct sph_material *m =
            &scene->materials[sph_grid_appearance(scene, &prim).material];
        if (m != best && weight(m) > (best ? weight(best) : 0)) best = m;
    }
    return best;
}

static struct sph_place place(const struct sph_survey *s, const struct sph_material *m) {
    return sph_place_of(s->scene, (uint32_t)m->line, "material",
                        (uint32_t)(m - s->scene->materials));
}

void sph_find_reflect(const struct sph_survey *s, struct sph_effect_report *entry) {
    const struct sph_material *mirror = best(s, sph_material_kr);
    int depth = s->options->max_depth, asked = s->options->reflect;
    if (!mirror)
        WHY(entry, "no used material mirrors (ks is 0)");
    else
        WHY(entry, "%s mirrors %d/256, depth %d", place(s, mirror).text, sph_material_kr(mirror),
            depth);
    entry->called = mirror ? depth : 0;
    sph_settle(entry, asked == SPH_ON ? depth : asked);
}

int sph_find_refract(const struct sph_survey *s, struct sph_effect_report *entry,
                     struct sph_error *err) {
    const struct sph_material *glass = best(s, sph_material_kt);
    int depth = s->options->max_depth;
    if (!glass)
        WHY(entry, "no used material transmits");
    else
        WHY(entry, "%s transmits %d/256, depth %d", place(s, glass).text, sph_material_kt(glass),
            depth);
    entry->called = glass && depth;
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
    const struct sph_material *shiny = best(s, sph_material_ks);
    if (!shiny)
        WHY(entry, "no used material has highlights");
    else if (!lights->n_shining)
        WHY(entry, "no light shines");
    else
        WHY(entry, "%s has highlights of %d/255, power %g", place(s, shiny).text,
            sph_material_ks(shiny), shiny->shine);
    entry->called = shiny && lights->n_shining;
    sph_settle(entry, s->options->specular);
}

void sph_find_sum(const struct sph_survey *s, struct sph_effect_report *entry) {
    const struct sph_material *sum = best(s, is_sum);
    entry->on = entry->called = sum != NULL;
    if (sum)
        WHY(entry, "%s is shaded by Whitted's sum", place(s, sum).text);
    else
        WHY(entry, "every used material blends");
}

int sph_may_pass(const struct sph_survey *s) {
    return s->options->clear != SPH_OFF && best(s, passes);
}

void sph_find_clear(const struct sph_survey *s, int shadow, struct sph_effect_report *entry) {
    const struct sph_material *clear = best(s, passes);
    entry->called = clear && shadow;
    if (!clear)
        WHY(entry, "no used material lets shadow rays pass");
    else
        WHY(entry, "%s lets shadow rays pass%s", place(s, clear).text,
            shadow ? "" : ", but there are none");
    sph_settle(entry, s->options->clear);
    if (entry->on && !shadow) sph_drop(entry, "it needs shadow, which is off");
}
