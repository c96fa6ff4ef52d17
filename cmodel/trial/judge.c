/* judge.c - see judge.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "trial/judge.h"

#include <math.h>
#include <stdlib.h>

#include "builder/emit.h"
#include "builder/tree/choose_tree.h"
#include "common/parallel.h"
#include "trial/draw.h"

const char *sph_judge_cannot(const struct sph_scene *scene, const struct sph_build_options *o) {
    /* Effects that the double reference leaves out too, if they are off. */
    static const char as_asked[SPH_REPORTS] = {
        [SPH_REPORT_SHADOW] = 1,   [SPH_REPORT_REFLECT] = 1, [SPH_REPORT_REFRACT] = 1,
        [SPH_REPORT_SPECULAR] = 1, [SPH_REPORT_TEXTURE] = 1, [SPH_REPORT_SPREAD] = 1,
        [SPH_REPORT_LIGHTS] = 1};
    if (o->traverse != SPH_BUILD_NEAREST) return "first hits are not the nearest ones";
    if (sph_build_approximate(o)) return "options leave out what the scene has";
    for (int i = 0; i < SPH_REPORTS; i++)
        if (o->asked[i] == SPH_OFF && !as_asked[i]) return "options leave out what the scene has";
    if (scene->n_spheres + scene->n_facets > SPH_JUDGE_PRIMS) return "there are many primitives";
    return NULL;
}

int sph_judge_begin(const struct sph_scene *scene, const struct sph_build_options *o,
                    struct sph_judge *j, struct sph_error *err) {
    j->scene = *scene;
    if (o->lights != SPH_AUTO && o->lights < scene->n_lights) j->scene.n_lights = o->lights;
    j->options = *o;
    j->options.tree = sph_tree_of(scene, o);
    j->options.axes = sph_axes_of(scene, o);
    if (j->options.tree == SPH_TREE_REINSERTED) j->options.tree = SPH_TREE_BALANCED;
    if (j->options.tree == SPH_TREE_BRUTE) j->options.tree = SPH_TREE_BIH;
    j->options.background = SPH_BG_NONE;
    j->options.bases = NULL;
    j->options.kept = NULL;
    j->quiet = sph_progress_part(o->progress, 0, 0);
    j->options.progress = &j->quiet;
    j->options.unmet = NULL;
    j->options.numbers = NULL;
    j->options.later = 1;
    const struct sph_yardstick_options how = {
        .most = SPH_JUDGE_PIXELS, .lod = SPH_LOD_MENDED, .as_asked = 1};
    if (sph_yardstick_make(&j->scene, &j->options, &how, &j->yardstick, err)) return -1;
    const struct sph_reference *r = &j->yardstick.reference;
    j->decidable = 0;
    for (size_t i = 0; i < (size_t)r->width * (size_t)r->height; i++)
        j->decidable += !r->pixels[i].doubt;
    return 0;
}

void sph_judge_end(struct sph_judge *j) {
    sph_yardstick_free(&j->yardstick);
}

/* ---- the drawing ---- */

/* Every PARTS-th pixel is drawn, then those behind them, and so on. */
enum { PARTS = 16, PIXELS = 256 }; /* PIXELS: that are worth a thread */

struct job {
    const struct sph_yardstick *yardstick;
    struct sph_drawer drawer;
    uint32_t n, part; /* pixels of the yardstick */
    struct sph_squares *sum;
};

