/* test_bih.c - bounds of planes against exact integers; the builder of a BIH against its rules
 * SPDX-License-Identifier: Apache-2.0
 */
#include "vectors.h"

#include <string.h>

#include "builder/tree/bih.h"
#include "trace/bih.h"

enum { W_TINY = 8, WD_TINY = 9 };
static const struct sph_profile tiny = {"tiny", W_TINY, WD_TINY, W_TINY, 0, W_TINY, 0};
static const struct sph_profile widest = {"widest", 24, 31, 31, 2, 14, 0};

static const struct sph_profile *profile(int i) {
    return i < SPH_PROFILES ? &sph_profiles[i] : i == SPH_PROFILES ? &tiny : &widest;
}

static struct sph_ray ray_of(int64_t x, int64_t y, int64_t z) {
    struct sph_ray ray = {.dir = {x, y, z}};
    ray.a = (uint64_t)(x * x + y * y + z * z);
    return ray;
}

/* One plane from both sides: what is left, and that a bound is on its side of a*v/|d| and near it.
 */
static void check(const struct sph_profile *p, const struct sph_ray *ray, int axis, int64_t clip) {
    struct sph_bih_ray b;
    sph_bih_setup(p, ray, &b);
    int64_t d = ray->dir[axis], v = clip - ray->org[axis], size = d < 0 ? -d : d;
    int keys = p->w + p->wd + 2, cut = keys > SPH_BIH_T ? keys - SPH_BIH_T : 0;
    for (int below = 0; below < 2; below++) {
        struct sph_interval s = {0, SPH_BIH_NO_BOUND};
        int left = sph_bih_cut(&b, ray, axis, clip, below, &s);
        if (!d) {
            assert_int_equal(left, below ? ray->org[axis] <= clip : ray->org[axis] >= clip);
            assert_true(s.lo == 0 && s.hi == SPH_BIH_NO_BOUND);
            continue;
        }
        int64_t far = d < 0 ? -v : v;
        int leaving = below == (d > 0);
        assert_int_equal(left, !leaving || far >= 0);
        if (!left || far <= 0) {
            assert_true(s.lo == 0 && (!left || leaving || s.hi == SPH_BIH_NO_BOUND));
            continue;
        }
        /* T = num / den */
        sph_u128 num = (sph_u128)ray->a * (uint64_t)far, den = (sph_u128)(uint64_t)size << cut;
        sph_u128 step = ((sph_u128)ray->a << b.v_shift) / den + 1; /* what v_shift may cost */
        if (leaving) {
            assert_int_equal(s.lo, 0);
            assert_true(s.hi == SPH_BIH_NO_BOUND || s.hi * den > num);
            if (b.axis[axis].shift >= 0)
                assert_true(s.hi <= num / den + (num / den >> 14) + step + 2);
            else
                assert_true(s.hi == SPH_BIH_NO_BOUND);
        } else {
            assert_true(s.hi == SPH_BIH_NO_BOUND && s.lo * den <= num);
            sph_u128 most = num / den < SPH_BIH_NO_BOUND ? num / den : SPH_BIH_NO_BOUND;
            if (b.axis[axis].shift >= 0) assert_true(s.lo + (s.lo >> 14) + step + 1 >= most);
        }
    }
}

static void every_small_bound(void **state) {
    (void)state;
    static const int others[][2] = {{0, 0}, {1, 0}, {0, -7}, {-256, 255}, {33, -129}};
    int step = VEC_SHARE == 1 ? 1 : 17;
    for (int o = 0; o < 5; o++)
        for (int d = -256; d < 256; d += step) {
            struct sph_ray ray = ray_of(others[o][0], d, others[o][1]);
            ray.org[1] = o * 61 - 128;
            for (int clip = -512; clip < 512; clip += 3)
                check(&tiny, &ray, 1, clip);
        }
}

static void random_bounds(void **state) {
    struct sph_rng rng = vec_seed("test_bih");
    (void)state;
    for (int i = 0; i < 600000 / VEC_SHARE; i++) {
        const struct sph_profile *p = profile(i % (SPH_PROFILES + 2));
        int64_t d[3];
        for (int j = 0; j < 3; j++)
            d[j] = vec_pick(&rng, 0, 5) ? vec_signed(&rng, p->wd) : 0;
        struct sph_ray ray = ray_of(d[0], d[1], d[2]);
        int axis = (int)vec_pick(&rng, 0, 2);
        ray.org[axis] = vec_signed(&rng, p->w);
        check(p, &ray, axis, vec_signed(&rng, p->w + 2));
    }
}

/* The words of keys and of the shadow ray's end. */
static void times(void **state) {
    struct sph_bih_ray b;
    struct sph_ray ray = ray_of(3, 4, 12);
    (void)state;
    sph_bih_setup(&sph_profiles[SPH_STANDARD], &ray, &b);
    assert_int_equal(b.t_shift, 13);
    assert_int_equal(b.limit, SPH_BIH_NO_BOUND);
    assert_int_equal(sph_bih_time(&b, (5ull << 13) + 8191), 5);
    assert_int_equal(sph_bih_time(&b, (1ull << 35) - 1), SPH_BIH_NO_BOUND);
    assert_int_equal(sph_bih_time(&b, 1ull << 62), SPH_BIH_NO_BOUND);
    ray = ray_of(20000, -7, 0);
    ray.kind = SPH_SHADOW;
    sph_bih_setup(&sph_profiles[SPH_STANDARD], &ray, &b);
    assert_int_equal(b.limit, ray.a >> 13);
}

