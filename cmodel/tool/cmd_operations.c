/* cmd_operations.c - `sphaera operations`: what the ray/sphere tests of the texts cost
 * SPDX-License-Identifier: Apache-2.0
 */
#include <inttypes.h>

#include "validate/prims.h"
#include "pixel/background.h"
#include "prim/sphere.h"
#include "reference/predicates.h"
#include "tool/print.h"
#include "tool/report.h"
#include "trace/setup.h"

/* A ray and a sphere: what the exact test says. */
enum { MISS, BEHIND, HIT, INSIDE, CASES };

static const char *const predicate_names[SPH_PREDICATES] = {"paper", "machine", "geometric",
                                                            "quadratic"};
static const char *const case_names[CASES] = {"miss", "behind", "hit", "inside"};

struct tally {
    uint64_t rays, tests[CASES];
    struct sph_flops ray[SPH_PREDICATES], test[SPH_PREDICATES][CASES];
    uint64_t wrong[SPH_PREDICATES]; /* answers that are not the exact test's */
};

static error_t parse(int key, char *arg, struct argp_state *state) {
    return tool_report_key(key, arg, state, "no scene and no machine given");
}

/* The exact test of a primary ray, all roots ahead of the eye counted. */
static int case_of(const struct sph_ray *ray, const struct sph_leaf *sphere) {
    struct sph_leaf_result exact = sph_leaf_test(ray, sphere);
    if (exact.k > 0) return INSIDE;
    if (exact.disc <= 0) return MISS;
    return exact.b > 0 ? HIT : BEHIND;
}

/* One ray against every sphere, by every predicate. */
static void count_ray(const struct sph_machine *m, const struct sph_ray *ray, struct tally *t) {
    double org[3], dir[3], ctr[3];
    struct sph_predicate_ray made[SPH_PREDICATES];
    int64_t spheres = m->regs[SPH_REG_N_PRIMS] - sph_machine_facets(m);
    for (int i = 0; i < 3; i++)
        org[i] = (double)ray->org[i], dir[i] = (double)ray->dir[i];
    for (int p = 0; p < SPH_PREDICATES; p++)
        made[p] = sph_predicate_ray(p, org, dir, &t->ray[p]);
    t->rays++;
    for (int64_t id = 0; id < spheres; id++) {
        struct sph_leaf sphere = sph_sphere_read(
            sph_line(m, (size_t)m->regs[SPH_REG_PRIM_BASE] + (size_t)id), m->profile.w);
        for (int i = 0; i < 3; i++)
            ctr[i] = (double)sphere.ctr[i];
        int is = case_of(ray, &sphere);
        t->tests[is]++;
        for (int p = 0; p < SPH_PREDICATES; p++) {
            int met = sph_predicate(p, &made[p], ctr, (double)sphere.rad, &t->test[p][is]);
            t->wrong[p] += met != (is == HIT || is == INSIDE);
        }
    }
}

static void count_frame(const struct sph_machine *m, struct tally *t) {
    const int32_t *r = m->regs;
    struct sph_ray ray = {.org = {r[SPH_REG_EYE_X], r[SPH_REG_EYE_Y], r[SPH_REG_EYE_Z]},
                          .kind = SPH_PRIMARY,
                          .skip = {SPH_ID_NONE, 0},
                          .inside = 1};
    for (int y = 0; y < r[SPH_REG_FRAME_H]; y++)
        for (int x = 0; x < r[SPH_REG_FRAME_W]; x++) {
            sph_primary_dir(m, x, y, ray.dir);
            sph_ray_setup(&m->profile, &ray);
            count_ray(m, &ray, t);
        }
}

static double mean(uint64_t sum, uint64_t n) {
    return n ? (double)sum / (double)n : 0;
}

