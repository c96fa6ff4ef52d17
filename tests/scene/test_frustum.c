/* test_frustum.c - cones and cylinders: `c` of NFF as triangles, near enough, closed, turned right
 * SPDX-License-Identifier: Apache-2.0
 *
 * build/test/test_frustum [seed]
 */
#include "scene_files.h"
#include "number.h"

#include <math.h>

#include "scene/frustum.h"
#include "scene/generate.h"
#include "scene/rng.h"
#include "scene/vector.h"

enum { CONES = 300, SAMPLES = 40 };
static uint64_t seed = 1;

static const struct bad bads[] = {
    {"before_material", CAM "c 0 0 0 1 0 0 1 1\n", 8, "no material (`f`) before this cone", 0, 0},
    {"short", CAM MAT "c 0 0 0 1\n0 0 1\n", 10, "ends within `c`, before apex radius", 0, 0},
    {"word", CAM MAT "c 0 0 0 r 0 0 1 1\n", 9, "base radius: `r` is not", 0, 0},
    {"point", CAM MAT "c 1 2 3 1\n1 2 3 .5\n", 9, "base and apex are the same point", 0, 0},
    {"needle", CAM MAT "c 0 0 0 0 0 0 1 0\n", 9, "both radii are zero", 0, 0},
    {"signs", CAM MAT "c 0 0 0 1 0 0 1 -1\n", 9, "one radius is negative", 0, 0},
    {"signs_turned", CAM MAT "c 0 0 0 -1 0 0 1 1\n", 9, "one radius is negative", 0, 0},
};

static void test_bad(void **state) {
    const struct bad *bad = *state;
    struct sph_error err = {""};
    struct sph_scene scene;
    put_bad(bad);
    assert_int_equal(sph_scene_read(file_name, NULL, &scene, &err), -1);
    assert_message(bad, &err);
}

static void test_sides(void **unused) {
    (void)unused;
    const double round[] = {0.5, 0.1, 0.01, SPH_FRUSTUM_ROUND, 0.002, 1e-4, SPH_FRUSTUM_ROUND_MIN};
    for (int i = 0; i < 7; i++) {
        int n = sph_frustum_sides(round[i]);
        assert_true(n >= 3 && 1 - cos(M_PI / n) <= round[i]);
        assert_true(n == 3 || 1 - cos(M_PI / (n - 1)) > round[i]);
    }
    assert_int_equal(sph_frustum_sides(SPH_FRUSTUM_ROUND), 32);
}

