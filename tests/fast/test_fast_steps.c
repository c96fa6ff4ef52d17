/* test_fast_steps.c - each step of the fast walk by itself against the literal one, random numbers
 * SPDX-License-Identifier: Apache-2.0
 */
#include "drawn.h"
#include "fast/decoded.h"
#include "fast/fast.h"
#include "fast/leaf.h"
#include "fast/prepare.h"
#include "fast/setup.h"
#include "math/arith.h"
#include "model_scene.h"
#include "prim/sphere.h"
#include "trace/setup.h"

enum { LANES = SPH_FAST_PLAIN + 1 };

static void check_root(sph_u128 x, int bits) {
    int inexact, expected;
    uint64_t root = sph_fast_isqrt_bits(x, bits, &inexact);
    assert_int_equal(root, sph_isqrt_bits(x, bits, &expected));
    assert_int_equal(inexact, expected);
}

/* Every small radicand; squares, what lies beside them and halfway, of every length. */
static void roots(void **state) {
    struct sph_rng rng = {seed()};
    (void)state;
    for (uint32_t x = 0; x < (SANITIZED ? 5000 : 300000); x++)
        check_root(x, (int)(x % 12));
    for (int length = 1; length <= 62; length++)
        for (uint64_t i = 0; i < (SANITIZED ? 30 : 2000); i++) {
            uint64_t most = (1ull << length) - 1;
            uint64_t root = i < 9 ? most - i : sph_rng_next(&rng) & most;
            if (i >= 9 && i < 18) root = (1ull << (length - 1)) + i - 9;
            if (root > most) continue;
            sph_u128 square = (sph_u128)root * root;
            int bits = i % 3 ? 0 : 4 + (int)(i % 48);
            check_root(square, bits);
            if (square) check_root(square - 1, bits);
            check_root(square + 1, bits);
            check_root(square + root, bits);
            check_root(square + 2 * root, bits);
        }
}

/* Spheres and rays of few bits, so that each comparison meets both sides equal. */
static void spheres(void **state) {
    struct sph_rng rng = {seed()};
    struct sph_machine m = {.profile = sph_profiles[SPH_DRAFT]};
    (void)state;
    for (int i = 0; i < (SANITIZED ? 20000 : 400000); i++) {
        struct sph_leaf s = {.rad = small(&rng, 2) + 3, .id = (uint32_t)small(&rng, 1) + 1};
        struct sph_ray ray = {.kind = (int)(sph_rng_next(&rng) >> 8 & 1),
                              .skip = {(uint32_t)small(&rng, 1) + 1, (int)small(&rng, 1) > 0},
                              .inside = (int)small(&rng, 1) >= 0};
        for (int k = 0; k < 3; k++) {
            s.ctr[k] = small(&rng, 3);
            ray.org[k] = small(&rng, 3);
            ray.dir[k] = small(&rng, 3);
            ray.a += (uint64_t)(ray.dir[k] * ray.dir[k]);
        }
        uint32_t record[SPH_LINE_WORDS] = {0}, errors = 0;
        for (int k = 0; k < 3; k++)
            sph_field_set(record, SPH_LEAF_CTR_X_LSB + k * SPH_LEAF_CTR_X_BITS, SPH_LEAF_CTR_X_BITS,
                          (uint32_t)s.ctr[k]);
        sph_field_set(record, SPH_LEAF_RAD_LSB, SPH_LEAF_RAD_BITS, (uint32_t)s.rad);
        sph_field_set(record, SPH_LEAF_ID_LSB, SPH_LEAF_ID_BITS, s.id);
        m.profile.pr = i % 5 ? 0 : 4;
        struct sph_counters c[2] = {{{0}}, {{0}}};
        struct sph_ray_query literal = sph_ray_query_of(&m, &ray, &c[0], &errors);
        struct sph_ray_query fast = sph_ray_query_of(&m, &ray, &c[1], &errors);
        struct sph_fast_leaf leaf = {
            {(int32_t)s.ctr[0], (int32_t)s.ctr[1], (int32_t)s.ctr[2]}, (int32_t)s.rad, s.id, 0};
        if (i & 1) literal.best = fast.best = (struct sph_hit){5, 1, 0, 0};
        sph_leaf_visit(&literal, record);
        sph_fast_leaf_visit(&fast, &leaf, record);
        assert_int_equal(fast.best.key, literal.best.key);
        assert_int_equal(fast.best.id, literal.best.id);
        assert_int_equal(fast.best.far, literal.best.far);
        assert_int_equal(c[1].count[SPH_COUNT_ROOTS], c[0].count[SPH_COUNT_ROOTS]);
    }
}

