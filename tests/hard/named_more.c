/* named_more.c - named cases 70 to 78 and 80: planes, images, BIH and unit vectors
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdlib.h>

#include "facet.h"
#include "texture/texel.h"
#include "texture/lod.h"
#include "texture/coords.h"

void named_planes_equal(struct named *n) {
    int64_t k = n->half / 2, m = n->most;
    for (int64_t y = 0; y < k; y = 5 * y + 1)
        for (int64_t big = 1; big < 1 << 22; big = 60 * big + 7) {
            const int64_t at[3] = {k, y, 3};
            struct hard_facet c = plane(V3(-k, -y, 3), V3(2 * k, 2 * y, 0), at, V3(-big, 1, 7));
            struct hard_facet other = plane(c.ray.org, c.ray.dir, at, V3(big / 2 + 1, 3, -big));
            expect_first_facet(n, c, &other.facet, -1);
            c.facet.v[0][0]--; /* a unit nearer the eye: at |dir| = 2k a key of its own */
            if (!y) expect_first_facet(n, c, &other.facet, 0);
            c.facet.v[0][0] += 2;
            if (!y) expect_first_facet(n, c, &other.facet, 1);
            expect_facet(n, c, ORACLE, 0);
        }
    expect_facet(n, plane(V3(-k, 0, 0), V3(m, 0, 0), V3(k, 0, 0), V3(-1, 8388607, -8388608)), NEAR,
                 key_at(V3(m, 0, 0), 2 * k, m));
}

void named_plane_along(struct named *n) {
    int64_t h = n->half, m = n->most;
    for (int64_t y = 1; y < h; y = 3 * y + 1) { /* N.dir = -1, 0, 1 */
        for (int64_t off = -1; off <= 1; off++) {
            const int64_t dir[3] = {m, 1, 0}, org[3] = {-h, 0, 0};
            struct hard_facet c = plane(org, dir, V3(-h, y, 0), V3(-1, m + off, 0));
            int64_t num = (m + off) * y; /* what is left of the way adds to the key */
            uint64_t end = key_at(dir, 2 * h, m) + (uint64_t)(m - (2 * h + num - 1) / num);
            if (m + off > 8388607) continue;
            expect_facet(n, c, off > 0 ? FAR : MISS, off > 0 ? end : 0);
            c.facet.v[0][1] = -y;
            expect_facet(n, c, off < 0 ? NEAR : MISS, off < 0 ? end : 0);
        }
        expect_facet(n, plane(V3(0, 0, 0), V3(0, 0, m), V3(0, 0, h - 1), V3(y, y, 1)), FAR,
                     (uint64_t)(m * (h - 1)));
    }
}

void named_facets_flat(struct named *n) {
    int64_t k = n->half / 4, m = n->most;
    for (int64_t x = -k; x <= k; x += k)
        for (int64_t z = 1; z < k; z = 4 * z + 1) {
            struct hard_facet c = wall(V3(-2 * k, z, 0), V3(m, 0, 0), x, 2 * k, k);
            struct sph_facet_leaf other = c.facet;
            for (int i = 0; i < 3; i++)
                other.v[i][2] += i - 1, other.v[i][1] -= i;
            expect_first_facet(n, c, &other, -1);
            c.ray.dir[1] = 1;
            expect_first_facet(n, c, &other, -1);
        }
}

/* ---- images ---- */

static void around(struct named *n, int64_t x, int64_t y, int64_t z, int64_t expected,
                   int64_t down) {
    struct hard_case c = {.of = HARD_AROUND, .v = {x, y, z}};
    const int32_t v[3] = {(int32_t)x, (int32_t)y, (int32_t)z};
    struct sph_longitude r = sph_longitude(v);
    expect_case(n, &c);
    require(n, expected < 0 || labs((int64_t)r.around - expected) <= 1, "around %u", r.around);
    require(n, down < 0 || labs((int64_t)r.down - down) <= 1, "down %u", r.down);
}

