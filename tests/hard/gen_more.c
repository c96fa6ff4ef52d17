/* gen_more.c - families of refraction, images, BIH and unit vectors
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>
#include <string.h>

#include "gen.h"
#include "shade/refract.h"
#include "trace/setup.h"

static uint32_t index_of(struct sph_rng *rng) {
    return (uint32_t)(gen_one_in(rng, 4) ? vec_pick(rng, 990, 1010)
                                         : vec_pick(rng, SPH_INDEX_MIN, SPH_INDEX_MAX));
}

/* sine = q/p exactly, by frames: X = 0; or the index where X changes its sign, or one beside. */
void gen_critical(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    static const int64_t sines[][3] = {{3, 4, 5},   {4, 3, 5},   {5, 12, 13},  {12, 5, 13},
                                       {8, 15, 17}, {7, 24, 25}, {20, 21, 29}, {1, 0, 1}};
    const int64_t *t = sines[vec_pick(rng, 0, 7)];
    int64_t u[3], v[3], w[3];
    c->from = index_of(rng);
    if (gen_one_in(rng, 2)) {
        int64_t least = (SPH_INDEX_MIN + t[0] - 1) / t[0];
        gen_frame(rng, 1ll << vec_pick(rng, 0, (p->wd - 8) / 2), u, v, w);
        int64_t size = gen_one_in(rng, 2) ? 1 : vec_pick(rng, 1, 4),
                m = vec_pick(rng, least, SPH_INDEX_MAX / t[2]);
        for (int i = 0; i < 3; i++) {
            c->ray.dir[i] = t[0] * u[i] - t[1] * v[i];
            c->v[i] = size * v[i];
        }
        c->from = (uint32_t)(m * t[2]);
        c->to = (uint32_t)(m * t[0]);
    } else {
        struct sph_ray ray;
        struct sph_surface s = {.nn = 0};
        uint32_t low = SPH_INDEX_MIN, high = SPH_INDEX_MAX;
        for (int i = 0; i < 3; i++) {
            c->ray.dir[i] = vec_signed(rng, p->wd);
            c->v[i] = s.normal[i] = vec_signed(rng, p->wd);
            s.nn += (uint64_t)(c->v[i] * c->v[i]);
        }
        ray = c->ray;
        sph_ray_setup(p, &ray);
        s.unit = sph_unit(s.normal, s.nn, p->wd);
        while (low < high) {
            uint32_t middle = (low + high) / 2;
            if (sph_refract_disc(&ray, &s, c->from, middle) < 0)
                low = middle + 1;
            else
                high = middle;
        }
        c->to = low;
    }
    if (gen_one_in(rng, 3)) c->to += (uint32_t)gen_sign(rng);
    if (gen_one_in(rng, 4)) c->ray.dir[vec_pick(rng, 0, 2)] += c->ray.dir[0] > 0 ? -1 : 1;
    if (c->to < SPH_INDEX_MIN || c->to > SPH_INDEX_MAX) c->to = SPH_INDEX_ONE;
}

/* Up to three refractions from outside a glass ball with a ball of another glass in it. */
void gen_nested(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    struct sph_leaf *s = c->sphere;
    uint32_t outer = index_of(rng), inner = index_of(rng);
    double to[3], r;
    c->n = 2;
    gen_random(rng, p, c);
    c->sphere[1].rad = gen_one_in(rng, 2) ? s[0].rad - vec_pick(rng, 0, 3) : gen_log(rng, p->w - 2);
    if (s[1].rad > s[0].rad || s[1].rad < 0) s[1].rad = s[0].rad;
    int64_t room = s[0].rad - s[1].rad; /* what lies in it, or pokes out */
    r = (double)s[1].rad;
    for (int i = 0; i < 3; i++) {
        s[1].ctr[i] = gen_clamp(p, s[0].ctr[i] + vec_pick(rng, -room, room));
        to[i] = (double)s[1].ctr[i] + sph_rng_range(rng, -r, r);
    }
    gen_aim(rng, p, to, p->wd - 4, c);
    for (int64_t left = vec_pick(rng, 1, 3); left; left--) {
        struct sph_ray ray = c->ray, next = c->ray;
        struct sph_hit hit = {0};
        struct sph_surface at;
        int which = 0;
        sph_ray_setup(p, &ray);
        for (int i = 0; i < 2; i++) {
            uint64_t roots = 0;
            struct sph_leaf_result l = sph_leaf_test(&ray, &s[i]);
            uint64_t key = l.hit ? sph_leaf_key(&l, &roots) : 0;
            if (!l.hit || (hit.key && key >= hit.key)) continue;
            hit = (struct sph_hit){key, s[i].id, l.far != 0, 0};
            which = i;
        }
        if (!hit.key || ray.a < (uint64_t)SPH_MIN_SCREEN * SPH_MIN_SCREEN) return;
        sph_surface_at(p, &ray, &hit, &s[which], &at);
        uint32_t out = which ? outer : SPH_INDEX_ONE, in = which ? inner : outer;
        if (!sph_refract(p, &ray, &at, hit.far ? in : out, hit.far ? out : in, next.dir)) return;
        memcpy(next.org, at.point, sizeof next.org);
        next.kind = SPH_REFRACTED;
        next.skip = (struct sph_skip){hit.id, !hit.far};
        c->ray = next;
    }
}

