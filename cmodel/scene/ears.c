/* ears.c - see ears.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "scene/ears.h"

#include <float.h>
#include <gmp.h>
#include <math.h>
#include <string.h>

#include "scene/polygon.h"

static int exact_turn(const double a[2], const double b[2], const double c[2]) {
    mpq_t from[2], v[4];
    for (int i = 0; i < 2; i++) {
        mpq_init(from[i]);
        mpq_set_d(from[i], a[i]);
    }
    for (int i = 0; i < 4; i++) {
        mpq_init(v[i]);
        mpq_set_d(v[i], (i < 2 ? b : c)[i & 1]);
        mpq_sub(v[i], v[i], from[i & 1]);
    }
    mpq_mul(v[0], v[0], v[3]);
    mpq_mul(v[1], v[1], v[2]);
    int sign = mpq_cmp(v[0], v[1]);
    for (int i = 0; i < 4; i++)
        mpq_clear(v[i]);
    mpq_clear(from[0]);
    mpq_clear(from[1]);
    return (sign > 0) - (sign < 0);
}

/* Shewchuk 1997, orient2d: a difference beyond 4 rounding errors of its terms has the right sign;
 * products so small that they lose bits are left to the exact one. */
int sph_turn(const double a[2], const double b[2], const double c[2]) {
    double p = (b[0] - a[0]) * (c[1] - a[1]), q = (b[1] - a[1]) * (c[0] - a[0]);
    double terms = fabs(p) + fabs(q);
    if (terms > DBL_MIN / DBL_EPSILON && fabs(p - q) > 4 * DBL_EPSILON * terms)
        return p > q ? 1 : -1;
    return exact_turn(a, b, c);
}

struct outline {
    double at[SPH_MAX_CORNERS][2];
    int list[SPH_MAX_CORNERS], n; /* corners that are left */
};

/* The two axes that show most of the polygon, counterclockwise. */
static void project(struct outline *o, const struct sph_vec *corner, int n, struct sph_vec normal) {
    const double along[3] = {normal.x, normal.y, normal.z};
    int k = 0;
    for (int i = 1; i < 3; i++)
        if (fabs(along[i]) > fabs(along[k])) k = i;
    int u = (k + 1) % 3, v = (k + 2) % 3;
    for (int i = 0; i < n; i++) {
        const double p[3] = {corner[i].x, corner[i].y, corner[i].z};
        o->at[i][0] = p[along[k] > 0 ? u : v];
        o->at[i][1] = p[along[k] > 0 ? v : u];
        o->list[i] = i;
    }
    o->n = n;
}

/* Whether two edges cross, each at a point within. */
static int cross(const double a[2], const double b[2], const double c[2], const double d[2]) {
    return sph_turn(a, b, c) * sph_turn(a, b, d) < 0 && sph_turn(c, d, a) * sph_turn(c, d, b) < 0;
}

static int check_crossings(const struct outline *o, struct sph_error *err) {
    for (int i = 0; i < o->n; i++)
        for (int k = i + 2; k < o->n; k++)
            if (cross(o->at[i], o->at[i + 1], o->at[k], o->at[(k + 1) % o->n]))
                return sph_fail(err,
                                "the edges from corner %d and from corner %d of the polygon cross: "
                                "it cannot be cut in triangles",
                                i + 1, k + 1);
    return 0;
}

/* Whether the edge from p to q runs through the inside of triangle a b c: no line of an edge, nor
 * of p and q, has them on different sides. */
static int enters(const double a[2], const double b[2], const double c[2], const double p[2],
                  const double q[2]) {
    const double *corner[4] = {a, b, c, a};
    int left = 0, right = 0;
    for (int i = 0; i < 3; i++) {
        if (sph_turn(corner[i], corner[i + 1], p) <= 0 &&
            sph_turn(corner[i], corner[i + 1], q) <= 0)
            return 0;
        int side = sph_turn(p, q, corner[i]);
        left |= side > 0, right |= side < 0;
    }
    return left && right;
}

