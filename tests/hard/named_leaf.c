/* named_leaf.c - named cases 1 to 17: tangents, sizes, origins on the surface and inside
 * SPDX-License-Identifier: Apache-2.0
 */
#include <string.h>

#include "math/arith.h"
#include "named.h"
#include "shade/surface.h"
#include "trace/setup.h"

/* Vectors at right angles of the same whole length. */
static const struct {
    int64_t u[3], v[3], length;
} frames[] = {
    {{1, 0, 0}, {0, 1, 0}, 1},  {{1, 2, 2}, {2, 1, -2}, 3},  {{2, 3, 6}, {3, -6, 2}, 7},
    {{1, 4, 8}, {4, 7, -4}, 9}, {{2, 6, 9}, {6, 7, -6}, 11}, {{3, 4, 12}, {4, -12, 3}, 13},
};
enum { FRAMES = sizeof frames / sizeof *frames };

/* The sphere of radius f.length * aside that touches the ray. */
static struct hard_case touching(const struct named *n, int f, int64_t length, int64_t along) {
    int64_t org[3], dir[3], ctr[3], aside = n->half / 4 / frames[f].length;
    for (int i = 0; i < 3; i++) {
        org[i] = -n->half / 4 * (frames[f].v[i] > 0 ? 1 : -1);
        dir[i] = length * frames[f].u[i];
        ctr[i] = org[i] + along * frames[f].u[i] + aside * frames[f].v[i];
    }
    return vector(org, dir, ctr, aside * frames[f].length);
}

static int64_t longest(const struct named *n, int f) {
    return n->most / (frames[f].length);
}

void named_tangent(struct named *n) {
    for (int f = 0; f < FRAMES; f++)
        for (int64_t along = 0; along < n->half / 4 / frames[f].length; along += n->half / 53) {
            expect(n, touching(n, f, 1, along), MISS, 0);
            expect(n, touching(n, f, longest(n, f), along), MISS, 0);
        }
}

/* Cases of 2 R^2 - q^2 = which (1 or -1) with a diagonal ray at distance q/sqrt(2) of the centre,
 * as far along as the grid lets it. */
static void pell(struct named *n, int which, int outcome) {
    int64_t q = 1, r = 1, lengths[] = {1, n->most / 2 + 1, n->most};
    for (int i = 0; q + 2 * r < n->half; i++) {
        if (i % 2 == (which < 0))
            for (int j = 0; j < 3; j++) {
                int64_t d = lengths[j], x = n->half - 1 - q;
                struct hard_case c = vector(V3(0, 0, 0), V3(d, d, 0), V3(x, x + q, 0), r);
                expect(n, c, outcome, outcome == NEAR ? (uint64_t)(d * (2 * x + q - 1)) : 0);
            }
        int64_t next = q + 2 * r;
        r += q;
        q = next;
    }
}

void named_pell_hit(struct named *n) {
    pell(n, 1, NEAR);
}

void named_pell_miss(struct named *n) {
    pell(n, -1, MISS);
}

void named_distance(struct named *n) {
    for (int64_t y = 1; y < n->half; y = 3 * y + 1)
        for (int64_t z = 1; z < n->half; z = 5 * z + 2) {
            int inexact;
            uint64_t square = (uint64_t)(y * y + z * z);
            int64_t rad = (int64_t)sph_isqrt(square, &inexact);
            struct hard_case c =
                vector(V3(-n->half, 0, 0), V3(n->most, 0, 0), V3(n->half - 1, y, -z), rad);
            expect(n, c, MISS, 0);
            c.sphere[0].rad++;
            expect(n, c, NEAR, 0);
        }
}

void named_tangent_off(struct named *n) {
    for (int f = 0; f < FRAMES; f++)
        for (int i = 0; i < 6; i++) {
            struct hard_case c = touching(n, f, longest(n, f) / 2, n->half / 8 / frames[f].length);
            c.sphere[0].ctr[i / 2] += i % 2 ? 1 : -1;
            expect(n, c, ORACLE, 0);
            c = touching(n, f, longest(n, f) / 2, n->half / 8 / frames[f].length);
            c.ray.dir[i / 2] += i % 2 ? 1 : -1;
            expect(n, c, ORACLE, 0);
        }
}

void named_tiny_far(struct named *n) {
    int64_t far = n->half - 2;
    for (int64_t off = 0; off < 4; off++) {
        struct hard_case c = vector(V3(-n->half, -n->half, -n->half),
                                    V3(n->most, n->most, n->most - off), V3(far, far, far), 1);
        expect(n, c, off ? ORACLE : NEAR, 0);
        c.ray.dir[0] -= off;
        expect(n, c, off ? ORACLE : NEAR, 0);
    }
}

/* |ctr - org| = 3k along (2, 2, 1), the origin `above` units outside; the direction goes to the
 * centre (side 1) or away from it. */
static struct hard_case huge(const struct named *n, int64_t k, int64_t above, int64_t side) {
    int64_t m = side * (n->most / 2), end = -n->half;
    return vector(V3(end, end, end), V3(2 * m, 2 * m, m), V3(end + 2 * k, end + 2 * k, end + k),
                  3 * k - above);
}

void named_huge_outside(struct named *n) {
    int64_t k = (2 * n->half - 1) / 3, m = n->most / 2;
    expect(n, huge(n, k, 1, 1), NEAR, (uint64_t)(3 * m));
    expect(n, huge(n, k, 64, 1), NEAR, (uint64_t)(64 * 3 * m));
    expect(n, huge(n, k, 1, -1), MISS, 0);
    struct hard_case c = huge(n, k, 0, 1);
    c.sphere[0].ctr[2]++;
    expect(n, c, NEAR, 0);
    m = n->most / 4;
    c.ray.dir[0] = c.ray.dir[1] = m; /* along the surface */
    c.ray.dir[2] = -4 * m;
    expect(n, c, ORACLE, 0);
}

