/* named_tie.c - named cases 82 to 87: surfaces in one place, edges in the middle of pixels, the eye
 * on what it sees
 * SPDX-License-Identifier: Apache-2.0
 */
#include "facet.h"

void named_coplane(struct named *n) {
    int64_t k = n->half / 4;
    for (int64_t m = 1; m <= n->most / 4; m = 200 * m + 1)
        for (int64_t slope = 0; slope < 3; slope++) {          /* x + slope y = k */
            const int64_t at[3][2] = {{1, 1}, {0, 2}, {0, 0}}; /* the middle, an edge, a corner */
            for (int i = 0; i < 3; i++) {
                const int64_t org[3] = {k - 4 - slope * at[i][0], at[i][0], at[i][1]};
                struct hard_facet c =
                    triangle(org, V3(m, 0, 0), V3(k, 0, 0), V3(k - 8 * slope, 8, 0), V3(k, 0, 8));
                struct sph_facet_leaf flat =
                    plane(org, V3(m, 0, 0), V3(k - 9 * slope, 9, -7), V3(5, 5 * slope, 0)).facet;
                expect_first_facet(n, c, &flat, -1);
                flat.v[0][0]--;
                expect_first_facet(n, c, &flat, 1);
                flat.v[0][0] += 2;
                expect_first_facet(n, c, &flat, 0);
                c.ray.org[2] = -1; /* past the triangle: the plane has no edges */
                expect_first_facet(n, c, &flat, 1);
            }
        }
}

void named_pixel(struct named *n) {
    int64_t far = n->half / 64;
    for (int64_t pitch = 1; pitch < 4; pitch++)
        for (int64_t step = 0; step <= 8; step++) { /* of nine pixels in a row, up or aslant */
            const int64_t org[3] = {-far, 3, far / 2}, y = (2 * step - 8) * pitch;
            const int64_t a[3] = {17, -8 * pitch, -8 * pitch}, b[3] = {17, 8 * pitch, 8 * pitch};
            struct hard_facet c =
                triangle(org, V3(17, y, y), V3(org[0] + 17 * far / 32, org[1], org[2]), org,
                         V3(far, 9, -far));
            for (int i = 0; i < 3; i++) {
                c.facet.v[0][i] = org[i] + 2 * a[i];
                c.facet.v[1][i] = org[i] + 3 * b[i];
            }
            struct sph_facet_leaf other = c.facet;
            other.v[2][1] = -far, other.v[2][2] = far;
            expect_first_facet(n, c, &other, -1);
            c.ray.dir[1]++; /* the next ray belongs to one of them */
            expect_facet(n, c, ORACLE, 0);
            c.facet = other;
            expect_facet(n, c, ORACLE, 0);
        }
}

void named_ridge(struct named *n) {
    int64_t k = n->half / 4;
    for (int64_t m = 1; m <= n->most / 4; m = 300 * m + 2)
        for (int64_t high = -3; high <= 3; high++) { /* a valley, flat, a ridge along z */
            struct hard_facet c =
                triangle(V3(-k, 0, 1), V3(m, 0, 0), V3(0, 0, -4), V3(0, 0, 4), V3(high, 5, 0));
            struct sph_facet_leaf other = c.facet;
            other.v[2][1] = -5;
            expect_first_facet(n, c, &other, -1);
            if (!high) continue;
            /* in the plane of the first, beyond the edge: the second alone, whichever is stored
             * first */
            for (int i = 0; i < 3; i++) {
                c.ray.org[i] = -4 * c.facet.v[2][i] + (i == 2);
                c.ray.dir[i] = c.facet.v[2][i];
            }
            expect_first_facet(n, c, &other, 1);
            c.ray.dir[2] = 1; /* along it and off its middle, still in its plane */
            expect_facet(n, c, MISS, 0);
        }
}

/* As two hits of the model, and as a case of the benches. */
static void tie(struct named *n, const struct hard_facet *c, const struct sph_leaf *s, int winner) {
    struct hard_case both = {.of = HARD_TIES, .ray = c->ray, .sphere = {*s}, .facet = {c->facet}};
    both.n = 1;
    both.sphere[0].id = HARD_ID;
    both.facet[0].id = HARD_OTHER;
    expect_case(n, &both);
    expect_first_sphere(n, *c, s, winner);
}

