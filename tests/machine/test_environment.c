/* test_environment.c - the library draws the same in a fork, and whatever the caller rounds to
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
#include <fenv.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

static const char *const scenes[] = {
    "paper5",      "interpenetrating", "materials",         "huge_tiny",
    "facets/room", "facets/plane",     "refraction/nested", "texture/slant",
};
enum { SCENES = sizeof scenes / sizeof *scenes };

/* Hash of all that the library makes of a scene: machine file, frame, picture, a ray. */
static uint64_t made(const char *name) {
    char path[64], file[] = "/tmp/sphaera-XXXXXX";
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
    if (sphaera_machine_write(m, file, &e)) fail_msg("%s", e.text);
    FILE *in = fopen(file, "rb");
    for (int c; (c = getc(in)) != EOF;)
        hash = 31 * hash + (uint64_t)c;
    fclose(in);
    unlink(file);
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
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_environment),
                                       cmocka_unit_test(test_fork)};
    return cmocka_run_group_tests_name("library", tests, NULL, NULL);
}
