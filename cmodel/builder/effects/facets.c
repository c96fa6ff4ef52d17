/* facets.c - what triangles and planes call for; see effects.h, docs/design/builder.md
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/effects/effects.h"
#include "builder/emit.h"
#include "builder/smooth.h"
#include "machine/records.h"

#define WHY(entry, ...) sph_note((entry)->why, sizeof(entry)->why, __VA_ARGS__)

static const char *name_of(const struct sph_grid_facet *facet) {
    return sph_kind_name((uint32_t)facet->kind);
}

struct sph_place sph_facet_place(const struct sph_survey *s, uint32_t facet) {
    uint32_t index = s->world.facets->list[facet].scene;
    return sph_place_of(s->scene, s->scene->facets[index].line, "number", index);
}

void sph_find_facets(const struct sph_survey *s, struct sph_effect_report *entry) {
    const struct sph_facets *f = s->world.facets;
    entry->on = entry->called = f->n > 0;
    if (!f->n) WHY(entry, "there is no triangle and no plane");
    for (uint32_t kind = 0; kind < SPH_KINDS; kind++) {
        uint32_t n = 0;
        for (uint32_t i = 0; i < f->n; i++)
            n += (uint32_t)f->list[i].kind == kind;
        if (n)
            WHY(entry, "%s%u %s%s", entry->why[0] ? ", " : "", n, sph_kind_name(kind),
                n == 1 ? "" : "s");
    }
    if (f->n) WHY(entry, "; the first is the %s %s", name_of(f->list), sph_facet_place(s, 0).text);
}

void sph_find_smooth(const struct sph_survey *s, struct sph_effect_report *entry) {
    const struct sph_facets *f = s->world.facets;
    uint32_t n = 0, first = 0, met = 0;
    for (uint32_t i = f->n; i-- > 0;) {
        struct sph_grid_prim prim = sph_grid_prim_of(s->world.balls, s->world.n, f, s->world.n + i);
        if (!sph_smooth_bends(&s->scene->facets[prim.index])) continue;
        n++, first = i;
        met += !sph_is_unmet(s->scene, s->options, &prim);
    }
    entry->called = n > 0;
    if (n)
        WHY(entry, "%u triangles have normals, the first is that %s", n,
            sph_facet_place(s, first).text);
    else
        WHY(entry, "no triangle has normals but its own");
    if (n && !met) sph_leave_out(entry, "no ray of this frame meets one");
    sph_settle(entry, s->options->smooth);
    if (entry->on && !f->n) sph_drop(entry, "there is no triangle");
}

void sph_find_facet_shadow(const struct sph_survey *s, struct sph_effect_report *entry) {
    const struct sph_facets *f = s->world.facets;
    entry->called = s->world.n > 0 || f->list[0].after + 1u < f->n;
    if (entry->called)
        WHY(entry, "the %s %s may shade or be shaded", name_of(f->list),
            sph_facet_place(s, 0).text);
    else
        WHY(entry, "there is one polygon or plane and nothing else");
}

int sph_find_facet_inside(const struct sph_survey *s, struct sph_effect_report *entry) {
    const struct sph_world *w = &s->world;
    uint32_t facet, ball;
    int found = sph_near_facet(w, &facet, &ball);
    if (found > 0)
        WHY(entry, "the %s %s comes within %.4g grid units of the sphere %s",
            name_of(&w->facets->list[facet]), sph_facet_place(s, facet).text,
            (double)sph_facet_error(w->profile) / (double)(1 << sph_error_bits(w->profile)),
            sph_sphere_place(s->scene, ball).text);
    else if (found < 0)
        WHY(entry, "there are too many triangles and spheres to try every pair");
    return found != 0;
}
