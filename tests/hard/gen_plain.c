/* gen_plain.c - families that place ray and sphere by size and by bit pattern
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>

#include "gen.h"

/* A point within `reach` radii of the sphere, per axis. */
static void near_sphere(struct sph_rng *rng, const struct sph_leaf *s, double reach, double to[3]) {
    double r = reach * (double)s->rad;
    for (int i = 0; i < 3; i++)
        to[i] = (double)s->ctr[i] + sph_rng_range(rng, -r, r);
}

void gen_random(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    double to[3];
    gen_point(rng, p, c->ray.org);
    gen_point(rng, p, c->sphere[0].ctr);
    c->sphere[0].rad = gen_log(rng, p->w - 1);
    near_sphere(rng, &c->sphere[0], 1.2, to);
    gen_aim(rng, p, to, 4, c);
    if (!gen_one_in(rng, 4)) return;
    for (int i = 0; i < 3; i++)
        c->ray.dir[i] = vec_pick(rng, -(1ll << (p->wd - 1)), (1ll << (p->wd - 1)) - 1);
}

void gen_tiny_far(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    int64_t half = gen_half(p), room = half / 8;
    double to[3];
    for (int i = 0; i < 3; i++) {
        int64_t side = gen_one_in(rng, 4) ? 0 : gen_sign(rng);
        c->ray.org[i] = gen_clamp(p, side * half + vec_pick(rng, -room, room));
        c->sphere[0].ctr[i] = gen_clamp(p, -side * half + vec_pick(rng, -room, room));
    }
    c->sphere[0].rad = vec_pick(rng, 1, 3);
    near_sphere(rng, &c->sphere[0], 1, to);
    gen_aim(rng, p, to, p->wd - 2, c);
}

void gen_huge_near(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    int64_t half = gen_half(p);
    double n[3], to[3];
    do { /* the centre lies where there is room for the radius */
        double far = (double)half * sph_rng_range(rng, 0.5, 1.99);
        double above = (double)(gen_one_in(rng, 8) ? -vec_pick(rng, 1, 4) : vec_pick(rng, 1, 64));
        gen_unit(rng, n);
        for (int i = 0; i < 3; i++) {
            c->ray.org[i] = gen_clamp(p, (int64_t)(n[i] * (double)half * 1.4));
            c->sphere[0].ctr[i] = c->ray.org[i] - (int64_t)rint(n[i] * far);
        }
        c->sphere[0].rad = (int64_t)(far - above);
    } while (!gen_on_grid(p, c->sphere[0].ctr));
    near_sphere(rng, &c->sphere[0], gen_one_in(rng, 2) ? 1 : 0.05, to);
    if (gen_one_in(rng, 4)) /* along the surface */
        for (int i = 0; i < 3; i++)
            to[i] = (double)c->ray.org[i] + n[(i + 1) % 3] - n[(i + 2) % 3];
    gen_aim(rng, p, to, 4, c);
}

void gen_inside(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    double n[3], to[3];
    struct sph_leaf *s = &c->sphere[0];
    gen_point(rng, p, s->ctr);
    s->rad = gen_log(rng, p->w);
    double deep = (double)s->rad * sph_rng_range(rng, 0, gen_one_in(rng, 4) ? 1 : 0.999);
    gen_unit(rng, n);
    for (int i = 0; i < 3; i++)
        c->ray.org[i] = gen_clamp(p, s->ctr[i] + (int64_t)(n[i] * deep));
    if (gen_one_in(rng, 16))
        for (int i = 0; i < 3; i++)
            c->ray.org[i] = s->ctr[i];
    gen_unit(rng, n);
    for (int i = 0; i < 3; i++)
        to[i] = (double)c->ray.org[i] + n[i];
    gen_aim(rng, p, to, 1, c);
}

void gen_axis(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    int axis = (int)vec_pick(rng, 0, 2), kind = (int)vec_pick(rng, 0, 3);
    struct sph_leaf *s = &c->sphere[0];
    gen_point(rng, p, c->ray.org);
    s->rad = gen_log(rng, p->w - 1);
    for (int i = 0; i < 3; i++) {
        s->ctr[i] = gen_clamp(p, c->ray.org[i] + vec_pick(rng, -s->rad - 1, s->rad + 1));
        if (i == axis) s->ctr[i] = vec_pick(rng, -gen_half(p), gen_half(p) - 1);
        int64_t d = gen_sign(rng) * gen_log(rng, p->wd - 1);
        if (kind < 2 && i != axis) d = 0;               /* along an axis */
        if (kind == 1 && i == axis) d = d < 0 ? -1 : 1; /* the shortest */
        if (kind == 2 && i != axis) d = gen_sign(rng) * vec_pick(rng, 0, 1);
        if (kind == 3 && i == axis) d = 0; /* in a plane */
        c->ray.dir[i] = d;
    }
    if (kind == 3) s->ctr[axis] = gen_clamp(p, c->ray.org[axis] + vec_pick(rng, -s->rad, s->rad));
}

void gen_corner(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    int ends = gen_one_in(rng, 3); /* nothing but the ends of the ranges */
    int64_t half = gen_half(p), most = 1ll << (p->wd - 1);
    for (int i = 0; i < 3; i++) {
        uint64_t r = sph_rng_next(rng);
        c->ray.org[i] = ends ? (r & 1 ? -half : half - 1) : vec_signed(rng, p->w);
        c->sphere[0].ctr[i] = ends ? (r & 2 ? -half : half - 1) : vec_signed(rng, p->w);
        c->ray.dir[i] = ends ? (r & 4 ? -most : most - 1) : vec_signed(rng, p->wd);
    }
    c->sphere[0].rad = (int64_t)vec_unsigned(rng, p->w);
    if (ends && gen_one_in(rng, 2)) c->sphere[0].rad = 2 * half - 1 - vec_pick(rng, 0, 1);
}

void gen_rad0(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    gen_corner(rng, p, c);
    c->sphere[0].rad = 0;
    if (gen_one_in(rng, 4)) return;
    int64_t unit[3], steps = vec_pick(rng, 1, 1000);
    int64_t length = gen_log(rng, p->wd - 3);
    for (int i = 0; i < 3; i++) { /* exactly through the centre */
        unit[i] = vec_pick(rng, -3, 3);
        c->ray.dir[i] = unit[i] * length;
        c->sphere[0].ctr[i] = gen_clamp(p, c->ray.org[i] + steps * unit[i]);
    }
}

void gen_dir0(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    gen_corner(rng, p, c);
    for (int i = 0; i < 3; i++) {
        c->ray.dir[i] = 0;
        if (gen_one_in(rng, 3)) c->sphere[0].ctr[i] = c->ray.org[i];
    }
    if (gen_one_in(rng, 2)) c->ray.kind = SPH_SHADOW;
}
