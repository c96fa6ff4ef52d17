/* test_library.c - what the library refuses, by name, and that it answers whatever numbers it gets
 * SPDX-License-Identifier: Apache-2.0
 *
 * A call has a second of a processor, ten under sanitizers.
 */
#include "sphaera/sphaera.h"

/* clang-format off: cmocka.h needs these before it */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
/* clang-format on */

#include <float.h>
#include <limits.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <sys/time.h>
#include <unistd.h>

#include "number.h"

#define REFUSED(name, call)                                                                        \
    do {                                                                                           \
        sphaera_error error = {""};                                                                \
        assert_int_equal(call, -1);                                                                \
        assert_string_equal(error.text, name " is NULL");                                          \
    } while (0)

static const char text[] = "v\nfrom 5 4 6\nat 0 0 0\nup 0 1 0\nangle 40\nhither 1\n"
                           "resolution 8 4\nf 1 0 0 1 0 0 0 1\ns 0 0 0 1\n";

static void test_null(void **unused) {
    sphaera_scene *s;
    sphaera_machine *m;
    sphaera_frame *f;
    sphaera_hit hit;
    const double v[3] = {0, 0, -1};
    uint8_t rgb[3 * 8 * 4];
    size_t n = sizeof text - 1;
    (void)unused;
    assert_int_equal(sphaera_scene_parse(text, n, "s", 0, &s, NULL), 0);
    assert_int_equal(sphaera_build(s, NULL, &m, NULL), 0);
    assert_int_equal(sphaera_render(m, 1, &f, NULL), 0);
    REFUSED("path", sphaera_scene_read(NULL, 0, &s, &error));
    REFUSED("scene", sphaera_scene_read("s", 0, NULL, &error));
    REFUSED("text", sphaera_scene_parse(NULL, n, "s", 0, &s, &error));
    REFUSED("scene", sphaera_scene_parse(text, n, "s", 0, NULL, &error));
    REFUSED("name", sphaera_scene_parse(text, n, NULL, 0, &s, &error));
    sphaera_price *price;
    REFUSED("scene", sphaera_price_measure(NULL, NULL, 0, 0, 0, &price, &error));
    REFUSED("price", sphaera_price_measure(s, NULL, 0, 0, 0, NULL, &error));
    REFUSED("scene", sphaera_build(NULL, NULL, &m, &error));
    REFUSED("machine", sphaera_build(s, NULL, NULL, &error));
    REFUSED("path", sphaera_machine_read(NULL, &m, &error));
    REFUSED("machine", sphaera_machine_read("m", NULL, &error));
    REFUSED("machine", sphaera_machine_write(NULL, "m", &error));
    REFUSED("path", sphaera_machine_write(m, NULL, &error));
    REFUSED("machine", sphaera_render(NULL, 1, &f, &error));
    REFUSED("frame", sphaera_render(m, 1, NULL, &error));
    REFUSED("frame", sphaera_frame_write(NULL, "f.png", &error));
    REFUSED("path", sphaera_frame_write(f, NULL, &error));
    REFUSED("machine", sphaera_trace(NULL, v, v, &hit, &error));
    REFUSED("origin", sphaera_trace(m, NULL, v, &hit, &error));
    REFUSED("direction", sphaera_trace(m, v, NULL, &hit, &error));
    REFUSED("hit", sphaera_trace(m, v, v, NULL, &error));
    assert_int_equal(sphaera_frame_rgb(NULL, 0, rgb), -1);
    assert_int_equal(sphaera_frame_rgb(f, 0, NULL), -1);
    assert_int_equal(sphaera_counter_find(NULL), -1);
    assert_int_equal(sphaera_scene_read(NULL, 0, &s, NULL), -1); /* nobody asks why */
    sphaera_frame_free(f);
    sphaera_machine_free(m);
    sphaera_scene_free(s);
}

/* ---- any number gets an answer ---- */

static char doing[256];