/* Unit vectors at the seam, the poles and the quarter turns, a few units of 2^-16 beside. */
void gen_seam(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    int which = (int)vec_pick(rng, 0, 4), axis = (int)vec_pick(rng, 0, 2);
    double unit[3];
    (void)p;
    gen_unit(rng, unit);
    if (which < 3) { /* near an axis */
        int bits = (int)vec_pick(rng, 1, 9);
        for (int i = 0; i < 3; i++)
            unit[i] = i == axis ? 0 : (double)vec_pick(rng, -(1 << bits), 1 << bits) / 65536;
        double rest = 0;
        for (int i = 0; i < 3; i++)
            rest += unit[i] * unit[i];
        unit[axis] = (double)gen_sign(rng) * sqrt(1 - rest);
    }
    if (which == 3) { /* near a plane through the axis: the seam among them */
        int still = gen_one_in(rng, 2) ? 0 : 2;
        double rest = 1 - unit[still] * unit[still];
        unit[still] = (double)vec_pick(rng, -3, 3) / 65536;
        for (int i = 0; i < 3; i++)
            if (i != still) unit[i] /= sqrt(rest);
    }
    for (int i = 0; i < 3; i++)
        c->v[i] = (int64_t)floor(unit[i] * 65536 + 0.5);
}

/* Edges and middles of texels, a few units of 2^-20 beside, in repeats up to the word's end. */
void gen_texel(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    static const uint32_t sizes[] = {1, 2, 3, 5, 7, 8, 100, 255, 256, 257, 640, 1000, 2047, 2048};
    int64_t repeat =
        gen_one_in(rng, 2) ? vec_pick(rng, -2, 2) : vec_pick(rng, -(1 << 19), (1 << 19) - 1);
    uint32_t one = (uint32_t)vec_unsigned(rng, 32);
    (void)p;
    c->texel.size =
        gen_one_in(rng, 2) ? sizes[vec_pick(rng, 0, 13)] : (uint32_t)vec_pick(rng, 1, 2048);
    c->texel.clamp = (int)vec_pick(rng, 0, 1);
    int64_t halves = vec_pick(rng, 0, 2 * (int64_t)c->texel.size);
    c->texel.at = repeat * (1 << 20) + halves * (1 << 19) / c->texel.size + vec_pick(rng, -2, 2);
    if (c->texel.at >= 1ll << 39) c->texel.at = (1ll << 39) - 1;
    if (c->texel.at < -(1ll << 39)) c->texel.at = -(1ll << 39);
    for (int i = 0; i < 4; i++) {
        c->texel.near[i] = gen_one_in(rng, 4) ? one : (uint32_t)vec_unsigned(rng, 32);
        c->texel.far[i] = gen_one_in(rng, 4) ? one : (uint32_t)vec_unsigned(rng, 32);
    }
    c->texel.wx = (uint32_t)vec_unsigned(rng, 8);
    c->texel.wy = (uint32_t)vec_unsigned(rng, 8);
    c->texel.between = (uint32_t)vec_unsigned(rng, 8);
}

