/* test_facet.c - the exact test of ray and facet: every operand of two bits, and what it is for
 * SPDX-License-Identifier: Apache-2.0
 *
 * The oracle of the small operands walks along the ray until the side of the plane changes, and
 * looks for the point among the corners as they are seen along one axis.
 */
#include "vectors.h"

#include "naive/naive.h"
#include "prim/facet.h"

enum { OWN = 7, NAIVE = 997 }; /* id of every tested facet; one in so many in GMP as well */

static const struct sph_profile two_bits = {"two bits", 2, 2, 2, 0, 2, 0};

static int sign(int64_t x) {
    return (x > 0) - (x < 0);
}

/* Side of the point org + at/of * dir (org = 0): N.(at*dir - of*v0), N by Sarrus' rule. */
static int64_t side(const int64_t v[3][3], const int64_t dir[3], int64_t at, int64_t of) {
    int64_t p[3][3], sum = 0;
    for (int i = 0; i < 3; i++) {
        p[0][i] = at * dir[i] - of * v[0][i];
        p[1][i] = v[1][i] - v[0][i];
        p[2][i] = v[2][i] - v[0][i];
    }
    for (int i = 0; i < 3; i++)
        sum += p[0][i] * p[1][(i + 1) % 3] * p[2][(i + 2) % 3] -
               p[2][i] * p[1][(i + 1) % 3] * p[0][(i + 2) % 3];
    return sum;
}

/* Whether at/of * dir, a point of the triangle's plane, is one of the triangle: along an axis that
 * shows the triangle's face it turns the same way about all three edges. */
static int seen_within(const int64_t v[3][3], const int64_t dir[3], int64_t at, int64_t of) {
    for (int axis = 0; axis < 3; axis++) {
        int x = (axis + 1) % 3, y = (axis + 2) % 3, turns[3];
        int64_t face =
            (v[1][x] - v[0][x]) * (v[2][y] - v[0][y]) - (v[1][y] - v[0][y]) * (v[2][x] - v[0][x]);
        if (!face) continue;
        for (int i = 0; i < 3; i++) {
            const int64_t *p = v[i], *q = v[(i + 1) % 3];
            turns[i] = sign(of) * sign((q[x] - p[x]) * (at * dir[y] - of * p[y]) -
                                       (q[y] - p[y]) * (at * dir[x] - of * p[x]));
        }
        int left = turns[0] >= 0 && turns[1] >= 0 && turns[2] >= 0;
        int right = turns[0] <= 0 && turns[1] <= 0 && turns[2] <= 0;
        return left || right;
    }
    return 0;
}

/* The second model says the same of a ray that hits or not, with a key or to a light. */
static void check_naive(const struct sph_ray *ray, const struct sph_facet_leaf *f, int hit, int far,
                        uint64_t key) {
    struct sph_naive_leaf n = sph_naive_facet(&two_bits, ray, f);
    assert_true(n.hit == hit && n.key == (ray->kind == SPH_SHADOW ? 0 : key));
    assert_true(!hit || n.far == far);
}

/* One of the 27 ways in which an origin may have been rounded without guard bits. */
static void lift_of(uint64_t n, int64_t lift[3]) {
    for (int i = 0; i < 3; i++, n /= 3)
        lift[i] = (int64_t)(n % 3) - 1;
}

/* Triangle v (relative to the origin) against the ray dir; returns hits. */
static int check_small(const int64_t v[3][3], const int64_t dir[3], uint64_t number) {
    struct sph_ray ray = {.skip = {SPH_ID_NONE, 0}};
    struct sph_facet_leaf f = {.kind = SPH_TRIANGLE, .id = OWN};
    int naive = number % NAIVE == 0;
    int64_t a = 0, key = 0, before = side(v, dir, 0, 1), past = side(v, dir, 1, 1) - before;
    for (int i = 0; i < 3; i++) {
        ray.dir[i] = dir[i];
        a += dir[i] * dir[i];
        for (int j = 0; j < 3; j++)
            f.v[i][j] = v[i][j];
    }
    ray.a = (uint64_t)a;
    int hit = before && past && seen_within(v, dir, -before, past);
    while (hit && sign(side(v, dir, key, a)) == sign(before))
        if (key++ > 64) hit = 0; /* it lies behind the origin */
    int shadow = hit && sign(side(v, dir, 1, 1)) == -sign(before);
    lift_of(number, ray.lift);
    for (int c = 0; c < 8 && shadow; c++) { /* the cube that the ray comes from */
        const int64_t at[3] = {(c & 1 ? 1 : -1) - ray.lift[0], (c & 2 ? 1 : -1) - ray.lift[1],
                               (c & 4 ? 1 : -1) - ray.lift[2]};
        shadow = sign(side(v, at, 1, 1)) == sign(before);
    }

    uint64_t divisions = 0, got = 0;
    struct sph_facet_result r = sph_facet_test(&two_bits, &ray, &f);
    if (r.hit) got = sph_facet_key(&ray, &r, &divisions);
    if (naive) check_naive(&ray, &f, hit, r.far, hit ? (uint64_t)key : 0);
    ray.kind = SPH_SHADOW;
    int got_shadow = sph_facet_test(&two_bits, &ray, &f).hit;
    if (naive) check_naive(&ray, &f, shadow, r.far, 0);
    if (r.hit != hit || got_shadow != shadow || (hit && got != (uint64_t)key) ||
        divisions != (uint64_t)hit || r.far != (past > 0))
        fail_msg("(%ld %ld %ld) (%ld %ld %ld) (%ld %ld %ld) dir (%ld %ld %ld): hit %d shadow %d "
                 "key %lu far %d, expected %d %d %ld %d",
                 v[0][0], v[0][1], v[0][2], v[1][0], v[1][1], v[1][2], v[2][0], v[2][1], v[2][2],
                 dir[0], dir[1], dir[2], r.hit, got_shadow, got, r.far, hit, shadow, key, past > 0);
    return hit;
}

