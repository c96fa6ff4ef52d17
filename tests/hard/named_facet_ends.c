/* named_facet_ends.c - named cases 55 to 61: where a facet, the world or the numbers end
 * SPDX-License-Identifier: Apache-2.0
 */
#include "facet.h"

void named_facet_light(struct named *n) {
    int64_t k = n->half / 2;
    for (int64_t y = 0; y < k; y = 5 * y + 1)
        for (int64_t x = k - 1; x <= k + 1; x++) {
            struct hard_facet c = wall(V3(0, 0, 0), V3(x, y, 0), k, k, k);
            c.ray.kind = SPH_SHADOW;
            expect_facet(n, c, x > k && y < k ? NEAR : MISS, 0);
            c = plane(V3(0, 0, 0), V3(x, y, 0), V3(k, 0, 0), V3(3, 0, 0));
            c.ray.kind = SPH_SHADOW;
            expect_facet(n, c, x > k ? FAR : MISS, 0);
            c.ray.dir[0] = -x; /* the light is on the other side */
            expect_facet(n, c, MISS, 0);
        }
}

void named_facet_ties(struct named *n) {
    int64_t k = n->half / 4;
    for (int64_t x = 4; x < k; x = x * 3 + 1) {
        /* spheres whose near root is x, x - 0.27, x + 0.27; facets at x and at x - 0.5 */
        struct hard_facet c = wall(V3(0, 0, 0), V3(1, 0, 0), x, k, k);
        struct sph_leaf s = {{x + 2, 0, 0}, 2, 0}, before = {{x + 1, 1, 0}, 2, 0};
        struct sph_leaf after = {{x + 2, 1, 0}, 2, 0};
        expect_first_sphere(n, c, &s, -1);
        expect_first_sphere(n, c, &before, -1);
        expect_first_sphere(n, c, &after, 1);
        s.ctr[0]++;
        expect_first_sphere(n, c, &s, 1);
        s.ctr[0] -= 2;
        expect_first_sphere(n, c, &s, 0);
        struct hard_facet slant =
            triangle(c.ray.org, c.ray.dir, V3(x, -2, -2), V3(x - 1, 2, 2), V3(x, -4, 4));
        struct sph_facet_leaf other = slant.facet;
        expect_first_facet(n, c, &other, -1); /* x - 1/2 */
        other.v[0][0]--;
        expect_first_facet(n, c, &other, 1);
    }
}

/* x / by of positive numbers, rounded up. */
static int64_t up(int64_t x, int64_t by) {
    return (x + by - 1) / by;
}

void named_facet_horizon(struct named *n) {
    int64_t h = n->half, y = h / 3;
    for (int64_t end = -h; end < h; end += 2 * h - 1) /* the faces x = -2^(W-1), 2^(W-1)-1 */
        for (int64_t m = 1; m < 4; m++) {
            const int64_t org[3] = {h - 1 + end < 0 ? h / 2 : -h / 2, 0, 5};
            struct hard_facet c = plane(org, V3(end - org[0], y, 0), V3(0, y, 0), V3(0, -m, 0));
            expect_facet(n, c, NEAR, 0); /* on the face itself: t = 1 */
            c.ray.dir[0] += end < 0 ? 1 : -1;
            expect_facet(n, c, NEAR, 0);
            c.ray.dir[0] += end < 0 ? -2 : 2; /* a unit beyond the face: t = 1 still */
            expect_facet(n, c, NEAR, key_at(c.ray.dir, 1, 1));
            int64_t size = c.ray.dir[0] < 0 ? -c.ray.dir[0] : c.ray.dir[0], room = size;
            for (int more = 1; more < 4; more++) { /* farther: to there, and what is left of dir */
                c.ray.dir[0] += end < 0 ? -1 : 1;
                uint64_t key = key_at(c.ray.dir, room, size + more) + (uint64_t)more;
                expect_facet(n, c, NEAR, key);
            }
            c.ray.dir[0] += end < 0 ? 4 : -4;
            c.ray.dir[1]++; /* a little steeper: before the face */
            expect_facet(n, c, NEAR, 0);
            c.ray.dir[1] = 1; /* hardly towards it: far beyond */
            uint64_t key = key_at(c.ray.dir, room, size - 1) + (uint64_t)(size - 1 - up(room, y));
            expect_facet(n, c, NEAR, key);
            c.ray.dir[1] = 0;
            expect_facet(n, c, MISS, 0);
            c = plane(org, V3(end - org[0], 0, 0), V3(end, y, 0), V3(m, 0, 0)); /* the face */
            expect_facet(n, c, end < 0 ? NEAR : FAR, 0);
            c.facet.v[1][1] = m; /* leaves the box before it is met, from beside the edge */
            expect_facet(n, c, ORACLE, 0);
        }
    for (int i = 0; i < 27; i++) { /* ties of the longest axis, from beside each face */
        const int64_t s[3] = {i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1}, k = n->half / 2;
        const int64_t org[3] = {h - 1, -h, s[0]}, dir[3] = {s[0] * k, s[1] * k, s[2] * k};
        expect_facet(n, plane(org, dir, V3(0, 0, 0), V3(7, -5, 3)), ORACLE, 0);
        expect_facet(n, plane(org, V3(dir[0], dir[1] + 1, dir[2]), V3(0, 0, 1), V3(-9, 1, 2)),
                     ORACLE, 0);
    }
    /* a ray to the corner of the box */
    struct hard_facet c = plane(V3(0, 0, 0), V3(h - 1, h - 1, h - 1), V3(h - 1, 0, 0), V3(9, 0, 0));
    expect_facet(n, c, FAR, 3 * (uint64_t)((h - 1) * (h - 1)));
    c.ray.dir[0]--; /* the face y is first, a unit beyond */
    expect_facet(n, c, FAR, key_at(c.ray.dir, h, h - 1));
}

