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