static void draw_part(void *user, uint32_t first, uint32_t end) {
    const struct job *j = user;
    const struct sph_yardstick *y = j->yardstick;
    struct sph_squares mine = {0};
    struct sph_counters counters = {{0}};
    uint32_t errors = 0, width = (uint32_t)y->width;
    struct sph_trail trail;
    for (uint32_t k = first; k < end; k++) {
        uint32_t i = k * PARTS + j->part, at = y->places ? y->places[i] : i;
        if (y->reference.pixels[i].doubt) continue;
        struct sph_pixel p = sph_drawer_pixel(&j->drawer, (int)(at % width), (int)(at / width),
                                              &counters, &errors, &trail);
        sph_squares_add(&mine, p.colour[SPH_FRAMES - 1],
                        y->reference.pixels[i].colour[SPH_FRAMES - 1]);
    }
    sph_parallel_lock();
    j->sum->n += mine.n;
    j->sum->square += mine.square;
    j->sum->weighed += mine.weighed;
    sph_parallel_unlock();
}

struct sph_measured sph_judge_widths(const struct sph_judge *judge,
                                     const struct sph_profile *widths, double enough) {
    const struct sph_yardstick *y = &judge->yardstick;
    struct sph_measured found = {0};
    struct sph_build_options o = judge->options;
    struct sph_error why = {""};
    struct sph_machine m;
    struct sph_build_report *report = malloc(sizeof *report);
    o.widths = widths;
    if (!report || sph_build(&judge->scene, &o, &m, report, &why)) {
        free(report);
        found.memory = !report || sph_error_memory(&why);
        return found;
    }
    struct sph_squares sum = {0};
    struct job j = {y, sph_drawer_begin(&m),
                    (uint32_t)y->reference.width * (uint32_t)y->reference.height, 0, &sum};
    for (; j.part < PARTS && j.part < j.n && !found.left; j.part++) {
        if (sph_progress_at(&judge->quiet, 0)) break;
        sph_parallel_for((j.n - 1 - j.part) / PARTS + 1, PIXELS, draw_part, &j);
        found.left = sph_squares_psnr(&sum, j.n) < enough; /* the rest of them equal */
    }
    sph_drawer_end(&j.drawer);
    sph_machine_free(&m);
    free(report);
    found.pixels = sum.n;
    found.of = (uint64_t)y->width * (uint64_t)y->height;
    found.psnr = sph_squares_psnr(&sum, found.left ? j.n : sum.n);
    found.psnr_least = y->places ? sph_squares_psnr_least(&sum) : found.psnr;
    return found;
}

int sph_judge_once(const struct sph_scene *scene, const struct sph_build_options *o,
                   const struct sph_profile *widths, struct sph_measured *measured,
                   struct sph_error *err) {
    struct sph_judge judge;
    if (sph_judge_begin(scene, o, &judge, err)) return -1;
    *measured = sph_judge_widths(&judge, widths, 0);
    sph_judge_end(&judge);
    return measured->memory ? sph_fail(err, "%s: no memory for a trial", scene->path) : 0;
}

/* ---- in words ---- */

int sph_picture_keeps(const struct sph_known_picture *p, const struct sph_error_bound *bound) {
    double psnr = p->measured.pixels ? p->measured.psnr_least : p->expected.psnr;
    return p->expected.fits && p->expected.pixels <= bound->pixels && psnr >= bound->psnr;
}

const char *sph_picture_says(const struct sph_known_picture *p, char *text, size_t size) {
    const struct sph_measured *m = &p->measured;
    text[0] = 0;
    if (!m->pixels)
        sph_note(text, size, "expected %.1f dB, a mean", p->expected.psnr);
    else if (m->left)
        sph_note(text, size, "measured less than %.1f dB", m->psnr);
    else if (isinf(m->psnr))
        sph_note(text, size, "measured no difference in %llu pixels",
                 (unsigned long long)m->pixels);
    else
        sph_note(text, size, "measured %.1f dB of %llu pixels", m->psnr,
                 (unsigned long long)m->pixels);
    if (m->pixels && !m->left && m->psnr_least != m->psnr)
        sph_note(text, size, ", at least %.1f dB of all %llu with %.1f %% confidence",
                 m->psnr_least, (unsigned long long)m->of, 100 * SPH_TRIAL_SURE);
    sph_note(text, size, ", %.2g pixels off at most", p->expected.pixels);
    return text;
}
