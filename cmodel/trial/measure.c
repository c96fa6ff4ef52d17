/* measure.c - see measure.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "trial/measure.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "common/parallel.h"
#include "pixel/background.h"
#include "render/render.h"
#include "scene/rng.h"
#include "trial/draw.h"

/* Seconds of processor, all threads. */
static double cpu_now(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* ---- the sample ---- */

static uint64_t cells(int side, int cell) {
    return (uint64_t)((side + cell - 1) / cell);
}

/* A pixel of each cell, where a random number has it: none, if that is outside the frame, so that
 * cells cut by its edge count for what they are. Returns how many. */
static uint32_t sample(struct sph_yardstick *y, uint32_t most) {
    struct sph_rng rng = {0};
    uint32_t n = 0;
    int across = 1, down = 1;
    while (cells(y->width, across) * cells(y->height, down) > most)
        *(down < y->height && (across > down || across == y->width) ? &down : &across) += 1;
    y->places = malloc(cells(y->width, across) * cells(y->height, down) * sizeof *y->places);
    if (!y->places) return 0;
    for (int top = 0; top < y->height; top += down)
        for (int left = 0; left < y->width; left += across) {
            int at_x = left + (int)sph_rng_range(&rng, 0, across);
            int at_y = top + (int)sph_rng_range(&rng, 0, down);
            if (at_x < y->width && at_y < y->height)
                y->places[n++] = (uint32_t)at_y * (uint32_t)y->width + (uint32_t)at_x;
        }
    return n;
}

int sph_yardstick_make(const struct sph_scene *scene, const struct sph_build_options *o,
                       const struct sph_yardstick_options *asked, struct sph_yardstick *y,
                       struct sph_error *err) {
    int all = !asked->as_asked;
    *y = (struct sph_yardstick){.scene = scene,
                                .width = o->width ? o->width : scene->camera.width,
                                .height = o->height ? o->height : scene->camera.height};
    struct sph_reference_options how = {.width = y->width,
                                        .height = y->height,
                                        .max_depth = o->max_depth,
                                        .shadow = all || o->shadow != SPH_OFF,
                                        .reflect = all || o->reflect != SPH_OFF,
                                        .refract = all || o->refract != SPH_OFF,
                                        .specular = all || o->specular != SPH_OFF,
                                        .threads = asked->threads,
                                        .mips = o->texture == SPH_OFF ? NULL : o->mips,
                                        .filter = o->tex_filter,
                                        .lod = asked->lod,
                                        .spread = o->spread != SPH_OFF,
                                        .progress = o->progress};
    double start = cpu_now();
    if (asked->most && (uint64_t)y->width * (uint64_t)y->height > asked->most) {
        how.n_places = sample(y, asked->most);
        how.places = y->places;
        if (!y->places) return sph_fail(err, "%s: no memory for a sample", scene->path);
    }
    if (sph_reference_render(scene, &how, &y->reference, err)) {
        sph_yardstick_free(y);
        return -1;
    }
    y->seconds = cpu_now() - start;
    return 0;
}

void sph_yardstick_free(struct sph_yardstick *y) {
    sph_reference_free(&y->reference);
    free(y->places);
    y->places = NULL;
}

/* ---- the drawing ---- */

struct job {
    const struct sph_yardstick *yardstick;
    struct sph_trial *trial;
    struct sph_drawer drawer;
};

static void draw_part(void *user, uint32_t first, uint32_t end) {
    const struct job *j = user;
    struct sph_counters mine = {{0}};
    uint32_t errors = 0;
    for (uint32_t i = first; i < end; i++) {
        uint32_t at = j->yardstick->places[i], width = (uint32_t)j->yardstick->width;
        j->trial->shot.frame.pixels[i] = sph_drawer_pixel(
            &j->drawer, (int)(at % width), (int)(at / width), &mine, &errors, &j->trial->trails[i]);
    }
    sph_parallel_lock();
    j->trial->shot.errors |= errors;
    for (int c = 0; c < SPH_COUNTERS; c++)
        j->trial->shot.counters.count[c] += mine.count[c];
    sph_parallel_unlock();
}

/* The places of the sample alone. */
static int draw_places(const struct sph_yardstick *y, struct sph_trial *t, int threads,
                       struct sph_error *err) {
    enum { PIXELS = 256 }; /* that are worth a thread */
    struct sph_shot *shot = &t->shot;
    const struct sph_reference *like = &y->reference;
    shot->frame = (struct sph_frame){like->width, like->height, NULL};
    shot->frame.pixels = calloc((size_t)like->width, sizeof *shot->frame.pixels);
    if (!shot->frame.pixels) return sph_fail(err, "%s: no memory for a sample", t->machine.name);
    struct job j = {y, t, sph_drawer_begin(&t->machine)};
    shot->errors = sph_background_missing(&t->machine) ? 1u << SPH_ERROR_BAD_NODE : 0;
    int before = sph_parallel_most(threads);
    sph_parallel_for((uint32_t)like->width, PIXELS, draw_part, &j);
    sph_parallel_most(before);
    sph_drawer_end(&j.drawer);
    return 0;
}

static int draw_all(struct sph_trial *t, int threads, struct sph_error *err) {
    struct sph_render_options how = {
        .traverse = SPH_TRAVERSE_FAST, .threads = threads, .trails = t->trails};
    int bits = sph_render(&t->machine, &how, &t->shot.frame, &t->shot.counters, err);
    t->shot.errors = (uint32_t)bits;
    return bits < 0 ? -1 : 0;
}

/* ---- what it is worth ---- */

/* Probability of k or fewer of n, each of which is one with probability p. */
static double few(uint64_t k, uint64_t n, double p) {
    double sum = 0, all = lgamma((double)n + 1);
    for (uint64_t i = 0; i <= k; i++)
        sum += exp(all - lgamma((double)i + 1) - lgamma((double)(n - i) + 1) + (double)i * log(p) +
                   (double)(n - i) * log1p(-p));
    return sum;
}

double sph_trial_at_most(uint64_t k, uint64_t n) {
    enum { HALVINGS = 40 };
    if (k >= n) return 1;
    double low = (double)k / (double)n, high = 1;
    for (int i = 0; i < HALVINGS; i++) {
        double middle = (low + high) / 2;
        *(few(k, n, middle) > 1 - SPH_TRIAL_SURE ? &low : &high) = middle;
    }
    return high;
}

#define FULL (255.0 * 255 * 3) /* squared error of black against white */
#define BET 0.9                /* near 1: wide where no pixel is far off it is not */
#define WEIGHED 4294967296.0   /* 2^32 */

void sph_squares_add(struct sph_squares *s, uint32_t colour, uint32_t like) {
    uint32_t square = 0;
    for (int shift = 0; shift < 24; shift += 8) {
        int off = (int)(colour >> shift & 255) - (int)(like >> shift & 255);
        square += (uint32_t)(off * off);
    }
    s->n++;
    s->square += square;
    if (square) s->weighed += (uint64_t)ceil(-log1p(-BET * square / FULL) * WEIGHED);
}

double sph_squares_psnr(const struct sph_squares *s, uint64_t n) {
    return s->square ? 10 * log10(FULL * (double)n / (double)s->square) : INFINITY;
}

double sph_squares_psnr_least(const struct sph_squares *s) {
    double weighed = (double)s->weighed / WEIGHED, sure = log(SPH_PROFILES / (1 - SPH_TRIAL_SURE));
    if (!s->n) return 0;
    return fmax(-10 * log10(-expm1(-(weighed + sure) / (double)s->n) / BET), 0);
}

/* The same of a sample that was drawn. */
static double psnr_least(const struct sph_yardstick *y, const struct sph_frame *drawn) {
    const struct sph_reference *like = &y->reference;
    struct sph_squares s = {0};
    for (int i = 0; i < like->width; i++)
        if (!like->pixels[i].doubt)
            sph_squares_add(&s, drawn->pixels[i].colour[SPH_FRAMES - 1],
                            like->pixels[i].colour[SPH_FRAMES - 1]);
    return sph_squares_psnr_least(&s);
}

void sph_trial_judge(const struct sph_yardstick *y, struct sph_trial *t) {
    sph_accuracy_number(t->numbers, &t->shot.frame, t->trails);
    struct sph_accuracy_frame f = {&t->machine,      &t->shot.frame,      t->trails,
                                   t->report.lights, t->report.eye.ahead, t->report.eye.wider,
                                   y->places};
    t->accuracy = sph_accuracy_measure(&f, &y->reference);
    const struct sph_image_error *e = &t->accuracy.image;
    uint64_t counted = e->pixels - e->undecidable;
    t->wrong = e->silhouette + e->wrong_id;
    t->psnr_least = e->psnr[SPH_FRAMES - 1];
    t->wrong_most = counted ? (double)t->wrong / (double)counted : 0;
    if (!y->places) return;
    t->psnr_least = psnr_least(y, &t->shot.frame);
    t->wrong_most = sph_trial_at_most(t->wrong, counted);
}

int sph_trial_draw(const struct sph_yardstick *y, int threads, struct sph_trial *t,
                   struct sph_error *err) {
    size_t n = (size_t)y->reference.width * (size_t)y->reference.height;
    t->trails = calloc(n, sizeof *t->trails);
    if (!t->trails) return sph_fail(err, "%s: no memory for the rays of a frame", y->scene->path);
    double start = cpu_now();
    if (y->places ? draw_places(y, t, threads, err) : draw_all(t, threads, err)) return -1;
    t->seconds = cpu_now() - start;
    return 0;
}

int sph_trial_measure(const struct sph_yardstick *y, const struct sph_build_options *options,
                      int threads, struct sph_trial *t, struct sph_error *err) {
    struct sph_build_options o = *options;
    memset(t, 0, sizeof *t);
    o.numbers = t->numbers =
        malloc((y->scene->n_spheres + y->scene->n_facets + 1ull) * sizeof *t->numbers);
    if (!t->numbers)
        return sph_fail(err, "%s: no memory for the numbers of primitives", y->scene->path);
    int rc =
        sph_build(y->scene, &o, &t->machine, &t->report, err) || sph_trial_draw(y, threads, t, err);
    if (rc) {
        sph_trial_free(t);
        return -1;
    }
    sph_trial_judge(y, t);
    return 0;
}

void sph_trial_free(struct sph_trial *t) {
    sph_machine_free(&t->machine);
    sph_frame_free(&t->shot.frame);
    free(t->trails);
    free(t->numbers);
    t->trails = NULL;
    t->numbers = NULL;
}