static void print_tally(FILE *to, const struct tally *t) {
    uint64_t all = 0;
    for (int c = 0; c < CASES; c++)
        all += t->tests[c];
    fprintf(to, "%" PRIu64 " rays, %" PRIu64 " tests:", t->rays, all);
    for (int c = 0; c < CASES; c++)
        fprintf(to, " %s %" PRIu64 "%s", case_names[c], t->tests[c], c + 1 < CASES ? "," : "\n");
    fprintf(to, "%-10s %-8s %6s %6s %6s %6s\n", "predicate", "case", "mul", "add", "div", "root");
    for (int p = 0; p < SPH_PREDICATES; p++) {
        const struct sph_flops *f = &t->ray[p];
        fprintf(to, "%-10s %-8s %6.2f %6.2f %6.2f %6.2f\n", predicate_names[p], "each ray",
                mean(f->mul, t->rays), mean(f->add, t->rays), mean(f->div, t->rays),
                mean(f->root, t->rays));
        for (int c = 0; c < CASES; c++) {
            f = &t->test[p][c];
            if (t->tests[c])
                fprintf(to, "%-10s %-8s %6.2f %6.2f %6.2f %6.2f\n", "", case_names[c],
                        mean(f->mul, t->tests[c]), mean(f->add, t->tests[c]),
                        mean(f->div, t->tests[c]), mean(f->root, t->tests[c]));
        }
        fprintf(to, "%-10s other answer than the exact test: %" PRIu64 "\n", "", t->wrong[p]);
    }
}

static json_t *json_flops(const struct sph_flops *f) {
    return json_pack("{s:I, s:I, s:I, s:I}", "mul", (json_int_t)f->mul, "add", (json_int_t)f->add,
                     "div", (json_int_t)f->div, "root", (json_int_t)f->root);
}

static void report_tally(json_t *report, const struct tally *t) {
    json_t *tests = json_object(), *predicates = json_object();
    for (int c = 0; c < CASES; c++)
        json_object_set_new(tests, case_names[c], json_integer((json_int_t)t->tests[c]));
    for (int p = 0; p < SPH_PREDICATES; p++) {
        json_t *each = json_object();
        json_object_set_new(each, "ray", json_flops(&t->ray[p]));
        for (int c = 0; c < CASES; c++)
            json_object_set_new(each, case_names[c], json_flops(&t->test[p][c]));
        json_object_set_new(each, "wrong", json_integer((json_int_t)t->wrong[p]));
        json_object_set_new(predicates, predicate_names[p], each);
    }
    report_count(report, "rays", t->rays);
    report_add(report, "tests", tests);
    report_add(report, "predicates", predicates);
}

int tool_operations(int argc, char **argv) {
    static const struct argp_child children[] = {{&tool_source_argp, 0, NULL, 1}, {0}};
    static const struct argp argp = {
        tool_report_options,
        parse,
        "SCENE.nff|MACHINE.sph",
        "Counts the arithmetic of the test of ray and sphere, as four texts have it.\v"
        "Every primary ray meets every sphere, and each predicate counts what it does: that of "
        "Borodavka et al. (paper), the same as the machine has it (machine), that of a ray of "
        "length 1 (geometric) and the quadratic equation (quadratic). Figures are means; "
        "`behind`, where the line meets the sphere before the eye. Facets are left out.",
        children,
        NULL,
        NULL};
    struct tool_report_arguments a = {.source = tool_source_default};
    struct tool_built built;
    struct sph_error err = {""};
    tool_parse(&argp, argc, argv, 0, &a);

    if (tool_load(a.input, &a.source, &built, &err)) return tool_failed(&err);
    struct tally tally = {0};
    count_frame(&built.machine, &tally);
    FILE *to = print_stream(a.json);
    if (to) print_tally(to, &tally);
    json_t *report = report_new("operations");
    report_text(report, "input", a.input);
    report_tally(report, &tally);
    int rc = report_write(report, a.json, &err);
    sph_machine_free(&built.machine);
    return rc ? tool_failed(&err) : TOOL_GOOD;
}
