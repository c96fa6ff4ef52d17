/* price.c - see price.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "trial/price.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "builder/emit.h"
#include "trial/met.h"
#include "validate/describe.h"

struct job {
    const struct sph_build_options *build;
    const struct sph_price_options *o;
    struct sph_yardstick yardstick;
    struct sph_price *price;
    struct sph_progress row; /* where the row at hand is; who asks is asked in it, too */
};

#define YARDSTICK 0.5 /* share of the time until it is drawn */

/* ---- a row ---- */

static int keeps(const struct sph_price_row *r, const struct sph_error_bound *bound) {
    return r->psnr_least >= bound->psnr && r->expected.fits && r->expected.pixels <= bound->pixels;
}

/* The core that build tools make by themselves, but for its pipes. */
static void of_core(struct sph_price_row *r, const struct sph_machine *m, int pipes,
                    const struct job *j) {
    r->sizes = sph_core_sizes_of(m);
    r->sizes.PIPES = pipes;
    r->cycles = sph_cycles_expect(m, &r->sizes, j->o->most, j->o->threads);
    snprintf(r->tree, sizeof r->tree, "%s", sph_machine_tree_name(m));
    sph_machine_core(m, r->core, sizeof r->core);
    r->known = sph_known_core(r->profile.name, r->core, pipes);
    r->energy = sph_energy_expect(&r->known, &r->cycles);
    if (r->known.median > 0)
        r->milliseconds =
            r->cycles.pixel * j->price->width * j->price->height / (r->known.median * 1000);
}

/* As sph_trial_measure(), of a machine without what no ray of the frame meets. */
static int measure_met(const struct job *j, struct sph_build_options *o, struct sph_trial *t,
                       struct sph_estimate *expected, struct sph_error *err) {
    const struct sph_scene *scene = j->yardstick.scene;
    const struct sph_error_bound any = {INFINITY, 0}; /* it is measured here */
    struct sph_profile_choice choice;
    memset(t, 0, sizeof *t);
    t->numbers = calloc((size_t)scene->n_spheres + scene->n_facets + 1, sizeof *t->numbers);
    if (!t->numbers) return sph_fail(err, "%s: no memory", scene->path);
    o->numbers = t->numbers;
    int rc = sph_build_met(scene, o, 0, &any, &choice, &t->machine, &t->report, err) ||
             sph_trial_draw(&j->yardstick, j->o->threads, t, err);
    if (rc)
        sph_trial_free(t);
    else
        sph_trial_judge(&j->yardstick, t);
    if (!rc) *expected = choice.of[choice.taken].expected;
    return rc;
}

/* Measures widths in a tree (SPH_TREE_*) on a core of so many pipes. 0, or -1 if memory is out. */
static int measure(const struct job *j, const struct sph_profile *profile, int tree, int pipes,
                   struct sph_price_row *r, struct sph_error *err) {
    struct sph_build_options o = *j->build;
    struct sph_error why = {""};
    struct sph_trial t;
    r->profile = *profile;
    o.widths = &r->profile;
    o.tree = tree;
    o.progress = &j->row;
    if (sph_measure_trees(j->yardstick.scene, &o, NULL, 0, err) ||
        sph_estimate(j->yardstick.scene, &o, &r->profile, 1, &r->expected, err))
        return -1;
    r->built = !(j->o->met ? measure_met(j, &o, &t, &r->expected, &why)
                           : sph_trial_measure(&j->yardstick, &o, j->o->threads, &t, &why));
    if (!r->built) {
        if (sph_error_memory(&why)) return sph_fail(err, "%s", why.text);
        snprintf(r->why, sizeof r->why, "%s", why.text);
        return 0;
    }
    r->accuracy = t.accuracy;
    r->wrong = t.wrong;
    r->wrong_most = t.wrong_most;
    r->psnr_least = t.psnr_least;
    of_core(r, &t.machine, pipes, j);
    r->keeps = keeps(r, &j->o->bound);
    sph_trial_free(&t);
    return 0;
}

