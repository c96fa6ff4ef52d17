/* gen_pair.c - families about order, root, quotient, surface point and node filter
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>

#include "gen.h"

void gen_through(struct sph_rng *rng, const struct sph_profile *p, const int64_t at[3],
                 struct sph_leaf *s) {
    int64_t u[3], v[3], w[3];
    do {
        int64_t n = gen_frame(rng, 1ll << vec_pick(rng, 0, (p->w - 3) / 2), u, v, w);
        int64_t m = gen_sign(rng) * (gen_log(rng, p->w - 1) / n + 1);
        s->rad = n * (m < 0 ? -m : m);
        for (int i = 0; i < 3; i++)
            s->ctr[i] = at[i] + m * u[i];
    } while (!gen_on_grid(p, s->ctr) || s->rad >= 2 * gen_half(p));
}

void gen_pair(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    int64_t at[3], longest = 1;
    c->n = 2;
    gen_point(rng, p, at);
    gen_point(rng, p, c->ray.org);
    for (int i = 0; i < 3; i++) {
        c->ray.dir[i] = at[i] - c->ray.org[i];
        int64_t size = c->ray.dir[i] < 0 ? -c->ray.dir[i] : c->ray.dir[i];
        longest = size > longest ? size : longest;
    }
    int64_t scale = vec_pick(rng, 1, ((1ll << (p->wd - 1)) - 1) / longest);
    for (int i = 0; i < 3; i++)
        c->ray.dir[i] *= scale;
    gen_through(rng, p, at, &c->sphere[0]);
    gen_through(rng, p, at, &c->sphere[1]);
    int which = (int)vec_pick(rng, 0, 3), i = (int)vec_pick(rng, 0, 2);
    if (which == 0) c->sphere[1].rad += c->sphere[1].rad > 1 ? -1 : 1;
    if (which == 1) c->sphere[1].ctr[i] = gen_clamp(p, c->sphere[1].ctr[i] + gen_sign(rng));
    if (which == 2 && c->ray.dir[i]) c->ray.dir[i] += c->ray.dir[i] > 0 ? -1 : 1;
}

void gen_concentric(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    if (gen_one_in(rng, 3))
        gen_inside(rng, p, c);
    else
        gen_random(rng, p, c);
    c->n = 2;
    c->sphere[1] = c->sphere[0];
    c->sphere[1].id = HARD_OTHER;
    int64_t more = vec_pick(rng, -3, 3);
    if (gen_one_in(rng, 4)) more = 0;
    int64_t rad = c->sphere[1].rad + more;
    if (rad >= 0 && rad < 2 * gen_half(p)) c->sphere[1].rad = rad;
}

/* Along an axis at distance y of the centre: disc = m^2 (R^2 - y^2). */
void gen_root(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    struct sph_leaf *s = &c->sphere[0];
    int64_t u[3], v[3], w[3], off[3] = {0, 0, 0}, half = gen_half(p);
    int axis = (int)vec_pick(rng, 0, 2), j = (axis + 1) % 3, k = (axis + 2) % 3;
    int64_t q = 0;
    do
        switch (vec_pick(rng, 0, 3)) {
        case 0: /* R^2 - y^2 - z^2 is a square */
            s->rad = gen_frame(rng, 1ll << vec_pick(rng, 0, (p->w - 4) / 2), u, v, w);
            off[j] = u[j], off[k] = u[k];
            break;
        case 1: /* one below a square: R = q, y = 1 */
            s->rad = gen_log(rng, p->w - 1);
            off[j] = 1, off[k] = 0;
            break;
        case 2: /* one above a square: (R-y)(R+y) = q^2 + 1 with R - y = 1, q even */
            q = 2 * gen_log(rng, p->w / 2 - 2);
            off[j] = q * q / 2, off[k] = 0;
            s->rad = off[j] + 1;
            break;
        default: /* a power of two, one unit more, one less */
            s->rad = (1ll << vec_pick(rng, 1, p->w - 2)) + vec_pick(rng, -1, 1);
            off[j] = vec_pick(rng, 0, 1), off[k] = 0;
        }
    while (s->rad >= 2 * half || off[j] >= half || off[k] >= half || off[j] < -half ||
           off[k] < -half);
    for (int i = 0; i < 3; i++) {
        c->ray.org[i] = i == axis ? vec_pick(rng, -half, half - 1) : 0;
        s->ctr[i] = i == axis ? vec_pick(rng, -half, half - 1) : off[i];
    }
    c->ray.dir[axis] = gen_sign(rng) * (gen_one_in(rng, 2) ? 1 : gen_log(rng, p->wd - 1));
}