/* Triangles of the profiles whose products have room in 64 bits; half of the rays go to a corner
 * or the middle of an edge. */
static void triangles(void **state) {
    struct sph_rng rng = {seed()};
    struct sph_machine m = {.regs[SPH_REG_EFFECTS] = 1 << SPH_EFFECT_FACETS};
    static const int at[3] = {SPH_TRIANGLE_V0_X_LSB, SPH_TRIANGLE_V1_X_LSB, SPH_TRIANGLE_V2_X_LSB};
    int hits = 0;
    (void)state;
    assert_false(sph_fast_triangles_fit(&sph_profiles[SPH_REFERENCE]));
    for (int i = 0; i < (SANITIZED ? 30000 : 600000); i++) {
        const struct sph_profile *p = &sph_profiles[i % 3];
        int way = i / 3 % 3, far = way && i & 1;
        struct sph_ray ray = {.kind = (int)(sph_rng_next(&rng) >> 8 & 1),
                              .skip = {(uint32_t)small(&rng, 2) + 2, 0}};
        uint32_t record[SPH_LINE_WORDS] = {0}, errors = 0;
        assert_true(sph_fast_triangles_fit(p));
        m.profile = *p;
        int to = (int)((sph_rng_next(&rng) >> 9) % 3), aimed = i / 9 & 1;
        for (int k = 0; k < 3; k++) {
            int64_t most = (1ll << (p->wd - 1)) - 1, up = sph_rng_next(&rng) >> 9 & 1 ? 1 : -1;
            ray.org[k] = coordinate(&rng, p->w, way);
            ray.dir[k] = far ? up * most : way ? any(&rng, p->wd - 1) : small(&rng, 3);
            int64_t v[3];
            for (int c = 0; c < 3; c++) {
                v[c] = coordinate(&rng, p->w, way);
                sph_field_set(record, at[c] + k * SPH_LEAF_CTR_Y_LSB, SPH_LEAF_CTR_X_BITS,
                              (uint32_t)v[c]);
            }
            if (aimed) ray.dir[k] = (v[0] + v[to]) / 2 - ray.org[k];
            ray.lift[k] = small(&rng, 2);
            ray.a += (uint64_t)(ray.dir[k] * ray.dir[k]);
        }
        sph_field_set(record, SPH_FACET_KIND_LSB, SPH_FACET_KIND_BITS, SPH_TRIANGLE);
        sph_field_set(record, SPH_FACET_ID_LSB, SPH_FACET_ID_BITS, (uint32_t)small(&rng, 1) + 2);
        sph_field_set(record, SPH_FACET_BEFORE_LSB, SPH_FACET_BEFORE_BITS, (uint32_t)i & 1);
        sph_field_set(record, SPH_FACET_AFTER_LSB, SPH_FACET_AFTER_BITS, (uint32_t)i >> 1 & 1);
        struct sph_counters c[2] = {{{0}}, {{0}}};
        struct sph_ray_query literal = sph_ray_query_of(&m, &ray, &c[0], &errors);
        struct sph_ray_query fast = sph_ray_query_of(&m, &ray, &c[1], &errors);
        struct sph_fast_triangle triangle;
        if (i & 2) literal.best = fast.best = (struct sph_hit){5, 2, 0, 0};
        sph_fast_triangle_read(p, record, &triangle);
        assert_true(triangle.known);
        sph_leaf_visit(&literal, record);
        sph_fast_triangle_visit(&fast, &triangle);
        assert_int_equal(fast.best.key, literal.best.key);
        assert_int_equal(fast.best.id, literal.best.id);
        assert_int_equal(fast.best.far, literal.best.far);
        assert_memory_equal(&c[0], &c[1], sizeof *c);
        hits += literal.best.key && literal.best.key != 5;
    }
    printf("# %d hits of triangles\n", hits);
    assert_true(hits > 1000);
}