void named_facet_grazing(struct named *n) {
    int64_t h = n->half, m = 2 * h - 1;
    struct hard_facet c =
        triangle(V3(-h, 1, 0), V3(m, -1, 0), V3(-h, 0, -h), V3(-h, 0, h - 1), V3(h - 1, 0, 0));
    expect_facet(n, c, NEAR, key_at(c.ray.dir, 1, 1)); /* the far corner, at the end of the world */
    c.ray.dir[0] = m + (n->most > m);
    expect_facet(n, c, ORACLE, 0);
    for (int64_t y = 0; y < 4; y++)
        for (int64_t dy = -3; dy <= 3; dy++) {
            c.ray.org[1] = y;
            c.ray.dir[0] = n->most;
            c.ray.dir[1] = dy;
            expect_facet(n, c, y && dy < 0 && y * n->most <= -dy * m ? NEAR : MISS, 0);
            struct hard_facet p = plane(c.ray.org, c.ray.dir, V3(0, 0, 0), V3(0, 8388607, 0));
            int towards = y && dy<0, beyond = y * n->most> - dy * (m + 1);
            uint64_t key = 0;
            if (towards && beyond)
                key =
                    key_at(c.ray.dir, m + 1, n->most) + (uint64_t)(n->most - up(-dy * (m + 1), y));
            expect_facet(n, p, towards ? NEAR : MISS, key);
        }
}

void named_facet_ends(struct named *n) {
    int64_t h = n->half, e[2] = {-h, h - 1}, d[3] = {-n->most - 1, 0, n->most};
    for (int i = 0; i < 8; i++) { /* the greatest volumes: corners of the world, the four others */
        const int64_t o[3] = {e[i & 1], e[i >> 1 & 1], e[i >> 2]};
        const int64_t x = e[~i & 1], y = e[~i >> 1 & 1], z = e[~i >> 2 & 1];
        for (int k = 0; k < 27; k++) {
            const int64_t dir[3] = {d[k % 3], d[k / 3 % 3], d[k / 9]};
            expect_facet(n, triangle(o, dir, V3(x, y, o[2]), V3(x, o[1], z), V3(o[0], y, z)),
                         ORACLE, 0);
            expect_facet(n, triangle(o, dir, V3(x, y, z), V3(x, o[1], o[2]), V3(o[0], y, o[2])),
                         ORACLE, 0);
            for (int s = -1; s < 2; s++)
                expect_facet(n, plane(o, dir, V3(x, y, z), V3(8388607, s * 8388607, -8388608)),
                             ORACLE, 0);
        }
    }
}

void named_facet_sliver(struct named *n) {
    int64_t k = n->half / 2, m = n->most;
    for (int64_t y = -2; y < 3; y++)
        for (int64_t z = 0; z <= m / 2; z = z * 4 + 3) {
            struct hard_facet c =
                triangle(V3(0, 0, 0), V3(m, y, z), V3(k, 0, 0), V3(k, 1, 0), V3(k, 0, n->half - 1));
            expect_facet(n, c, ORACLE, 0);
            c.facet.v[1][1] = 0; /* no area: what no machine has */
            expect_facet(n, c, MISS, 0);
            c.facet.v[2][2] = 0;
            expect_facet(n, c, MISS, 0);
        }
}

void named_facet_dir0(struct named *n) {
    for (int64_t x = -1; x < 2; x++)
        for (int kind = 0; kind < 2; kind++) {
            struct hard_facet c = wall(V3(x, 0, 0), V3(0, 0, 0), 0, 9, 9);
            c.ray.kind = kind ? SPH_SHADOW : SPH_PRIMARY;
            expect_facet(n, c, MISS, 0);
            c = plane(V3(x, 0, 0), V3(0, 0, 0), V3(0, 0, 0), V3(1, 0, 0));
            c.ray.kind = kind ? SPH_SHADOW : SPH_PRIMARY;
            expect_facet(n, c, MISS, 0);
        }
}
