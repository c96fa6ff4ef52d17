/* test_environment.c - the library draws the same in a fork, whatever the caller rounds to and
 * whatever OMP_NUM_THREADS is; and it stops
 * SPDX-License-Identifier: Apache-2.0
 */
#include "sphaera/sphaera.h"

/* clang-format off: cmocka.h needs these before it */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
/* clang-format on */
#include <dlfcn.h>
#include <fenv.h>
#include <pthread.h>
#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

static int started; /* threads */

int pthread_create(pthread_t *thread, const pthread_attr_t *attr, void *(*run)(void *),
                   void *user) {
    int (*next)(pthread_t *, const pthread_attr_t *, void *(*)(void *), void *);
    *(void **)&next = dlsym(RTLD_NEXT, "pthread_create");
    __atomic_add_fetch(&started, 1, __ATOMIC_RELAXED);
    return next(thread, attr, run, user);
}

/* Small scenes are built by one thread; large ones, and frames, by as many as there are. */
static void test_threads(void **unused) {
    static const struct {
        const char *path;
        int shared;
    } cases[] = {{"scenes/paper100.nff", 0}, {"scenes/facets/room.nff", 0}, {"many", 1}};
    cpu_set_t set;
    (void)unused;
    assert_int_equal(sched_getaffinity(0, sizeof set, &set), 0);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char *text = NULL;
        size_t size;
        sphaera_scene *s;
        sphaera_machine *m;
        sphaera_frame *f;
        sphaera_error e = {""};
        FILE *out = open_memstream(&text, &size);
        fputs("v\nfrom 0 0 99\nat 0 0 0\nup 0 1 0\nangle 40\nhither 1\nresolution 64 36\n"
              "f 1 0 0 1 0 0 0 1\n",
              out);
        for (int k = 0; k < 20000; k++)
            fprintf(out, "s %d %d %d .4\n", k % 30 - 15, k / 30 % 30 - 15, k / 900 - 9);
        fclose(out);
        int rc = cases[i].shared ? sphaera_scene_parse(text, size, "many", 0, &s, &e)
                                 : sphaera_scene_read(cases[i].path, 0, &s, &e);
        if (rc) fail_msg("%s", e.text);
        started = 0;
        sphaera_build_options o;
        sphaera_build_init(&o);
        o.profile = "standard"; /* auto draws pictures, which threads share */
        o.accel = "bvh4";
        if (sphaera_build(s, &o, &m, &e)) fail_msg("%s", e.text);
        int shared = started > 0;
        if (shared != (cases[i].shared && CPU_COUNT(&set) > 1))
            fail_msg("%s: %d threads", cases[i].path, started);
        started = 0;
        assert_int_equal(sphaera_render(m, 3, &f, &e), 0);
        assert_int_equal(started, 2);
        sphaera_frame_free(f);
        sphaera_machine_free(m);
        sphaera_scene_free(s);
        free(text);
    }
}

static const char *const scenes[] = {
    "paper5",      "interpenetrating", "materials",         "huge_tiny",
    "facets/room", "facets/plane",     "refraction/nested", "texture/slant",
};
enum { SCENES = sizeof scenes / sizeof *scenes };

/* Hash of a file's bytes, which is removed. */
static uint64_t of_file(uint64_t hash, const char *file) {
    FILE *in = fopen(file, "rb");
    for (int c; (c = getc(in)) != EOF;)
        hash = 31 * hash + (uint64_t)c;
    fclose(in);
    unlink(file);
    return hash;
}

