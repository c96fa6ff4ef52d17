/* named_edge.c - named cases 18 to 26 and 34 to 37, 46, 47: directions, ends of ranges, shadows
 * SPDX-License-Identifier: Apache-2.0
 */
#include "named.h"
#include "trace/setup.h"

void named_axes(struct named *n) {
    for (int sign = -1; sign <= 1; sign += 2)
        for (int64_t m = 1; m <= n->most; m = m < n->most && 4 * m > n->most ? n->most : 4 * m) {
            struct hard_case c = vector(V3(-sign * n->half / 2, 5, -7), V3(sign * m, 0, 0),
                                        V3(sign * n->half / 2, 5, -7), n->half / 4);
            expect(n, c, NEAR, (uint64_t)(m * (n->half - n->half / 4)));
            c.sphere[0].ctr[1] += n->half / 4 - 1;
            expect(n, c, NEAR, 0);
            c.sphere[0].ctr[1]++;
            expect(n, c, MISS, 0);
        }
}

void named_unit_axis(struct named *n) {
    for (int64_t y = 0; y < n->half / 4; y = 3 * y + 1) {
        struct hard_case c =
            vector(V3(-n->half, 0, 0), V3(1, 0, 0), V3(n->half / 2, y, 0), n->half / 4);
        expect(n, c, NEAR, 0);
        c.ray.org[0] = n->half / 2;
        expect(n, c, FAR, 0);
    }
}

void named_one_and_power(struct named *n) {
    for (int64_t m = 1; m <= n->most; m *= 2)
        for (int sign = -1; sign <= 1; sign += 2)
            for (int64_t rad = 1; rad < n->half; rad = 8 * rad + 1) {
                int64_t z = n->half - 1, x = z / m;
                struct hard_case c = vector(V3(0, 0, 0), V3(sign, 0, m), V3(sign * x, rad, z), rad);
                expect(n, c, ORACLE, 0);
                c.sphere[0].ctr[1]--;
                expect(n, c, ORACLE, 0);
            }
}

void named_dir0(struct named *n) {
    expect(n, vector(V3(0, 0, 0), V3(0, 0, 0), V3(n->half / 2, 1, 2), n->half / 4), MISS, 0);
    expect(n, vector(V3(3, 3, 3), V3(0, 0, 0), V3(3, 3, 3), n->half), MISS, 0);
    expect(n, vector(V3(3, 3, 3), V3(0, 0, 0), V3(3, 3, 3), 0), MISS, 0);
    expect(n, vector(V3(4, 3, 3), V3(0, 0, 0), V3(3, 3, 3), 1), MISS, 0);
}

void named_rad0(struct named *n) {
    for (int64_t m = 1; m <= n->most / 3; m *= 3) {
        int64_t x = n->half / 4;
        expect(n, vector(V3(-x, x, x), V3(2 * m, -m, -3 * m), V3(-x + 2 * x, 0, -2 * x), 0), MISS,
               0);
        expect(n, vector(V3(0, 0, 0), V3(m, 0, 0), V3(x, 0, 0), 0), MISS, 0);
    }
}

void named_rad0_centre(struct named *n) {
    expect(n, vector(V3(1, 2, 3), V3(n->most, 0, 0), V3(1, 2, 3), 0), MISS, 0);
    expect(n, vector(V3(1, 2, 3), V3(-1, 1, n->most), V3(1, 2, 3), 0), MISS, 0);
}

void named_ends(struct named *n) {
    int64_t rads[] = {0, 1, 2 * n->half - 1};
    for (int bits = 0; bits < 512; bits++)
        for (int r = 0; r < 3; r++) {
            struct hard_case c = vector(V3(0, 0, 0), V3(0, 0, 0), V3(0, 0, 0), rads[r]);
            for (int i = 0; i < 3; i++) {
                c.ray.org[i] = bits >> i & 1 ? -n->half : n->half - 1;
                c.sphere[0].ctr[i] = bits >> (3 + i) & 1 ? -n->half : n->half - 1;
                c.ray.dir[i] = bits >> (6 + i) & 1 ? -n->most - 1 : n->most;
            }
            expect(n, c, rads[r] ? ORACLE : MISS, 0);
        }
}

void named_disc_ends(struct named *n) {
    int64_t low = -n->half, high = n->half - 1, d = -n->most - 1;
    sph_i128 most = 2 * n->half - 1, unit = (sph_i128)d * d * most * most;
    for (int i = 0; i < 3; i++) { /* oc.dir = +-1 in units: |oc x dir|^2 = 8 */
        int64_t org[3] = {low, low, low}, ctr[3] = {high, high, high};
        org[i] = high;
        ctr[i] = low;
        struct hard_case c = vector(org, V3(d, d, d), ctr, 0);
        sph_ray_setup(n->p, &c.ray);
        require(n, sph_leaf_test(&c.ray, &c.sphere[0]).disc == -8 * unit,
                "the least disc is not -8 (2^W-1)^2 2^(2WD-2)");
        expect(n, c, MISS, 0);
        expect(n, vector(ctr, V3(d, d, d), org, 0), MISS, 0); /* b > 0: disc alone decides */
    }
    struct hard_case c = vector(V3(1, 0, low), V3(d, d, d), V3(1, 0, low), (int64_t)most);
    sph_ray_setup(n->p, &c.ray);
    require(n, sph_leaf_test(&c.ray, &c.sphere[0]).disc == 3 * unit,
            "the greatest disc is not 3 (2^W-1)^2 2^(2WD-2)");
    expect(n, c, FAR, 0);
}

