/* test_effects.c - what finds effects: error of hit points, near spheres, shadows, against others
 * SPDX-License-Identifier: Apache-2.0
 *
 * build/test/test_effects [seed]
 */
#include "effects_scene.h"

#include <time.h>

#include "builder/effects/occlude.h"
#include "machine/layout.h"
#include "prim/sphere.h"
#include "trace/setup.h"

static const struct sph_facets no_facets;

static int32_t whole(double lo, double hi) {
    return (int32_t)floor(between(lo, hi + 1));
}

static struct sph_ball ball_in(const struct sph_profile *p, int32_t most) {
    int32_t half = (1 << (p->w - 1)) - 8;
    struct sph_ball b = {.r = whole(1, most)};
    for (int i = 0; i < 3; i++)
        b.c[i] = whole(-half + b.r, half - b.r);
    return b;
}

static double length(const double v[3]) {
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/* No point where a ray may start is farther from its sphere than the bound; some are not much
 * nearer, so that the bound is no larger than need be. */
static void test_point_error(void **unused) {
    (void)unused;
    for (int profile = 0; profile < SPH_PROFILES; profile++) {
        const struct sph_profile *p = &sph_profiles[profile];
        double bound = (double)sph_point_error(p) / (1 << sph_error_bits(p)), worst = 0;
        int64_t half = 1ll << (p->w - 1);
        int hits = 0;
        for (int run = 0; run < 300000 / SLOW; run++) {
            struct sph_ball ball = ball_in(p, run & 1 ? 9 : 1 << (p->w - 5));
            struct sph_leaf leaf = {{ball.c[0], ball.c[1], ball.c[2]}, ball.r, 0};
            struct sph_ray ray = {.kind = SPH_REFLECTED, .skip = {SPH_ID_NONE, 0}, .inside = 1};
            double to[3], most = 0;
            for (int i = 0; i < 3; i++) {
                ray.org[i] = whole((double)-half, (double)half - 1);
                if (run & 2) { /* as far as can be */
                    ray.org[i] = -half;
                    leaf.ctr[i] = half - 5 - ball.r - whole(0, 20);
                }
                to[i] = (double)(leaf.ctr[i] - ray.org[i]) + between(-0.4, 0.4) * ball.r;
                most = fmax(most, fabs(to[i]));
            }
            /* mirror rays have full length; primary ones may be as short as 16 */
            double size = ldexp(between(0.5, 1), run % 5 ? p->wd - 1 : 6);
            for (int i = 0; i < 3; i++)
                ray.dir[i] = (int64_t)(to[i] * size / most);
            sph_ray_setup(p, &ray);
            if (ray.a < SPH_MIN_SCREEN * SPH_MIN_SCREEN) continue;
            struct sph_leaf_result r = sph_leaf_test(&ray, &leaf);
            if (!r.hit) continue;
            uint64_t roots = 0;
            struct sph_hit hit = {sph_leaf_key(&r, &roots), 0, r.far != 0, 0};
            struct sph_surface s;
            sph_surface_at(p, &ray, &hit, &leaf, &s);
            double off[3];
            for (int i = 0; i < 3; i++)
                off[i] = (double)(s.point[i] - leaf.ctr[i]);
            worst = fmax(worst, fabs(length(off) - (double)leaf.rad));
            hits++;
        }
        printf("# %s: %d hits, at most %.3f grid units off the sphere, bound %.3f\n", p->name, hits,
               worst, bound);
        assert_true(worst <= bound && worst > 0.6 * bound && hits > 1000);
    }
}

/* The search finds a pair exactly if a test of all pairs does, and what it finds is one. */
static void test_near_pair(void **unused) {
    enum { MOST = 300 };
    static struct sph_ball balls[MOST];
    int with = 0, without = 0;
    (void)unused;
    for (int run = 0; run < 4000 / SLOW; run++) {
        const struct sph_profile *p = &sph_profiles[run % SPH_PROFILES];
        uint32_t n = (uint32_t)whole(0, run & 4 ? 12 : MOST), pair[2];
        double crowd = between(0.02, 0.4) / cbrt(n + 1.0);
        int any = 0;
        for (uint32_t i = 0; i < n; i++) {
            balls[i] = ball_in(p, 1 + (int32_t)ldexp(crowd, p->w - (run & 8 ? 1 : 4)));
            if (run & 16) balls[i].c[run / 32 % 3] = 0;
            if (i && uniform() < 1.0 / MOST) { /* now and then one at the limit */
                balls[i] = balls[i - 1];
                balls[i].c[0] += 2 * balls[i].r + whole(0, 6);
            }
        }
        for (uint32_t i = 0; i < n; i++)
            for (uint32_t j = 0; j < i; j++)
                any |= sph_nearness(&balls[i], &balls[j], p) != SPH_APART;
        assert_int_equal(sph_near_pair(balls, n, p, pair, NULL), any);
        if (any) {
            assert_true(pair[0] < pair[1] && pair[1] < n);
            assert_true(sph_nearness(&balls[pair[0]], &balls[pair[1]], p) != SPH_APART);
        }
        with += any, without += !any && n > 1;
    }
    printf("# %d with a pair, %d without\n", with, without);
    assert_true(with > 800 / SLOW && without > 800 / SLOW);
}

/* How two spheres lie to each other, at every limit. */
static void test_nearness(void **unused) {
    static const struct {
        int32_t x, y, r1, r2;
        int draft, reference;
    } cases[] = {
        {10, 0, 4, 4, SPH_NEARLY, SPH_APART},   {13, 0, 4, 4, SPH_APART, SPH_APART},
        {9, 0, 4, 4, SPH_NEARLY, SPH_NEARLY},   {8, 0, 4, 4, SPH_TOUCH, SPH_TOUCH},
        {12, 0, 4, 4, SPH_NEARLY, SPH_APART},   {6, 8, 5, 5, SPH_TOUCH, SPH_TOUCH},
        {7, 0, 4, 4, SPH_OVERLAP, SPH_OVERLAP}, {3, 0, 7, 4, SPH_NESTED, SPH_NESTED},
        {4, 0, 7, 4, SPH_OVERLAP, SPH_OVERLAP}, {0, 0, 7, 4, SPH_NESTED, SPH_NESTED},
    };
    (void)unused;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct sph_ball a = {{-3, 5, 2}, cases[i].r1}, b = {{-3, 5, 2}, cases[i].r2};
        b.c[0] += cases[i].x, b.c[1] += cases[i].y;
        assert_int_equal(sph_nearness(&a, &b, &sph_profiles[SPH_DRAFT]), cases[i].draft);
        assert_int_equal(sph_nearness(&b, &a, &sph_profiles[SPH_REFERENCE]), cases[i].reference);
    }
    assert_int_equal(sph_point_error(&sph_profiles[SPH_STANDARD]), 37); /* docs/design/builder.md */
    assert_int_equal(sph_point_error(&sph_profiles[SPH_FINE]), 13);
}

