/* met.c - see met.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "trial/met.h"

#include <stdlib.h>
#include <string.h>

#include "builder/effects/effects.h"
#include "builder/emit.h"
#include "machine/records.h"
#include "render/render.h"

static const struct sph_facet *facet_of(const struct sph_scene *scene, uint32_t i) {
    return i < scene->n_spheres ? NULL : &scene->facets[i - scene->n_spheres];
}

/* Draws a machine and adds what its rays met; numbers: of its primitives in the scene. */
static int draw(struct sph_census *c, const struct sph_machine *m, const uint32_t *numbers,
                const int lights[SPH_MAX_LIGHTS], struct sph_error *err) {
    const int32_t *r = m->regs;
    uint32_t n = (uint32_t)r[SPH_REG_N_PRIMS];
    struct sph_met met = {.prims = calloc((size_t)n + 1, sizeof *met.prims)};
    struct sph_render_options how = {.traverse = SPH_TRAVERSE_FAST, .met = &met};
    struct sph_counters counters = {{0}};
    struct sph_frame frame = {0};
    if (!met.prims) return sph_fail(err, "%s: no memory for what is met", m->name);
    int errors = sph_render(m, &how, &frame, &counters, err);
    sph_frame_free(&frame);
    if (errors > 0) c->kept = "the drawing of it found errors";
    for (int l = 0; l < r[SPH_REG_N_LIGHTS]; l++) {
        c->lights |= 1u << lights[l];
        c->lit |= (met.lit >> l & 1) << lights[l];
        c->blocked |= (met.blocked >> l & 1) << lights[l];
    }
    for (uint32_t id = 0; id < n; id++) {
        uint32_t *to = &c->prims[numbers[id]];
        *to |= met.prims[id] & SPH_MET_SHADED;
        for (int l = 0; l < r[SPH_REG_N_LIGHTS]; l++)
            *to |= (met.prims[id] >> l & 1) << lights[l];
    }
    c->inside |= met.inside;
    c->passed |= met.passed;
    c->depths |= met.depths;
    free(met.prims);
    return errors < 0 ? -1 : 0;
}

/* Whether a frame of these options is to be drawn at all; else c->kept says why not. */
static int drawable(struct sph_census *c, const struct sph_machine *m,
                    const struct sph_build_options *o) {
    c->pixels += (uint64_t)m->regs[SPH_REG_FRAME_W] * (uint64_t)m->regs[SPH_REG_FRAME_H];
    if (o->traverse == SPH_BUILD_FIRST)
        c->kept = "what a primary ray meets at its first visit hangs on the tree";
    else if (c->pixels > SPH_CENSUS_PIXELS)
        c->kept = "there are too many pixels to draw them for this";
    return !c->kept;
}

int sph_census_add(struct sph_census *c, const struct sph_scene *scene,
                   const struct sph_build_options *o, const struct sph_machine *m,
                   const struct sph_build_report *report, struct sph_error *err) {
    uint32_t n = scene->n_spheres + scene->n_facets;
    if (!c->prims) {
        c->n = n;
        c->prims = calloc((size_t)n + 1, sizeof *c->prims);
    }
    if (!c->prims) return sph_fail(err, "%s: no memory for what is met", scene->path);
    if (n != c->n) c->kept = "its frames have not the same primitives";
    return drawable(c, m, o) ? draw(c, m, o->numbers, report->lights, err) : 0;
}

const struct sph_unmet *sph_census_unmet(struct sph_census *c, struct sph_scene *scene,
                                         const struct sph_build_options *o) {
    c->unmet = (struct sph_unmet){0};
    free(c->shaded);
    c->shaded = c->kept ? NULL : calloc((size_t)c->n + 1, 1);
    if (!c->shaded) return NULL;
    for (uint32_t i = 0; i < c->n; i++)
        c->shaded[i] = !(c->prims[i] & SPH_MET_SHADED);
    for (int l = 0; l < scene->n_lights && o->lights == SPH_AUTO; l++) {
        struct sph_light *lamp = &scene->lights[l];
        if (!((c->lights & ~c->lit) >> l & 1)) continue;
        c->unmet.lights |= 1u << l;
        memset(lamp->rgb, 0, sizeof lamp->rgb);
    }
    c->unmet.prims = c->shaded;
    c->unmet.shadow = !(c->blocked & ~c->unmet.lights);
    c->unmet.inside = !c->inside;
    c->unmet.clear = !c->passed;
    while (c->depths >> c->unmet.depth > 1)
        c->unmet.depth++;
    return &c->unmet;
}