/* Follows the nodes: planes around all boxes, each in one leaf, rules of leaves. */
struct visit {
    const struct sph_bih *bih;
    const struct sph_aabb *boxes;
    const struct sph_bih_options *options;
    uint32_t next; /* the leaves are in order */
    struct sph_bih_stats stats;
};

static void visit(struct visit *v, uint32_t index, struct sph_aabb space, uint32_t depth) {
    const struct sph_bih_node *n = &v->bih->nodes[index];
    assert_true(depth <= v->options->max_depth);
    if (n->axis == SPH_BIH_LEAF) {
        assert_true(n->count == 0 || n->first == v->next);
        for (uint32_t i = n->first; i < n->first + n->count; i++) {
            const struct sph_aabb *b = &v->boxes[v->bih->order[i]];
            for (int j = 0; j < 3; j++)
                assert_true(b->lo[j] >= space.lo[j] && b->hi[j] <= space.hi[j]);
        }
        v->next += n->count;
        sph_bih_count_leaf(&v->stats, n->count, depth);
        return;
    }
    struct sph_aabb l = space, r = space;
    assert_true(n->child % 2 == 0 && n->child > index && n->child < v->bih->n_nodes);
    v->stats.inner++;
    if (n->fit) {
        v->stats.optimized++;
        l.lo[n->axis] = n->clip_l, l.hi[n->axis] = n->clip_r;
        visit(v, n->child, l, depth + 1);
        return;
    }
    l.hi[n->axis] = n->clip_l, r.lo[n->axis] = n->clip_r;
    visit(v, n->child, l, depth + 1);
    visit(v, n->child + 1, r, depth + 1);
}

/* Builds and checks; the stats. */
static struct sph_bih_stats tree(const struct sph_aabb *boxes, uint32_t n, uint32_t max_prims,
                                 uint32_t max_depth, int how) {
    struct sph_bih_options o = {max_prims, max_depth, how, NULL, 0};
    struct sph_bih bih;
    struct sph_error err = {{0}};
    if (sph_bih_build(boxes, n, &o, &bih, &err)) fail_msg("%s", err.text);
    struct visit v = {.bih = &bih, .boxes = boxes, .options = &o};
    uint8_t *seen = calloc(n + 1u, 1);
    assert_non_null(seen);
    visit(&v, 0, bih.box, 1);
    for (uint32_t i = 0; i < n; i++)
        assert_true(bih.order[i] < n && !seen[bih.order[i]]++);
    assert_int_equal(v.next, n);
    if (how == SPH_BIH_LISTING) {
        assert_int_equal(v.stats.optimized, 0);
        v.stats.optimized = bih.stats.optimized;
        assert_int_equal(v.stats.inner, v.stats.leaves - 1);
    } else {
        assert_int_equal(v.stats.inner, v.stats.leaves - 1 + v.stats.optimized);
    }
    assert_memory_equal(&v.stats, &bih.stats, sizeof v.stats);
    sph_bih_free(&bih);
    free(seen);
    return v.stats;
}

enum { MOST = 4096 };
static struct sph_aabb list[MOST];

/* A cube of 2 reach + 1 around a point. */
static void cube(uint32_t i, int32_t x, int32_t y, int32_t z, int32_t reach) {
    list[i] =
        (struct sph_aabb){{x - reach, y - reach, z - reach}, {x + reach, y + reach, z + reach}};
}

static void random_trees(void **state) {
    struct sph_rng rng = vec_seed("test_bih");
    uint32_t optimized = 0, empty = 0;
    (void)state;
    for (int run = 0; run < 400 / VEC_SHARE; run++) {
        uint32_t n = (uint32_t)vec_pick(&rng, 0, run % 10 ? 60 : 700);
        int space = (int)vec_pick(&rng, 1, 23), reach = (int)vec_pick(&rng, 0, space);
        for (uint32_t i = 0; i < n; i++)
            for (int j = 0; j < 3; j++) {
                int64_t at = vec_pick(&rng, 0, 1) ? vec_signed(&rng, space + 1)
                                                  : vec_pick(&rng, 0, 1ll << space);
                list[i].lo[j] = (int32_t)at;
                list[i].hi[j] = (int32_t)(at + vec_pick(&rng, 0, 1ll << reach));
            }
        uint32_t prims = (uint32_t)vec_pick(&rng, 1, 9);
        struct sph_bih_stats s = tree(list, n, prims, SPH_BIH_STACK + 1, SPH_BIH_FULL);
        tree(list, n, prims, (uint32_t)vec_pick(&rng, 1, 12), SPH_BIH_FULL);
        tree(list, n, prims, SPH_BIH_STACK + 1, SPH_BIH_LISTING);
        optimized += s.optimized;
        empty += n ? s.bars[0] : 0;
    }
    assert_true(optimized > 100 / VEC_SHARE && empty > 10 / VEC_SHARE);
}

