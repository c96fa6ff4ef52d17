/* leaf.c - ray and sphere by definition, see naive.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * |org + t*dir - ctr|^2 = rad^2 has the roots t = tau / a with tau = b -+ sqrt(disc).
 */
#include <gmp.h>

#include "naive/naive.h"

struct line { /* what the roots depend on */
    mpz_t a, b, disc, x, y;
};

enum { NEAR = -1, FAR = 1 };

/* sum += p*q for plain integers */
static void add_product(mpz_t sum, int64_t p, int64_t q) {
    mpz_t product;
    mpz_init_set_si(product, p);
    mpz_mul_si(product, product, q);
    mpz_add(sum, sum, product);
    mpz_clear(product);
}

/* Fills in a, b and disc = rad^2 * a - |oc x dir|^2. */
static void line_set(struct line *l, const struct sph_ray *ray, const struct sph_leaf *leaf) {
    const int64_t *d = ray->dir;
    int64_t oc[3];
    mpz_inits(l->a, l->b, l->disc, l->x, l->y, NULL);
    for (int i = 0; i < 3; i++) {
        oc[i] = leaf->ctr[i] - ray->org[i];
        add_product(l->a, d[i], d[i]);
        add_product(l->b, oc[i], d[i]);
    }
    mpz_mul_si(l->disc, l->a, leaf->rad);
    mpz_mul_si(l->disc, l->disc, leaf->rad);
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        mpz_set_si(l->x, 0);
        add_product(l->x, oc[j], d[k]);
        add_product(l->x, oc[k], -d[j]);
        mpz_submul(l->disc, l->x, l->x);
    }
}

static void line_clear(struct line *l) {
    mpz_clears(l->a, l->b, l->disc, l->x, l->y, NULL);
}

/* Sign of tau - n for the near or far root, exactly; disc > 0. */
static int root_cmp(struct line *l, int root, const mpz_t n) {
    mpz_sub(l->x, n, l->b); /* tau - n = -+sqrt(disc) - x */
    mpz_mul(l->y, l->x, l->x);
    if (root == FAR) return mpz_sgn(l->x) < 0 ? 1 : mpz_cmp(l->disc, l->y);
    return mpz_sgn(l->x) >= 0 ? -1 : mpz_cmp(l->y, l->disc);
}

/* The smallest integer n >= 1 with n >= tau, for tau > 0: doubling, then bisection. */
static uint64_t root_key(struct line *l, int root) {
    mpz_t low, high, middle;
    mpz_init_set_si(low, 0);
    mpz_init_set_si(high, 1);
    mpz_init(middle);
    while (root_cmp(l, root, high) > 0)
        mpz_set(low, high), mpz_mul_2exp(high, high, 1);
    for (;;) { /* low < tau <= high */
        mpz_sub(middle, high, low);
        if (mpz_cmp_si(middle, 1) == 0) break;
        mpz_add(middle, high, low);
        mpz_fdiv_q_2exp(middle, middle, 1);
        mpz_set(root_cmp(l, root, middle) > 0 ? low : high, middle);
    }
    uint64_t key = mpz_get_ui(high);
    mpz_clears(low, high, middle, NULL);
    return key;
}

/* b - root, or b + root rounded up, at least 1, for the greatest number m * step <= sqrt(disc) with
 * m < 2^bits and step the least power of two for which the next m would be too great. */
static uint64_t cut_key(struct line *l, int which, int bits) {
    mpz_t step, root, next;
    mpz_inits(root, next, NULL);
    mpz_init_set_si(step, 1);
    for (;;) { /* is 2^bits steps too far? */
        mpz_mul_2exp(next, step, (mp_bitcnt_t)bits);
        mpz_mul(l->y, next, next);
        if (mpz_cmp(l->y, l->disc) > 0) break;
        mpz_mul_2exp(step, step, 1);
    }
    for (int i = bits - 1; i >= 0; i--) {
        mpz_mul_2exp(next, step, (mp_bitcnt_t)i);
        mpz_add(next, next, root);
        mpz_mul(l->y, next, next);
        if (mpz_cmp(l->y, l->disc) <= 0) mpz_set(root, next);
    }
    mpz_mul(l->y, root, root);
    if (which == FAR && mpz_cmp(l->y, l->disc) != 0) mpz_add_ui(root, root, 1);
    mpz_mul_si(root, root, which);
    mpz_add(root, root, l->b);
    uint64_t key = mpz_sgn(root) > 0 ? mpz_get_ui(root) : 1;
    mpz_clears(step, root, next, NULL);
    return key;
}

/* Where org + t*dir lies: 1 outside the sphere, 0 on it, -1 in it. */
static int side(const struct sph_ray *ray, int64_t t, const struct sph_leaf *leaf) {
    mpz_t distance2;
    mpz_init(distance2);
    for (int i = 0; i < 3; i++) {
        int64_t v = ray->org[i] + t * ray->dir[i] - leaf->ctr[i];
        add_product(distance2, v, v);
    }
    add_product(distance2, leaf->rad, -leaf->rad);
    int sign = mpz_sgn(distance2);
    mpz_clear(distance2);
    return sign > 0 ? 1 : sign < 0 ? -1 : 0;
}

struct sph_naive_leaf sph_naive_leaf_bits(const struct sph_ray *ray, const struct sph_leaf *leaf,
                                          int pr) {
    struct sph_naive_leaf r = {0};
    int own = leaf->id == ray->skip.id;
    if (!ray->inside && (own || side(ray, 0, leaf) <= 0)) return r;
    if (own && !ray->skip.inside) return r; /* convex: no way back from outside */
    if (own && ray->kind == SPH_SHADOW) {
        r.far = r.hit = side(ray, 1, leaf) > 0;
        return r;
    }
    struct line l;
    line_set(&l, ray, leaf);
    mpz_t zero;
    mpz_init(zero);
    int root = 0;
    if (mpz_sgn(l.disc) > 0) {
        if (!own && root_cmp(&l, NEAR, zero) > 0)
            root = NEAR;
        else if (root_cmp(&l, FAR, zero) > 0)
            root = FAR;
    }
    if (ray->kind == SPH_SHADOW) {
        r.hit = root && root_cmp(&l, root, l.a) < 0;
    } else if (root) {
        r.hit = 1;
        r.key = pr ? cut_key(&l, root, pr) : root_key(&l, root);
    } else if (own) {
        r.hit = r.exit = 1;
        r.key = 1;
    }
    r.far = r.hit && (root == FAR || own);
    mpz_clear(zero);
    line_clear(&l);
    return r;
}
