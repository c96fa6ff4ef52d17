/* test_effects_facets.c - with triangles and planes, too: what build leaves off changes no pixel
 * SPDX-License-Identifier: Apache-2.0
 *
 * build/test/test_effects_facets [seed [scenes]]: facets next to spheres, gaps about as large as
 * the error of hit points; and the search for near facets against plain arithmetic.
 */
#include "build_scene.h"

#include "builder/effects/occlude.h"
#include "effects_scene.h"
#include "builder/prim/build.h"

enum { WIDTH = 24, HEIGHT = 16 };
static int scenes = 600 / SLOW; /* of each test: argument 2 */

static int32_t whole(double lo, double hi) {
    return (int32_t)floor(between(lo, hi + 1));
}

/* Distance of a point from a segment, and from a triangle, in double. */
static double segment_distance(const double a[3], const double b[3], const double c[3]) {
    double along = 0, length = 0, sum = 0;
    for (int i = 0; i < 3; i++) {
        along += (c[i] - a[i]) * (b[i] - a[i]);
        length += (b[i] - a[i]) * (b[i] - a[i]);
    }
    double s = fmin(fmax(along / length, 0), 1);
    for (int i = 0; i < 3; i++)
        sum += pow(a[i] + s * (b[i] - a[i]) - c[i], 2);
    return sqrt(sum);
}

static double triangle_distance(const struct sph_grid_facet *f, const struct sph_ball *ball) {
    double v[3][3], c[3], best = INFINITY;
    for (int i = 0; i < 3; i++) {
        c[i] = ball->c[i];
        for (int k = 0; k < 3; k++)
            v[k][i] = f->v[k][i];
    }
    for (int k = 0; k < 3; k++)
        best = fmin(best, segment_distance(v[k], v[(k + 1) % 3], c));
    for (int i = 0; i <= 300; i++) /* and segments across it */
        for (int j = 0; j < 2; j++) {
            double p[3], q[3], s = i / 300.0;
            for (int k = 0; k < 3; k++) {
                p[k] = v[0][k] + s * (v[1][k] - v[0][k]);
                q[k] = v[2][k] + s * (v[1][k] - v[2][k]) * j;
            }
            best = fmin(best, segment_distance(p, q, c));
        }
    return best;
}

/* The exact "no" against distances. */
static void test_near(void **unused) {
    int yes = 0, no = 0;
    (void)unused;
    for (int run = 0; run < 4000 / SLOW; run++) {
        const struct sph_profile *p = &sph_profiles[run % SPH_PROFILES];
        double error = (double)sph_facet_error(p) / (1 << sph_error_bits(p));
        struct sph_grid_facet f = {.kind = SPH_TRIANGLE};
        double size = exp(between(0, log(0.4) + p->w * log(2))), n[3], square = 0;
        struct sph_ball ball = {.r = whole(1, size / 2 + 1)};
        for (int i = 0; i < 3; i++) {
            for (int k = 0; k < 3; k++)
                f.v[k][i] = whole(-size, size);
            ball.c[i] = whole(-size, size);
        }
        if (run % 3 == 2) { /* its distance is about that of the limit */
            double d = triangle_distance(&f, &ball);
            ball.r = (int32_t)fmax(d - error + between(-3, 3), 1);
        }
        double gap = triangle_distance(&f, &ball) - ball.r - error;
        int near = sph_prim_build_of((uint32_t)f.kind)->near(&f, &ball, p);
        assert_true(gap > -1e-6 || near); /* never a wrong "no"; samples are too far, if at all */
        if (run % 3 == 2 && size < 100) assert_true(gap < size / 200 + 1 || !near);
        f.kind = SPH_PLANE;
        double off = 0;
        for (int i = 0; i < 3; i++) {
            n[i] = f.v[1][i];
            square += n[i] * n[i];
            off += n[i] * (ball.c[i] - f.v[0][i]);
        }
        if (square > 0) {
            gap = fabs(off) / sqrt(square) - ball.r - error;
            near = sph_prim_build_of((uint32_t)f.kind)->near(&f, &ball, p);
            assert_true(gap > 0 || near);
            assert_true(gap < 1e-3 * ball.r + 1 || square < 1e6 || !near);
        }
        yes += near, no += !near;
    }
    printf("# %d near, %d not\n", yes, no);
    assert_true(yes > 400 / SLOW && no > 400 / SLOW);
}

static struct sph_material materials[] = {{{0.9, 0.5, 0.3}, 0.7, 0.3, 1, 0, 1, 0, {0}, 0},
                                          {{0.3, 0.9, 0.5}, 0.2, 0.8, 1, 0, 1, 0, {0}, 0},
                                          {{0.5, 0.3, 0.9}, 1, 0, 1, 0, 1, 0, {0}, 0}};

