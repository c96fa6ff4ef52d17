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
    REFUSED("text", sphaera_scene_parse_with(NULL, n, "s", NULL, &s, &error));
    REFUSED("scene", sphaera_scene_parse(text, n, "s", 0, NULL, &error));
    REFUSED("name", sphaera_scene_parse(text, n, NULL, 0, &s, &error));
    sphaera_price *price;
    REFUSED("scene", sphaera_price_measure(NULL, NULL, 0, 0, 0, &price, &error));
    REFUSED("price", sphaera_price_measure(s, NULL, 0, 0, 0, NULL, &error));
    REFUSED("scene", sphaera_build(NULL, NULL, &m, &error));
    REFUSED("machine", sphaera_build(s, NULL, NULL, &error));
    REFUSED("scene", sphaera_refit(NULL, m, NULL, NULL, &m, &error));
    REFUSED("machine", sphaera_refit(s, NULL, NULL, NULL, &m, &error));
    REFUSED("moved", sphaera_refit(s, m, NULL, NULL, NULL, &error));
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
    sphaera_arrays arrays;
    sphaera_render_options render;
    sphaera_picture_options picture;
    sphaera_hits hits = {0};
    sphaera_layers layers = {0};
    sphaera_pixel *pixel;
    sphaera_scoreboard *board;
    int32_t w[3] = {0}, u[3];
    uint32_t lines, texels[8] = {0}, mant;
    const uint32_t *memory = sphaera_machine_memory(m, &lines);
    const int32_t *registers = sphaera_machine_registers(m);
    uint64_t root;
    int n_regs = sphaera_registers(), flag, weights[2] = {0};
    sphaera_arrays_init(&arrays);
    sphaera_render_init(&render);
    sphaera_picture_init(&picture);
    REFUSED("arrays", sphaera_scene_make(NULL, &s, &error));
    REFUSED("scene", sphaera_scene_make(&arrays, NULL, &error));
    REFUSED("scene", sphaera_scene_write(NULL, "s", &error));
    REFUSED("path", sphaera_scene_write(s, NULL, &error));
    REFUSED("path", sphaera_scene_read_with(NULL, NULL, &s, &error));
    REFUSED("scene", sphaera_scene_read_with("s", NULL, NULL, &error));
    REFUSED("registers", sphaera_machine_make(NULL, n_regs, memory, lines, "m", &m, &error));
    REFUSED("memory", sphaera_machine_make(registers, n_regs, NULL, lines, "m", &m, &error));
    REFUSED("name", sphaera_machine_make(registers, n_regs, memory, lines, NULL, &m, &error));
    REFUSED("machine", sphaera_machine_make(registers, n_regs, memory, lines, "m", NULL, &error));
    REFUSED("machine", sphaera_machine_export(NULL, "c", "m", &error));
    REFUSED("format", sphaera_machine_export(m, NULL, "m", &error));
    REFUSED("path", sphaera_machine_export(m, "c", NULL, &error));
    REFUSED("machine", sphaera_render_with(NULL, &render, &f, &error));
    REFUSED("options", sphaera_render_with(m, NULL, &f, &error));
    REFUSED("frame", sphaera_render_with(m, &render, NULL, &error));
    REFUSED("frame", sphaera_frame_layers(NULL, &layers, &error));
    REFUSED("to", sphaera_frame_layers(f, NULL, &error));
    REFUSED("frame", sphaera_frame_write_with(NULL, "f.png", &picture, &error));
    REFUSED("path", sphaera_frame_write_with(f, NULL, &picture, &error));
    REFUSED("options", sphaera_frame_write_with(f, "f.png", NULL, &error));
    REFUSED("machine", sphaera_trace_rays(NULL, 1, v, v, 1, &hits, &error));
    REFUSED("origins", sphaera_trace_rays(m, 1, NULL, v, 1, &hits, &error));
    REFUSED("directions", sphaera_trace_rays(m, 1, v, NULL, 1, &hits, &error));
    REFUSED("hits", sphaera_trace_rays(m, 1, v, v, 1, NULL, &error));
    REFUSED("machine", sphaera_trace_grid(NULL, 1, w, w, 1, &hits, &error));
    REFUSED("origins", sphaera_trace_grid(m, 1, NULL, w, 1, &hits, &error));
    REFUSED("directions", sphaera_trace_grid(m, 1, w, NULL, 1, &hits, &error));
    REFUSED("hits", sphaera_trace_grid(m, 1, w, w, 1, NULL, &error));
    REFUSED("machine", sphaera_primary(NULL, 0, 0, w, w, &error));
    REFUSED("origin", sphaera_primary(m, 0, 0, NULL, w, &error));
    REFUSED("direction", sphaera_primary(m, 0, 0, w, NULL, &error));
    REFUSED("machine", sphaera_pixel_trace(NULL, 0, 0, &pixel, &error));
    REFUSED("pixel", sphaera_pixel_trace(m, 0, 0, NULL, &error));
    REFUSED("machine", sphaera_scoreboard_new(NULL, 1, &board, &error));
    REFUSED("board", sphaera_scoreboard_new(m, 1, NULL, &error));
    REFUSED("v", sphaera_model_unit_vector(16, NULL, u, &mant, &flag, &error));
    REFUSED("root", sphaera_model_root(0, 1, 0, NULL, &flag, &error));
    REFUSED("inexact", sphaera_model_root(0, 1, 0, &root, NULL, &error));
    REFUSED("mant", sphaera_model_quotient(1, 8, 1, 8, 8, NULL, &flag, &error));
    REFUSED("leaf", sphaera_model_leaf(NULL, NULL, &error));
    REFUSED("filter", sphaera_model_filter(NULL, &flag, u, &error));
    REFUSED("far_texels", sphaera_model_texel(texels, NULL, weights, weights, 0, &mant, &error));
    assert_int_equal(sphaera_machine_parameter(NULL, 0, NULL), -1);
    assert_int_equal(sphaera_machine_line(m, lines, texels), -1);
    assert_int_equal(sphaera_pixel_ray(NULL, 0, NULL), -1);
    assert_int_equal(sphaera_pixel_stage(NULL, 0, NULL), -1);
    assert_int_equal(sphaera_pixel_operand(NULL, 0, 0, NULL), -1);
    assert_null(sphaera_pixel_text(NULL, 0));
    sphaera_pixel_free(NULL);
    sphaera_scoreboard_free(NULL);
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

