/* test_tree_better.c - trees by agglomeration and reinsertion: whole, cheaper, the same for all
 * threads SPDX-License-Identifier: Apache-2.0
 *
 * build/test/test_tree_better [seed].
 */
#include "build_scene.h"

#include <omp.h>
#include <stdlib.h>
#include <string.h>

#include "builder/tree_better.h"

#ifdef __SANITIZE_ADDRESS__
enum { MOST = 1100, SLOW = 300 };
#else
enum { MOST = 9000, SLOW = 8000 }; /* more than are joined from the leaves upwards; fewer */
#endif

static const struct sph_profile *const profile = &sph_profiles[SPH_REFERENCE];

static struct sph_split better(const struct sph_ball *balls, uint32_t n, int threads) {
    struct sph_split split;
    struct sph_error err;
    int before = omp_get_max_threads();
    omp_set_num_threads(threads);
    assert_int_equal(sph_split(balls, NULL, n, 64, &split, &err), 0);
    assert_int_equal(sph_split_better(balls, NULL, n, profile, &split, &err), 0);
    omp_set_num_threads(before);
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
        assert_int_equal(sph_split(balls, NULL, n, 64, &plain, &err), 0);
        sph_split_fill(balls, profile, &plain);
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

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(clouds), cmocka_unit_test(slow)};
    seed(argc, argv);
    return cmocka_run_group_tests_name("better trees", tests, NULL, NULL);
}