/* A grid unit is one unit of the scene: a black light makes it so large. */
static struct sph_scene units(struct sph_build_options *o) {
    struct sph_scene s = bare();
    s.n_lights = 0;
    s.camera =
        (struct sph_camera){{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 60, .width = WIDTH, .height = HEIGHT};
    s.ambient[0] = s.ambient[1] = s.ambient[2] = 0.2;
    s.background[2] = 1;
    s.materials = materials, s.n_materials = 3;
    *o = standard;
    o->profile = whole(0, SPH_PROFILES - 1);
    o->tree = whole(SPH_TREE_PAPER, SPH_TREE_BALANCED);
    o->background = SPH_BG_NONE;
    o->max_depth = 3;
    s.lights[s.n_lights++] =
        (struct sph_light){{ldexp(0.75, sph_profiles[o->profile].w), 0, 0}, {0, 0, 0}, 0};
    return s;
}

static struct sph_vec rounded(struct sph_vec v) {
    return at(round(v.x), round(v.y), round(v.z));
}

static struct sph_vec unit(void) {
    struct sph_vec v = near_to(at(0, 0, 0), 1);
    double size = sqrt(v.x * v.x + v.y * v.y + v.z * v.z) + 1e-9;
    return at(v.x / size, v.y / size, v.z / size);
}

/* A facet at a gap from a sphere: its plane is about tangential, or an edge or corner looks at it.
 */
static void lay(struct sph_scene *s, const struct sph_sphere *to, double gap) {
    struct sph_vec u = unit(), w = unit(), x, y, p;
    double far = to->rad + gap, size = to->rad * between(0.5, 5) + 4;
    x = at(u.y * w.z - u.z * w.y, u.z * w.x - u.x * w.z, u.x * w.y - u.y * w.x);
    y = at(u.y * x.z - u.z * x.y, u.z * x.x - u.x * x.z, u.x * x.y - u.y * x.x);
    double tilt = uniform() < 0.4 ? between(0, 2) : 0;
    p = at(to->ctr.x + far * u.x, to->ctr.y + far * u.y, to->ctr.z + far * u.z);
    if (uniform() < 0.2 && s->n_facets < 2) {
        add_plane(s, rounded(p), u);
    } else {
        struct sph_vec v[3];
        for (int k = 0; k < 3; k++) {
            double a = size * cos(2.1 * k), b = size * sin(2.1 * k), c = tilt * (size + a);
            v[k] = rounded(at(p.x + a * x.x + b * y.x + c * u.x, p.y + a * x.y + b * y.y + c * u.y,
                              p.z + a * x.z + b * y.z + c * u.z));
        }
        add_triangle(s, v[0], v[1], v[2], s->n_facets);
    }
    s->facets[s->n_facets - 1].material = (uint32_t)whole(0, 2);
}

static void test_gaps(void **unused) {
    struct tally t = {0};
    int facets = 0;
    (void)unused;
    for (int run = 0; run < scenes; run++) {
        struct sph_build_options o;
        struct sph_scene s = units(&o);
        double far = 30 + exp(between(0, log(ldexp(0.3, sph_profiles[o.profile].w))));
        int n = whole(1, 3);
        for (int i = 0; i < n; i++) {
            add_ball(&s, rounded(at(60 * i, between(-20, 20), -far)), whole(1, 25));
            s.spheres[i].material = (uint32_t)whole(0, 2);
        }
        for (int i = whole(1, 4); i > 0; i--)
            lay(&s, &s.spheres[whole(0, n - 1)], uniform() < 0.1 ? -5 : between(0, 9));
        for (int i = whole(0, 2); i > 0; i--)
            s.lights[s.n_lights++] = (struct sph_light){
                rounded(near_to(s.spheres[0].ctr, uniform() < 0.5 ? 40 : 200)), {0.9, 0.7, 0.8}, 0};
        s.camera.angle = fmin(2 * atan(between(40, 150) / far) * 180 / M_PI, 120);
        facets += (int)s.n_facets;
        compare(&s, o, &t);
    }
    printf("# %d facets\n", facets);
    print_tally(&t);
    assert_true(t.frames > scenes * 9 / 10 && t.seen > 20 * t.frames);
    assert_true(t.off[SPH_REPORT_INSIDE] * 10 > scenes);
}

/* A light shut in by a sphere stays out of the machine, unless a facet is in there too. */
static void test_dark(void **unused) {
    (void)unused;
    for (int in = 0; in < 2; in++) {
        struct sph_build_options o;
        struct sph_build_report report;
        struct sph_scene s = units(&o);
        struct tally t = {0};
        o.profile = SPH_STANDARD;
        s.lights[0].pos.x = 49152;
        add_ball(&s, at(0, 0, -300), 100);
        s.lights[s.n_lights++] = (struct sph_light){{0, 0, -300}, {0.9, 0.9, 0.9}, 0};
        double z = in ? -290 : -150;
        add_triangle(&s, at(0, 0, z), at(10, 0, z), at(0, 10, z), 0);
        struct sph_machine m = built(&s, o, &report);
        assert_int_equal(m.regs[SPH_REG_N_LIGHTS], in);
        sph_machine_free(&m);
        compare(&s, o, &t);
        print_tally(&t);
    }
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_near), cmocka_unit_test(test_gaps),
                                       cmocka_unit_test(test_dark)};
    seed(argc, argv);
    if (argc > 2) scenes = (int)test_number(argv[2], "scenes", 0);
    return cmocka_run_group_tests_name("effects of facets", tests, NULL, NULL);
}