static int add_profile(struct job *j, const struct sph_profile *p, struct sph_error *err) {
    struct sph_price_row *r = &j->price->row[j->price->n++];
    snprintf(r->name, sizeof r->name, "%s", p->name);
    return measure(j, p, j->build->tree, 1, r, err);
}

/* ---- single knobs ---- */

/* Is the row of a knob better than the one that it was turned at? */
static int pays(const struct sph_price_row *r, const struct sph_price_row *base, int fewer_bits) {
    if (!r->built) return 0;
    if (!fewer_bits) return r->cycles.frame < base->cycles.frame;
    return base->keeps ? r->keeps : r->psnr_least >= base->psnr_least && r->wrong <= base->wrong;
}

static int add_knob(struct job *j, const struct sph_price_row *base, const char *name,
                    const struct sph_profile *p, int tree, int pipes, struct sph_error *err) {
    struct sph_price *price = j->price;
    struct sph_price_row *r = &price->row[price->n];
    if (price->n == SPH_PRICE_ROWS) return 0;
    if (measure(j, p, tree, pipes, r, err)) return -1;
    snprintf(r->name, sizeof r->name, "%s", name);
    int other_widths = strcmp(p->name, base->profile.name) != 0;
    int same = !other_widths && pipes == base->sizes.PIPES && !strcmp(r->tree, base->tree);
    if (pays(r, base, other_widths)) {
        price->n++;
        return 0;
    }
    if (!same)
        sph_note(price->tried, sizeof price->tried, "%s%s", price->tried[0] ? "; " : "", name);
    memset(r, 0, sizeof *r);
    return 0;
}

/* Fewer bits of one width, of W with those that hang on it. */
static int add_widths(struct job *j, const struct sph_price_row *base, struct sph_error *err) {
    const struct sph_profile *b = &base->profile;
    struct sph_profile narrow[] = {*b, *b, *b, *b};
    narrow[0].w -= 1, narrow[0].wd -= 1;
    if (narrow[0].fw > narrow[0].w) narrow[0].fw = narrow[0].w;
    narrow[1].pq -= 2;
    narrow[2].pq -= 4;
    narrow[3].pr = (b->pr ? b->pr : b->w + b->wd) * 2 / 3;
    for (size_t i = 0; i < sizeof narrow / sizeof *narrow; i++) {
        struct sph_error why = {""};
        if (sph_profile_check(&narrow[i], &why)) continue;
        struct sph_profile p = sph_profile_unpack(sph_profile_pack(&narrow[i])); /* its name */
        if (add_knob(j, base, p.name, &p, j->build->tree, 1, err)) return -1;
    }
    return 0;
}

static int add_cores(struct job *j, const struct sph_price_row *base, struct sph_error *err) {
    static const struct {
        const char *name;
        int tree, pipes; /* 0: that of the options */
    } cores[] = {{"2 pipes", 0, 2},
                 {"tree of spheres", SPH_TREE_REINSERTED, 1},
                 {"tree of boxes", SPH_TREE_BOX4, 1},
                 {"BIH", SPH_TREE_BIH, 1}};
    for (size_t i = 0; i < sizeof cores / sizeof *cores; i++) {
        char name[sizeof base->name];
        int tree = cores[i].tree ? cores[i].tree : j->build->tree;
        snprintf(name, sizeof name, "%.64s, %s", base->profile.name, cores[i].name);
        if (add_knob(j, base, name, &base->profile, tree, cores[i].pipes, err)) return -1;
    }
    return 0;
}

static int add_knobs(struct job *j, struct sph_error *err) {
    const struct sph_price *price = j->price;
    int at = price->best;
    for (int i = 0; i < price->n && price->best < 0; i++)
        if (price->row[i].built) at = i;
    if (at < 0) return 0;
    struct sph_price_row base = price->row[at];
    return add_widths(j, &base, err) || add_cores(j, &base, err) ? -1 : 0;
}

