/* choose.c - see choose.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "trial/choose.h"

#include <stdio.h>
#include <string.h>

#include "builder/emit.h"
#include "builder/tree/choose_tree.h"
#include "machine/records.h"
#include "trial/cycles.h"
#include "trial/help.h"
#include "trial/known.h"
#include "validate/describe.h"

/* ---- in words ---- */

void sph_choose_why(const struct sph_profile_choice *choice, const struct sph_error_bound *bound,
                    char *text, size_t size) {
    enum { SAYS = 192 };
    char is[SAYS];
    int p = choice->taken;
    text[0] = 0;
    sph_note(text, size, "%s%s: %s, %s %g pixels, %g dB", sph_profiles[p].name,
             choice->kept ? "" : ", the finest", sph_picture_says(&choice->of[p], is, SAYS),
             choice->kept ? "within" : "which misses", bound->pixels, bound->psnr);
    if (p && choice->of[p - 1].expected.fits)
        sph_note(text, size, "; %s %s", sph_profiles[p - 1].name,
                 sph_picture_says(&choice->of[p - 1], is, SAYS));
    if (choice->not_measured) sph_note(text, size, "; not measured: %s", choice->not_measured);
}

/* ---- the choice ---- */

/* Measures profiles, from the cheapest to the first that keeps the bound; of the finest the whole
 * picture. Those that move points too far are passed over. */
static int measure(const struct sph_scene *scene, const struct sph_build_options *o,
                   const struct sph_error_bound *bound, struct sph_profile_choice *choice,
                   struct sph_error *err) {
    struct sph_judge judge;
    int kept = 0;
    if (sph_judge_begin(scene, o, &judge, err)) return -1;
    if (!judge.decidable) choice->not_measured = "no pixel can be told in double precision";
    for (int p = 0; p < SPH_PROFILES && !kept; p++) {
        struct sph_known_picture *of = &choice->of[p];
        int last = p == SPH_PROFILES - 1;
        if (!of->expected.fits || (!last && of->expected.pixels > bound->pixels)) continue;
        if (sph_progress_at(&judge.quiet, 0)) {
            sph_judge_end(&judge);
            return sph_fail(err, "%s: cancelled", scene->path);
        }
        of->measured = sph_judge_widths(&judge, &sph_profiles[p], last ? 0 : bound->psnr);
        if (of->measured.memory) {
            sph_judge_end(&judge);
            return sph_fail(err, "%s: no memory for a trial", scene->path);
        }
        kept = of->measured.pixels && sph_picture_keeps(of, bound);
    }
    sph_judge_end(&judge);
    return 0;
}

int sph_choose(const struct sph_scene *scene, struct sph_build_options *o,
               const struct sph_error_bound *bound, struct sph_profile_choice *choice,
               struct sph_error *err) {
    struct sph_estimate expected[SPH_PROFILES];
    *choice = (struct sph_profile_choice){.taken = SPH_PROFILES - 1,
                                          .not_measured = sph_judge_cannot(scene, o)};
    if (sph_estimate(scene, o, sph_profiles, SPH_PROFILES, expected, err)) return -1;
    int fit = 0;
    for (int p = 0; p < SPH_PROFILES; p++) {
        choice->of[p].expected = expected[p];
        fit += expected[p].fits;
    }
    if (fit && !choice->not_measured && measure(scene, o, bound, choice, err)) return -1;
    for (int p = SPH_PROFILES - 1; p >= 0; p--) {
        /* what was to be measured and was not cannot be built */
        int known = choice->not_measured || choice->of[p].measured.pixels;
        if (known && sph_picture_keeps(&choice->of[p], bound)) choice->taken = p, choice->kept = 1;
    }
    o->profile = choice->taken;
    return 0;
}

/* ---- the tree ---- */

/* Clocks a pixel in a tree, and cells of its core; 0, or -1 if one is not known; *err says why. */
static int cost_of(const struct sph_scene *scene, const struct sph_build_options *o, int tree,
                   double *clocks, int *cells, struct sph_error *err) {
    enum { PIXELS = 1 << 12 };
    struct sph_build_options mine = *o;
    struct sph_build_report report;
    struct sph_machine m;
    char core[256];
    struct sph_progress quiet = sph_progress_part(o->progress, 0, 0);
    mine.progress = &quiet;
    mine.tree = tree;
    mine.numbers = NULL;
    if (sph_build(scene, &mine, &m, &report, err)) return -1;
    const struct sph_core_sizes sizes = sph_core_sizes_of(&m);
    *clocks = sph_cycles_expect(&m, &sizes, PIXELS, 0).pixel;
    sph_machine_core(&m, core, sizeof core);
    *cells = sph_known_core(m.profile.name, core, 1).lut4eq;
    sph_machine_free(&m);
    return *clocks > 0 && *cells ? 0 : -1;
}