/* Set-up, point and normal of rays in widths of any kind: the same words. */
static void surfaces(void **state) {
    struct sph_rng rng = {seed()};
    int done = 0;
    (void)state;
    for (int i = 0; i < (SANITIZED ? 40000 : 600000); i++) {
        struct sph_profile p = sph_profiles[i % SPH_PROFILES];
        if (i % 3) {
            p.w = 8 + (int)(sph_rng_next(&rng) >> 8) % 9 + 8 * (i % 2);
            p.wd = p.w + 1 + (int)(sph_rng_next(&rng) >> 9 & 3);
            p.pq = 4 + (int)(sph_rng_next(&rng) >> 9 & 15) + 12 * (i % 2);
            p.ng = (int)(sph_rng_next(&rng) >> 9 & 3);
            p.fw = p.w < 14 ? p.w : 14;
        }
        if (sph_profile_check(&p, NULL)) continue;
        struct sph_ray a = {.kind = (int)(sph_rng_next(&rng) >> 9 & 3)}, b;
        struct sph_surface s, t;
        struct sph_leaf sphere;
        for (int k = 0; k < 3; k++) {
            a.org[k] = any(&rng, p.w - 1);
            a.dir[k] = any(&rng, p.wd - 1);
            sphere.ctr[k] = any(&rng, p.w - 1);
        }
        b = a;
        sph_ray_setup(&p, &a);
        sph_fast_prepare(&p, &b);
        assert_memory_equal(&a, &b, sizeof a);
        done++;
        struct sph_hit hit = {(uint64_t)any(&rng, p.w + p.wd + 1) | 1, 0, (i & 1) != 0, 0};
        hit.key = hit.key >> 63 ? -hit.key : hit.key;
        memset(&s, 0, sizeof s);
        memset(&t, 0, sizeof t);
        assert_int_equal(sph_fast_surface(&p, &b, &hit, sphere.ctr, &t),
                         sph_surface_at(&p, &a, &hit, &sphere, &s));
        assert_memory_equal(&s, &t, sizeof s);
    }
    assert_true(done > 10000);
}

/* Rays that are set up together, in widths of any kind, at the ends of their widths and, of a
 * damaged machine, beyond: the same words as one by one. */
static void together(void **state) {
    enum { MOST = 2 * SPH_TOGETHER + 3 };
    struct sph_rng rng = {seed()};
    struct sph_scene scene = model_scene("paper5");
    struct sph_machine m;
    struct sph_fast *fast[LANES];
    (void)state;
    assert_true(model_build(&scene, SPH_STANDARD, SPH_TREE_BALANCED, SPH_BG_NONE, 4, 4, &m));
    for (int lanes = 0; lanes < LANES; lanes++)
        assert_non_null(fast[lanes] = sph_fast_new(&m, lanes));
    for (int i = 0; i < (SANITIZED ? 4000 : 60000); i++) {
        struct sph_ray rays[1 + LANES][MOST];
        struct sph_profile p = sph_profiles[i % SPH_PROFILES];
        int n = 1 + (int)((sph_rng_next(&rng) >> 9) % MOST), wild = i % 7 == 0;
        if (i % 3 == 0) p.wd += (int)(sph_rng_next(&rng) >> 9 & 3);
        m.profile = p;
        for (int j = 0; j < n; j++) {
            struct sph_ray *a = memset(&rays[0][j], 0, sizeof *a);
            int64_t most = 1ll << (p.wd - 1);
            a->kind = (int)(sph_rng_next(&rng) >> 9 & 3);
            a->inside = (int)(sph_rng_next(&rng) >> 9 & 1);
            a->first = (int)(sph_rng_next(&rng) >> 9 & 1);
            for (int k = 0; k < 3; k++) {
                int way = (int)(sph_rng_next(&rng) >> 9 & 7);
                a->org[k] = coordinate(&rng, p.w, way % 3);
                a->dir[k] = way == 0   ? -most
                            : way == 1 ? most - 1
                            : way == 2 ? a->dir[0]
                            : way == 3 ? small(&rng, 1)
                                       : any(&rng, p.wd - 1);
                a->lift[k] = small(&rng, 100);
            }
            if (wild && small(&rng, 8) == 0) a->dir[(i >> 3) % 3] = most + small(&rng, 9) / 3;
            if (wild && small(&rng, 8) == 0) a->dir[j % 3] = any(&rng, 32);
            if (wild && small(&rng, 8) == 0) a->org[(i >> 3) % 3] = any(&rng, 31);
        }
        for (int lanes = 0; lanes < LANES; lanes++) {
            memcpy(rays[1 + lanes], rays[0], sizeof rays[0]);
            sph_fast_prepare_all(fast[lanes], rays[1 + lanes], n);
        }
        for (int j = 0; j < n; j++) {
            sph_ray_setup(&p, &rays[0][j]);
            for (int lanes = 0; lanes < LANES; lanes++)
                assert_memory_equal(&rays[1 + lanes][j], &rays[0][j], sizeof rays[0][j]);
        }
    }
    for (int lanes = 0; lanes < LANES; lanes++)
        sph_fast_free(fast[lanes]);
    sph_machine_free(&m);
    sph_scene_free(&scene);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(roots), cmocka_unit_test(spheres),
                                       cmocka_unit_test(triangles), cmocka_unit_test(surfaces),
                                       cmocka_unit_test(together)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
