/* test_extremes_made.c - scenes by formula whatever numbers they are asked for with: an answer
 * SPDX-License-Identifier: Apache-2.0
 *
 * Each option of sph_generate() takes each value below, of every kind: there is a scene, which is
 * written, read again, built as the tool does, and drawn, or a message. That has a second of a
 * processor, ten under sanitizers; scenes of more than MANY primitives are made only. Without ALL=1
 * each kind gets every fourth value, another of each option; every sixteenth under sanitizers.
 */
#include "scene_files.h"

#include <float.h>
#include <limits.h>
#include <math.h>
#include <signal.h>
#include <sys/time.h>

#include "trial/choose.h"
#include "render/render.h"
#include "number.h"
#include "scene/generate.h"

static const double reals[] = {0,       5e-324,   -1e-320, 1e-310, 1e-300, 1e-30,    1e-9,
                               0.5,     1,        -1,      1e9,    1e17,   1e30,     1e300,
                               DBL_MAX, -DBL_MAX, 360,     361,    NAN,    INFINITY, -INFINITY};
static const int wholes[] = {INT_MIN, -1, 0, 1, 2, 3, 5, 6, 16383, 16384, INT_MAX};
static const uint32_t counts[] = {0, 1, 2, 3, 64, SPH_MAX_SPHERES + 1u, UINT32_MAX};
static const uint64_t seeds[] = {0, 1, 2, 1ull << 63, UINT64_MAX};
enum {
    REALS = sizeof reals / sizeof *reals,
    WHOLES = sizeof wholes / sizeof *wholes,
    COUNTS = sizeof counts / sizeof *counts,
    SEEDS = sizeof seeds / sizeof *seeds,
    MANY = 1000,
};
enum { SIZE, WIDTH, HEIGHT, BOTH, RADIUS, DRIFT, ORBIT, ALL_REALS, N, SEED, FIELDS };
static const char *const names[FIELDS] = {"size",   "width", "height", "width, height",
                                          "radius", "drift", "orbit",  "radius, drift, orbit",
                                          "n",      "seed"};
static const int values_of[FIELDS] = {WHOLES, WHOLES, WHOLES, WHOLES, REALS,
                                      REALS,  REALS,  REALS,  COUNTS, SEEDS};

static char doing[256];

static void late(int sign) {
    (void)sign;
    ssize_t done = write(2, doing, strlen(doing)) + write(2, ": takes too long\n", 17);
    _exit(done ? 1 : 2);
}

static void set(struct sph_generate_options *o, int field, int i) {
    if (field == SIZE) o->size = wholes[i];
    if (field == WIDTH || field == BOTH) o->width = wholes[i];
    if (field == HEIGHT || field == BOTH) o->height = wholes[i];
    if (field == RADIUS || field == ALL_REALS) o->radius = reals[i];
    if (field == DRIFT || field == ALL_REALS) o->drift = reals[i];
    if (field == ORBIT || field == ALL_REALS) o->orbit = reals[i];
    if (field == N) o->n = counts[i];
    if (field == SEED) o->seed = seeds[i];
    if (field == WIDTH && o->width) o->height = 9;
    if (field == HEIGHT && o->height) o->width = 16;
}

/* Writes it, reads that, builds it, draws it: no message is without a name. */
static void use(const struct sph_scene *scene, const char *kind) {
    static struct sph_build_report report;
    struct sph_build_options o = SPH_BUILD_DEFAULT;
    const struct sph_error_bound bound = {SPH_ERROR_BOUND_PIXELS, SPH_ERROR_BOUND_PSNR};
    struct sph_profile_choice choice;
    struct sph_machine m;
    struct sph_error err = {""};
    o.width = 16, o.height = 9;
    struct sph_scene back;
    char *text = NULL;
    size_t size;
    FILE *to = open_memstream(&text, &size);
    assert_non_null(to);
    if (sph_scene_write(scene, to, &err)) fail_msg("%s: not written: %s", doing, err.text);
    fclose(to);
    if (sph_scene_parse(text, size, kind, &(struct sph_read_options){0}, &back, &err))
        fail_msg("%s: not read again: %s", doing, err.text);
    sph_scene_free(&back);
    free(text);
    if (sph_build_kept(scene, &o, 1, &bound, &choice, &m, &report, &err)) {
        if (strncmp(err.text, kind, strlen(kind))) fail_msg("%s: %s", doing, err.text);
        return;
    }
    struct sph_render_options how = {.traverse = SPH_TRAVERSE_FAST, .threads = 1};
    struct sph_counters counters = {{0}};
    struct sph_frame frame = {0};
    if (sph_render(&m, &how, &frame, &counters, &err)) fail_msg("%s: errors", doing);
    sph_frame_free(&frame);
    sph_machine_free(&m);
}

static void test_made(void **state) {
    const struct itimerval limit = {{0, 0}, {SANITIZED ? 10 : 1, 0}}, none = {{0, 0}, {0, 0}};
    int made = 0, refused = 0, turn = 0, kinds = 0;
    (void)state;
    signal(SIGVTALRM, late);
    for (const char *line = sph_generate_help; line && *line; line = strchr(line, '\n')) {
        char kind[32];
        line += *line == '\n';
        snprintf(kind, sizeof kind, "%.*s", (int)strcspn(line, " \n"), line);
        if (!*kind) continue;
        assert_int_not_equal(sph_generate_takes(kind), SPH_TAKES_UNKNOWN);
        kinds++;
        for (int field = 0; field < FIELDS; field++)
            for (int i = 0; i < values_of[field]; i++) {
                struct sph_generate_options o = {.size = 1, .n = 20};
                struct sph_scene scene;
                struct sph_error err = {""};
                if (turn++ % (SANITIZED ? 16 : 4) && !getenv("ALL")) continue;
                set(&o, field, i);
                snprintf(doing, sizeof doing, "%s, %s number %d", kind, names[field], i);
                setitimer(ITIMER_VIRTUAL, &limit, NULL);
                if (sph_generate(kind, &o, &scene, &err)) {
                    if (!strstr(err.text, kind)) fail_msg("%s: message '%s'", doing, err.text);
                    refused++;
                } else {
                    if (scene.n_spheres + scene.n_facets <= MANY) use(&scene, kind);
                    sph_scene_free(&scene);
                    made++;
                }
                setitimer(ITIMER_VIRTUAL, &none, NULL);
            }
        turn++;
    }
    printf("# %d kinds: %d scenes made, %d refused\n", kinds, made, refused);
    assert_true(kinds > 15 && made > 20 && refused > 20);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_made)};
    cmocka_set_message_output(CM_OUTPUT_TAP);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
