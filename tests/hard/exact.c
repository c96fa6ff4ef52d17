/* exact.c - see exact.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "exact.h"

#include <gmp.h>
#include <math.h>

/* Sets whole and part of a*t = b -+ sqrt(disc): the root from a floating one, put right. */
static void split(struct exact *e) {
    uint64_t s = (uint64_t)sqrtl((long double)e->disc);
    while ((sph_i128)s * s > e->disc)
        s--;
    while ((sph_i128)(s + 1) * (s + 1) <= e->disc)
        s++;
    uint64_t rest = (uint64_t)(e->disc - (sph_i128)s * s); /* <= 2s */
    long double fraction = (long double)rest / (sqrtl((long double)e->disc) + (long double)s);
    e->whole = e->b + e->root * (int64_t)s;
    e->part = fraction;
    if (e->root == EXACT_NEAR && rest) {
        e->whole--;
        e->part = 1 - fraction;
    }
}

static int end_outside(const struct sph_ray *ray, const struct sph_leaf *leaf) {
    int64_t sum = 0;
    for (int i = 0; i < 3; i++) {
        int64_t v = ray->org[i] + ray->dir[i] - leaf->ctr[i];
        sum += v * v;
    }
    return sum > leaf->rad * leaf->rad;
}

struct exact exact_leaf(const struct sph_ray *ray, const struct sph_leaf *leaf) {
    struct exact e = {0};
    const int64_t *d = ray->dir;
    int64_t oc[3];
    for (int i = 0; i < 3; i++) {
        oc[i] = leaf->ctr[i] - ray->org[i];
        e.a += d[i] * d[i];
        e.b += oc[i] * d[i];
    }
    e.disc = (sph_i128)(leaf->rad * leaf->rad) * e.a;
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        int64_t cross = oc[j] * d[k] - oc[k] * d[j];
        e.disc -= (sph_i128)cross * cross;
    }
    int own = leaf->id == ray->skip.id;
    if (own && !(ray->skip.inside && ray->inside)) return e;
    if (own && ray->kind == SPH_SHADOW) {
        e.hit = e.far = end_outside(ray, leaf);
        return e;
    }
    sph_i128 bb = (sph_i128)e.b * e.b;
    if (e.disc > 0) {
        if (!own && e.b > 0 && bb > e.disc)
            e.root = EXACT_NEAR;
        else if ((e.b >= 0 || e.disc > bb) && ray->inside)
            e.root = EXACT_FAR;
    }
    if (e.root && ray->kind == SPH_SHADOW && exact_compare(&e, e.a) >= 0) e.root = EXACT_NONE;
    e.exit = own && !e.root;
    e.hit = e.root != EXACT_NONE || e.exit;
    e.far = e.hit && (own || e.root == EXACT_FAR);
    if (e.root) split(&e);
    return e;
}

int exact_compare(const struct exact *e, int64_t n) {
    int64_t x = n - e->b; /* a*t - n = -+sqrt(disc) - x */
    sph_i128 xx = (sph_i128)x * x;
    if (e->root == EXACT_FAR) return x < 0 || xx < e->disc ? 1 : xx > e->disc ? -1 : 0;
    return x >= 0 || xx < e->disc ? -1 : xx > e->disc ? 1 : 0;
}

static void set_i128(mpz_t z, sph_i128 v) {
    sph_u128 u = v < 0 ? -(sph_u128)v : (sph_u128)v;
    mpz_set_ui(z, (uint64_t)(u >> 64));
    mpz_mul_2exp(z, z, 64);
    mpz_add_ui(z, z, (uint64_t)u);
    if (v < 0) mpz_neg(z, z);
}

/* Sign of c + p*sqrt(u) + q*sqrt(v), p and q 1 or -1, u and v > 0: by squaring twice. */
static int sign_of(int64_t c, int p, sph_i128 u, int q, sph_i128 v) {
    mpz_t uu, vv, left, right;
    int sign, roots = p == q ? p : u == v ? 0 : (u > v ? p : q); /* of p*sqrt(u) + q*sqrt(v) */
    if (c == 0 || roots == 0) return roots ? roots : (c > 0) - (c < 0);
    if ((c > 0) == (roots > 0)) return roots;
    mpz_inits(uu, vv, left, right, NULL);
    set_i128(uu, u);
    set_i128(vv, v);
    mpz_set_si(left, c); /* |roots|^2 - c^2 = u + v - c^2 + 2pq sqrt(uv) */
    mpz_mul(left, left, left);
    mpz_sub(left, uu, left);
    mpz_add(left, left, vv);
    mpz_mul(right, uu, vv);
    mpz_mul_2exp(right, right, 2);
    int first = mpz_sgn(left);
    mpz_mul(left, left, left);
    int more = mpz_cmp(left, right); /* of the squares of both sides */
    if (p == q)
        sign = first >= 0 ? 1 : -more; /* left + sqrt(right) */
    else
        sign = first <= 0 ? -1 : more; /* left - sqrt(right) */
    mpz_clears(uu, vv, left, right, NULL);
    return sign * roots;
}

int exact_order(const struct exact *e1, const struct exact *e2) {
    if (e1->whole - e2->whole > 1) return 1;
    if (e2->whole - e1->whole > 1) return -1;
    long double apart = (long double)(e1->whole - e2->whole) + (e1->part - e2->part);
    if (fabsl(apart) > 0x1p-40L) return apart > 0 ? 1 : -1;
    return sign_of(e1->b - e2->b, e1->root, e1->disc, -e2->root, e2->disc);
}

int exact_against(const struct exact *e, int64_t whole, sph_i128 part, sph_i128 of) {
    int first = exact_compare(e, whole), past = exact_compare(e, whole + 1);
    if (first < 0 || past >= 0) return first < 0 ? -1 : 1;
    if (first == 0) return part ? -1 : 0;
    long double apart = e->part - (long double)part / (long double)of;
    if (fabsl(apart) > 0x1p-40L) return apart > 0 ? 1 : -1;
    mpz_t c, d, root; /* c +- d sqrt(disc), c = (b - whole) of - part, d = of */
    mpz_inits(c, d, root, NULL);
    set_i128(d, of);
    mpz_mul_si(c, d, e->b - whole);
    set_i128(root, part);
    mpz_sub(c, c, root);
    set_i128(root, e->disc);
    mpz_mul(root, root, d);
    mpz_mul(root, root, d);
    int side = mpz_sgn(c);
    mpz_mul(c, c, c);
    int more = mpz_cmp(c, root); /* |c| is more than the root */
    mpz_clears(c, d, root, NULL);
    return side == e->root || !side ? e->root : more > 0 ? side : more < 0 ? e->root : 0;
}

double exact_key_error(const struct exact *e, uint64_t key) {
    return (double)(((long double)((int64_t)key - e->whole) - e->part) / sqrtl((long double)e->a));
}

long double exact_t(const struct exact *e) {
    return ((long double)e->whole + e->part) / (long double)e->a;
}