/* Paths where nine bits round, bases by which they are just a level, or nearly. */
void gen_level(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    int bits = p->w + 8 > 31 ? 31 : p->w + 8;
    uint64_t path = vec_unsigned(rng, bits);
    if (gen_one_in(rng, 2)) { /* 1.ffffffff1 * 2^e, and one less */
        int e = (int)vec_pick(rng, 9, bits - 1);
        path = ((uint64_t)vec_pick(rng, 512, 1023) << e >> 9) - (uint64_t)vec_pick(rng, 0, 1);
    }
    c->level.path = (uint32_t)path;
    c->level.levels = (int)vec_pick(rng, 1, 12);
    int64_t base = vec_signed(rng, 16);
    if (path && !gen_one_in(rng, 4))
        base = (int64_t)(63 - __builtin_clzll(path)) * 256 - 1024 -
               256 * vec_pick(rng, -1, c->level.levels) + vec_pick(rng, -300, 2);
    c->level.base = (int32_t)(base < -32768 ? -32768 : base > 32767 ? 32767 : base);
}

/* A plane of a node some units of every size ahead, at the origin, or behind. */
void gen_clip(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    gen_point(rng, p, c->ray.org);
    for (int i = 0; i < 3; i++)
        c->ray.dir[i] = gen_one_in(rng, 12) ? 0 : gen_sign(rng) * gen_log(rng, p->wd - 1);
    if (gen_one_in(rng, 8)) c->ray.dir[vec_pick(rng, 0, 2)] = -(1ll << (p->wd - 1));
    int64_t most = 2ll << p->w, v = gen_sign(rng) * gen_log(rng, p->w + 1);
    c->clip.axis = (int)vec_pick(rng, 0, 2);
    c->clip.below = (int)vec_pick(rng, 0, 1);
    if (gen_one_in(rng, 8)) v = vec_pick(rng, -1, 1);
    v += c->ray.org[c->clip.axis];
    c->clip.at = v < -most ? -most : v >= most ? most - 1 : v;
}

/* Two spheres that touch, cut each other or have one surface; the ray from outside, or inside. */
void gen_walk(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    static gen_maker *const makers[] = {gen_pair, gen_concentric, gen_graze1, gen_inside};
    int which = (int)vec_pick(rng, 0, 3);
    makers[which](rng, p, c);
    if (c->n < 2) {
        c->n = 2;
        c->sphere[1].rad = gen_log(rng, p->w - 2);
        for (int i = 0; i < 3; i++)
            c->sphere[1].ctr[i] =
                gen_clamp(p, c->sphere[0].ctr[i] + vec_pick(rng, -4, 4) * c->sphere[1].rad / 2);
    }
    for (int k = 0; k < 2; k++) /* as build does it, whole spheres lie in the grid */
        for (int i = 0; i < 3; i++) {
            int64_t at = c->sphere[k].ctr[i], room = gen_half(p) - (at < 0 ? -at : at);
            if (c->sphere[k].rad > room) c->sphere[k].rad = room;
        }
    c->ray.kind = SPH_PRIMARY;
    c->ray.skip.id = SPH_ID_NONE;
}

/* Vectors at the ends of a table's line, of few bits, of all. */
void gen_unit_vector(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    int bits = (int)vec_pick(rng, 1, p->wd - 1);
    int64_t end = (1ll << (p->wd - 1)) - 1;
    for (int i = 0; i < 3; i++)
        c->v[i] = gen_one_in(rng, 3) ? vec_signed(rng, p->wd) : gen_sign(rng) * gen_log(rng, bits);
    if (gen_one_in(rng, 2)) { /* v.v next to a whole line: x * 2^k */
        double line = (double)vec_pick(rng, 256, 1023) * ldexp(1, 2 * bits - 9);
        for (int i = 0; i < 2; i++) {
            c->v[i] = vec_pick(rng, -(1ll << (bits - 1)), 1ll << (bits - 1));
            line -= (double)c->v[i] * (double)c->v[i];
        }
        c->v[2] = (int64_t)(line > 0 ? sqrt(line) : 0) + vec_pick(rng, -1, 1);
        if (c->v[2] > end) c->v[2] = end;
    }
}