void named_seam(struct named *n) {
    const int64_t one = 65536, turn = 1 << 18;
    around(n, 0, 0, one, turn / 2, turn / 4);
    around(n, one, 0, 0, turn * 3 / 4, turn / 4);
    around(n, -one, 0, 0, turn / 4, turn / 4);
    around(n, 0, one, 0, turn / 2, 0);
    around(n, 0, -one, 0, turn / 2, turn / 2);
    around(n, 0, 0, 0, turn / 2, turn / 4);
    around(n, 0, 0, -one, 0, turn / 4);
    for (int64_t x = 2; x < 100; x++) { /* the seam: 0 on one side, all but 1 on the other */
        around(n, -x, 0, -one, -1, turn / 4);
        around(n, x, 0, -one, -1, turn / 4);
        struct sph_longitude a = sph_longitude((const int32_t[3]){(int32_t)-x, 0, -65536});
        struct sph_longitude b = sph_longitude((const int32_t[3]){(int32_t)x, 0, -65536});
        require(n, a.around < 200 && b.around > turn - 200, "%u and %u beside the seam", a.around,
                b.around);
        around(n, x, one, 1 - x, -1, -1);
        around(n, x, -one, x, -1, -1);
    }
}

void named_texel_edge(struct named *n) {
    const int64_t one = 1 << 20;
    for (uint32_t size = 1; size <= 2048; size = size < 10 ? size + 1 : size * 2 - size % 3)
        for (int64_t repeat = -(1 << 19); repeat < 1 << 19; repeat += repeat ? 1 << 18 : 1)
            for (int clamp = 0; clamp < 2; clamp++)
                for (int64_t i = 0; i <= size; i += i < 2 || i > size - 3 ? 1 : (size - 4) / 2 + 1)
                    for (int64_t off = -1; off <= 1; off++) {
                        struct hard_case c = {.of = HARD_TEXELS};
                        c.texel.at = repeat * one + i * one / size + off;
                        c.texel.size = size;
                        c.texel.clamp = clamp;
                        if (c.texel.at < -(1ll << 39)) continue;
                        expect_case(n, &c);
                        if (i || off) continue;
                        struct sph_axis a = sph_axis_at(c.texel.at, size, clamp);
                        uint32_t before = clamp ? (repeat > 0 ? size - 1 : 0) : size - 1;
                        if (clamp && repeat > 0) continue;
                        require(n, a.texel[0] == before && !a.texel[1] && !a.nearest,
                                "at the edge of %u: %u, %u", size, a.texel[0], a.texel[1]);
                    }
}

void named_texel_mean(struct named *n) {
    static const uint32_t sets[][4] = {{0, 0, 0, 0},
                                       {~0u, ~0u, ~0u, ~0u},
                                       {0, ~0u, ~0u, 0},
                                       {~0u, 0, 0, 0},
                                       {0, 0x01010101, 0, 0x01010101},
                                       {0x01020304, 0x01020304, 0x01020304, 0x01020304}};
    static const uint32_t weights[] = {0, 1, 127, 128, 129, 255};
    for (int i = 0; i < 36; i++)
        for (int j = 0; j < 216; j++) {
            struct hard_case c = {.of = HARD_TEXELS};
            c.texel.size = 4;
            for (int k = 0; k < 4; k++)
                c.texel.near[k] = sets[i % 6][k], c.texel.far[k] = sets[i / 6][k];
            c.texel.wx = weights[j % 6];
            c.texel.wy = weights[j / 6 % 6];
            c.texel.between = weights[j / 36];
            expect_case(n, &c);
        }
}

void named_level(struct named *n) {
    for (int bits = 0; bits < n->p->w + 8 && bits < 32; bits++)
        for (int64_t off = -2; off <= 2; off++)
            for (int32_t base = -1025; base <= 1; base += 1 + (base == -1023) * 1022)
                for (int levels = 1; levels <= 12; levels += 11) {
                    struct hard_case c = {.of = HARD_LEVELS};
                    c.level.path = (uint32_t)((1ll << bits) + off);
                    if ((1ll << bits) + off < 0) continue;
                    c.level.base = base;
                    c.level.levels = levels;
                    expect_case(n, &c);
                    int64_t lod = 256 * bits - 1024 - base, last = 256 * (levels - 1);
                    if (off) continue;
                    require(n,
                            sph_lod(c.level.path, base, levels) == (uint32_t)(lod < 0      ? 0
                                                                              : lod > last ? last
                                                                                           : lod),
                            "log2 of a power of two is not whole");
                }
    for (int64_t nine = 256; nine < 512; nine++) /* 1.ffffffff1 and what is just below it */
        for (int64_t off = -1; off <= 0; off++) {
            struct hard_case c = {.of = HARD_LEVELS};
            c.level.path = (uint32_t)((2 * nine + 1) * 32 + off);
            c.level.base = -512;
            c.level.levels = 12;
            expect_case(n, &c);
        }
}

