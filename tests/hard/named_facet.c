/* named_facet.c - named cases 48 to 54, 81: triangles and planes
 * SPDX-License-Identifier: Apache-2.0
 */
#include "facet.h"

void named_facet_edge_on(struct named *n) {
    int64_t k = n->half / 4, m = n->most;
    for (int64_t y = 0; y < k; y = 3 * y + 1) { /* crosses the triangle z = 1 in its plane */
        struct hard_facet c =
            triangle(V3(-k, y, 1), V3(m, 0, 0), V3(0, 0, 1), V3(k, 0, 1), V3(0, k, 1));
        expect_facet(n, c, MISS, 0);
        c.ray.org[0] = y / 2; /* from inside it */
        expect_facet(n, c, MISS, 0);
        c.ray.kind = SPH_SHADOW;
        expect_facet(n, c, MISS, 0);
        expect_facet(n, plane(V3(-k, y, 1), V3(m, 1, 0), V3(0, 0, 1), V3(0, 0, 1)), MISS, 0);
        expect_facet(n, plane(V3(-k, y, 2), V3(m, 1, 0), V3(0, 0, 1), V3(0, 0, 1)), MISS, 0);
        /* x + y + z = k */
        c = triangle(V3(2 * k, -k, 0), V3(-m, m, 0), V3(k, 0, 0), V3(0, k, 0), V3(0, 0, k));
        expect_facet(n, c, MISS, 0);
        expect_facet(n, plane(c.ray.org, c.ray.dir, V3(k, 0, 0), V3(1, 1, 1)), MISS, 0);
    }
}

void named_facet_edge(struct named *n) {
    int64_t k = n->half / 2;
    for (int64_t m = 1; m <= n->most; m = m * 7 + 2)
        for (int64_t z = 0; z <= m / 4; z = z * 5 + 1) {
            const int64_t dir[3] = {m, 0, z};
            struct hard_facet c = wall(V3(0, 0, 0), dir, k, k, k);
            expect_facet(n, c, NEAR, key_at(dir, k, m));
            c.facet.v[2][1] = -k; /* the neighbour, wound the other way round */
            expect_facet(n, c, FAR, key_at(dir, k, m));
            c.ray.dir[1] = 1;
            expect_facet(n, c, MISS, 0);
            c.facet.v[2][1] = k;
            expect_facet(n, c, NEAR, 0);
            c.ray.dir[1] = -1;
            expect_facet(n, c, MISS, 0);
        }
}

void named_facet_neighbours(struct named *n) {
    int64_t k = n->half / 2, m = n->most;
    for (int64_t tip = -k; tip <= k; tip += k) { /* the neighbour's third corner */
        struct hard_facet c = wall(V3(0, 0, 0), V3(m, 0, m / 3), k, k, k);
        struct sph_facet_leaf other = c.facet;
        other.v[2][0] = k + tip;
        other.v[2][1] = -k;
        if (tip == k) other.v[2][0]--;
        expect_first_facet(n, c, &other, -1);
        c.ray.dir[1] = 1;
        expect_first_facet(n, c, &other, 0);
        c.ray.dir[1] = -1;
        expect_first_facet(n, c, &other, 1);
    }
}

void named_facet_corner(struct named *n) {
    int64_t k = n->half / 2, y = n->half / 3;
    const int64_t rim[4][2] = {{y, 1}, {-1, y}, {-y, -2}, {2, -y}};
    for (int64_t m = 1; m <= n->most; m = m * 9 + 4)
        for (int i = 0; i < 4; i++) {
            const int64_t *a = rim[i], *b = rim[(i + 1) % 4];
            const int64_t dir[3] = {m, -m / 2, m / 8};
            const int64_t org[3] = {-k, k / 2 * (m / 2 * 2 == m), 0};
            struct hard_facet c = triangle(V3(0, 0, 0), V3(m, 0, 0), V3(k, 0, 0), V3(k, a[0], a[1]),
                                           V3(k, b[0], b[1]));
            expect_facet(n, c, FAR, key_at(c.ray.dir, k, m)); /* along x through the corner */
            struct sph_facet_leaf next = c.facet;
            const int64_t *d = rim[(i + 2) % 4];
            for (int j = 0; j < 2; j++)
                next.v[1][1 + j] = b[j], next.v[2][1 + j] = d[j];
            expect_first_facet(n, c, &next, -1);
            c.facet.v[1][0] += i - 1; /* a fan that is not flat */
            expect_first_facet(n, c, &next, -1);
            c = triangle(org, dir, V3(k, 0, 0), V3(k, a[0], a[1]), V3(k, b[0], b[1]));
            expect_facet(n, c, ORACLE, 0);
        }
}