/* Two spheres and a light against the least room over many places of the cone, in double. */
static void test_occlusion(void **unused) {
    int found = 0, none = 0;
    (void)unused;
    for (int run = 0; run < 20000 / SLOW; run++) {
        const struct sph_profile *p = &sph_profiles[run % SPH_PROFILES];
        struct sph_ball balls[2] = {ball_in(p, 1 << (p->w - 2)), ball_in(p, 1 << (p->w - 3))};
        struct sph_ball lamp = ball_in(p, 1);
        const int32_t eye[3] = {0, 0, (1 << (p->w - 1)) - 1};
        struct sph_world world = {balls, 2, p, eye, &no_facets, 0};
        struct sph_witness w = {0};
        double room = INFINITY, error = (double)sph_point_error(p) / (1 << sph_error_bits(p));
        for (int i = 0; i < 2; i++)
            for (int k = 0; k <= 4000; k++) {
                const struct sph_ball *a = &balls[i], *b = &balls[1 - i];
                double s = k / 4000.0, v[3];
                for (int axis = 0; axis < 3; axis++)
                    v[axis] = a->c[axis] - lamp.c[axis] - s * (b->c[axis] - lamp.c[axis]);
                room = fmin(room, length(v) - s * b->r - a->r - error);
            }
        if (sph_eye_ball(&world) < 2) continue;
        int how = sph_occlusion(&world, (const int32_t(*)[3]) & lamp.c, 1, &w);
        assert_true(how == SPH_OCCLUDES || how == SPH_NOTHING_OCCLUDES);
        if (how == SPH_OCCLUDES) /* within the step of k */
            assert_true(w.occluder + w.receiver == 1 && room < ldexp(1, p->w - 10));
        else
            assert_true(room > 0);
        found += how == SPH_OCCLUDES, none += how != SPH_OCCLUDES;
    }
    printf("# %d with a shadow, %d without\n", found, none);
    assert_true(found > 500 / SLOW && none > 500 / SLOW);
}