static void late(int sign) {
    (void)sign;
    ssize_t done = write(2, doing, strlen(doing)) + write(2, ": takes too long\n", 17);
    _exit(done ? 1 : 2);
}

static void begin(const char *call) {
    const struct itimerval limit = {{0, 0}, {SANITIZED ? 10 : 1, 0}};
    snprintf(doing, sizeof doing, "%s", call);
    signal(SIGVTALRM, late);
    setitimer(ITIMER_VIRTUAL, &limit, NULL);
}

/* rc is 0, or -1 with a message that has the word. */
static void answered(int rc, const sphaera_error *error, const char *word) {
    const struct itimerval none = {{0, 0}, {0, 0}};
    setitimer(ITIMER_VIRTUAL, &none, NULL);
    if (rc != 0 && rc != -1) fail_msg("%s gives %d", doing, rc);
    if (rc && !strstr(error->text, word)) fail_msg("%s: message '%s'", doing, error->text);
}

static const double reals[] = {0,        5e-324,   -1e-320,   1e-310,     -1e-300, 1e-30,
                               1,        -1,       1e17,      -1e30,      1e300,   DBL_MAX,
                               -DBL_MAX, INFINITY, -INFINITY, (double)NAN};
static const int wholes[] = {INT_MIN, -2, -1,   0,    1,     2,     5,
                             10,      11, 1024, 1025, 16384, 16385, INT_MAX};
enum { REALS = sizeof reals / sizeof *reals, WHOLES = sizeof wholes / sizeof *wholes };

static int finite3(const double v[3]) {
    return isfinite(v[0]) && isfinite(v[1]) && isfinite(v[2]);
}

/* Each number in one coordinate, in two, in all; of origin and direction. */
static void test_rays(void **unused) {
    sphaera_scene *s;
    sphaera_machine *m;
    (void)unused;
    assert_int_equal(sphaera_scene_parse(text, sizeof text - 1, "s", 0, &s, NULL), 0);
    assert_int_equal(sphaera_build(s, NULL, &m, NULL), 0);
    int hits = 0;
    for (int i = 0; i < REALS * 8 * REALS * 8; i++) {
        double org[3] = {0, 0, 5}, dir[3] = {0, 0, -1};
        int which = i % 8, turned = i / 8 % 8, a = i / 64 % REALS, b = i / 64 / REALS;
        for (int k = 0; k < 3; k++) {
            if (which >> k & 1) org[k] = reals[a];
            if (turned >> k & 1) dir[k] = reals[b];
        }
        sphaera_error error = {""};
        sphaera_hit hit;
        if (i % 64 == 0) begin("sphaera_trace");
        int rc = sphaera_trace(m, org, dir, &hit, &error);
        int sound = finite3(org) && finite3(dir) && (dir[0] != 0 || dir[1] != 0 || dir[2] != 0);
        if (!rc && !sound) fail_msg("traced: %g %g %g", dir[0], dir[1], dir[2]);
        if (rc && sound && !strstr(error.text, "outside the grid")) fail_msg("%s", error.text);
        if (!rc && !finite3(hit.point)) fail_msg("hits what is no point");
        if (i % 64 == 63) answered(rc, &error, "");
        hits += !rc && hit.id == 0;
    }
    assert_true(hits > 1000);
    /* the direction alone counts, not the length, however small or large */
    for (double length = 5e-324; length < DBL_MAX / 16; length *= 16) {
        const double org[3] = {-4, 0, 4}, dir[3] = {length, 0, -length};
        sphaera_hit hit;
        assert_int_equal(sphaera_trace(m, org, dir, &hit, NULL), 0);
        assert_int_equal(hit.id, 0);
        assert_true(fabs(hit.distance - (4 * M_SQRT2 - 1)) < 0.01);
    }
    sphaera_machine_free(m);
    sphaera_scene_free(s);
}