/* Each number in each place of each array; what is made of it can be built, or is refused. */
static void test_arrays(void **unused) {
    double spheres[2][4] = {{0, 0, 0, 1}, {2, 0, 0, 1}}, planes[1][6] = {{0, -2, 0, 0, 1, 0}};
    double triangles[1][9] = {{-4, -1, -4, 4, -1, -4, 0, -1, 5}};
    double normals[1][9] = {{0, 1, 0, 0, 1, 0, 0, 1, 0}}, lights[1][3] = {{4, 6, 8}};
    double colours[1][3] = {{1, 1, 1}}, materials[1][8] = {{0.9, 0.3, 0.2, 0.7, 0.3, 10, 0.5, 1.5}};
    sphaera_arrays a;
    sphaera_build_options o;
    (void)unused;
    sphaera_build_init(&o);
    o.profile = "fine";
    sphaera_arrays_init(&a);
    a.from[2] = 9;
    a.width = 8, a.height = 4;
    a.n_spheres = 2, a.spheres = spheres[0];
    a.n_planes = 1, a.planes = planes[0];
    a.n_triangles = 1, a.triangles = triangles[0], a.normals = normals[0];
    a.n_lights = 1, a.lights = lights[0], a.light_colours = colours[0];
    a.materials = materials[0];
    const struct {
        const char *name;
        double *row;
        int n;
    } rows[] = {{"spheres[0]", spheres[0], 4},
                {"planes[0]", planes[0], 6},
                {"triangles[0]", triangles[0], 9},
                {"normals[0]", normals[0], 9},
                {"lights[0]", lights[0], 3},
                {"light_colours[0]", colours[0], 3},
                {"materials[0]", materials[0], 8},
                {"camera", a.from, 3},
                {"camera", a.at, 3},
                {"camera", a.up, 3},
                {"camera", &a.angle, 1},
                {"background", a.background, 3},
                {"ambient", a.ambient, 3}};
    int made = 0, refused = 0;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        for (int k = 0; k < rows[i].n; k++)
            for (int r = 0; r < REALS; r++) {
                double was = rows[i].row[k];
                sphaera_scene *s;
                sphaera_machine *m = NULL;
                sphaera_error error = {""};
                rows[i].row[k] = reals[r];
                begin(rows[i].name);
                int rc = sphaera_scene_make(&a, &s, &error);
                answered(rc, &error, rows[i].name);
                rows[i].row[k] = was;
                refused += rc != 0, made += !rc;
                if (rc) continue;
                if (r % 4 == 0) { /* some of them */
                    begin("sphaera_build");
                    rc = sphaera_build(s, &o, &m, &error);
                    answered(rc, &error, " ");
                    sphaera_machine_free(m);
                }
                sphaera_scene_free(s);
            }
    assert_true(made > 200 && refused > 200);
    const uint32_t none = 1;
    sphaera_scene *s;
    sphaera_error error = {""};
    a.plane_materials = &none;
    assert_int_equal(sphaera_scene_make(&a, &s, &error), -1);
    assert_string_equal(error.text, "plane_materials[0]: 1 is none of 1 materials");
    a.planes = NULL;
    assert_int_equal(sphaera_scene_make(&a, &s, &error), -1);
    assert_string_equal(error.text, "planes is NULL, n_planes is 1");
}