void named_facet_origin_on(struct named *n) {
    int64_t k = n->half / 4, m = n->most;
    for (int64_t x = -1; x <= 1; x++)
        for (int64_t y = 0; y <= k; y += k / 2) { /* an edge, inside, the corner */
            const int64_t org[3] = {k + x, y, 0};
            struct hard_facet c = wall(org, V3(m, 0, 0), k, k, k);
            expect_facet(n, c, x < 0 ? NEAR : MISS, x < 0 ? (uint64_t)m : 0);
            c.ray.dir[0] = -m;
            expect_facet(n, c, x > 0 ? FAR : MISS, x > 0 ? (uint64_t)m : 0);
            c.ray.kind = SPH_SHADOW;
            expect_facet(n, c, x > 0 ? FAR : MISS, 0);
            c = plane(org, V3(1, 2, 3), V3(k, 0, 0), V3(1, 0, 0));
            expect_facet(n, c, x < 0 ? FAR : MISS, x < 0 ? 14 : 0);
        }
}

void named_facet_group(struct named *n) {
    const uint32_t last = SPH_MAX_GROUP - 1;
    int64_t k = n->half / 2;
    struct hard_facet c = wall(V3(0, 1, 0), V3(1, 0, 0), k, k, k);
    for (uint32_t size = 0; size <= last; size = size * 2 + 1)
        for (int away = -2; away <= 2; away++)
            for (int inside = 0; inside < 2; inside++) {
                c.ray.inside = c.ray.skip.inside = inside;
                c.facet.id = 1000;
                c.facet.before = size, c.facet.after = last - size;
                c.ray.skip.id = (uint32_t)(1000 - (int)size + away);
                expect_facet(n, c, away < 0 ? NEAR : MISS, 0);
                c.ray.skip.id = (uint32_t)(1000 + (int)(last - size) + away);
                expect_facet(n, c, away > 0 ? NEAR : MISS, 0);
            }
    struct hard_facet p = plane(c.ray.org, c.ray.dir, V3(k, 0, 0), V3(-5, 0, 0));
    expect_facet(n, p, NEAR, (uint64_t)k);
    p.ray.skip.id = p.facet.id;
    expect_facet(n, p, MISS, 0);
}

void named_facet_back(struct named *n) {
    int64_t k = n->half / 2;
    for (int64_t m = 1; m < n->most; m = 3 * m + 1) {
        const int64_t dir[3] = {m, m / 4, 0}, back[3] = {-m, m / 4, 0};
        expect_facet(n, wall(V3(0, 0, 0), dir, k, k, k), NEAR, key_at(dir, k, m));
        expect_facet(n, wall(V3(k, 0, 0), back, 0, k, k), FAR, key_at(dir, k, m));
        expect_facet(n, plane(V3(0, 0, 0), dir, V3(k, 7, 9), V3(-1, 0, 0)), NEAR,
                     key_at(dir, k, m));
        expect_facet(n, plane(V3(0, 0, 0), dir, V3(k, 7, 9), V3(1, 0, 0)), FAR, key_at(dir, k, m));
    }
}

/* A ray to a light, the origin rounded by lift; and one to no light. */
static void leaves(struct named *n, struct hard_facet c, const int64_t lift[3], int outcome) {
    for (int i = 0; i < 3; i++)
        c.ray.lift[i] = lift[i];
    expect_facet(n, c, c.ray.dir[0] < 0 ? FAR : NEAR, 0);
    c.ray.kind = SPH_SHADOW;
    expect_facet(n, c, outcome, 0);
}

void named_facet_beside(struct named *n) {
    int64_t k = n->half / 4, m = n->most, unit = 1 << n->p->ng;
    for (int64_t x = 1; x < 3; x++)
        for (int64_t lift = -unit; lift <= unit; lift++) {
            int hits = unit * x + lift > 1;
            /* straight on, or nearly along the facet to its far edge; lift beside it counts not */
            struct hard_facet c = wall(V3(k - x, 1, 0), V3(m, 0, 0), k, k, k);
            leaves(n, c, V3(lift, unit, -unit), hits ? NEAR : MISS);
            c.ray.dir[0] = 2 * x;
            c.ray.dir[1] = k;
            leaves(n, c, V3(lift, -unit, 0), hits ? NEAR : MISS);
            c = wall(V3(k + x, 1, 0), V3(-m, 0, 0), k, k, k);
            leaves(n, c, V3(-lift, unit, unit), hits ? FAR : MISS);
            leaves(n, plane(c.ray.org, c.ray.dir, V3(k, 7, 9), V3(-5, 0, 0)), V3(-lift, 1, 0),
                   hits ? FAR : MISS);
            /* x + y + z = k: three components of 1, so that four guard bits are ahead */
            c = triangle(V3(k - x, 0, 0), V3(m, m, m), V3(k, 0, 0), V3(0, 0, k), V3(0, k, 0));
            for (int64_t y = -unit; y <= unit; y += unit)
                leaves(n, c, V3(lift, y, -y), hits && unit * x + lift > 3 ? NEAR : MISS);
        }
}

/* ---- named cases 55 to 61: where a facet, the world or the numbers end ---- */

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