/* Hash of all that the library makes of a scene: machine file, frame, picture, a ray. */
static uint64_t made(const char *name) {
    char path[64], file[] = "/tmp/sphaera-XXXXXX", picture[sizeof file + 4];
    sphaera_scene *s;
    sphaera_machine *m;
    sphaera_frame *f;
    sphaera_hit hit;
    sphaera_error e;
    sphaera_build_options o;
    const double from[3] = {0, 0, 0}, to[3] = {0.1, -0.7, 0.3};
    snprintf(path, sizeof path, "scenes/%s.nff", name);
    sphaera_build_init(&o);
    o.width = 24, o.height = 14;
    if (sphaera_scene_read(path, 0, &s, &e) || sphaera_build(s, &o, &m, &e) ||
        sphaera_render(m, 2, &f, &e))
        fail_msg("%s", e.text);
    uint64_t hash = sphaera_frame_hash(f);
    if (!sphaera_trace(m, from, to, &hit, NULL))
        for (int i = 0; i < 3; i++)
            hash = 31 * hash + (uint64_t)(1e6 * hit.point[i]);
    close(mkstemp(file));
    snprintf(picture, sizeof picture, "%s.png", file);
    if (sphaera_machine_write(m, file, &e) || sphaera_frame_write(f, picture, &e))
        fail_msg("%s", e.text);
    hash = of_file(of_file(hash, file), picture);
    sphaera_frame_free(f);
    sphaera_machine_free(m);
    sphaera_scene_free(s);
    return hash;
}

/* The caller's rounding and traps change nothing, and stay. */
static void test_environment(void **unused) {
    static const int rounds[] = {FE_TONEAREST, FE_DOWNWARD, FE_UPWARD, FE_TOWARDZERO};
    (void)unused;
    for (int n = 0; n < SCENES; n++) {
        uint64_t right = made(scenes[n]);
        for (int i = 0; i < 8; i++) {
            fesetround(rounds[i / 2]);
            if (i % 2) feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW | FE_UNDERFLOW);
            feraiseexcept(FE_INEXACT);
            uint64_t hash = made(scenes[n]);
            int round = fegetround(), traps = fegetexcept(), flag = fetestexcept(FE_INEXACT);
            fesetenv(FE_DFL_ENV);
            if (hash != right) fail_msg("%s is another one in environment %d", scenes[n], i);
            assert_int_equal(round, rounds[i / 2]);
            assert_int_equal(traps != 0, i % 2);
            assert_true(flag);
        }
    }
}

static sphaera_machine *machine_of(const char *path, int width, int height) {
    sphaera_scene *s;
    sphaera_machine *m;
    sphaera_error e;
    sphaera_build_options o;
    sphaera_build_init(&o);
    o.profile = "standard", o.width = width, o.height = height;
    if (sphaera_scene_read(path, 0, &s, &e) || sphaera_build(s, &o, &m, &e)) fail_msg("%s", e.text);
    sphaera_scene_free(s);
    return m;
}

/* As many threads as OMP_NUM_THREADS says, and no more than there are processors. */
static void test_omp(void **unused) {
    static const struct {
        const char *threads;
        int most; /* 0: one for every processor */
    } cases[] = {
        {"1", 1},   {"2", 2},  {"100000", 0}, {"99999999999999999999", 0},
        {"1,4", 1}, /* nested */
        {"0", 0},   {"-1", 0}, {"many", 0},   {"1x", 0},
        {"", 0},
    };
    sphaera_machine *m = machine_of("scenes/paper100.nff", 64, 36);
    cpu_set_t set;
    sphaera_frame *f;
    sphaera_error e;
    uint64_t right = 0;
    (void)unused;
    assert_int_equal(sched_getaffinity(0, sizeof set, &set), 0);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        int n = CPU_COUNT(&set), most = cases[i].most && cases[i].most < n ? cases[i].most : n;
        setenv("OMP_NUM_THREADS", cases[i].threads, 1);
        started = 0;
        if (sphaera_render(m, 0, &f, &e)) fail_msg("%s", e.text);
        if (started > most - 1 || (most > 1 && !started))
            fail_msg("OMP_NUM_THREADS=%s: %d threads beside the caller", cases[i].threads, started);
        if (!i) right = sphaera_frame_hash(f);
        assert_true(sphaera_frame_hash(f) == right);
        sphaera_frame_free(f);
    }
    unsetenv("OMP_NUM_THREADS");
    sphaera_machine_free(m);
}

static int stop;
static struct timespec stopped_at;

static void *stop_soon(void *unused) {
    usleep(50000);
    clock_gettime(CLOCK_MONOTONIC, &stopped_at);
    __atomic_store_n(&stop, 1, __ATOMIC_RELAXED);
    return unused;
}

