/* enclose.c - the smallest sphere around spheres (farthest-first pivoting); see bound.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * The smallest enclosing sphere is fixed by a support of one to four spheres that touch it from
 * inside. A sphere that sticks out of it belongs to the support of the next, larger one
 * (Fischer, Gaertner: The smallest enclosing ball of balls). So: take the farthest sphere, try
 * every subset of the support with it, keep the smallest that holds them all, repeat.
 * The result steers quality only; what is stored is made safe in integers afterwards.
 */
#include <math.h>
#include <string.h>

#include "builder/grid/bound.h"

struct real_ball {
    double c[3], r;
};

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static double distance(const double a[3], const double b[3]) {
    double d[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    return sqrt(dot(d, d));
}

/* Solves the m x m system g x = rhs for two right sides, m <= 3. 0 if it is singular. */
static inline int solve(int m, double g[3][5]) {
    for (int col = 0; col < m; col++) {
        int pivot = col;
        for (int row = col + 1; row < m; row++)
            if (fabs(g[row][col]) > fabs(g[pivot][col])) pivot = row;
        if (fabs(g[pivot][col]) < 1e-9) return 0;
        for (int j = 0; j < 5; j++) {
            double swap = g[col][j];
            g[col][j] = g[pivot][j], g[pivot][j] = swap;
        }
        for (int row = 0; row < m; row++) {
            if (row == col) continue;
            double f = g[row][col] / g[col][col];
            for (int j = 0; j < 5; j++)
                g[row][j] -= f * g[col][j];
        }
    }
    return 1;
}

/* Whether the sphere holds the ball, up to rounding. */
static int holds(const struct real_ball *sphere, const struct real_ball *ball) {
    return distance(sphere->c, ball->c) + ball->r <= sphere->r + 1e-7 * (1 + sphere->r);
}

/* The smaller sphere, centred in the hull of the m balls, that touches all from inside and holds
 * the n balls `all`. With v = c - c0: v.d_i = e_i + f_i R, |v| = R - r0. 0 if there is none. */
static inline int tangent(int m, const struct real_ball *const b[4], int n,
                          const struct real_ball *const all[5], struct real_ball *out) {
    double d[3][3] = {{0}}, g[3][5], va[3] = {0}, vb[3] = {0};
    const struct real_ball *o = b[0];
    memset(g, 0, sizeof g);
    for (int i = 1; i < m; i++) {
        for (int j = 0; j < 3; j++)
            d[i - 1][j] = b[i]->c[j] - o->c[j];
        g[i - 1][3] = (dot(d[i - 1], d[i - 1]) + o->r * o->r - b[i]->r * b[i]->r) / 2;
        g[i - 1][4] = b[i]->r - o->r;
    }
    for (int i = 0; i < m - 1; i++)
        for (int j = 0; j < m - 1; j++)
            g[i][j] = dot(d[i], d[j]);
    if (!solve(m - 1, g)) return 0;
    for (int i = 0; i < m - 1; i++)
        for (int j = 0; j < 3; j++) {
            va[j] += g[i][3] / g[i][i] * d[i][j];
            vb[j] += g[i][4] / g[i][i] * d[i][j];
        }
    double qa = dot(vb, vb) - 1, qb = dot(va, vb) + o->r, qc = dot(va, va) - o->r * o->r;
    double disc = qb * qb - qa * qc, roots[2];
    if (disc < 0 || fabs(qa) < 1e-12) return 0;
    roots[0] = (-qb + sqrt(disc)) / qa, roots[1] = (-qb - sqrt(disc)) / qa;
    if (roots[0] > roots[1]) roots[0] = roots[1], roots[1] = (-qb + sqrt(disc)) / qa;
    for (int root = 0; root < 2; root++) {
        struct real_ball s = {.r = roots[root]};
        for (int j = 0; j < 3; j++)
            s.c[j] = o->c[j] + va[j] + vb[j] * s.r;
        int good = s.r > 0;
        for (int i = 0; i < n && good; i++)
            good = holds(&s, all[i]);
        if (good) {
            *out = s;
            return 1;
        }
    }
    return 0;
}

/* The same, made by a compiler that knows m. */
static int tangent_to(int m, const struct real_ball *const b[4], int n,
                      const struct real_ball *const all[5], struct real_ball *out) {
    switch (m) {
    case 1:
        *out = *b[0];
        for (int i = 1; i < n; i++)
            if (!holds(out, all[i])) return 0;
        return 1;
    case 2:
        return tangent(2, b, n, all, out);
    case 3:
        return tangent(3, b, n, all, out);
    default:
        return tangent(4, b, n, all, out);
    }
}

/* The smallest sphere that touches `fresh` and holds it and the support, which it replaces.
 * 0 if rounding leaves none. */
static int pivot(struct real_ball support[4], int *n_support, const struct real_ball *fresh,
                 struct real_ball *sphere) {
    struct real_ball best = {.r = HUGE_VAL};
    const struct real_ball *all[5] = {fresh};
    int best_set = -1, n = *n_support;
    for (int i = 0; i < n; i++)
        all[i + 1] = &support[i];
    for (int set = 0; set < 1 << n; set++) {
        const struct real_ball *use[5] = {fresh};
        struct real_ball s;
        int m = 1;
        for (int i = 0; i < n; i++)
            if (set >> i & 1) use[m++] = &support[i];
        if (m > 4 || !tangent_to(m, use, n + 1, all, &s)) continue;
        if (s.r < best.r) best = s, best_set = set;
    }
    if (best_set < 0) return 0;
    int m = 0;
    for (int i = 0; i < n; i++)
        if (best_set >> i & 1) support[m++] = support[i];
    support[m++] = *fresh;
    *n_support = m;
    *sphere = best;
    return 1;
}

static struct real_ball real_ball(const struct sph_ball *b) {
    return (struct real_ball){.c = {b->c[0], b->c[1], b->c[2]}, .r = b->r};
}

/* The ball that reaches farthest from a point, the first of equal ones; *most: how far. A ball that
 * is nearer than the farthest one by more than roundings takes no root. */
static uint32_t farthest(const double c[3], const struct sph_ball *balls, const uint32_t *index,
                         uint32_t n, double *most) {
    uint32_t far = 0;
    double best = -1, near = -1; /* a little less than best */
    for (uint32_t i = 0; i < n; i++) {
        const struct sph_ball *b = &balls[index ? index[i] : i];
        double x = c[0] - b->c[0], y = c[1] - b->c[1], z = c[2] - b->c[2], room = near - b->r;
        double sum = x * x + y * y + z * z;
        if (room > 0 && sum < room * room) continue;
        double reach = sqrt(sum) + b->r;
        if (reach > best) best = reach, near = best * (1 - 1e-12), far = i;
    }
    *most = best;
    return far;
}

void sph_enclose(const struct sph_ball *balls, const uint32_t *index, uint32_t n, double out[4]) {
    enum { PASSES = 40 };
    struct real_ball support[4], sphere = real_ball(&balls[index ? index[0] : 0]);
    int n_support = 1;
    support[0] = sphere;
    for (int pass = 0; pass < PASSES; pass++) {
        double most, before = sphere.r;
        uint32_t far = farthest(sphere.c, balls, index, n, &most);
        if (most <= sphere.r * (1 + 1e-6) + 1e-6) break;
        struct real_ball fresh = real_ball(&balls[index ? index[far] : far]);
        if (!pivot(support, &n_support, &fresh, &sphere) || sphere.r <= before) {
            sphere.r = most;
            break;
        }
    }
    for (int j = 0; j < 3; j++)
        out[j] = sphere.c[j];
    out[3] = sphere.r;
}