void sph_census_free(struct sph_census *c) {
    free(c->prims);
    free(c->shaded);
    *c = (struct sph_census){0};
}

/* ---- what a machine asks for ---- */

/* Whether a machine asks for an effect that no surface which is shaded asks for. */
static int spare(const struct sph_census *c, const struct sph_machine *m, const uint32_t *numbers) {
    static const struct {
        int effect, lsb, bits;
    } asks[] = {{SPH_EFFECT_REFLECT, SPH_PRIM_KR_LSB, SPH_PRIM_KR_BITS},
                {SPH_EFFECT_REFRACT, SPH_PRIM_KT_LSB, SPH_PRIM_KT_BITS},
                {SPH_EFFECT_SPECULAR, SPH_PRIM_KS_LSB, SPH_PRIM_KS_BITS},
                {SPH_EFFECT_SUM, SPH_PRIM_SUM_LSB, SPH_PRIM_SUM_BITS},
                {SPH_EFFECT_TEXTURE, SPH_PRIM_TEX_LSB, SPH_PRIM_TEX_BITS},
                {SPH_EFFECT_SMOOTH, SPH_PRIM_SMOOTH_LSB, SPH_PRIM_SMOOTH_BITS},
                {SPH_EFFECT_SPREAD, SPH_PRIM_BEND_LSB, SPH_PRIM_BEND_BITS}};
    if (sph_machine_effect(m, SPH_EFFECT_SHADOW) && c->unmet.shadow) return 1;
    if (sph_machine_effect(m, SPH_EFFECT_INSIDE) && c->unmet.inside) return 1;
    if (sph_machine_effect(m, SPH_EFFECT_CLEAR) && c->unmet.clear) return 1;
    int most = m->regs[SPH_REG_MAX_DEPTH];
    if (c->unmet.depth < most && (!c->unmet.depth || most > sph_parts[SPH_PART_REFLECT].all))
        return 1;
    for (size_t a = 0; a < sizeof asks / sizeof *asks; a++) {
        int met = !sph_machine_effect(m, asks[a].effect);
        for (uint32_t id = 0; !met && id < (uint32_t)m->regs[SPH_REG_N_PRIMS]; id++) {
            const uint32_t *prim = sph_line(m, (uint32_t)m->regs[SPH_REG_PRIM_BASE] + id);
            int has = asks[a].effect != SPH_EFFECT_SMOOTH || sph_prim_kind(m, prim) != SPH_SPHERE;
            met = has && !c->shaded[numbers[id]] && sph_field(prim, asks[a].lsb, asks[a].bits);
        }
        if (!met) return 1;
    }
    return 0;
}

/* ---- what makes the grid coarse ---- */

/* The scene without some primitives, which owns its spheres and facets; drop[i]: without i. */
static int without(const struct sph_scene *scene, const uint8_t *drop, struct sph_scene *rest) {
    *rest = *scene;
    rest->n_spheres = rest->n_facets = 0;
    rest->spheres = malloc(((size_t)scene->n_spheres + 1) * sizeof *rest->spheres);
    rest->facets = malloc(((size_t)scene->n_facets + 1) * sizeof *rest->facets);
    if (!rest->spheres || !rest->facets) return -1;
    for (uint32_t i = 0; i < scene->n_spheres; i++)
        if (!drop[i]) rest->spheres[rest->n_spheres++] = scene->spheres[i];
    for (uint32_t i = 0; i < scene->n_facets; i++)
        if (!drop[scene->n_spheres + i]) rest->facets[rest->n_facets++] = scene->facets[i];
    return 0;
}

static void release(struct sph_scene *rest) {
    free(rest->spheres);
    free(rest->facets);
}