static double dot(struct sph_vec a, struct sph_vec b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/* Distance from the surface between the circles: in the half plane of axis and point it is that
 * from a segment. *out: the point lies on the outer side. */
static double distance(const struct sph_frustum *c, struct sph_vec p, int *out) {
    struct sph_vec axis = sph_vec_sub(c->apex, c->base), from = sph_vec_sub(p, c->base);
    double length = sqrt(dot(axis, axis)), h = dot(from, axis) / length;
    double along = h / length, r0 = fabs(c->base_rad);
    struct sph_vec off = {from.x - along * axis.x, from.y - along * axis.y,
                          from.z - along * axis.z};
    double r = sqrt(dot(off, off));
    double dr = fabs(c->apex_rad) - r0, size = length * length + dr * dr;
    double t = fmin(fmax((h * length + (r - r0) * dr) / size, 0), 1);
    *out = r - r0 > dr * h / length;
    return hypot(h - t * length, r - r0 - t * dr);
}

/* A cone of any place, size and direction; every fourth has an apex, or begins with one. */
static struct sph_frustum random_cone(struct sph_rng *rng, int number) {
    double scale = exp(sph_rng_range(rng, -7, 7)), sign = number & 1 ? -1 : 1;
    struct sph_vec base = {sph_rng_range(rng, -9, 9), sph_rng_range(rng, -9, 9),
                           sph_rng_range(rng, -9, 9)};
    struct sph_vec dir = {sph_rng_range(rng, -1, 1), sph_rng_range(rng, -1, 1),
                          sph_rng_range(rng, -1, 1)};
    if (number % 7 == 0) dir = sph_vec_of(0, number % 3 == 0, number % 3 != 0);
    struct sph_frustum c = {base, base, sph_rng_range(rng, 0.01, 1) * scale * sign,
                            sph_rng_range(rng, 0.01, 1) * scale * sign, 7};
    c.apex.x += scale * dir.x, c.apex.y += scale * dir.y, c.apex.z += scale * dir.z;
    if (number % 4 == 1) c.apex_rad = 0;
    if (number % 8 == 2) c.base_rad = 0;
    return c;
}

/* Every edge is shared by two triangles, in opposite directions and to the last bit, but for those
 * of the two circles. */
static void assert_closed(const struct sph_scene *s, int open) {
    int alone = 0;
    for (uint32_t i = 0; i < 3 * s->n_facets; i++) {
        const struct sph_vec *a = s->facets[i / 3].v;
        int back = 0, same = 0;
        for (uint32_t j = 0; j < 3 * s->n_facets; j++) {
            const struct sph_vec *b = s->facets[j / 3].v;
            const struct sph_vec *p = &a[i % 3], *q = &a[(i + 1) % 3];
            same += !memcmp(p, &b[j % 3], sizeof *p) && !memcmp(q, &b[(j + 1) % 3], sizeof *q);
            back += !memcmp(q, &b[j % 3], sizeof *p) && !memcmp(p, &b[(j + 1) % 3], sizeof *q);
        }
        assert_true(same == 1 && back <= 1);
        alone += !back;
    }
    assert_int_equal(alone, open);
}

static void test_surface(void **unused) {
    (void)unused;
    struct sph_rng rng = {seed};
    double worst = 0;
    for (int number = 0; number < CONES; number++) {
        struct sph_frustum c = random_cone(&rng, number);
        double round = exp(sph_rng_range(&rng, log(1e-3), log(0.5)));
        double most = fmax(fabs(c.base_rad), fabs(c.apex_rad));
        double size = sqrt(dot(c.base, c.base)) + most, slack = 1e-13 * size;
        int n = sph_frustum_sides(round), rims = (c.base_rad != 0) + (c.apex_rad != 0), out;
        struct sph_scene s = {.path = "cone.nff"};
        struct sph_facet look = {.material = 3, .line = 7};
        struct sph_error err = {""};
        uint32_t groups = 5;
        assert_int_equal(sph_scene_add_frustum(&s, &c, round, &look, &groups, &err), 0);
        assert_int_equal(s.n_facets, rims * n);
        assert_int_equal(groups, 5 + n);
        for (uint32_t i = 0; i < s.n_facets; i++) {
            const struct sph_facet *f = &s.facets[i];
            struct sph_vec e1 = sph_vec_sub(f->v[1], f->v[0]), e2 = sph_vec_sub(f->v[2], f->v[0]);
            struct sph_vec normal = {e1.y * e2.z - e1.z * e2.y, e1.z * e2.x - e1.x * e2.z,
                                     e1.x * e2.y - e1.y * e2.x};
            assert_true(f->kind == SPH_TRIANGLE && f->material == 3 && f->line == 7);
            for (int k = 0; k < 3; k++)
                assert_true(distance(&c, f->v[k], &out) <= slack);
            for (int k = 0; k < SAMPLES / (int)s.n_facets + 1; k++) {
                double x = sph_rng_range(&rng, 0, 1), y = sph_rng_range(&rng, 0, 1 - x),
                       step = 1e-3 * most;
                struct sph_vec p = {f->v[0].x + x * e1.x + y * e2.x,
                                    f->v[0].y + x * e1.y + y * e2.y,
                                    f->v[0].z + x * e1.z + y * e2.z};
                double off = distance(&c, p, &out), long_n = sqrt(dot(normal, normal));
                worst = fmax(worst, off / (round * most));
                assert_true(off <= round * most + slack);
                step += 2 * off; /* over the surface on the side that the normal shows */
                p.x += step * normal.x / long_n, p.y += step * normal.y / long_n;
                p.z += step * normal.z / long_n;
                distance(&c, p, &out);
                if (c.base_rad * c.apex_rad > 0) assert_int_equal(out, c.base_rad > 0);
            }
        }
        if (number < 60) assert_closed(&s, rims * n);
        sph_scene_free(&s);
    }
    printf("# worst of %d cones: %.3f of what is allowed\n", CONES, worst);
    assert_true(worst > 0.9);
}

/* What a file says is written again as it was, and read again as the same. */
static void test_file(void **unused) {
    (void)unused;
    static const char text[] =
        CAM MAT "c 0 0 0 1\n0 2 0 .5\nmove 1 0 0 .5 0 0 0\nc 3 0 0 -1 3 1 0 -1\n"
                "still\np 3 0 0 0 1 0 0 0 1 0\n";
    struct sph_scene a, b;
    struct sph_error err = {""};
    struct sph_read_options o = {.round = 0.1};
    put_file(text, sizeof text - 1);
    assert_int_equal(sph_scene_read(file_name, &o, &a, &err), 0);
    assert_int_equal(a.n_facets, 4 * 7 + 1);
    FILE *file = fopen(file_name, "w");
    assert_int_equal(sph_scene_write(&a, file, &err), 0);
    fclose(file);
    assert_int_equal(sph_scene_read(file_name, &o, &b, &err), 0);
    assert_int_equal(a.n_facets, b.n_facets);
    assert_int_equal(b.n_frusta, 2);
    for (uint32_t i = 0; i < a.n_facets; i++) {
        assert_memory_equal(a.facets[i].v, b.facets[i].v, sizeof a.facets[i].v);
        assert_int_equal(a.facets[i].group, b.facets[i].group);
        assert_int_equal(a.facets[i].motion != 0, i >= 14 && i < 28);
    }
    sph_scene_free(&b);
    o.round = 0; /* as nothing were said */
    assert_int_equal(sph_scene_read(file_name, &o, &b, &err), 0);
    assert_int_equal(b.n_facets, 4 * 32 + 1);
    sph_scene_free(&a);
    sph_scene_free(&b);
}

/* Scenes by formula have their cones, whatever their size; sizes out of range are refused. */
static void test_made(void **unused) {
    (void)unused;
    static const struct {
        const char *kind;
        uint32_t balls[2], cones[2]; /* of sizes 1 and 3 */
    } made[] = {{"jacks", {6, 54}, {3, 27}},
                {"lattice", {8, 64}, {12, 144}},
                {"tree", {0, 0}, {7, 31}},
                {"rings", {12, 36}, {12, 36}}};
    struct sph_error err = {""};
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 2; i++) {
            struct sph_generate_options o = {.size = 1 + 2 * i};
            struct sph_scene s;
            assert_int_equal(sph_generate(made[k].kind, &o, &s, &err), 0);
            assert_int_equal(s.n_spheres, made[k].balls[i]);
            assert_int_equal(s.n_frusta, made[k].cones[i]);
            sph_scene_free(&s);
            o.size = 6;
            assert_int_equal(sph_generate(made[k].kind, &o, &s, &err), -1);
            assert_non_null(strstr(err.text, "size 6 is not within 1 to 5"));
        }
}

int main(int argc, char **argv) {
    enum { N_BADS = sizeof bads / sizeof *bads, N_TESTS = 4 };
    struct CMUnitTest tests[N_TESTS + N_BADS] = {
        cmocka_unit_test(test_sides), cmocka_unit_test(test_surface), cmocka_unit_test(test_file),
        cmocka_unit_test(test_made)};
    for (int i = 0; i < N_BADS; i++)
        tests[N_TESTS + i] = (struct CMUnitTest){
            .name = bads[i].name, .test_func = test_bad, .initial_state = (void *)&bads[i]};
    if (argc > 1) seed = test_number(argv[1], "seed", 1);
    printf("# repeat with: %s %llu\n", argv[0], (unsigned long long)seed);
    return cmocka_run_group_tests_name("frusta", tests, make_folder, remove_folder);
}