/* Diagonal rays with m = 1: k*a = -b^2 +- 1, b as large as the grid lets it. */
void named_disc_one(struct named *n) {
    int64_t q = 1, r = 1;
    for (int i = 0; q + 2 * r < n->half; i++) {
        int64_t x = n->half - 1 - q;
        struct hard_case c = vector(V3(-x, -x, 0), V3(1, 1, 0), V3(x, x + q, 0), r);
        expect(n, c, i % 2 ? MISS : NEAR, 0);
        int64_t next = q + 2 * r;
        r += q;
        q = next;
    }
}

void named_behind(struct named *n) {
    for (int64_t r = 1; r < n->half / 2; r = 3 * r + 1)
        for (int64_t y = 0; y < r; y = 2 * y + 1) {
            int64_t end = -n->half; /* behind a node around it too */
            expect(n, vector(V3(0, 0, 0), V3(n->most, 0, 0), V3(-r - 1, y, 0), r), MISS, 0);
            expect(n, vector(V3(0, 0, 0), V3(n->most, 0, 0), V3(end, y, 0), r), MISS, 0);
        }
}

/* A shadow ray from org to the light. */
static struct hard_case shadow(const int64_t org[3], const int64_t light[3], const int64_t ctr[3],
                               int64_t rad) {
    struct hard_case c =
        vector(org, V3(light[0] - org[0], light[1] - org[1], light[2] - org[2]), ctr, rad);
    c.ray.kind = SPH_SHADOW;
    return c;
}

void named_light_on(struct named *n) {
    int64_t x = n->half / 2, far = n->half - 1;
    for (int64_t m = 1; m < n->half / 16; m *= 2) {
        const int64_t light[3] = {x - m, x - 2 * m, x - 2 * m}, ctr[3] = {x, x, x};
        expect(n, shadow(V3(-far, -far, -far), light, ctr, 3 * m), MISS, 0);
        struct hard_case in = shadow(V3(x + m, x, x), light, ctr, 3 * m);
        expect(n, in, MISS, 0);
        in.ray.skip = (struct sph_skip){HARD_ID, 1};
        expect(n, in, MISS, 0);
        expect(n, shadow(V3(-far, -far, -far), light, ctr, 3 * m + 1), NEAR, 0);
        expect(n, shadow(V3(x + m, x, x), light, ctr, 3 * m - 1), FAR, 0);
    }
}

void named_light_in(struct named *n) {
    int64_t x = n->half / 2, r = n->half / 4;
    for (int64_t deep = 1; deep < 2 * r; deep *= 2)
        expect(n, shadow(V3(-x, 3, 4), V3(x - r + deep, 0, 0), V3(x, 0, 0), r), NEAR, 0);
    expect(n, shadow(V3(x - 1, 3, 4), V3(x + r / 2, 0, 0), V3(x, 0, 0), r), MISS, 0); /* both in */
    expect(n, shadow(V3(x - 1, 3, 4), V3(x + r + 9, 0, 0), V3(x, 0, 0), r), FAR, 0);
}

void named_light_zero(struct named *n) {
    expect(n, shadow(V3(1, 2, 3), V3(1, 2, 3), V3(n->half / 2, 2, 3), 5), MISS, 0);
    expect(n, shadow(V3(1, 2, 3), V3(1, 2, 3), V3(1, 2, 3), n->half), MISS, 0);
    expect(n, shadow(V3(6, 2, 3), V3(6, 2, 3), V3(1, 2, 3), 5), MISS, 0);
}

void named_disc_small(struct named *n) {
    for (int64_t x = 2; x < n->half; x = 7 * x + 1)
        for (int i = 1; i <= 3; i++) { /* disc = 1, 2, 3 with root 1 */
            struct hard_case c =
                vector(V3(0, 0, 0), V3(1, i > 1, i > 2), V3(x, i > 1 ? x : 0, i > 2 ? x : 0), 1);
            expect(n, c, NEAR, (uint64_t)(i * x - 1));
        }
}

void named_alternate(struct named *n) {
    int64_t low = -n->half, high = n->half - 1, d = n->most;
    struct hard_case all[] = {
        vector(V3(low, low, low), V3(d, d, d), V3(high, high, high), 2 * n->half - 1),
        vector(V3(0, 0, 0), V3(1, 0, 0), V3(2, 0, 0), 1),
        vector(V3(high, high, high), V3(-d - 1, -d - 1, -d - 1), V3(low, low, low), 0),
        vector(V3(0, 0, 0), V3(0, 0, 0), V3(0, 0, 0), 0),
        vector(V3(high, low, high), V3(-d - 1, d, -d - 1), V3(low, high, low), 1),
    };
    enum { ALL = sizeof all / sizeof *all };
    static const int outcome[ALL] = {NEAR, NEAR, MISS, MISS, ORACLE};
    struct sph_leaf_result first[ALL];
    for (int i = 0; i < 8 * ALL; i++) {
        int at = i < ALL ? i : i * 3 % ALL;
        struct sph_ray ray = all[at].ray;
        sph_ray_setup(n->p, &ray);
        struct sph_leaf_result r = sph_leaf_test(&ray, &all[at].sphere[0]);
        if (i < ALL) first[at] = r;
        require(n, r.hit == first[at].hit && r.far == first[at].far && r.disc == first[at].disc,
                "vector %d has another answer behind other vectors", at);
        expect(n, all[at], outcome[at], 0);
    }
}
