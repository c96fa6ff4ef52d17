/* test_leaf_cases.c - named ray and sphere cases with their outcome written down
 * SPDX-License-Identifier: Apache-2.0
 *
 * Each row is one rule of the leaf test; golden and naive model must both agree with it.
 */
#include "vectors.h"

#include "naive/naive.h"

enum { P = SPH_PRIMARY, S = SPH_SHADOW, NO = 0, OUT = 1, IN = 2 /* own sphere, from which side */ };
enum { X = 4 /* with P or S: effect INSIDE is off */ };
enum { MISS, NEAR, FAR, EXIT };

static const struct {
    const char *name;
    int64_t org[3], dir[3], ctr[3], rad;
    int kind, own, expected;
    uint64_t key;
} cases[] = {
    {"head on: a*t = 10*(100-20)", {0}, {10}, {100}, 20, P, NO, NEAR, 800},
    {"tangent", {0}, {10}, {100, 20}, 20, P, NO, MISS, 0},
    {"one unit inside the tangent", {0}, {10}, {100, 20}, 21, P, NO, NEAR, 936},
    {"one unit outside the tangent", {0}, {10}, {100, 21}, 20, P, NO, MISS, 0},
    {"sphere behind", {0}, {10}, {-100}, 20, P, NO, MISS, 0},
    {"origin inside, heading to the centre", {90}, {10}, {100}, 20, P, NO, FAR, 300},
    {"origin inside, heading away", {110}, {10}, {100}, 20, P, NO, FAR, 100},
    {"origin at the centre", {100}, {10}, {100}, 20, P, NO, FAR, 200},
    {"on the surface, entering: t = 2b/a", {80}, {10}, {100}, 20, P, NO, FAR, 400},
    {"on the surface, leaving", {120}, {10}, {100}, 20, P, NO, MISS, 0},
    {"on the surface, along it", {100, 20}, {10}, {100}, 20, P, NO, MISS, 0},
    {"one unit above the surface", {79}, {10}, {100}, 20, P, NO, NEAR, 10},
    {"no direction", {0}, {0}, {100}, 20, P, NO, MISS, 0},
    {"no direction, at the centre", {100}, {0}, {100}, 20, P, NO, MISS, 0},
    {"no radius, aimed at", {0}, {10}, {100}, 0, P, NO, MISS, 0},
    {"no radius, at the centre", {100}, {10}, {100}, 0, P, NO, MISS, 0},
    {"shortest direction", {0}, {1}, {100}, 20, P, NO, NEAR, 80},
    {"near root rounds up: 100 - sqrt(399)", {0}, {1}, {100, 1}, 20, P, NO, NEAR, 81},
    {"far root rounds up: sqrt(399)", {100}, {1}, {100, 1}, 20, P, NO, FAR, 20},
    {"own sphere from outside", {90}, {10}, {100}, 20, P, OUT, MISS, 0},
    {"own sphere from inside", {90}, {10}, {100}, 20, P, IN, FAR, 300},
    {"own from inside, origin rounded outward", {79}, {10}, {100}, 20, P, IN, FAR, 410},
    {"own from inside, nothing ahead", {121}, {10}, {100}, 20, P, IN, EXIT, 1},
    {"own from inside, tangent", {100, 20}, {10}, {100}, 20, P, IN, EXIT, 1},
    {"shadow: occluder between", {0}, {200}, {100}, 20, S, NO, NEAR, 0},
    {"shadow: occluder behind the light", {0}, {70}, {100}, 20, S, NO, MISS, 0},
    {"shadow: light on the surface, t = 1", {0}, {80}, {100}, 20, S, NO, MISS, 0},
    {"shadow: light one unit inside", {0}, {81}, {100}, 20, S, NO, NEAR, 0},
    {"shadow: light at the centre", {0}, {100}, {100}, 20, S, NO, NEAR, 0},
    {"shadow: point and light inside", {90}, {20}, {100}, 20, S, NO, MISS, 0},
    {"shadow: point inside, light outside", {90}, {50}, {100}, 20, S, NO, FAR, 0},
    {"shadow: point inside, light on the far side", {90}, {30}, {100}, 20, S, NO, MISS, 0},
    {"shadow: tangent", {0}, {200}, {100, 20}, 20, S, NO, MISS, 0},
    {"shadow: light at the point", {90}, {0}, {100}, 20, S, NO, MISS, 0},
    {"shadow: own from outside", {80}, {200}, {100}, 20, S, OUT, MISS, 0},
    {"shadow: own from inside, light outside", {81}, {200}, {100}, 20, S, IN, FAR, 0},
    {"shadow: own from inside, light inside", {81}, {20}, {100}, 20, S, IN, MISS, 0},
    {"only outside: head on", {0}, {10}, {100}, 20, P | X, NO, NEAR, 800},
    {"only outside: one unit above the surface", {79}, {10}, {100}, 20, P | X, NO, NEAR, 10},
    {"only outside: on the surface, entering", {80}, {10}, {100}, 20, P | X, NO, MISS, 0},
    {"only outside: origin inside", {90}, {10}, {100}, 20, P | X, NO, MISS, 0},
    {"only outside: own sphere, said to be inside", {90}, {10}, {100}, 20, P | X, IN, MISS, 0},
    {"only outside: own sphere, origin above it", {79}, {10}, {100}, 20, P | X, IN, MISS, 0},
    {"only outside: shadow, occluder between", {0}, {200}, {100}, 20, S | X, NO, NEAR, 0},
    {"only outside: shadow, light inside", {0}, {81}, {100}, 20, S | X, NO, NEAR, 0},
    {"only outside: shadow, point on the surface", {80}, {200}, {100}, 20, S | X, NO, MISS, 0},
    {"only outside: shadow, point inside", {90}, {50}, {100}, 20, S | X, NO, MISS, 0},
    {"only outside: shadow, own from inside", {81}, {200}, {100}, 20, S | X, IN, MISS, 0},
    {"corner to corner of draft: 3*4095^2 - 4095^2*sqrt(3)",
     {-2048, -2048, -2048},
     {4095, 4095, 4095},
     {2047, 2047, 2047},
     4095,
     P,
     NO,
     NEAR,
     21262272},
};

