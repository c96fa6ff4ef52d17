/* maker.c - see maker.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "view/maker.h"

#include <pthread.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <time.h>

#include "reference/reference.h"
#include "trial/price.h"

enum { LESS = 10 }; /* of nice: a tenth of what a thread that draws gets */

struct view_maker {
    const struct sph_scene *scene;
    view_make *make;
    pthread_t thread;
    pthread_mutex_t lock;
    pthread_cond_t asked;
    struct view_made *wanted, *made;
    int busy, quit;
};

void view_make_machine(const struct sph_scene *scene, struct view_made *made) {
    struct sph_scene seen = *scene;
    struct sph_build_report *report = malloc(sizeof *report);
    seen.camera = made->camera;
    made->failed = report ? sph_build(&seen, &made->build, &made->machine, report, &made->err)
                          : sph_fail(&made->err, "no memory for a machine");
    free(report);
    if (!made->failed) made->fast = sph_fast_new(&made->machine, SPH_FAST_BEST);
}

void view_make_truth(const struct sph_scene *scene, struct view_made *made) {
    struct sph_scene seen = *scene;
    struct sph_reference reference = {0};
    seen.camera = made->camera;
    struct sph_reference_options how = {.width = made->build.width,
                                        .height = made->build.height,
                                        .max_depth = made->build.max_depth,
                                        .shadow = 1,
                                        .reflect = 1,
                                        .refract = 1,
                                        .specular = 1,
                                        .threads = 1,
                                        .mips = made->build.mips,
                                        .filter = made->build.tex_filter};
    made->failed = sph_reference_render(&seen, &how, &reference, &made->err);
    size_t n = (size_t)reference.width * (size_t)reference.height;
    if (!made->failed) made->truth = malloc(n * sizeof *made->truth);
    if (!made->failed && !made->truth) made->failed = sph_fail(&made->err, "no memory");
    for (size_t i = 0; !made->failed && i < n; i++)
        made->truth[i] =
            (struct view_truth){reference.pixels[i].colour[SPH_FRAMES - 1], reference.pixels[i].id};
    sph_reference_free(&reference);
}

void view_make_price(const struct sph_scene *scene, struct view_made *made) {
    enum { PIXELS = 8192 }; /* that are looked at */
    struct sph_scene seen = *scene;
    struct sph_price *price = malloc(sizeof *price);
    const struct sph_price_options how = {
        .only = sph_build_profile(&made->build), .most = PIXELS, .threads = 1};
    seen.camera = made->camera;
    made->failed = price ? sph_price_make(&seen, &made->build, &how, price, &made->err)
                         : sph_fail(&made->err, "no memory");
    const struct sph_price_row *row = made->failed ? NULL : &price->row[0];
    if (row && !row->built) made->failed = sph_fail(&made->err, "%s", row->why);
    if (row && row->built)
        made->price = (struct view_price){
            row->accuracy.image.psnr[SPH_FRAMES - 1], row->cycles.pixel, row->wrong,
            row->cycles.most < 0 ? "nothing" : sph_load_name(row->cycles.most)};
    free(price);
}

static void *work(void *user) {
    struct view_maker *m = user;
    setpriority(PRIO_PROCESS, 0, getpriority(PRIO_PROCESS, 0) + LESS); /* of this thread */
    pthread_mutex_lock(&m->lock);
    while (!m->quit) {
        struct view_made *made = m->wanted;
        struct timespec start, end;
        if (!made) {
            pthread_cond_wait(&m->asked, &m->lock);
            continue;
        }
        m->wanted = NULL;
        pthread_mutex_unlock(&m->lock);
        clock_gettime(CLOCK_MONOTONIC, &start);
        m->make(m->scene, made);
        clock_gettime(CLOCK_MONOTONIC, &end);
        made->seconds =
            (double)(end.tv_sec - start.tv_sec) + 1e-9 * (double)(end.tv_nsec - start.tv_nsec);
        pthread_mutex_lock(&m->lock);
        m->made = made;
        m->busy = 0;
    }
    pthread_mutex_unlock(&m->lock);
    return NULL;
}

struct view_maker *view_maker_new(const struct sph_scene *scene, view_make *make) {
    struct view_maker *m = calloc(1, sizeof *m);
    if (!m) return NULL;
    *m = (struct view_maker){.scene = scene, .make = make};
    pthread_mutex_init(&m->lock, NULL);
    pthread_cond_init(&m->asked, NULL);
    if (!pthread_create(&m->thread, NULL, work, m)) return m;
    free(m);
    return NULL;
}

int view_maker_free(struct view_maker *m) {
    if (!m) return 0;
    pthread_mutex_lock(&m->lock);
    m->quit = 1;
    int busy = m->busy;
    pthread_cond_signal(&m->asked);
    pthread_mutex_unlock(&m->lock);
    if (busy) {
        pthread_detach(m->thread);
        return 1;
    }
    pthread_join(m->thread, NULL);
    view_made_free(m->made);
    pthread_cond_destroy(&m->asked);
    pthread_mutex_destroy(&m->lock);
    free(m);
    return 0;
}

int view_maker_busy(struct view_maker *m) {
    pthread_mutex_lock(&m->lock);
    int busy = m->busy || m->made;
    pthread_mutex_unlock(&m->lock);
    return busy;
}

int view_maker_ask(struct view_maker *m, const struct view_made *want) {
    struct view_made *made = malloc(sizeof *made);
    if (!made) return -1;
    *made = *want;
    pthread_mutex_lock(&m->lock);
    m->wanted = made;
    m->busy = 1;
    pthread_cond_signal(&m->asked);
    pthread_mutex_unlock(&m->lock);
    return 0;
}

struct view_made *view_maker_take(struct view_maker *m) {
    pthread_mutex_lock(&m->lock);
    struct view_made *made = m->made;
    m->made = NULL;
    pthread_mutex_unlock(&m->lock);
    return made;
}

void view_made_free(struct view_made *made) {
    if (!made) return;
    sph_fast_free(made->fast);
    sph_machine_free(&made->machine);
    free(made->truth);
    free(made);
}
