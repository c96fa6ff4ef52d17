/* exact.h - ray and sphere in exact integers of fixed width: the fast oracle
 * SPDX-License-Identifier: Apache-2.0
 *
 * Lagrange's discriminant rad^2*a - |oc x dir|^2 needs at most 2W+2WD+2 = 100 bits, so that nothing
 * wraps in 128. There is no hit rule: signs of roots are found by squaring. The naive model, in
 * unbounded integers, checks a share of its answers.
 */
#ifndef HARD_EXACT_H
#define HARD_EXACT_H

#include "hard.h"
#include "math/fx.h"

enum { EXACT_NEAR = -1, EXACT_NONE = 0, EXACT_FAR = 1 };

struct exact {
    int64_t a, b;
    sph_i128 disc;
    int hit, far, exit; /* after the rules of skip, shadow and inside */
    int root;           /* which root the hit is; EXACT_NONE without one */
    /* of a hit with a root: a*t = whole + part, 0 <= part < 1; exact but for 2^-60 of part */
    int64_t whole;
    long double part;
};

/* Decides ray and sphere; of *ray org, dir, kind, skip and inside are read. */
struct exact exact_leaf(const struct sph_ray *ray, const struct sph_leaf *leaf);

/* Sign of a*t - n, exactly. */
int exact_compare(const struct exact *e, int64_t n);

/* Sign of t1 - t2 of two hits of one ray, exactly. */
int exact_order(const struct exact *e1, const struct exact *e2);

/* Sign of a*t - whole - part / of, 0 <= part < of, exactly. */
int exact_against(const struct exact *e, int64_t whole, sph_i128 part, sph_i128 of);

/* (key - a*t) / |dir|: grid units along the ray. */
double exact_key_error(const struct exact *e, uint64_t key);

/* The value of t, to 2^-60. */
long double exact_t(const struct exact *e);

#endif