/* ---- all of them ---- */

static int make(struct job *j, struct sph_error *err) {
    struct sph_price *price = j->price;
    int n = j->o->only ? 1 : SPH_PROFILES;
    for (int p = 0; p < n; p++) {
        double share = YARDSTICK + (1 - YARDSTICK) * p / n;
        j->row = sph_progress_part(j->build->progress, share, share);
        if (add_profile(j, j->o->only ? j->o->only : &sph_profiles[p], err)) return -1;
        if (sph_progress_at(&j->row, 0))
            return sph_fail(err, "%s: cancelled", j->yardstick.scene->path);
        if (price->best < 0 && price->row[price->n - 1].keeps) price->best = price->n - 1;
    }
    return j->o->more ? add_knobs(j, err) : 0;
}

int sph_price_make(const struct sph_scene *scene, const struct sph_build_options *build,
                   const struct sph_price_options *options, struct sph_price *price,
                   struct sph_error *err) {
    struct job j = {.build = build, .o = options, .price = price};
    memset(price, 0, sizeof *price);
    price->best = -1;
    const struct sph_yardstick_options how = {
        .most = options->most, .lod = SPH_LOD_MENDED, .threads = options->threads};
    struct sph_progress first = sph_progress_part(build->progress, 0, YARDSTICK);
    struct sph_build_options of_first = *build;
    if (build->progress) of_first.progress = &first;
    if (sph_yardstick_make(scene, &of_first, &how, &j.yardstick, err)) return -1;
    price->width = j.yardstick.width;
    price->height = j.yardstick.height;
    price->sampled = j.yardstick.places != NULL;
    int rc = make(&j, err);
    sph_yardstick_free(&j.yardstick);
    return rc;
}

/* ---- in words ---- */

/* Where the machine is most often wrong. */
static void worst_kind(const struct sph_accuracy *a, char *text, size_t size) {
    const struct {
        uint64_t pixels;
        const char *how;
    } kinds[] = {{a->image.silhouette + a->image.wrong_id, "see another object"},
                 {a->shadow, "have another shadow"},
                 {a->reflected, "see another object in a mirror"},
                 {a->refracted, "see another object through glass"}};
    size_t most = 0;
    for (size_t i = 1; i < sizeof kinds / sizeof *kinds; i++)
        if (kinds[i].pixels > kinds[most].pixels) most = i;
    if (kinds[most].pixels)
        sph_note(text, size, "; %lu of its pixels %s", (unsigned long)kinds[most].pixels,
                 kinds[most].how);
}

void sph_price_says(const struct sph_price *price, const struct sph_error_bound *bound, char *text,
                    size_t size) {
    const struct sph_price_row *best = NULL;
    text[0] = 0;
    if (price->best >= 0) {
        best = &price->row[price->best];
        sph_note(text, size,
                 "* %s is the cheapest that keeps %g pixels and %g dB: %.2g pixels expected, %s"
                 "%.2f dB measured",
                 best->name, bound->pixels, bound->psnr, best->expected.pixels,
                 price->sampled ? "at least " : "", best->psnr_least);
        return;
    }
    for (int i = 0; i < price->n; i++)
        if (price->row[i].built && (!best || price->row[i].psnr_least > best->psnr_least))
            best = &price->row[i];
    if (!best) {
        sph_note(text, size, "no row could be built: %s", price->row[price->n - 1].why);
        return;
    }
    sph_note(text, size,
             "none keeps %g pixels and %g dB; %s comes nearest, with %.2g pixels and "
             "%.2f dB: --error %.2g,%.0f would do",
             bound->pixels, bound->psnr, best->name, best->expected.pixels, best->psnr_least,
             best->expected.pixels * 1.05, floor(fmin(best->psnr_least, 99)));
    worst_kind(&best->accuracy, text, size);
}