/* A drawing of seconds ends within a tenth of one; on a busy machine one of some tries does. */
static void test_stop(void **unused) {
#ifdef __SANITIZE_ADDRESS__
    enum { TRIES = 5, MILLISECONDS = 1000 }; /* what is checked takes its time */
#else
    enum { TRIES = 5, MILLISECONDS = 100 };
#endif
    sphaera_machine *m = machine_of("scenes/paper100.nff", 8000, 4500);
    sphaera_render_options o;
    sphaera_frame *f = NULL;
    sphaera_error e = {""};
    int64_t least = INT64_MAX;
    (void)unused;
    sphaera_render_init(&o);
    o.threads = 2, o.stop = &stop;
    for (int i = 0; i < TRIES && least > MILLISECONDS; i++) {
        pthread_t thread;
        struct timespec now;
        stop = 0;
        pthread_create(&thread, NULL, stop_soon, NULL);
        assert_int_equal(sphaera_render_with(m, &o, &f, &e), -1);
        clock_gettime(CLOCK_MONOTONIC, &now);
        pthread_join(thread, NULL);
        assert_string_equal(e.text, "paper100: cancelled");
        assert_null(f);
        int64_t ms =
            (now.tv_sec - stopped_at.tv_sec) * 1000 + (now.tv_nsec - stopped_at.tv_nsec) / 1000000;
        least = ms < least ? ms : least;
    }
    if (least > MILLISECONDS) fail_msg("stopped after %d ms", (int)least);
    sphaera_machine_free(m);
}

/* A frame of the bytes of another is that frame; of other bytes there is none. */
static void test_bytes(void **unused) {
    sphaera_machine *m = machine_of("scenes/paper5.nff", 21, 13);
    sphaera_frame *f, *again;
    sphaera_error e;
    (void)unused;
    if (sphaera_render(m, 0, &f, &e)) fail_msg("%s", e.text);
    size_t size = sphaera_frame_size(f);
    uint8_t *bytes = malloc(size), rgb[2][21 * 13 * 3];
    sphaera_frame_pack(f, bytes);
    if (sphaera_frame_unpack(m, bytes, size, &again, &e)) fail_msg("%s", e.text);
    assert_true(sphaera_frame_hash(f) == sphaera_frame_hash(again));
    for (int i = 0; sphaera_counter_name(i); i++)
        assert_true(sphaera_frame_counter(f, i) == sphaera_frame_counter(again, i));
    sphaera_frame_rgb(f, 1, rgb[0]), sphaera_frame_rgb(again, 1, rgb[1]);
    assert_memory_equal(rgb[0], rgb[1], sizeof rgb[0]);
    sphaera_frame_free(again);
    assert_int_equal(sphaera_frame_unpack(m, bytes, size - 1, &again, NULL), -1);
    assert_int_equal(sphaera_frame_unpack(m, bytes, 9, &again, NULL), -1);
    for (size_t i = 0; i < size; i += 7) { /* a bit of it is another */
        bytes[i] ^= 4;
        assert_int_equal(sphaera_frame_unpack(m, bytes, size, &again, NULL), -1);
        bytes[i] ^= 4;
    }
    sphaera_machine *other = machine_of("scenes/paper5.nff", 13, 21);
    assert_int_equal(sphaera_frame_unpack(other, bytes, size, &again, NULL), -1);
    sphaera_machine_free(other);
    free(bytes);
    sphaera_frame_free(f);
    sphaera_machine_free(m);
}

/* A child draws after its parent did, and before. */
static void test_fork(void **unused) {
    (void)unused;
    uint64_t right = made("texture/kitchen");
    int status;
    pid_t child = fork();
    if (!child) {
        alarm(60);
        _exit(made("texture/kitchen") != right);
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_int_equal(status, 0);
    assert_true(made("texture/kitchen") == right);
}

int main(void) {
    unsetenv("OMP_NUM_THREADS");
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_threads), cmocka_unit_test(test_environment),
        cmocka_unit_test(test_omp),     cmocka_unit_test(test_stop),
        cmocka_unit_test(test_bytes),   cmocka_unit_test(test_fork)};
    return cmocka_run_group_tests_name("library", tests, NULL, NULL);
}