void named_huge_inside(struct named *n) {
    int64_t k = (2 * n->half - 1) / 3 - 1, m = n->most / 2;
    expect(n, huge(n, k, -1, -1), FAR, (uint64_t)(3 * m));
    expect(n, huge(n, k, -1, 1), FAR, (uint64_t)(3 * m * (6 * k + 1)));
}

/* The origin exactly on the sphere; d.v at most 0 with `along` -1, 1, 0. */
static void on_surface(struct named *n, int64_t along, int outcome) {
    for (int f = 0; f < FRAMES; f++)
        for (int64_t m = 1; m * frames[f].length < n->half / 2; m *= 4) {
            int64_t org[3], dir[3], ctr[3];
            uint64_t b = 0;
            for (int i = 0; i < 3; i++) {
                org[i] = 3;
                ctr[i] = 3 + m * frames[f].v[i];
                dir[i] = along * frames[f].v[i] * (longest(n, f) / 2) + frames[f].u[i];
                b += (uint64_t)(dir[i] * (ctr[i] - org[i]));
            }
            expect(n, vector(org, dir, ctr, m * frames[f].length), outcome,
                   outcome == FAR ? 2 * b : 0);
        }
}

void named_surface_entering(struct named *n) {
    on_surface(n, 1, FAR);
}

void named_surface_leaving(struct named *n) {
    on_surface(n, -1, MISS);
}

void named_surface_along(struct named *n) {
    on_surface(n, 0, MISS);
}

/* Mirror rays at rounded hit points of rays that meet a sphere of radius rad. */
static void bounced(struct named *n, int with_id, int inside, int outcome) {
    struct sph_rng rng = {3};
    for (int i = 0; i < 400; i++) {
        struct hard_case c;
        struct sph_surface s;
        uint64_t roots = 0;
        gen_start(&c);
        if (inside)
            gen_inside(&rng, n->p, &c);
        else
            gen_random(&rng, n->p, &c);
        sph_ray_setup(n->p, &c.ray);
        struct sph_leaf_result r = sph_leaf_test(&c.ray, &c.sphere[0]);
        if (!r.hit || r.far != inside || c.ray.a < 256) continue;
        struct sph_hit hit = {sph_leaf_key(&r, &roots), HARD_ID, r.far != 0, 0};
        if (sph_surface_at(n->p, &c.ray, &hit, &c.sphere[0], &s)) continue;
        sph_reflect(n->p, c.ray.dir, &s, c.ray.dir);
        memcpy(c.ray.org, s.point, sizeof s.point);
        c.ray.kind = SPH_REFLECTED;
        if (with_id) c.ray.skip = (struct sph_skip){HARD_ID, inside};
        expect(n, c, outcome, 0);
    }
}

void named_own_outward(struct named *n) {
    bounced(n, 1, 0, MISS);
    named_scene(n, "alone");
}

void named_no_id(struct named *n) {
    bounced(n, 0, 0, ORACLE);
    require(n, n->tally.hits > n->vectors / 8, "only %lu of %lu hit", n->tally.hits, n->vectors);
}

void named_own_inward(struct named *n) {
    int64_t x = n->half / 2, r = n->half / 4;
    for (int64_t out = 1; out < 4; out++) {
        struct hard_case c = vector(V3(x - r - out, 0, 0), V3(n->most, 3, 0), V3(x, 0, 0), r);
        c.ray.kind = SPH_REFLECTED;
        c.ray.skip = (struct sph_skip){HARD_ID, 1};
        expect(n, c, FAR, 0);
    }
    bounced(n, 1, 1, ORACLE);
}

void named_own_exit(struct named *n) {
    int64_t x = n->half / 2, r = n->half / 4;
    for (int64_t out = 0; out < 2; out++) { /* rounding moves less than a unit */
        struct hard_case c = vector(V3(x, r + out, 0), V3(n->most, 0, 0), V3(x, 0, 0), r);
        c.ray.kind = SPH_REFLECTED;
        c.ray.skip = (struct sph_skip){HARD_ID, 1};
        expect(n, c, EXIT, 1);
        c.ray.dir[1] = n->most; /* all of the sphere lies behind */
        c.ray.dir[0] = 0;
        expect(n, c, EXIT, 1);
    }
}

void named_at_centre(struct named *n) {
    for (int f = 0; f < FRAMES; f++)
        for (int64_t rad = 1; rad < 2 * n->half; rad = 4 * rad + 3) {
            int64_t dir[3], at[3] = {1 - n->half, 0, n->half - 2}, m = longest(n, f);
            for (int i = 0; i < 3; i++)
                dir[i] = m * frames[f].u[i];
            expect(n, vector(at, dir, at, rad), FAR, (uint64_t)(rad * m * frames[f].length));
        }
}

void named_inside_away(struct named *n) {
    for (int64_t deep = 1; deep < n->half / 4; deep = 2 * deep + 1) {
        int64_t r = n->half / 2;
        expect(n, vector(V3(r - deep, 0, 0), V3(n->most, 0, 0), V3(0, 0, 0), r), FAR,
               (uint64_t)(n->most * deep));
        expect(n, vector(V3(r - deep, 0, 0), V3(n->most, n->most / 2, 1), V3(0, 0, 0), r), FAR, 0);
    }
}