/* What must not go on for ever, and what is a leaf at once. */
static void ends(void **state) {
    (void)state;
    for (uint32_t i = 0; i < 100; i++)
        cube(i, 5, -7, 11, (int32_t)i);
    struct sph_bih_stats s = tree(list, 100, 1, SPH_BIH_STACK + 1, SPH_BIH_FULL);
    assert_int_equal(s.leaves - s.bars[0], 1);
    assert_int_equal(s.prims_max, 100);
    s = tree(list, 100, 1, SPH_BIH_STACK + 1, SPH_BIH_LISTING);
    assert_int_equal(s.leaves, 1);
    s = tree(list, 100, UINT32_MAX, SPH_BIH_STACK + 1, SPH_BIH_FULL);
    assert_true(s.leaves == 1 && s.inner == 0);
    s = tree(list, 0, 1, SPH_BIH_STACK + 1, SPH_BIH_FULL);
    assert_true(s.leaves == 1 && s.prims_max == 0);
    for (uint32_t i = 0; i < 24; i++) /* ever nearer to one corner: as deep as can be */
        for (uint32_t j = 0; j < 3; j++)
            cube(3 * i + j, j == 0 ? 1 << i : 0, j == 1 ? 1 << i : 0, j == 2 ? 1 << i : 0, 0);
    s = tree(list, 72, 1, SPH_BIH_STACK + 1, SPH_BIH_FULL);
    assert_true(s.depth_max > 30);
    s = tree(list, 72, 1, 9, SPH_BIH_FULL);
    assert_int_equal(s.depth_max, 9);
    assert_true(s.prims_max > 1);
}

/* Scenario 1 of Table 4.2: a lattice of 16^3 is cut in halves all the way. */
static void lattice(void **state) {
    (void)state;
    for (uint32_t i = 0; i < MOST; i++)
        cube(i, (int32_t)(i % 16) * 250, (int32_t)(i / 16 % 16) * 250, (int32_t)(i / 256) * 250,
             100);
    for (int how = SPH_BIH_FULL; how <= SPH_BIH_LISTING; how++) {
        struct sph_bih_stats s = tree(list, MOST, 1, SPH_BIH_STACK + 1, how);
        assert_true(s.inner == 4095 && s.leaves == 4096 && s.bars[1] == 4096 && !s.optimized);
        assert_true(s.depth_min == 13 && s.depth_max == 13);
        s = tree(list, MOST, 8, SPH_BIH_STACK + 1, how);
        assert_true(s.inner == 511 && s.leaves == 512 && s.prims_min == 8 && s.prims_max == 8);
        assert_true(s.depth_min == 10 && s.depth_max == 10 && !s.optimized);
        assert_int_equal(sph_bih_bytes(&s), 12 * 1023 + 4 * 4096 + 24);
    }
}

/* 1.3 times the reach is compared with the box exactly: 100 of 130 is not less, 99 is. */
static void refit(void **state) {
    (void)state;
    for (int32_t reach = 98; reach <= 101; reach++)
        for (int how = SPH_BIH_FULL; how <= SPH_BIH_LISTING; how++) {
            cube(0, 0, 0, 0, 0), cube(1, 0, reach, 0, 0);
            cube(2, 200, 0, 0, 0), cube(3, 200, 130, 0, 0);
            struct sph_bih_stats s = tree(list, 4, 1, SPH_BIH_STACK + 1, how);
            assert_int_equal(s.optimized, reach < 100);
            assert_int_equal(s.leaves, 4);
        }
}

static int told, told_last;

static int tell(void *user, int done, int all) {
    (void)user;
    assert_true(done > told_last && done <= all);
    told++;
    told_last = done;
    return 0;
}

/* 4096 primitives, one a leaf: told after each 1024. */
static void progress(void **state) {
    struct sph_progress to = {tell, NULL, 0, 1};
    struct sph_bih_options o = {1, SPH_BIH_STACK + 1, SPH_BIH_FULL, &to, 0};
    struct sph_error err = {{0}};
    struct sph_bih bih;
    (void)state;
    for (int i = 0; i < MOST; i++)
        cube((uint32_t)i, 4 * (i & 15), 4 * (i >> 4 & 15), 4 * (i >> 8), 1);
    assert_int_equal(sph_bih_build(list, MOST, &o, &bih, &err), 0);
    sph_bih_free(&bih);
    assert_int_equal(told, 4);
    assert_int_equal(told_last, SPH_PROGRESS_ALL);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_small_bound),
        cmocka_unit_test(random_bounds),
        cmocka_unit_test(times),
        cmocka_unit_test(random_trees),
        cmocka_unit_test(ends),
        cmocka_unit_test(lattice),
        cmocka_unit_test(refit),
        cmocka_unit_test(progress),
    };
    return cmocka_run_group_tests_name("bih", tests, NULL, NULL);
}
