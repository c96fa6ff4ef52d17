/* workers.c - see workers.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * A job has a canvas of its own. A worker that is late, as on a loaded machine, still writes to the
 * canvas of the job before, and nobody waits for it.
 */
#include "view/workers.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

#include "render/render.h"

enum { LESS = 4 }; /* of nice, than the thread that answers */

struct canvas {
    struct view_job job;
    int busy; /* workers at it; under the lock */
    /* read and written by several threads at once, by __atomic functions */
    int stop;              /* they are to leave it */
    int next;              /* row of the job to be taken, all passes in one row */
    int left[VIEW_PASSES]; /* rows not done */
    uint8_t *done;         /* of each cell: it may be read */
    struct view_cell *cells;
};

struct view_workers {
    int width, height, n, n_canvases;
    pthread_t *threads;
    pthread_mutex_t lock;
    pthread_cond_t started, ended;
    struct canvas *canvases; /* two more than threads: one is always free */
    struct canvas *now;      /* of the newest job, NULL: none */
    int asked, quit;         /* asked: counts jobs */
};

static int step_of(int pass) {
    return VIEW_COARSEST >> pass;
}

static int rows_of(const struct view_workers *w, int pass) {
    return (w->height + step_of(pass) - 1) / step_of(pass);
}

/* Draws what a row of a pass adds; 0 if it was told to stop. */
static int draw_row(const struct view_workers *w, struct canvas *c, struct sph_machine *m, int pass,
                    int y) {
    const struct sph_render_options how = {.traverse = SPH_TRAVERSE_FAST, .fast = c->job.fast};
    int step = step_of(pass), old = pass && y % (2 * step) == 0;
    for (int x = old ? step : 0; x < w->width; x += old ? 2 * step : step) {
        if (__atomic_load_n(&c->stop, __ATOMIC_RELAXED)) return 0;
        size_t at = (size_t)y * (size_t)w->width + (size_t)x;
        view_cell_draw(m, &c->job.aim, &how, x, y, &c->cells[at]);
        __atomic_store_n(&c->done[at], 1, __ATOMIC_RELEASE);
    }
    return 1;
}

static void draw(const struct view_workers *w, struct canvas *c) {
    struct sph_machine m;
    view_aim_start(c->job.machine, &c->job.aim, &m);
    for (;;) {
        int row = __atomic_fetch_add(&c->next, 1, __ATOMIC_RELAXED), pass = 0;
        while (pass < VIEW_PASSES && row >= rows_of(w, pass))
            row -= rows_of(w, pass++);
        if (pass == VIEW_PASSES || !draw_row(w, c, &m, pass, row * step_of(pass))) return;
        __atomic_fetch_sub(&c->left[pass], 1, __ATOMIC_RELEASE);
    }
}

static void *work(void *user) {
    struct view_workers *w = user;
    int seen = 0;
    setpriority(PRIO_PROCESS, 0, getpriority(PRIO_PROCESS, 0) + LESS); /* of this thread */
    pthread_mutex_lock(&w->lock);
    while (!w->quit) {
        struct canvas *c = w->now;
        if (seen == w->asked || !c) {
            pthread_cond_wait(&w->started, &w->lock);
            continue;
        }
        seen = w->asked;
        c->busy++;
        pthread_mutex_unlock(&w->lock);
        draw(w, c);
        pthread_mutex_lock(&w->lock);
        c->busy--;
    }
    pthread_mutex_unlock(&w->lock);
    return NULL;
}

static int make_canvas(const struct view_workers *w, struct canvas *c) {
    size_t n = (size_t)w->width * (size_t)w->height;
    if (!c->cells) c->cells = malloc(n * sizeof *c->cells);
    if (!c->done) c->done = malloc(n * sizeof *c->done);
    return c->cells && c->done;
}

