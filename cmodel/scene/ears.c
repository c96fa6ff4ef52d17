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

/* Whether p, on the line of a and b, lies between them. */
static int between(const double a[2], const double b[2], const double p[2]) {
    int k = a[0] == b[0];
    return fmin(a[k], b[k]) <= p[k] && p[k] <= fmax(a[k], b[k]);
}

/* Whether two edges have a point in common. */
static int meet(const double a[2], const double b[2], const double c[2], const double d[2]) {
    int ac = sph_turn(a, b, c), ad = sph_turn(a, b, d);
    int ca = sph_turn(c, d, a), cb = sph_turn(c, d, b);
    if (ac * ad < 0 && ca * cb < 0) return 1;
    return (!ac && between(a, b, c)) || (!ad && between(a, b, d)) || (!ca && between(c, d, a)) ||
           (!cb && between(c, d, b));
}

/* Whether an edge and the next one, from a over b to c, lie on each other. */
static int folded(const double a[2], const double b[2], const double c[2]) {
    return !sph_turn(a, b, c) && (between(a, b, c) || between(b, c, a));
}

static int check_simple(const struct outline *o, struct sph_error *err) {
    for (int i = 0; i < o->n; i++)
        for (int k = i + 1; k < o->n; k++) {
            int j = (i + 1) % o->n, l = (k + 1) % o->n, bad;
            if (k == j)
                bad = folded(o->at[i], o->at[j], o->at[l]);
            else if (l == i)
                bad = folded(o->at[k], o->at[i], o->at[j]);
            else
                bad = meet(o->at[i], o->at[j], o->at[k], o->at[l]);
            if (bad)
                return sph_fail(err,
                                "the edges from corner %d and from corner %d of the polygon meet: "
                                "it cannot be cut in triangles",
                                i + 1, k + 1);
        }
    return 0;
}

/* Whether the triangle around place i of the list is part of the polygon, and nothing else of the
 * outline is in it. */
static int is_ear(const struct outline *o, int i) {
    int n = o->n, before = o->list[(i + n - 1) % n], tip = o->list[i], after = o->list[(i + 1) % n];
    const double *a = o->at[before], *b = o->at[tip], *c = o->at[after];
    if (sph_turn(a, b, c) <= 0) return 0;
    for (int k = 0; k < n; k++) {
        int p = o->list[k];
        if (p == before || p == tip || p == after) continue;
        if (sph_turn(a, b, o->at[p]) >= 0 && sph_turn(b, c, o->at[p]) >= 0 &&
            sph_turn(c, a, o->at[p]) >= 0)
            return 0;
    }
    return 1;
}

int sph_polygon_ears(const struct sph_vec *corner, int n, struct sph_vec normal, int (*index)[3],
                     struct sph_error *err) {
    struct outline o;
    project(&o, corner, n, normal);
    if (check_simple(&o, err)) return -1;
    int at = 1, tries = 0, count = 0;
    while (o.n > 3) {
        if (!is_ear(&o, at)) { /* corner 0 is kept: of two ears one is another corner */
            at = at % (o.n - 1) + 1;
            if (++tries > o.n) return sph_fail(err, "the polygon cannot be cut in triangles");
            continue;
        }
        index[count][0] = o.list[at - 1], index[count][1] = o.list[at];
        index[count][2] = o.list[(at + 1) % o.n];
        count++;
        o.n--;
        memmove(&o.list[at], &o.list[at + 1], (size_t)(o.n - at) * sizeof o.list[0]);
        at = at > 1 ? at - 1 : 1;
        tries = 0;
    }
    memcpy(index[count], o.list, 3 * sizeof(int));
    return 0;
}