void gen_quotient(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    struct sph_leaf *s = &c->sphere[0];
    int64_t half = gen_half(p), end = 1ll << (p->wd - 1), most = 2 * half - 1;
    int64_t length = 1ll << vec_pick(rng, 0, p->wd - 2), steps = vec_pick(rng, 1, half);
    int kind = (int)vec_pick(rng, 0, 3), axis = (int)vec_pick(rng, 0, 2);
    if (kind == 1) length = end - 1;
    if (kind == 2) length = gen_log(rng, p->wd - 1);
    for (int i = 0; i < 3; i++) {
        int diagonal = kind == 3;
        c->ray.dir[i] = diagonal || i == axis ? length : 0;
        if (diagonal && gen_one_in(rng, 2)) c->ray.dir[i] = -end; /* a greatest, if all three */
        int64_t way = c->ray.dir[i] < 0 ? -1 : c->ray.dir[i] > 0;
        int64_t org = -way * vec_pick(rng, 0, 1) - way * (half - 1 - vec_pick(rng, 0, 3));
        c->ray.org[i] = gen_clamp(p, org);
        s->ctr[i] = gen_clamp(p, c->ray.org[i] + way * steps);
    }
    s->rad = gen_one_in(rng, 2) ? vec_pick(rng, 1, steps) : gen_log(rng, p->w - 1);
    if (gen_one_in(rng, 4)) s->rad = steps < most ? steps + 1 : most; /* just inside */
    if (gen_one_in(rng, 2)) /* a little off: t not whole by a little */
        s->ctr[(axis + 1) % 3] = gen_clamp(p, s->ctr[(axis + 1) % 3] + vec_pick(rng, -2, 2));
}

void gen_surface(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    struct sph_leaf *s = &c->sphere[0];
    int64_t half = gen_half(p);
    double to[3];
    int which = (int)vec_pick(rng, 0, 3);
    if (which == 0) { /* grazing hits: the mirror ray nearly goes on */
        gen_graze1(rng, p, c);
        return;
    }
    for (int i = 0; i < 3; i++) {
        s->ctr[i] = which == 1 || gen_one_in(rng, 2)
                        ? gen_clamp(p, gen_sign(rng) * (half - vec_pick(rng, 0, 4)))
                        : vec_pick(rng, -half, half - 1);
        c->ray.org[i] = vec_pick(rng, -half, half - 1);
    }
    s->rad = which == 1 ? vec_pick(rng, 1, 2) : gen_log(rng, p->w);
    for (int i = 0; i < 3; i++) {
        if (which == 3) /* from inside, out of the grid */
            c->ray.org[i] = gen_clamp(p, s->ctr[i] + vec_pick(rng, -s->rad, s->rad) / 2);
        double r = (double)s->rad * (which == 3 ? 2 : 1);
        to[i] = (double)s->ctr[i] + sph_rng_range(rng, -r, r);
    }
    gen_aim(rng, p, to, 6, c);
}

/* The centre on a filter point, a radius that fills its filter units, the ray at 0.9995 of it on
 * the side from which rounding moves the origin; origins at the grid's end, which saturate. */
void gen_filter(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c) {
    struct sph_leaf *s = &c->sphere[0];
    int64_t unit = 1ll << (p->w - p->fw), half = gen_half(p), turn = gen_sign(rng);
    double side[3], to[3], dot = 0, length2 = 1e-9, size2 = 1e-9;
    int saturate = gen_one_in(rng, 3);
    s->rad = unit * (gen_one_in(rng, 2) ? vec_pick(rng, 1, 40) : gen_log(rng, p->fw - 3)) -
             vec_pick(rng, 0, 1);
    for (int i = 0; i < 3; i++) {
        int up = (int)(sph_rng_next(rng) & 1);
        c->ray.org[i] = vec_pick(rng, -half / unit, half / unit - 1) * unit;
        c->ray.org[i] += unit > 1 ? unit / 2 - !up : 0;
        if (saturate && gen_one_in(rng, 2)) c->ray.org[i] = half - vec_pick(rng, 1, 2), up = 0;
        s->ctr[i] = vec_pick(rng, -half / unit, half / unit - 1) * unit;
        if (gen_one_in(rng, 7)) s->ctr[i] += vec_pick(rng, 0, unit - 1);
        side[i] = gen_one_in(rng, 5) ? sph_rng_range(rng, -1, 1) : (double)(up ? turn : -turn);
        to[i] = (double)(s->ctr[i] - c->ray.org[i]);
        length2 += to[i] * to[i];
        dot += side[i] * to[i];
    }
    for (int i = 0; i < 3; i++) {
        side[i] -= dot / length2 * to[i];
        size2 += side[i] * side[i];
    }
    for (int i = 0; i < 3; i++)
        to[i] = (double)s->ctr[i] + side[i] / sqrt(size2) * 0.9995 * (double)s->rad;
    gen_aim(rng, p, to, p->wd - 2, c);
}