/* Each thing that keeps a sphere deep in another from being passed over. */
static void test_buried(void **unused) {
    struct sph_ball balls[3] = {{{0, 0, 0}, 200}, {{20, 0, 0}, 30}, {{500, 0, 0}, 100}};
    const int32_t eye[3] = {0, 0, 900}, in[3] = {0, 0, -150}, out[1][3] = {{0, 900, 0}};
    struct sph_world world = {balls, 3, &sph_profiles[SPH_DRAFT], eye, &no_facets, 1};
    uint8_t buried[3];
    (void)unused;
#define BURIED(lights, n) (sph_buried(&world, lights, n, buried), buried[1])
    assert_true(BURIED(out, 1) && !buried[0] && !buried[2]);
    assert_false(BURIED(&in, 1));
    world.mended = 0;
    assert_false(BURIED(out, 1));
    world.mended = 1, world.eye = in;
    assert_false(BURIED(out, 1));
    world.eye = eye, balls[2].c[0] = 300;
    assert_false(BURIED(out, 1));
    struct sph_ball other = balls[2];
    balls[2] = balls[1], balls[1] = other; /* in either order */
    assert_false(BURIED(out, 1) || buried[2]);
    balls[1] = balls[2], balls[2] = other;
    balls[2].c[0] = 500, balls[1].c[0] = 150;
    assert_false(BURIED(out, 1));
}

/* Prints how long the search takes where there is no pair to find. */
static void test_time(void **unused) {
    enum { SIDE = 47 };
    const uint32_t n = SIDE * SIDE * SIDE;
    struct sph_ball *balls = malloc(n * sizeof *balls);
    const struct sph_profile *p = &sph_profiles[SPH_FINE];
    uint32_t pair[2];
    (void)unused;
    for (int flat = 0; flat < 2; flat++) {
        for (uint32_t i = 0; i < n; i++) {
            int32_t pitch = flat ? 3000 : 20000, wide = flat ? 322 : SIDE;
            int32_t x = (int32_t)i % wide, y = (int32_t)i / wide % wide,
                    z = (int32_t)i / wide / wide;
            balls[i] = (struct sph_ball){
                {(x - wide / 2) * pitch + whole(-9, 9), (y - wide / 2) * pitch, (z - 9) * 20000},
                pitch / 2 - 20};
        }
        clock_t start = clock();
        assert_int_equal(sph_near_pair(balls, n, p, pair, NULL), 0);
        printf("# %u spheres apart, %s: %.3f s\n", n, flat ? "in a plane" : "in a cube",
               (double)(clock() - start) / CLOCKS_PER_SEC);
    }
    free(balls);
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_point_error), cmocka_unit_test(test_near_pair),
        cmocka_unit_test(test_nearness),    cmocka_unit_test(test_occlusion),
        cmocka_unit_test(test_buried),      cmocka_unit_test(test_time),
    };
    seed(argc, argv);
    return cmocka_run_group_tests_name("effects", tests, NULL, NULL);
}