static int point_fits(const struct sph_grid *grid, struct sph_vec p, double rad) {
    double at[3], most = (1 << (grid->w - 1)) - 2 * SPH_GRID_MARGIN - rad / grid->step;
    sph_grid_real(grid, p, at);
    for (int i = 0; i < 3; i++)
        if (!(at[i] <= most && at[i] >= -most)) return 0;
    return 1;
}

/* Whether primitive i lies well on a grid. */
static int fits(const struct sph_grid *grid, const struct sph_scene *scene, uint32_t i) {
    const struct sph_facet *f = facet_of(scene, i);
    if (!f) return point_fits(grid, scene->spheres[i].ctr, scene->spheres[i].rad);
    int in = !sph_kind_unbounded((uint32_t)f->kind);
    for (int k = 0; k < 3; k++)
        in = in && point_fits(grid, f->v[k], 0);
    return in;
}

/* Marks in drop[] the primitives that no ray meets and without which the grid of w bits is finer or
 * no facet is left. Where there is a plane a wide grid is worth more: it ends where the grid does.
 * How many; -1: no memory. */
static int64_t choose_drops(const struct sph_census *c, const struct sph_scene *scene, int w,
                            int axes, uint8_t *drop) {
    struct sph_scene rest;
    struct sph_grid all, less;
    uint32_t facets = 0, planes = 0;
    int64_t n = 0;
    for (uint32_t i = 0; i < c->n; i++) {
        const struct sph_facet *f = facet_of(scene, i);
        drop[i] = !(c->prims[i] & (c->lit | SPH_MET_SHADED));
        facets += f && !drop[i];
        planes += f && !drop[i] && sph_kind_unbounded((uint32_t)f->kind);
    }
    int rc = without(scene, drop, &rest);
    int finer = !rc && !planes && !sph_grid_fit(scene, w, axes, &all, NULL) &&
                !sph_grid_fit(&rest, w, axes, &less, NULL) && less.log2 < all.log2;
    for (uint32_t i = 0; i < c->n; i++) {
        int spared = i >= scene->n_spheres && !facets;
        drop[i] = drop[i] && (spared || (finer && !fits(&less, scene, i)));
        n += drop[i];
    }
    release(&rest);
    return rc ? -1 : n;
}

/* What drops[] marks, a line each for the first ones. */
static void name_drops(const struct sph_scene *scene, const uint8_t *drop, int64_t n, char *text,
                       size_t size) {
    enum { LINES = 8 };
    int64_t told = 0;
    for (uint32_t i = 0; i < scene->n_spheres + scene->n_facets && told < LINES; i++) {
        if (!drop[i]) continue;
        const struct sph_facet *f = facet_of(scene, i);
        sph_note(text, size, "the %s %s: no ray of this frame meets it\n",
                 sph_kind_name(f ? (uint32_t)f->kind : SPH_SPHERE),
                 sph_place_of(scene, f ? f->line : scene->spheres[i].line, "number", i).text);
        told++;
    }
    if (n > told) sph_note(text, size, "and %lld more\n", (long long)(n - told));
}

/* ---- both ---- */

/* What sph_build_met() works on. */
struct task {
    struct sph_build_options *o; /* numbers: room for all of the scene */
    int choose;
    const struct sph_error_bound *bound;
    struct sph_profile_choice *choice;
    struct sph_machine *m; /* empty, or what was built last */
    struct sph_build_report *report;
};

/* Builds without what is unmet, in the widths of look(). */
static int build(const struct task *t, const struct sph_scene *scene, const struct sph_unmet *unmet,
                 struct sph_error *err) {
    sph_machine_free(t->m);
    t->o->unmet = unmet;
    int rc = sph_build(scene, t->o, t->m, t->report, err);
    t->o->unmet = NULL;
    return rc;
}

/* The machine is the last one: says what it misses. */
static int tell(const struct task *t, const struct sph_scene *scene, struct sph_error *err) {
    return sph_choose_tell(scene, t->o, t->choose, t->bound, t->choice, t->report, err);
}

/* Builds with everything and draws that. */
static int look(const struct task *t, struct sph_census *c, const struct sph_scene *scene,
                struct sph_error *err) {
    sph_machine_free(t->m);
    return sph_build_chosen(scene, t->o, t->choose, t->bound, t->choice, t->m, t->report, err) ||
           sph_census_add(c, scene, t->o, t->m, t->report, err);
}