/* Whether the triangle around place i of the list is part of the polygon, and nothing else of the
 * outline is in it; touching: corners of the outline may lie on its edges. */
static int is_ear(const struct outline *o, int i, int touching) {
    int n = o->n, before = o->list[(i + n - 1) % n], tip = o->list[i], after = o->list[(i + 1) % n];
    const double *a = o->at[before], *b = o->at[tip], *c = o->at[after];
    if (sph_turn(a, b, c) <= 0) return 0;
    for (int k = 0; k < n; k++) {
        int p = o->list[k], q = o->list[(k + 1) % n];
        if (enters(a, b, c, o->at[p], o->at[q])) return 0;
        if (touching || p == before || p == tip || p == after) continue;
        if (sph_turn(a, b, o->at[p]) >= 0 && sph_turn(b, c, o->at[p]) >= 0 &&
            sph_turn(c, a, o->at[p]) >= 0)
            return 0;
    }
    return 1;
}

/* Whether p, on the line of a and b, lies between them. */
static int between(const double a[2], const double b[2], const double p[2]) {
    int k = a[0] == b[0];
    return fmin(a[k], b[k]) <= p[k] && p[k] <= fmax(a[k], b[k]);
}

/* Whether the outline is the same without the corner at place i of the list, since its neighbours
 * lie on one line with it; spike: and it goes back there. */
static int is_flat(const struct outline *o, int i, int spike) {
    int n = o->n;
    const double *a = o->at[o->list[(i + n - 1) % n]], *b = o->at[o->list[i]],
                 *c = o->at[o->list[(i + 1) % n]];
    return !sph_turn(a, b, c) && (!spike || !between(a, c, b) || (b[0] == a[0] && b[1] == a[1]) ||
                                  (b[0] == c[0] && b[1] == c[1]));
}

/* Cuts off the corner at place i of the list. */
static void cut(struct outline *o, int i, int triangle[3]) {
    int n = o->n--;
    triangle[0] = o->list[(i + n - 1) % n], triangle[1] = o->list[i];
    triangle[2] = o->list[(i + 1) % n];
    memmove(&o->list[i], &o->list[i + 1], (size_t)(n - 1 - i) * sizeof o->list[0]);
}

/* The first place of a corner that is_flat(), o->n if there is none. */
static int find_flat(const struct outline *o, int spike) {
    int i = 0;
    while (i < o->n && !is_flat(o, i, spike))
        i++;
    return i;
}

int sph_polygon_ears(const struct sph_vec *corner, int n, struct sph_vec normal, int (*index)[3],
                     struct sph_error *err) {
    struct outline o;
    int at = 1, tries = 0, count = 0, touching = 0;
    project(&o, corner, n, normal);
    if (check_crossings(&o, err)) return -1;
    while (o.n > 3) {
        int flat = tries ? o.n : find_flat(&o, 1);
        if (flat == o.n && is_ear(&o, at, touching)) flat = at;
        if (flat == o.n && ++tries > o.n) {
            if (touching) flat = find_flat(&o, 0);
            if (touching && flat == o.n)
                return sph_fail(err, "the polygon cannot be cut in triangles");
            tries = 0, touching = 1;
        }
        if (flat == o.n) {
            at = at % (o.n - 1) + 1; /* corner 0 is kept: of two ears one is another corner */
            continue;
        }
        cut(&o, flat, index[count++]);
        at = flat > 1 ? flat - 1 : 1;
        tries = touching = 0;
    }
    memcpy(index[count], o.list, 3 * sizeof(int));
    if (sph_turn(o.at[o.list[0]], o.at[o.list[1]], o.at[o.list[2]]) < 0)
        return sph_fail(err, "the outline of the polygon goes over itself: it cannot be cut in "
                             "triangles");
    return 0;
}