/* Digit `at` of n in base `base`, from low on. */
static int64_t digit(uint64_t n, int at, uint64_t base, int64_t low) {
    while (at--)
        n /= base;
    return low + (int64_t)(n % base);
}

/* Every triangle and direction of two bits, the origin at 0: the test knows differences alone. */
static void exhaustive(void **state) {
    (void)state;
    uint64_t hits = 0, n = 0;
    for (uint64_t corners = 0; corners < 1u << 18; corners += VEC_SHARE) {
        int64_t v[3][3];
        for (int i = 0; i < 9; i++)
            v[i / 3][i % 3] = digit(corners, i, 4, -2);
        for (uint64_t d = 0; d < 64; d++, n++) {
            int64_t dir[3] = {digit(d, 0, 4, -2), digit(d, 1, 4, -2), digit(d, 2, 4, -2)};
            hits += (uint64_t)check_small((const int64_t(*)[3])v, dir, n);
        }
    }
    printf("# %lu triangles and rays, %lu hits\n", n, hits);
    assert_true(hits > n / 20);
}

/* Plane through p with normal n: hit if the side changes, or ends with the world along the longest
 * axis: at -3 or 2. */
static int check_plane(const int64_t org[3], const int64_t dir[3], const int64_t p[3],
                       const int64_t n[3], uint64_t number) {
    struct sph_ray ray = {.skip = {SPH_ID_NONE, 0}};
    struct sph_facet_leaf f = {.kind = SPH_PLANE, .id = OWN};
    int naive = number % NAIVE == 0;
    int64_t start = 0, step = 0, a = 0, key = 0; /* at t the side is that of start + t * step */
    for (int i = 0; i < 3; i++) {
        ray.org[i] = org[i], ray.dir[i] = dir[i];
        f.v[0][i] = p[i], f.v[1][i] = n[i];
        start += n[i] * (org[i] - p[i]);
        step += n[i] * dir[i];
        a += dir[i] * dir[i];
    }
    ray.a = (uint64_t)a;
    int hit = start && sign(step) == -sign(start), longest = 0;
    for (int i = 1; i < 3; i++)
        if (labs(dir[i]) > labs(dir[longest])) longest = i;
    int64_t room = labs((dir[longest] > 0 ? 2 : -3) - org[longest]);
    while (hit && key * labs(dir[longest]) < a * room &&
           sign(start * a + key * step) == sign(start))
        key++;
    int64_t past =
        labs(start) * labs(dir[longest]) - labs(step) * room; /* the way beyond the face */
    if (hit && past > 0) key += past / labs(start);
    int shadow = hit && sign(start + step) == sign(step);
    lift_of(number, ray.lift);
    for (int c = 0; c < 8 && shadow; c++) {
        int64_t at = start;
        for (int i = 0; i < 3; i++)
            at += n[i] * ((c >> i & 1 ? 1 : -1) - ray.lift[i]);
        shadow = sign(at) == sign(start);
    }

    uint64_t divisions = 0, got = 0;
    struct sph_facet_result r = sph_facet_test(&two_bits, &ray, &f);
    if (r.hit) got = sph_facet_key(&ray, &r, &divisions);
    if (naive) check_naive(&ray, &f, hit, r.far, hit ? (uint64_t)key : 0);
    ray.kind = SPH_SHADOW;
    int got_shadow = sph_facet_test(&two_bits, &ray, &f).hit;
    if (naive) check_naive(&ray, &f, shadow, r.far, 0);
    if (r.hit != hit || got_shadow != shadow || got != (uint64_t)key || r.far != (step > 0))
        fail_msg("org (%ld %ld %ld) dir (%ld %ld %ld) plane (%ld %ld %ld) normal (%ld %ld %ld): "
                 "hit %d shadow %d key %lu far %d, expected %d %d %ld %d",
                 org[0], org[1], org[2], dir[0], dir[1], dir[2], p[0], p[1], p[2], n[0], n[1], n[2],
                 r.hit, got_shadow, got, r.far, hit, shadow, key, step > 0);
    return hit;
}

/* Every origin, direction and point of two bits, normals of -1, 0, 1. */
static void exhaustive_planes(void **state) {
    (void)state;
    uint64_t hits = 0, n = 0;
    for (uint64_t c = 0; c < 27u << 18; c += VEC_SHARE, n++) {
        int64_t v[3][3], normal[3];
        for (int i = 0; i < 9; i++)
            v[i / 3][i % 3] = (int64_t)(c >> 2 * i & 3) - 2;
        for (int i = 0; i < 3; i++)
            normal[i] = digit(c >> 18, i, 3, -1);
        hits += (uint64_t)check_plane(v[0], v[1], v[2], normal, n);
    }
    printf("# %lu planes and rays, %lu hits\n", n, hits);
    assert_true(hits > n / 20);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exhaustive),
        cmocka_unit_test(exhaustive_planes),
    };
    return cmocka_run_group_tests_name("facet", tests, NULL, NULL);
}