int sph_measure_trees(const struct sph_scene *scene, struct sph_build_options *o, char *why,
                      size_t size, struct sph_error *err) {
    static const int trees[] = {SPH_TREE_REINSERTED, SPH_TREE_BOX4};
    const double keep = 0.75; /* of the cost of the tree by rule */
    uint64_t n = (uint64_t)scene->n_spheres + scene->n_facets;
    double clocks[2];
    int cells[2], rule = sph_tree_of(scene, o) == SPH_TREE_BOX4;
    if (why) why[0] = 0;
    if (o->tree != SPH_TREE_AUTO || o->traverse != SPH_BUILD_NEAREST) return 0;
    if (!n || n > SPH_TREES_PRIMS) return 0;
    for (uint32_t i = 0; i < scene->n_facets; i++)
        if (sph_kind_unbounded((uint32_t)scene->facets[i].kind)) return 0;
    for (int i = 0; i < 2; i++) {
        struct sph_error unknown = {""};
        if (cost_of(scene, o, trees[i], &clocks[i], &cells[i], &unknown))
            return sph_error_memory(&unknown) ? sph_fail(err, "%s", unknown.text) : 0;
    }
    double cost[2] = {clocks[0] * cells[0], clocks[1] * cells[1]};
    int taken = cost[!rule] < keep * cost[rule] ? !rule : rule;
    o->tree = trees[taken];
    if (why)
        snprintf(why, size,
                 "%.4g clocks a pixel in spheres, %.4g in boxes, whose core has %.2f cells",
                 clocks[0], clocks[1], (double)cells[1] / cells[0]);
    return 0;
}

int sph_build_chosen(const struct sph_scene *scene, struct sph_build_options *o, int choose,
                     const struct sph_error_bound *bound, struct sph_profile_choice *choice,
                     struct sph_machine *machine, struct sph_build_report *report,
                     struct sph_error *err) {
    if (!choose) *choice = (struct sph_profile_choice){.taken = SPH_PROFILES};
    if (choose && sph_choose(scene, o, bound, choice, err)) return -1;
    int rc = sph_build(scene, o, machine, report, err);
    while (rc && !sph_error_memory(err) && choose && o->profile + 1 < SPH_PROFILES) {
        choice->taken = ++o->profile;
        err->text[0] = 0;
        rc = sph_build(scene, o, machine, report, err);
    }
    return rc;
}

/* ---- what misses it ---- */

/* Estimates the widths that were given, and measures them if that misses the bound. */
static int by_hand(const struct sph_scene *scene, const struct sph_build_options *o,
                   const struct sph_error_bound *bound, struct sph_profile_choice *choice,
                   struct sph_error *err) {
    struct sph_known_picture *mine = &choice->of[SPH_PROFILES];
    choice->not_measured = sph_judge_cannot(scene, o);
    if (sph_estimate(scene, o, sph_build_profile(o), 1, &mine->expected, err)) return -1;
    choice->kept = !mine->expected.fits || sph_picture_keeps(mine, bound);
    if (choice->kept || choice->not_measured) return 0;
    if (sph_judge_once(scene, o, sph_build_profile(o), &mine->measured, err)) return -1;
    choice->kept = sph_picture_keeps(mine, bound);
    return 0;
}

int sph_choose_tell(const struct sph_scene *scene, const struct sph_build_options *o, int choose,
                    const struct sph_error_bound *bound, struct sph_profile_choice *choice,
                    struct sph_build_report *report, struct sph_error *err) {
    enum { SAYS = 192 };
    char is[SAYS], *text = report->warning;
    size_t size = sizeof report->warning;
    struct sph_known_picture *mine = &choice->of[choice->taken];
    struct sph_profile_choice other;
    struct sph_build_options free_widths = *o;
    free_widths.widths = NULL;
    if (!choose && by_hand(scene, o, bound, choice, err)) return -1;
    if (choice->kept || !mine->expected.fits) return 0;
    if (!choose && sph_choose(scene, &free_widths, bound, &other, err)) return -1;
    sph_note(text, size, "%s: profile %s: %s, which misses %g pixels, %g dB: ", scene->path,
             sph_build_profile(o)->name, sph_picture_says(mine, is, SAYS), bound->pixels,
             bound->psnr);
    if (!choose && other.kept) {
        sph_note(text, size, "profile %s would do: %s\n", sph_profiles[other.taken].name,
                 sph_picture_says(&other.of[other.taken], is, SAYS));
        return 0;
    }
    sph_note(text, size, "no profile keeps that\n");
    return choice->not_measured ? 0 : sph_help(scene, o, bound, mine, report, err);
}

int sph_build_kept(const struct sph_scene *scene, struct sph_build_options *o, int choose,
                   const struct sph_error_bound *bound, struct sph_profile_choice *choice,
                   struct sph_machine *machine, struct sph_build_report *report,
                   struct sph_error *err) {
    if (sph_build_chosen(scene, o, choose, bound, choice, machine, report, err)) return -1;
    if (!sph_choose_tell(scene, o, choose, bound, choice, report, err)) return 0;
    sph_machine_free(machine);
    return -1;
}