/* The scene has lost lights or primitives: its frame is drawn anew, on its own grid. */
static int on_own_grid(const struct task *t, const struct sph_unmet *whole,
                       const struct sph_scene *rest, struct sph_error *err) {
    struct sph_census c = {0};
    struct sph_scene same = *rest; /* a light that is lost on this grid alone stays */
    int rc = look(t, &c, rest, err);
    if (!rc && sph_census_unmet(&c, &same, t->o)) {
        c.unmet.lights = whole->lights;
        c.unmet.shadow = !c.blocked;
        c.unmet.fewer = 1;
        rc = build(t, rest, &c.unmet, err);
    }
    sph_census_free(&c);
    return rc ? rc : tell(t, rest, err);
}

/* Numbers that primitives have without those of drop[] become numbers in the scene. */
static int renumber(const struct sph_census *c, const uint8_t *drop, const struct sph_machine *m,
                    uint32_t *numbers, struct sph_error *err) {
    uint32_t *kept = malloc(((size_t)c->n + 1) * sizeof *kept), n = 0;
    if (!kept) return sph_fail(err, "%s: no memory", m->name);
    for (uint32_t i = 0; i < c->n; i++)
        if (!drop[i]) kept[n++] = i;
    for (uint32_t id = 0; id < (uint32_t)m->regs[SPH_REG_N_PRIMS]; id++)
        numbers[id] = kept[numbers[id]];
    free(kept);
    return 0;
}

/* Leaves out what the census of the machine with everything says. */
static int leave_out(const struct task *t, struct sph_census *c, const struct sph_scene *scene,
                     uint8_t *drop, struct sph_error *err) {
    struct sph_scene dark = *scene, rest;
    const struct sph_unmet *unmet = sph_census_unmet(c, &dark, t->o);
    if (!unmet) {
        sph_note(t->report->left_out, sizeof t->report->left_out, "nothing: %s\n",
                 c->kept ? c->kept : "no memory");
        return tell(t, scene, err);
    }
    int turned = sph_machine_effect(t->m, SPH_EFFECT_TURNED);
    int64_t n =
        choose_drops(c, &dark, t->m->profile.w, turned ? SPH_AXES_SCENE : SPH_AXES_CAMERA, drop);
    if (n < 0) return sph_fail(err, "%s: no memory", scene->path);
    if (!n && !unmet->lights)
        return (spare(c, t->m, t->o->numbers) && build(t, scene, unmet, err)) ||
               tell(t, scene, err);
    int rc = without(&dark, drop, &rest) ? sph_fail(err, "%s: no memory", scene->path)
                                         : on_own_grid(t, unmet, &rest, err);
    release(&rest);
    if (rc || renumber(c, drop, t->m, t->o->numbers, err)) return -1;
    sph_emit_camera(t->m, t->report);
    name_drops(scene, drop, n, t->report->left_out, sizeof t->report->left_out);
    return 0;
}

int sph_build_met(const struct sph_scene *scene, struct sph_build_options *o, int choose,
                  const struct sph_error_bound *bound, struct sph_profile_choice *choice,
                  struct sph_machine *machine, struct sph_build_report *report,
                  struct sph_error *err) {
    struct sph_census c = {0};
    struct task t = {o, choose, bound, choice, machine, report};
    size_t n = (size_t)scene->n_spheres + scene->n_facets + 1;
    uint8_t *drop = calloc(n, 1);
    uint32_t *numbers = o->numbers;
    memset(machine, 0, sizeof *machine);
    if (!numbers) o->numbers = calloc(n, sizeof *o->numbers);
    int rc = o->numbers && drop ? 0 : sph_fail(err, "%s: no memory", scene->path);
    if (!rc) rc = look(&t, &c, scene, err);
    if (!rc) rc = leave_out(&t, &c, scene, drop, err);
    if (rc) sph_machine_free(machine);
    sph_census_free(&c);
    if (!numbers) free(o->numbers);
    o->numbers = numbers;
    free(drop);
    return rc;
}