static void named_cases(void **state) {
    (void)state;
    int failed = 0;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct sph_ray ray = {.kind = cases[i].kind & ~X,
                              .skip = {cases[i].own == NO ? SPH_ID_NONE : 7, cases[i].own == IN},
                              .inside = !(cases[i].kind & X)};
        struct sph_leaf leaf = {.rad = cases[i].rad, .id = 7};
        for (int j = 0; j < 3; j++) {
            ray.org[j] = cases[i].org[j];
            ray.dir[j] = cases[i].dir[j];
            leaf.ctr[j] = cases[i].ctr[j];
            ray.a += (uint64_t)(ray.dir[j] * ray.dir[j]);
        }
        uint64_t roots = 0;
        struct sph_leaf_result r = sph_leaf_test(&ray, &leaf);
        struct sph_naive_leaf n = sph_naive_leaf(&ray, &leaf);
        uint64_t key = r.hit && ray.kind != SPH_SHADOW ? sph_leaf_key(&r, &roots) : 0;
        int golden = !r.hit ? MISS : r.exit ? EXIT : r.far ? FAR : NEAR;
        int naive = !n.hit ? MISS : n.exit ? EXIT : n.far ? FAR : NEAR;
        if (golden == cases[i].expected && naive == golden && key == cases[i].key && n.key == key)
            continue;
        printf("# %s: expected %d key %lu, golden %d key %lu, naive %d key %lu\n", cases[i].name,
               cases[i].expected, cases[i].key, golden, key, naive, n.key);
        failed++;
    }
    assert_int_equal(failed, 0);
}

/* Of two spheres on one ray the key tells which comes first, near against far root too. */
static void order_of_keys(void **state) {
    (void)state;
    struct sph_ray ray = {.dir = {3, 4, 0}, .a = 25, .skip = {SPH_ID_NONE, 0}, .inside = 1};
    uint64_t roots = 0, before = 0;
    for (int64_t rad = 1; rad < 400; rad++) { /* concentric around the origin: far roots */
        struct sph_leaf leaf = {{0, 0, 0}, rad, 0};
        struct sph_leaf_result r = sph_leaf_test(&ray, &leaf);
        uint64_t key = sph_leaf_key(&r, &roots);
        assert_true(r.hit && r.far && key > before);
        assert_int_equal(key, 5 * rad);
        struct sph_leaf next = {{6 * rad, 8 * rad, 0}, 9 * rad - 1, 1}; /* entered just behind */
        r = sph_leaf_test(&ray, &next);
        assert_true(r.hit && !r.far && sph_leaf_key(&r, &roots) > key);
        before = key;
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(named_cases),
        cmocka_unit_test(order_of_keys),
    };
    return cmocka_run_group_tests_name("leaf_cases", tests, NULL, NULL);
}