void named_meet(struct named *n) {
    int64_t k = n->half / 16;
    const struct sph_leaf s = {{3 * k, 4 * k, 0}, 5 * k, 0};
    for (int64_t m = 1; m < n->most / 8; m *= 125) { /* to the origin, where all three are */
        const int64_t org[3] = {-4 * k, -k, 0}, dir[3] = {4 * m, m, 0};
        struct hard_facet t[] = {
            triangle(org, dir, V3(-k, -k, 0), V3(k, k, 0), V3(0, -2, k)), /* on an edge */
            triangle(org, dir, V3(0, 0, 0), V3(0, k, 9), V3(-9, k, -k)),  /* at a corner */
            triangle(org, dir, V3(-1, -2, k), V3(0, 2, 0), V3(1, 0, -k)), /* in the middle */
            plane(org, dir, V3(k, 0, 0), V3(0, 5, 1)),
            plane(org, dir, V3(4, -3, 7), V3(6, 8, 0)), /* it touches the sphere there */
        };
        for (size_t i = 0; i < sizeof t / sizeof *t; i++) {
            struct sph_leaf less = s, more = s;
            less.rad--, more.rad++;
            tie(n, &t[i], &s, -1);
            tie(n, &t[i], &more, 0);
            tie(n, &t[i], &less, 1);
        }
    }
}

void named_glass(struct named *n) {
    for (int64_t k = 1; k < n->half / 8; k = 3 * k + 1)
        for (int64_t off = -1; off <= 1; off++) /* the rounded shell may lie a unit beside it */
            for (int back = 0; back < 2; back++) {
                /* on a shell of radius 5k, past a ball of 3k in its middle */
                struct hard_case c =
                    vector(V3(back ? 4 * k : -4 * k, 3 * k, 0), V3(back ? -n->most : n->most, 0, 0),
                           V3(0, 0, 0), 3 * k);
                c.n = 2;
                c.ray.kind = back ? SPH_REFLECTED : SPH_REFRACTED;
                c.sphere[1].rad = 5 * k + off;
                c.sphere[0].id = HARD_OTHER, c.sphere[1].id = HARD_ID;
                c.ray.skip = (struct sph_skip){HARD_ID, 1};
                expect(n, c, MISS, 0); /* touches it */
                c.sphere[0].rad++;
                expect(n, c, NEAR, 0);
                c.sphere[0].rad -= 2;
                expect(n, c, MISS, 0);
                c.ray.kind = SPH_SHADOW; /* to a light before the shell's other side */
                c.ray.dir[0] = back ? -4 * k : 4 * k;
                expect(n, c, MISS, 0);
                c.sphere[0].rad += 2;
                expect(n, c, NEAR, 0);
            }
}

void named_eye(struct named *n) {
    int64_t k = n->half / 16;
    const struct sph_leaf s = {{3 * k, 4 * k, 0}, 5 * k, 0};
    const int64_t inwards[3] = {3, 4, 0}, along[3] = {4, -3, 0}, out[3] = {-3, -4, 1};
    for (int64_t off = -1; off <= 1; off++) { /* before, on and in both, which touch at 0 */
        const int64_t eye[3] = {3 * off, 4 * off, 0};
        struct hard_facet t[] = {
            triangle(eye, inwards, V3(-4 * k, 3 * k, 0), V3(4 * k, -3 * k, 0), V3(4, -3, k)),
            triangle(eye, inwards, V3(4, -3, -k), V3(0, 0, k), V3(-4, 3, -k)),
            plane(eye, inwards, V3(4, -3, 7), V3(6, 8, 0)),
        };
        for (size_t i = 0; i < sizeof t / sizeof *t; i++) {
            tie(n, &t[i], &s, off < 0 ? -1 : 0);
            expect_facet(n, t[i], off < 0 ? ORACLE : MISS, 0);
            t[i].ray.dir[0] = along[0], t[i].ray.dir[1] = along[1];
            expect_facet(n, t[i], MISS, 0);
            for (int j = 0; j < 3; j++)
                t[i].ray.dir[j] = out[j];
            expect_facet(n, t[i], off > 0 ? ORACLE : MISS, 0);
        }
    }
}