static void test_options(void **unused) {
    sphaera_scene *s;
    sphaera_machine *m;
    sphaera_frame *f;
    uint8_t rgb[3 * 8 * 4];
    (void)unused;
    assert_int_equal(sphaera_scene_parse(text, sizeof text - 1, "s", 0, &s, NULL), 0);
    for (int i = 0; i < WHOLES * 9; i++) {
        sphaera_build_options o;
        char call[64];
        sphaera_build_init(&o);
        int *const fields[] = {&o.width,   &o.height,   &o.depth,   &o.shadow, &o.reflect,
                               &o.refract, &o.specular, &o.texture, NULL};
        int n = wholes[i % WHOLES];
        if (fields[i / WHOLES])
            *fields[i / WHOLES] = n;
        else
            o.width = o.height = n;
        snprintf(call, sizeof call, "sphaera_build, option %d is %d", i / WHOLES, n);
        sphaera_error error = {""};
        begin(call);
        int rc = sphaera_build(s, &o, &m, &error);
        answered(rc, &error, " ");
        if (!rc) sphaera_machine_free(m);
        int is_choice = i / WHOLES >= 3 && fields[i / WHOLES];
        if (is_choice) assert_int_equal(rc, n < SPHAERA_AUTO || n > SPHAERA_ON ? -1 : 0);
    }
    static const char *const profiles[] = {"",
                                           "standard:w=0",
                                           "standard:w=99999999999999999999",
                                           "standard:w=-1",
                                           "standard:w=1e-320",
                                           "standard:w=14,w=14,w=15",
                                           "fine:",
                                           ":"};
    for (size_t i = 0; i < sizeof profiles / sizeof *profiles; i++) {
        sphaera_build_options o;
        sphaera_error error = {""};
        sphaera_build_init(&o);
        o.profile = profiles[i];
        begin(profiles[i]);
        int rc = sphaera_build(s, &o, &m, &error);
        answered(rc, &error, " ");
        assert_int_equal(rc, -1);
    }
    assert_int_equal(sphaera_build(s, NULL, &m, NULL), 0);
    for (int i = 0; i < WHOLES; i++) {
        sphaera_error error = {""};
        begin("sphaera_render");
        int n = wholes[i], rc = sphaera_render(m, n, &f, &error);
        answered(rc, &error, "threads is ");
        if (rc && n >= 0 && n <= 1024) fail_msg("%d threads: %s", n, error.text);
        if (rc) continue;
        for (int k = 0; k < WHOLES; k++) {
            int bad = wholes[k] < 0 || wholes[k] > 2;
            assert_int_equal(sphaera_frame_rgb(f, wholes[k], rgb), bad ? -1 : 0);
            assert_true(wholes[k] >= 0 || !sphaera_counter_name(wholes[k]));
            assert_true(wholes[k] < 1024 || !sphaera_counter_name(wholes[k]));
            sphaera_frame_counter(f, wholes[k]);
        }
        sphaera_frame_free(f);
    }
    sphaera_machine_free(m);
    sphaera_scene_free(s);
}

/* Frames that things are moved to; and each number of the text above. */
static void test_scenes(void **unused) {
    static const uint32_t frames[] = {0, 1, 65535, 65536, INT_MAX, UINT32_MAX};
    sphaera_scene *s;
    (void)unused;
    for (size_t i = 0; i < sizeof frames / sizeof *frames; i++) {
        sphaera_error error = {""};
        begin("sphaera_scene_parse");
        int rc = sphaera_scene_parse(text, sizeof text - 1, "s", frames[i], &s, &error);
        answered(rc, &error, "s: frame ");
        assert_int_equal(rc, frames[i] > 65535 ? -1 : 0);
        if (!rc) sphaera_scene_free(s);
    }
    for (int i = 0; i < REALS; i++)
        for (size_t at = 0; at < sizeof text - 1; at++) {
            if (at < 2 || text[at - 1] != ' ') continue;
            char changed[512];
            sphaera_error error = {""};
            size_t end = at + strcspn(text + at, " \n");
            int n = snprintf(changed, sizeof changed, "%.*s%.17g%s", (int)at, text, reals[i],
                             text + end);
            begin(changed);
            int rc = sphaera_scene_parse(changed, (size_t)n, "name", 0, &s, &error);
            answered(rc, &error, "name:");
            if (rc) continue;
            sphaera_machine *m = NULL;
            begin(changed);
            rc = sphaera_build(s, NULL, &m, &error);
            answered(rc, &error, "name:");
            sphaera_machine_free(m);
            sphaera_scene_free(s);
        }
}

