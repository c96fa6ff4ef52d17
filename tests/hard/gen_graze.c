/* gen_graze.c - families where hit and miss, or near and far, are a hair apart
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>

#include "gen.h"

/* A frame u, v, w of length n: a sphere of radius n*m at along*u + aside*v' touches the line in
 * direction u if v' is a multiple of v, of length n*m. */
void gen_graze0(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    struct sph_leaf *s = &c->sphere[0];
    int64_t u[3], v[3], w[3], most = 1ll << ((p->w - 2) / 2), length;
    do {
        int64_t n = gen_frame(rng, (int64_t)sqrt((double)vec_pick(rng, 1, most)), u, v, w);
        int64_t along = gen_sign(rng) * gen_log(rng, p->w - 1) / n + gen_sign(rng);
        int64_t aside = gen_sign(rng) * (gen_log(rng, p->w - 2) / n + 1);
        int64_t room = ((1ll << (p->wd - 1)) - 1) / n;
        length = room ? vec_pick(rng, 1, room) : 1;
        if (gen_one_in(rng, 3)) length = 1;
        s->rad = n * (aside < 0 ? -aside : aside);
        for (int i = 0; i < 3; i++) {
            c->ray.org[i] = vec_pick(rng, -gen_half(p), gen_half(p) - 1) / 2;
            c->ray.dir[i] = length * u[i];
            s->ctr[i] = c->ray.org[i] + along * u[i] + aside * v[i];
        }
    } while (!gen_on_grid(p, s->ctr) || s->rad >= 2 * gen_half(p));
}

/* 2 R^2 - q^2 = 1 or -1: the distance q/sqrt(2) of a diagonal ray is next to R. */
static void pell(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    struct sph_leaf *s = &c->sphere[0];
    int64_t q = 1, r = 1, d = gen_log(rng, p->wd - 1), next;
    int axis = (int)vec_pick(rng, 0, 2), turn = (int)gen_sign(rng);
    for (int i = (int)vec_pick(rng, 0, 30); i > 0 && q + 2 * r < gen_half(p); i--) {
        next = q + 2 * r;
        r += q;
        q = next;
    }
    int64_t along = vec_pick(rng, 0, gen_half(p) - 1 - q);
    for (int i = 0; i < 3; i++) {
        c->ray.org[i] = 0;
        c->ray.dir[i] = i == axis ? 0 : d;
        s->ctr[i] = i == axis ? 0 : along;
    }
    c->ray.dir[(axis + 1) % 3] *= turn;
    s->ctr[(axis + 1) % 3] = turn * along - turn * q;
    s->rad = r;
}

void gen_graze1(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    struct sph_leaf *s = &c->sphere[0];
    int i = (int)vec_pick(rng, 0, 2), turn = (int)gen_sign(rng);
    switch (vec_pick(rng, 0, 5)) {
    case 0:
        pell(rng, p, c);
        return;
    case 1:
    case 2: /* radius next to the distance, from double: right within a unit */
        do
            vec_ray(rng, p, &c->ray);
        while (!vec_grazed(rng, p, &c->ray, 1, s));
        s->id = HARD_ID;
        return;
    default:
        break;
    }
    gen_graze0(rng, p, c);
    int which = (int)vec_pick(rng, 0, 2);
    if (which == 0 && s->rad + turn < 2 * gen_half(p)) s->rad += turn;
    if (which == 1) s->ctr[i] = gen_clamp(p, s->ctr[i] + turn);
    if (which == 2) c->ray.dir[i] += c->ray.dir[i] > 0 ? -1 : 1;
}

/* Moves the origin of the case to the rounded point where an aimed ray hits its sphere; *n is the
 * normal there. */
static void to_surface(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c,
                       double n[3]) {
    struct sph_leaf *s = &c->sphere[0];
    do {
        gen_point(rng, p, s->ctr);
        s->rad = gen_log(rng, p->w - 1);
        gen_unit(rng, n);
        for (int i = 0; i < 3; i++)
            c->ray.org[i] = s->ctr[i] + (int64_t)rint(n[i] * (double)s->rad);
    } while (!gen_on_grid(p, c->ray.org));
}

/* A direction on the side of n (side 1) or against it, weighted towards the surface. */
static void leave(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c,
                  const double n[3], double side) {
    double d[3], along = 0, to[3];
    gen_unit(rng, d);
    for (int i = 0; i < 3; i++)
        along += d[i] * n[i];
    double part = gen_one_in(rng, 2) ? fabs(along) : sph_rng_range(rng, 0, 2e-3);
    for (int i = 0; i < 3; i++)
        to[i] = (double)c->ray.org[i] + d[i] + (side * part - along) * n[i];
    gen_aim(rng, p, to, 3, c);
}

void gen_surf_out(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    double n[3];
    to_surface(rng, p, c, n);
    leave(rng, p, c, n, 1);
    if (gen_one_in(rng, 2)) c->ray.skip = (struct sph_skip){HARD_ID, 0};
}

void gen_surf_in(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    double n[3];
    to_surface(rng, p, c, n);
    leave(rng, p, c, n, -1);
    if (gen_one_in(rng, 2)) c->ray.skip = (struct sph_skip){HARD_ID, 1};
}

/* The own sphere from either side and another one that may hide it. */
void gen_own(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    double n[3];
    int64_t light[3];
    to_surface(rng, p, c, n);
    int inside = !gen_one_in(rng, 4);
    leave(rng, p, c, n, gen_one_in(rng, 8) == inside ? 1 : -1);
    c->ray.kind = SPH_REFLECTED;
    c->ray.skip = (struct sph_skip){HARD_ID, inside};
    c->n = 2;
    c->sphere[1].rad = gen_log(rng, p->w - 1);
    for (int i = 0; i < 3; i++)
        c->sphere[1].ctr[i] = gen_clamp(
            p, c->ray.org[i] + vec_pick(rng, -2 * c->sphere[1].rad, 2 * c->sphere[1].rad));
    if (!gen_one_in(rng, 4)) return;
    for (int i = 0; i < 3; i++)
        light[i] =
            gen_clamp(p, c->sphere[0].ctr[i] + vec_pick(rng, -c->sphere[0].rad, c->sphere[0].rad));
    gen_shadow(p, light, c);
}

void gen_shadows(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    struct sph_leaf *s = &c->sphere[0];
    int64_t u[3], v[3], w[3], light[3];
    int placed = 0;
    do { /* the light at ctr + m*u, on the surface; moved by at most one unit */
        int64_t n = gen_frame(rng, 1ll << vec_pick(rng, 0, (p->w - 3) / 2), u, v, w);
        int64_t m = gen_log(rng, p->w - 1) / n + 1, which = vec_pick(rng, 0, 3);
        gen_point(rng, p, s->ctr);
        gen_point(rng, p, c->ray.org);
        s->rad = n * m;
        for (int i = 0; i < 3; i++) {
            light[i] = s->ctr[i] + m * u[i] + (which == 1 ? vec_pick(rng, -1, 1) : 0);
            if (which == 2) light[i] = s->ctr[i] + vec_pick(rng, -s->rad, s->rad);
            if (which == 3) c->ray.org[i] = s->ctr[i] + m * v[i] + vec_pick(rng, -1, 1);
        }
        placed = gen_on_grid(p, c->ray.org) && s->rad < 2 * gen_half(p);
    } while (!placed || !gen_shadow(p, light, c));
}
