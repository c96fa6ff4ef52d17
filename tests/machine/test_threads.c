/* test_threads.c - several threads of a program use the library at once, each with threads of its
 * own: build, render, batches of rays, one machine or many, and drawings that are stopped. Besides
 * as other suites it runs under ThreadSanitizer.
 * SPDX-License-Identifier: Apache-2.0
 */
#include <pthread.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>

#include <cmocka.h>

#include "sphaera/sphaera.h"

enum { WORKERS = 3, RAYS = 1000, WIDTH = 32, HEIGHT = 18 };

struct worker {
    const sphaera_machine *shared;
    int number, failed;
    uint64_t built, drawn; /* hashes: of a machine of its own, of the shared one */
    uint32_t id[RAYS], again[RAYS];
};

static sphaera_machine *build(int width, int height) {
    sphaera_scene *scene = NULL;
    sphaera_machine *machine = NULL;
    sphaera_build_options options;
    sphaera_build_init(&options);
    options.profile = "standard", options.width = width, options.height = height;
    if (!sphaera_scene_read("scenes/paper100.nff", 0, &scene, NULL))
        sphaera_build(scene, &options, &machine, NULL);
    sphaera_scene_free(scene);
    return machine;
}

static uint64_t hash_of(const sphaera_machine *machine, const char *traverse) {
    sphaera_render_options options;
    sphaera_frame *frame = NULL;
    sphaera_render_init(&options);
    options.threads = 3, options.traverse = traverse;
    if (!machine || sphaera_render_with(machine, &options, &frame, NULL)) return 0;
    uint64_t hash = sphaera_frame_hash(frame);
    sphaera_frame_free(frame);
    return hash;
}

static void *work(void *user) {
    static const char *const ways[] = {"fast", "literal"};
    struct worker *w = user;
    double *origins = calloc(RAYS, 3 * sizeof *origins);
    double *directions = calloc(RAYS, 3 * sizeof *directions);
    sphaera_machine *mine = build(WIDTH, HEIGHT);
    sphaera_hits hits = {.id = w->id}, again = {.id = w->again};
    for (int i = 0; i < RAYS && origins && directions; i++) {
        origins[3 * i + 2] = 0.25;
        directions[3 * i] = (i % 50 - 25) / 25.0;
        directions[3 * i + 1] = (i / 50 - 10) / 20.0;
        directions[3 * i + 2] = -1;
    }
    w->built = hash_of(mine, ways[w->number % 2]);
    w->drawn = hash_of(w->shared, ways[w->number % 2]);
    w->failed = !origins || !directions || !w->built ||
                sphaera_trace_rays(w->shared, RAYS, origins, directions, 4, &hits, NULL) ||
                sphaera_trace_rays(mine, RAYS, origins, directions, 1, &again, NULL);
    sphaera_machine_free(mine);
    free(directions);
    free(origins);
    return NULL;
}

/* All of them get what one alone gets. */
static void test_at_once(void **unused) {
    static struct worker workers[WORKERS];
    pthread_t threads[WORKERS];
    sphaera_machine *shared = build(WIDTH, HEIGHT);
    (void)unused;
    assert_non_null(shared);
    uint64_t alone = hash_of(shared, "literal");
    for (int i = 0; i < WORKERS; i++) {
        workers[i] = (struct worker){.shared = shared, .number = i};
        assert_int_equal(pthread_create(&threads[i], NULL, work, &workers[i]), 0);
    }
    for (int i = 0; i < WORKERS; i++)
        pthread_join(threads[i], NULL);
    for (int i = 0; i < WORKERS; i++) {
        assert_int_equal(workers[i].failed, 0);
        assert_true(workers[i].built == alone && workers[i].drawn == alone);
        assert_memory_equal(workers[i].id, workers[0].again, sizeof workers[i].id);
    }
    sphaera_machine_free(shared);
}

/* ---- the end of a drawing ---- */

struct drawing {
    const sphaera_machine *machine;
    int stop, code;
};

static int any(void *user, int done, int all) {
    (void)user, (void)done, (void)all;
    return 0;
}

static void *draw(void *user) {
    struct drawing *d = user;
    sphaera_frame *frame = NULL;
    sphaera_render_options options;
    sphaera_render_init(&options);
    options.threads = 3, options.stop = &d->stop, options.progress = any;
    d->code = sphaera_render_with(d->machine, &options, &frame, NULL);
    sphaera_frame_free(frame);
    return NULL;
}

/* One is stopped from outside, the others of the same machine go on. */
static void test_stop(void **unused) {
    sphaera_machine *large = build(4000, 2250), *small = build(WIDTH, HEIGHT);
    struct drawing drawing = {.machine = large};
    pthread_t thread;
    (void)unused;
    assert_non_null(large);
    assert_int_equal(pthread_create(&thread, NULL, draw, &drawing), 0);
    uint64_t one = hash_of(small, "fast"), other = hash_of(small, "fast");
    __atomic_store_n(&drawing.stop, 1, __ATOMIC_RELAXED);
    pthread_join(thread, NULL);
    assert_int_equal(drawing.code, -1);
    assert_true(one && one == other);
    sphaera_machine_free(small);
    sphaera_machine_free(large);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_at_once), cmocka_unit_test(test_stop)};
    return cmocka_run_group_tests_name("threads", tests, NULL, NULL);
}
