/* test_tree_better.c - trees by agglomeration and reinsertion: whole, cheaper, the same for all
 * threads SPDX-License-Identifier: Apache-2.0
 *
 * build/test/test_tree_better [seed].
 */
#include "build_scene.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "builder/tree/split.h"
#include "common/parallel.h"

#ifdef __SANITIZE_ADDRESS__
enum { MOST = 1100, SLOW = 300 };
#else
enum { MOST = 9000, SLOW = 8000 }; /* more than are joined from the leaves upwards; fewer */
#endif

static const struct sph_profile *const profile = &sph_profiles[SPH_REFERENCE];

static struct sph_split better(const struct sph_ball *balls, uint32_t n, int threads) {
    struct sph_split split;
    struct sph_error err;
    int before = sph_parallel_most(threads);
    assert_int_equal(sph_split(balls, NULL, n, 64, NULL, &split, &err), 0);
    assert_int_equal(sph_split_better(balls, NULL, n, profile, NULL, &split, &err), 0);
    sph_parallel_most(before);
    return split;
}

/* Whether a child stands for the spheres from `first` on; how many. */
static uint32_t check_child(const struct sph_split *split, uint32_t child, uint32_t first) {
    if (child & SPH_PAIR_LEAF) {
        assert_int_equal(split->order[first], child & ~SPH_PAIR_LEAF);
        return 1;
    }
    assert_in_range(child, 1, split->n_pairs - 1);
    assert_int_equal(split->pairs[child].first, first);
    return split->pairs[child].count;
}

/* Every sphere has one place, and the children of a pair share its places. */
static void check(const struct sph_split *split, uint32_t n) {
    uint8_t *seen = calloc(n, 1);
    assert_int_equal(split->n_pairs, n - 1);
    assert_int_equal(split->pairs[0].first, 0);
    assert_int_equal(split->pairs[0].count, n);
    for (uint32_t i = 0; i < n - 1; i++) {
        const struct sph_pair *p = &split->pairs[i];
        uint32_t left = check_child(split, p->child[0], p->first);
        assert_int_equal(left + check_child(split, p->child[1], p->first + left), p->count);
    }
    for (uint32_t i = 0; i < n; i++) {
        assert_in_range(split->order[i], 0, n - 1);
        assert_false(seen[split->order[i]]++);
    }
    free(seen);
}

static void clouds(void **unused) {
    static const uint32_t sizes[] = {2, 3, 4, 5, 7, 33, 100, 1000, 1024, 1025, 3000, MOST};
    static struct sph_ball balls[MOST];
    (void)unused;
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        uint32_t n = sizes[i];
        if (n > MOST) continue;
        for (uint32_t j = 0; j < n; j++) {
            for (int k = 0; k < 3; k++)
                balls[j].c[k] = (int32_t)between(-8e6, 8e6);
            balls[j].r = (int32_t)between(1e3, 3e5);
        }
        struct sph_split plain, one = better(balls, n, 1), three = better(balls, n, 3);
        struct sph_error err;
        assert_int_equal(sph_split(balls, NULL, n, 64, NULL, &plain, &err), 0);
        sph_split_fill(balls, NULL, profile, &plain);
        printf("# %u spheres: %.4f of the splits' cost\n", n,
               (double)(one.pairs[0].cost[1] / plain.pairs[0].cost[1]));
        check(&one, n);
        assert_true(one.pairs[0].cost[1] <= plain.pairs[0].cost[1]);
        assert_true(n < 1000 || one.pairs[0].cost[1] < 0.9999f * plain.pairs[0].cost[1]);
        assert_memory_equal(one.pairs, three.pairs, one.n_pairs * sizeof *one.pairs);
        assert_memory_equal(one.order, three.order, n * sizeof *one.order);
        sph_split_free(&plain);
        sph_split_free(&one);
        sph_split_free(&three);
    }
}

/* All in one point; all at the same distance; each farther away than all before are from each
 * other, so that one pair joins in a round. */
static void slow(void **unused) {
    enum { N = SLOW };
    static struct sph_ball balls[3][N];
    (void)unused;
    double at = 1;
    for (uint32_t i = 0; i < N; i++, at = at * (1 + 12.0 / N) + 1) {
        balls[0][i] = (struct sph_ball){{5, 6, 7}, 9};
        balls[1][i] = (struct sph_ball){
            {(int32_t)(i % 20) * 64, (int32_t)(i / 20 % 20) * 64, (int32_t)(i / 400) * 64}, 32};
        balls[2][i] = (struct sph_ball){{(int32_t)at, 0, 0}, 1};
    }
    for (int i = 0; i < 3; i++) {
        struct sph_split split = better(balls[i], N, 2);
        check(&split, N);
        sph_split_free(&split);
    }
}

/* Three spheres apart and a like scene of half the size between them, and so on: it is cheapest to
 * open the three in their node, one level of nodes for each size, which is too deep. */
static void deep(void **unused) {
    enum { SIZES = 22, N = 3 * SIZES };
    static const int32_t eye[3];
    static struct sph_ball balls[N];
    (void)unused;
    for (int i = 0; i < N; i++) {
        balls[i].c[i % 3] = 1 << (22 - i / 3);
        balls[i].r = balls[i].c[i % 3] / 64 + 1;
    }
    for (uint32_t above = 0; above <= 4; above += 2) {
        struct sph_tree tree = {.above = above};
        struct sph_error err;
        struct sph_split split = better(balls, N, 1);
        double sum = 0, unit = ldexp(1, profile->w - profile->fw);
        assert_int_equal(
            sph_tree_balanced(balls, NULL, N, profile, eye, SPH_TREE_REINSERTED, &tree, &err), 0);
        for (uint32_t i = 0; i < tree.n_nodes; i++)
            sum += pow(tree.nodes[i].ball.r * unit, 2) / (double)split.pairs[0].cost[1];
        printf("# %u levels below %u: %.4f of the cost without a limit\n", tree.depth, above, sum);
        assert_int_equal(tree.depth, SPH_STACK_DEPTH - above);
        assert_true(sum < 1.01);
        sph_split_free(&split);
        free(tree.nodes);
    }
}

/* Costs of boxes: those of splits are above those of what is reinserted in them. */
static void boxes(void **unused) {
    enum { N = 500 };
    static struct sph_ball balls[N];
    static struct sph_aabb own[N];
    struct sph_split split;
    struct sph_error err;
    (void)unused;
    for (int i = 0; i < N; i++) {
        for (int k = 0; k < 3; k++) {
            balls[i].c[k] = (int32_t)between(-8e6, 8e6);
            own[i].lo[k] = balls[i].c[k] - (int32_t)between(0, 3e5);
            own[i].hi[k] = balls[i].c[k] + (int32_t)between(0, 3e5);
        }
        balls[i].r = 600000;
    }
    assert_int_equal(sph_split(balls, own, N, 64, NULL, &split, &err), 0);
    sph_split_fill(balls, own, profile, &split);
    float before = split.pairs[0].cost[1];
    assert_int_equal(sph_split_better(balls, own, N, profile, NULL, &split, &err), 0);
    check(&split, N);
    printf("# %d boxes: %.4f of the splits' cost\n", N, (double)(split.pairs[0].cost[1] / before));
    assert_true(split.pairs[0].cost[1] < before && split.pairs[0].cost[1] > before / 2);
    sph_split_free(&split);
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(clouds), cmocka_unit_test(slow),
                                       cmocka_unit_test(deep), cmocka_unit_test(boxes)};
    seed(argc, argv);
    return cmocka_run_group_tests_name("better trees", tests, NULL, NULL);
}