struct view_workers *view_workers_new(int width, int height, int threads, struct sph_error *err) {
    struct view_workers *w = calloc(1, sizeof *w);
    long processors = sysconf(_SC_NPROCESSORS_ONLN);
    int wanted = threads > 0 ? threads : processors > 0 ? (int)processors : 1;
    if (w) {
        *w = (struct view_workers){.width = width, .height = height, .n_canvases = wanted + 2};
        pthread_mutex_init(&w->lock, NULL);
        pthread_cond_init(&w->started, NULL);
        w->threads = malloc((size_t)wanted * sizeof *w->threads);
        w->canvases = calloc((size_t)w->n_canvases, sizeof *w->canvases);
    }
    if (!w || !w->threads || !w->canvases || !make_canvas(w, w->canvases)) {
        sph_fail(err, "no memory for a picture of %dx%d", width, height);
        view_workers_free(w);
        return NULL;
    }
    while (w->n < wanted && !pthread_create(&w->threads[w->n], NULL, work, w))
        w->n++;
    if (w->n) return w;
    sph_fail(err, "no thread can be started");
    view_workers_free(w);
    return NULL;
}

void view_workers_free(struct view_workers *w) {
    if (!w) return;
    pthread_mutex_lock(&w->lock);
    if (w->now) __atomic_store_n(&w->now->stop, 1, __ATOMIC_RELAXED);
    w->quit = 1;
    pthread_cond_broadcast(&w->started);
    pthread_mutex_unlock(&w->lock);
    for (int i = 0; i < w->n; i++)
        pthread_join(w->threads[i], NULL);
    for (int i = 0; w->canvases && i < w->n_canvases; i++) {
        free(w->canvases[i].cells);
        free(w->canvases[i].done);
    }
    pthread_cond_destroy(&w->started);
    pthread_mutex_destroy(&w->lock);
    free(w->canvases);
    free(w->threads);
    free(w);
}

/* A canvas that no worker writes to, other than the newest. NULL: no memory. */
static struct canvas *free_canvas(struct view_workers *w) {
    for (int i = 0; i < w->n_canvases; i++) {
        struct canvas *c = &w->canvases[i];
        if (c != w->now && !c->busy) return make_canvas(w, c) ? c : NULL;
    }
    return NULL;
}

int view_workers_start(struct view_workers *w, const struct view_job *job) {
    pthread_mutex_lock(&w->lock);
    struct canvas *c = free_canvas(w);
    if (c) {
        c->job = *job;
        memset(c->done, 0, (size_t)w->width * (size_t)w->height);
        for (int pass = 0; pass < VIEW_PASSES; pass++)
            c->left[pass] = rows_of(w, pass);
        c->next = c->stop = 0;
        if (w->now) __atomic_store_n(&w->now->stop, 1, __ATOMIC_RELAXED);
        w->now = c;
        w->asked++;
        pthread_cond_broadcast(&w->started);
    }
    pthread_mutex_unlock(&w->lock);
    return c ? 0 : -1;
}

int view_workers_need(struct view_workers *w, const struct sph_machine *machine) {
    int need = 0;
    pthread_mutex_lock(&w->lock);
    for (int i = 0; i < w->n_canvases; i++) {
        const struct canvas *c = &w->canvases[i];
        need |= (c->busy || c == w->now) && c->job.machine == machine;
    }
    pthread_mutex_unlock(&w->lock);
    return need;
}

int view_workers_passes(struct view_workers *w) {
    int passes = 0;
    while (w->now && passes < VIEW_PASSES &&
           !__atomic_load_n(&w->now->left[passes], __ATOMIC_ACQUIRE))
        passes++;
    return passes;
}

void view_workers_paint(struct view_workers *w, const struct view_paint *how, const uint32_t *under,
                        uint32_t *pixels) {
    struct canvas *c = w->now;
    if (!c) return;
    for (int y = 0; y < w->height; y++)
        for (int x = 0; x < w->width; x++) {
            size_t at = (size_t)y * (size_t)w->width + (size_t)x, from = at;
            int step = 1, drawn = 0;
            for (; step <= VIEW_COARSEST && !drawn; step *= 2) {
                from = (size_t)(y & -step) * (size_t)w->width + (size_t)(x & -step);
                drawn = __atomic_load_n(&c->done[from], __ATOMIC_ACQUIRE);
                if (under) break;
            }
            if (drawn && from != at)
                pixels[at] = pixels[from]; /* painted before */
            else if (drawn)
                pixels[at] = view_paint(how, &c->cells[at], at);
            else if (under)
                pixels[at] = under[at];
        }
}