/* ---- trees ---- */

void named_clip(struct named *n) {
    const int64_t end = 2 * n->half, ends[] = {-n->most - 1, -1, 0, 1, 2, n->most};
    const int64_t orgs[] = {-n->half, 0, n->half - 1};
    for (int i = 0; i < 6 * 6 * 3; i++)
        for (int at = -4; at <= 4; at++)
            for (int side = 0; side < 6; side++) {
                struct hard_case c;
                gen_start(&c);
                c.of = HARD_CLIPS;
                c.clip.axis = side / 2;
                c.clip.below = side % 2;
                for (int k = 0; k < 3; k++) {
                    c.ray.dir[k] = ends[(i + k * (i / 6)) % 6];
                    c.ray.org[k] = orgs[i / 36];
                }
                c.clip.at = at < -3 ? -2 * end : at > 3 ? 2 * end - 1 : orgs[i / 36] + at;
                expect_case(n, &c);
            }
}

void named_walk(struct named *n) {
    int64_t h = n->half, k = h / 4, m = n->most;
    for (int64_t r = 1; r <= k; r = 3 * r + 1)
        for (int turn = 0; turn < 3; turn++)
            for (int which = 0; which < 5; which++) {
                static const int64_t dirs[][3] = {
                    {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {-1, 0, 0}, {0, -1, 1}};
                struct hard_case c;
                gen_start(&c);
                c.of = HARD_WALKS;
                c.n = 2;
                for (int i = 0; i < 3; i++) { /* they touch in the middle, or in a corner's box */
                    int64_t d = dirs[which][(i + turn) % 3];
                    c.ray.dir[i] = d * (m - 1);
                    c.ray.org[i] = -d * (h - 1);
                    c.sphere[0].ctr[i] = i == turn ? -r : 0;
                    c.sphere[1].ctr[i] = i == turn ? r : 0;
                }
                c.sphere[0].rad = c.sphere[1].rad = r;
                expect_case(n, &c);
                c.sphere[1].ctr[turn] = -r; /* one sphere, twice */
                expect_case(n, &c);
                c.sphere[1].rad = r - (r > 1); /* in it */
                expect_case(n, &c);
                c.sphere[1] = c.sphere[0];
                c.sphere[1].ctr[turn] = h - r; /* at a face of the grid */
                expect_case(n, &c);
                c.sphere[0].ctr[turn] = r - h;
                expect_case(n, &c);
                if (which) continue; /* across both, where they lie side by side; the left one */
                int ahead = (turn + 1) % 3, beside = (turn + 2) % 3;
                for (int i = 0; i < 3; i++) {
                    c.ray.dir[i] = i == ahead ? m : 0;
                    c.ray.org[i] = i == ahead ? -h : i == turn ? r : 0;
                    c.sphere[0].ctr[i] = 0;
                    c.sphere[1].ctr[i] = i == turn ? r : i == beside ? 3 * r : 0;
                }
                c.sphere[0].rad = 2 * r;
                c.sphere[1].rad = r;
                expect_case(n, &c);
            }
}

/* ---- unit vectors ---- */

void named_unit_ends(struct named *n) {
    const int64_t ends[] = {-n->most - 1, -n->most, -1, 0, 1, n->most};
    struct hard_case c = {.of = HARD_UNITS};
    for (int i = 0; i < 216; i++) {
        for (int k = 0, m = i; k < 3; k++, m /= 6)
            c.v[k] = ends[m % 6];
        expect_case(n, &c);
    }
    for (int64_t x = 1; x <= n->most; x = x * 9 / 8 + 1)
        for (int i = 0; i < 9; i++) {
            for (int k = 0; k < 3; k++)
                c.v[k] = i / 3 == 2 || k == i % 3 ? x : i / 3 * (k - 1);
            expect_case(n, &c);
        }
}