/* Any operand gets an answer. */
static void test_units(void **unused) {
    (void)unused;
    for (int i = 0; i < WHOLES * WHOLES; i++) {
        int a = wholes[i % WHOLES], b = wholes[i / WHOLES], u[3], flag;
        const int64_t v[3] = {a, b, 1};
        const int weights[2] = {a, b};
        const uint32_t texels[4] = {0xffffffu, 0, (uint32_t)a, (uint32_t)b};
        uint32_t word;
        uint64_t root;
        sphaera_error error = {""};
        sphaera_leaf_result hit;
        sphaera_leaf leaf = {.origin = {a, b, 0}, .direction = {1, b, a}, .radius = b, .pr = 8};
        sphaera_filter filter = {
            .origin = {a, b, 0}, .p_a = b, .q = {1, a, b}, .radius = b, .axis = a, .depth_max = b};
        begin("sphaera_model");
        answered(sphaera_model_unit_vector(a, v, u, &word, &flag, &error), &error, " is ");
        answered(sphaera_model_root((uint64_t)a, (uint64_t)b, b, &root, &flag, &error), &error,
                 "bits");
        answered(sphaera_model_quotient((uint64_t)a, b, (uint64_t)b, a, 17, &word, &flag, &error),
                 &error, "");
        answered(sphaera_model_leaf(&leaf, &hit, &error), &error, " is ");
        answered(sphaera_model_filter(&filter, &flag, u, &error), &error, " is ");
        answered(sphaera_model_texel(texels, texels, weights, weights, b, &word, &error), &error,
                 " is ");
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

/* Frame `at` of a scene that moves, in the tree of `machine`, or built by the options if it is
 * NULL.
 */
static sphaera_machine *moved(uint32_t at, const sphaera_machine *machine,
                              const sphaera_build_options *o) {
    sphaera_scene *s;
    sphaera_machine *m;
    sphaera_error error = {""};
    assert_int_equal(sphaera_scene_read("scenes/texture/robot.nff", at, &s, &error), 0);
    int rc = machine ? sphaera_refit(s, machine, NULL, NULL, &m, &error)
                     : sphaera_build(s, o, &m, &error);
    if (rc) fail_msg("%s", error.text);
    sphaera_scene_free(s);
    return m;
}

/* What its frame has; frees the machine. */
struct seen {
    uint64_t ids, visits, hash;
};

static struct seen seen(sphaera_machine *m) {
    enum { PIXELS = 48 * 27 };
    uint32_t id[PIXELS], visits[PIXELS];
    struct seen of = {0};
    sphaera_frame *f;
    assert_int_equal(sphaera_render(m, 0, &f, NULL), 0);
    assert_int_equal(sphaera_frame_width(f) * sphaera_frame_height(f), PIXELS);
    sphaera_frame_id(f, id);
    sphaera_frame_visits(f, visits);
    for (int i = 0; i < PIXELS; i++)
        of.ids = 31 * of.ids + id[i], of.visits += visits[i];
    of.hash = sphaera_frame_hash(f);
    sphaera_frame_free(f);
    sphaera_machine_free(m);
    return of;
}

static int ends(void *user, int done, int all) {
    (void)user, (void)done, (void)all;
    return 1;
}

/* A tree that is refitted shows what one that is built shows, whatever it was refitted to before;
 * what cannot be refitted is refused. That frames are the tool's is in tests/flow/test_python.sh.
 */
static void test_refit(void **unused) {
    static const char *const accels[] = {"bvh4", "bih", "box4", "brute", "auto"};
    sphaera_build_options o;
    sphaera_error error = {""};
    sphaera_scene *s;
    sphaera_machine *m, *none;
    (void)unused;
    for (size_t i = 0; i < sizeof accels / sizeof *accels; i++) {
        sphaera_build_init(&o);
        o.width = 16, o.height = 9, o.samples = 3, o.accel = accels[i], o.refit = 1;
        m = moved(0, NULL, &o);
        assert_true(sphaera_machine_tree_cost(m) == 1);
        sphaera_machine *two = moved(2, m, NULL), *three = moved(3, m, NULL);
        if (i < 3) assert_true(sphaera_machine_tree_cost(three) != 1);
        o.profile = sphaera_machine_profile(m);
        struct seen anew = seen(moved(3, NULL, &o));
        sphaera_machine_free(m);
        sphaera_machine *after = moved(3, two, NULL);
        sphaera_machine_free(two);
        struct seen fitted = seen(three);
        assert_true(fitted.ids == anew.ids && fitted.hash == seen(after).hash);
        if (i < 2) assert_true(fitted.visits != anew.visits);
    }
    static const char head[] = "v from 0 0 9 at 0 0 0 up 0 1 0 angle 40 resolution 8 4\n"
                               "f 1 0 0 1 0 0 0 1\n";
    static const char ball[] = "s 0 0 0 1\n", floor[] = "p 3 -4 -1 -4 4 -1 -4 0 -1 5\n";
    static const struct {
        const char *is[3], *says;
    } others[] = {
        {{ball, "s 2 0 0 1\n", floor},
         "s: 2 spheres, 1 triangles and planes on the grid, the "
         "tree is of 1 and 1"},
        {{ball, "", ""}, "s: 1 spheres, 0 triangles and planes"},
        {{ball, "plane 0 -2 0 0 1 0\n", ""}, "s: primitive 1 is of another kind"},
        {{"s 1 0 0 2\n", floor, ""}, ""}, /* moved */
    };
    char it[256];
    int n = snprintf(it, sizeof it, "%s%s%s", head, ball, floor);
    sphaera_build_init(&o);
    assert_int_equal(sphaera_scene_parse(it, (size_t)n, "s", 0, &s, NULL), 0);
    assert_int_equal(sphaera_build(s, &o, &m, NULL), 0);
    assert_int_equal(sphaera_refit(s, m, NULL, NULL, &none, &error), -1);
    assert_non_null(strstr(error.text, "s: the machine keeps no tree"));
    sphaera_machine_free(m);
    o.refit = 1;
    assert_int_equal(sphaera_build(s, &o, &m, NULL), 0);
    assert_int_equal(sphaera_refit(s, m, ends, NULL, &none, &error), -1);
    assert_string_equal(error.text, "cancelled");
    sphaera_scene_free(s);
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        const char *const *is = others[i].is;
        n = snprintf(it, sizeof it, "%s%s%s%s", head, is[0], is[1], is[2]);
        assert_int_equal(sphaera_scene_parse(it, (size_t)n, "s", 0, &s, NULL), 0);
        begin(others[i].says);
        int rc = sphaera_refit(s, m, NULL, NULL, &none, &error);
        answered(rc, &error, others[i].says);
        assert_int_equal(rc, others[i].says[0] ? -1 : 0);
        if (!rc) sphaera_machine_free(none);
        sphaera_scene_free(s);
    }
    sphaera_machine_free(m);
    assert_int_equal(sphaera_scene_parse(it, (size_t)n, "s", 0, &s, NULL), 0);
    for (int i = 0; i < 4; i++) {
        static const char *const says[] = {"refit: a tree 'paper'", "refit: with traverse 'first'",
                                           "refit: effects 'met'", "refit is 2, not 0 to 1"};
        sphaera_build_init(&o);
        o.refit = i == 3 ? 2 : 1;
        if (i == 0) o.tree = "paper";
        if (i == 1) o.traverse = "first";
        if (i == 2) o.effects = "met";
        begin(says[i]);
        int rc = sphaera_build(s, &o, &m, &error);
        answered(rc, &error, says[i]);
        assert_int_equal(rc, -1);
    }
    sphaera_scene_free(s);
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
        cmocka_unit_test(test_null),    cmocka_unit_test(test_rays),
        cmocka_unit_test(test_options), cmocka_unit_test(test_scenes),
        cmocka_unit_test(test_arrays),  cmocka_unit_test(test_units),
        cmocka_unit_test(test_kinds),   cmocka_unit_test(test_price),
        cmocka_unit_test(test_refit)};
    return cmocka_run_group_tests_name("library", tests, NULL, NULL);
}