/* A kind and a number where there is no file. */
static void test_kinds(void **unused) {
    static const struct {
        const char *text, *says;
        uint32_t spheres;
    } kinds[] = {
        {"random:256", "", 256},
        {"sphereflake:1", "", 10},
        {"paper5", "", 5},
        {"scenes/one_sphere.nff", "", 1},
        {"random:0", "random:0: '0' is no number from 1 to 16000000", 0},
        {"random:99999999999999999999", "is no number", 0},
        {"random:1e-320", "is no number", 0},
        {"random:nan", "is no number", 0},
        {"sphereflake:6", "is no number from 1 to 5", 0},
        {"nosuch:3", "nosuch:3: ", 0},
    };
    (void)unused;
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        sphaera_scene *s;
        sphaera_error error = {""};
        begin(kinds[i].text);
        int rc = sphaera_scene_read(kinds[i].text, 0, &s, &error);
        answered(rc, &error, kinds[i].says);
        assert_int_equal(rc, kinds[i].says[0] ? -1 : 0);
        if (rc) continue;
        assert_int_equal(sphaera_scene_spheres(s), kinds[i].spheres);
        sphaera_scene_free(s);
    }
}

/* Rows are those of `sphaera price`, which tests/tool/test_price.sh looks at. */
static void test_price(void **unused) {
    sphaera_scene *s;
    sphaera_price *price;
    sphaera_price_row row;
    sphaera_build_options o;
    sphaera_error error = {""};
    (void)unused;
    sphaera_build_init(&o);
    assert_int_equal(sphaera_scene_read("scenes/huge_tiny.nff", 0, &s, &error), 0);
    o.width = 64, o.height = 36;
    assert_int_equal(sphaera_price_measure(s, &o, 0, 0, 500, &price, &error), 0);
    assert_int_equal(sphaera_price_rows(price), 4);
    assert_int_equal(sphaera_price_get(price, 4, &row), -1);
    assert_int_equal(sphaera_price_get(price, -1, &row), -1);
    assert_int_equal(sphaera_price_get(price, 0, &row), 0); /* draft has no grid for it */
    assert_non_null(strstr(row.why, "is nothing on the grid"));
    for (int i = 1; i < 4; i++) {
        assert_int_equal(sphaera_price_get(price, i, &row), 0);
        assert_true(!row.why && row.pixels <= 500 && row.psnr >= row.psnr_least &&
                    row.cycles_per_pixel > 1 && row.wrong_most > 0 && row.wrong_most < 1);
        if (i == sphaera_price_best(price)) assert_true(row.keeps);
    }
    sphaera_price_free(price);
    o.profile = "standard:pq=13";
    assert_int_equal(sphaera_price_measure(s, &o, 100, 1, 0, &price, &error), 0);
    assert_int_equal(sphaera_price_rows(price), 1);
    assert_int_equal(sphaera_price_best(price), 0);
    sphaera_price_free(price);
    assert_int_equal(sphaera_price_measure(s, &o, NAN, 1, 0, &price, &error), -1);
    assert_int_equal(sphaera_price_measure(s, &o, -1, 1, 0, &price, &error), -1);
    o.profile = "none";
    assert_int_equal(sphaera_price_measure(s, &o, 0, 0, 0, &price, &error), -1);
    sphaera_price_free(NULL);
    sphaera_scene_free(s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_null),   cmocka_unit_test(test_rays),  cmocka_unit_test(test_options),
        cmocka_unit_test(test_scenes), cmocka_unit_test(test_kinds), cmocka_unit_test(test_price)};
    return cmocka_run_group_tests_name("library", tests, NULL, NULL);
}
