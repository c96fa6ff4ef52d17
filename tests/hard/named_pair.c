/* named_pair.c - named cases 27 to 33: two spheres, by order and in scenes
 * SPDX-License-Identifier: Apache-2.0
 */
#include "named.h"

static struct hard_case pair(struct hard_case c, const int64_t ctr[3], int64_t rad) {
    c.n = 2;
    for (int i = 0; i < 3; i++)
        c.sphere[1].ctr[i] = ctr[i];
    c.sphere[1].rad = rad;
    return c;
}

/* Spheres around the point (0, 0, 0), which the ray meets first on both. */
void named_same_point(struct named *n) {
    int64_t k = n->half / 16;
    for (int64_t m = 1; m < n->most / 8; m *= 5) {
        struct hard_case c = vector(V3(-4 * k, -k, 0), V3(4 * m, m, 0), V3(3 * k, 4 * k, 0), 5 * k);
        expect_first(n, pair(c, V3(2 * k, 2 * k, k), 3 * k), -1);
        expect_first(n, pair(c, V3(2 * k, 2 * k, -k), 3 * k - 1), 0);
        expect_first(n, pair(c, V3(1, 0, 0), 1), -1);
        expect_first(n, pair(c, V3(1, 0, 0), 2), 1);
    }
}

/* Along an axis with |dir| = 1 the keys are whole grid units: 100.27 and 100.76 are both 101. */
void named_tie(struct named *n) {
    for (int64_t x = 0; x < n->half - 104; x = 3 * x + 1) {
        struct hard_case c = vector(V3(0, 0, 0), V3(1, 0, 0), V3(x + 102, 1, 0), 2);
        expect_first(n, pair(c, V3(x + 103, 2, 0), 3), -1);
    }
}

/* Far root of 100 and 3: sqrt(9991) = 99.95; near roots 99.27 (equal keys), 98.76 (first) and
 * 100.27 (behind, by the lowest bit of the key). */
void named_near_far(struct named *n) {
    struct hard_case c = vector(V3(0, 0, 0), V3(1, 0, 0), V3(0, 3, 0), 100);
    expect_first(n, pair(c, V3(101, 1, 0), 2), -1);
    expect_first(n, pair(c, V3(101, 2, 0), 3), 1);
    expect_first(n, pair(c, V3(102, 1, 0), 2), 0);
    for (int64_t r = 100; r < n->half - 4; r *= 3) {
        c = vector(V3(0, 0, 0), V3(1, 0, 0), V3(0, 1, 0), r);
        expect_first(n, pair(c, V3(r + 1, 2, 0), 3), 1);
        expect_first(n, pair(c, V3(r + 2, 1, 0), 2), 0);
    }
}

void named_concentric(struct named *n) {
    int64_t x = n->half / 2;
    for (int64_t r = 1; r < n->half / 4; r = 5 * r + 1) {
        const int64_t ctr[3] = {x, 1, 0};
        struct hard_case out = vector(V3(-x, 1, 0), V3(n->most, 0, 0), ctr, r);
        struct hard_case in = vector(ctr, V3(n->most, 1, 0), ctr, r);
        expect_first(n, pair(out, ctr, r + 1), 1);
        expect_first(n, pair(in, ctr, r + 1), 0);
        out.sphere[0].rad++;
        expect_first(n, pair(out, ctr, r), 0);
    }
    named_scene(n, "concentric");
}

void named_identical(struct named *n) {
    int64_t x = n->half / 2;
    const int64_t ctr[3] = {x, 1, 0};
    struct hard_case c = vector(V3(-x, 0, 0), V3(n->most, 0, 0), ctr, x / 2);
    expect_first(n, pair(c, ctr, x / 2), -1);
    named_scene(n, "identical");
}

void named_lens(struct named *n) {
    int64_t r = n->half / 4;
    for (int64_t apart = 1; apart < r; apart *= 2) {
        struct hard_case c = vector(V3(0, 0, 0), V3(n->most, 1, 0), V3(apart, 0, 0), r);
        expect_first(n, pair(c, V3(-apart, 0, 0), r), 1); /* leaves the one behind first */
        expect_first(n, pair(c, V3(2 * apart, 0, 0), r), 0);
        c = vector(V3(-4 * r + 1, 0, 0), V3(n->most, 0, 0), V3(apart, 0, 0), r);
        expect_first(n, pair(c, V3(-apart, 0, 0), r), 1);
    }
    named_scene(n, "lens");
}

void named_contact(struct named *n) {
    for (int64_t r = 1; r < n->half / 4; r = 3 * r + 1) {
        struct hard_case c = vector(V3(0, -n->half, 0), V3(0, n->most, 0), V3(r, 0, 0), r);
        expect_first(n, pair(c, V3(-r, 0, 0), r), -1); /* between both: two tangents, no hit */
        c = vector(V3(-r, 0, 0), V3(n->most, 0, 0), V3(-r, 0, 0), r);
        expect_first(n, pair(c, V3(r, 0, 0), r), -1); /* out of one into the other */
        c = vector(V3(-3 * r, 0, 0), V3(n->most, 0, 0), V3(-r, 0, 0), r);
        expect_first(n, pair(c, V3(r, 0, 0), r), 0);
    }
    named_scene(n, "contact");
}
