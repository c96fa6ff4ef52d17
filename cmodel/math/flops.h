/* flops.h - arithmetic on real numbers that counts itself
 * SPDX-License-Identifier: Apache-2.0
 *
 * What is counted is what was done: the functions that choose levels, and those that make P_b, do
 * their sums through these. Comparisons, and signs turned over, are free.
 */
#ifndef SPH_FLOPS_H
#define SPH_FLOPS_H

#include <math.h>
#include <stdint.h>

struct sph_flops {
    uint64_t add; /* additions and subtractions */
    uint64_t mul, div, root, log;
};

static inline double sph_f_add(struct sph_flops *f, double a, double b) {
    f->add++;
    return a + b;
}

static inline double sph_f_sub(struct sph_flops *f, double a, double b) {
    f->add++;
    return a - b;
}

static inline double sph_f_mul(struct sph_flops *f, double a, double b) {
    f->mul++;
    return a * b;
}

static inline double sph_f_div(struct sph_flops *f, double a, double b) {
    f->div++;
    return a / b;
}

static inline double sph_f_root(struct sph_flops *f, double a) {
    f->root++;
    return sqrt(a);
}

static inline double sph_f_log2(struct sph_flops *f, double a) {
    f->log++;
    return log2(a);
}

static inline double sph_f_dot(struct sph_flops *f, const double a[3], const double b[3]) {
    double sum = sph_f_add(f, sph_f_mul(f, a[0], b[0]), sph_f_mul(f, a[1], b[1]));
    return sph_f_add(f, sum, sph_f_mul(f, a[2], b[2]));
}

static inline void sph_f_cross(struct sph_flops *f, const double a[3], const double b[3],
                               double out[3]) {
    for (int i = 0; i < 3; i++)
        out[i] = sph_f_sub(f, sph_f_mul(f, a[(i + 1) % 3], b[(i + 2) % 3]),
                           sph_f_mul(f, a[(i + 2) % 3], b[(i + 1) % 3]));
}

/* a - b of n numbers. */
static inline void sph_f_minus(struct sph_flops *f, int n, const double *a, const double *b,
                               double *out) {
    for (int i = 0; i < n; i++)
        out[i] = sph_f_sub(f, a[i], b[i]);
}

static inline void sph_flops_add(struct sph_flops *to, const struct sph_flops *more) {
    to->add += more->add;
    to->mul += more->mul;
    to->div += more->div;
    to->root += more->root;
    to->log += more->log;
}

#endif
