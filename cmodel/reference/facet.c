/* facet.c - see facet.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "reference/facet.h"

#include <float.h>
#include <gmp.h>
#include <limits.h>
#include <math.h>
#include <string.h>

/* ---- exact ---- */

enum { DIGITS = 53 }; /* of a double */

/* The least exponent of n numbers that are not 0: each is a whole number times 2 to that power. */
static int grain(const double *v, int n, int least) {
    for (int i = 0; i < n; i++) {
        int exponent;
        frexp(v[i], &exponent);
        if (v[i] != 0 && exponent - DIGITS < least) least = exponent - DIGITS;
    }
    return least;
}

static void whole(mpz_t out, double v, int grain) {
    int exponent;
    mpz_set_d(out, ldexp(frexp(v, &exponent), DIGITS));
    if (v != 0) mpz_mul_2exp(out, out, (mp_bitcnt_t)(exponent - DIGITS - grain));
}

int sph_ref_exact_side(const double org[3], const double dir[3], const double p[3],
                       const double q[3]) {
    mpz_t d[3], a[3], b[3], o, sum, product;
    int space = grain(org, 3, grain(p, 3, grain(q, 3, INT_MAX))), turn = grain(dir, 3, INT_MAX);
    mpz_inits(d[0], d[1], d[2], a[0], a[1], a[2], b[0], b[1], b[2], o, sum, product, NULL);
    for (int i = 0; i < 3; i++) {
        whole(d[i], dir[i], turn);
        whole(a[i], p[i], space);
        whole(b[i], q[i], space);
        whole(o, org[i], space);
        mpz_sub(a[i], a[i], o);
        mpz_sub(b[i], b[i], o);
    }
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        mpz_mul(product, a[j], b[k]);
        mpz_submul(product, a[k], b[j]);
        mpz_addmul(sum, product, d[i]);
    }
    int sign = mpz_sgn(sum);
    mpz_clears(d[0], d[1], d[2], a[0], a[1], a[2], b[0], b[1], b[2], o, sum, product, NULL);
    return sign;
}

static void between(struct sph_vec to, struct sph_vec from, double out[3]) {
    out[0] = to.x - from.x, out[1] = to.y - from.y, out[2] = to.z - from.z;
}

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double out[3]) {
    for (int i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static void triangle_normal(const struct sph_facet *f, double normal[3]) {
    double e1[3], e2[3];
    between(f->v[1], f->v[0], e1);
    between(f->v[2], f->v[0], e2);
    cross(e1, e2, normal);
}

/* Where the ray meets the plane of a triangle (Moller and Trumbore, Fast, minimum storage
 * ray/triangle intersection). a: the corners, seen from the origin; size: of these.
 * t = num / det, num = (from x e1).e2 and det = (dir x e2).e1: sums of six products of three
 * factors each, so they are off by 6 ULP E F and 6 ULP E D at most, with E the sizes of e1 and e2
 * multiplied, F and D those of from and dir. Corners that are off by ULP times their size move the
 * plane as far where it is the triangle, which is less than 6 E times that in num. As long as half
 * of det is certain all of it is at most twice of the sum over det. */
static void triangle_place(const struct sph_facet *f, const struct sph_ref_cast *c, double a[3][3],
                           double size, struct sph_ref_meet *m) {
    const double *dir = c->ray->dir, from[3] = {-a[0][0], -a[0][1], -a[0][2]};
    double e1[3], e2[3], p[3], q[3];
    between(f->v[1], f->v[0], e1);
    between(f->v[2], f->v[0], e2);
    cross(dir, e2, p);
    cross(from, e1, q);
    double det = dot(p, e1), wide = 12 * sph_ref_size(e1) * sph_ref_size(e2), steep = fabs(det);
    m->t = dot(q, e2) / det;
    m->lead = wide * c->ray->lift / steep;
    double scale = 2 * size + c->org + fabs(m->t) * c->dir;
    m->slack = SPH_REF_ULP * (wide * scale / steep + fabs(m->t));
    if (steep > SPH_REF_ULP * wide * c->dir) return;
    double low = INFINITY, high = -INFINITY; /* along its plane: all of the triangle */
    for (int k = 0; k < 3; k++) {
        double along = dot(a[k], dir) / dot(dir, dir);
        low = fmin(low, along), high = fmax(high, along);
    }
    m->t = (low + high) / 2;
    m->slack = (high - low) / 2 + SPH_REF_ULP * fabs(high);
    m->lead = c->ray->lift / c->dir;
    m->doubt = 1;
}

/* The volumes that the ray spans with the three edges have one sign. Each is judged from the two
 * corners of its edge alone, so two triangles judge the edge that they share alike; what doubles
 * cannot tell is decided in whole numbers. So no ray slips through. 6 products of three factors, of
 * sizes `size`, `size` and c->dir, make a volume: c->edge has what they, the corners and the ray
 * may be off by. */
static int triangle_meet(const struct sph_facet *f, const struct sph_ref_cast *c,
                         struct sph_ref_meet *m) {
    const double *org = c->ray->org, *dir = c->ray->dir;
    double a[3][3], v[3][3], u[3], n[3], size = 0, most = -INFINITY, least = INFINITY;
    for (int k = 0; k < 3; k++) {
        between(f->v[k], (struct sph_vec){0, 0, 0}, v[k]);
        for (int i = 0; i < 3; i++)
            a[k][i] = v[k][i] - org[i];
        double far = sph_ref_size(a[k]);
        size = sph_ref_most(size, far);
    }
    for (int k = 0; k < 3; k++) {
        cross(a[(k + 1) % 3], a[(k + 2) % 3], n);
        u[k] = dot(n, dir);
        most = sph_ref_most(most, u[k]);
        least = sph_ref_least(least, u[k]);
    }
    double unsure = size * (c->edge[0] + size * c->edge[1]);
    if ((most > unsure && least < -unsure) || !(fabs(u[0] + u[1] + u[2]) <= DBL_MAX)) return 0;
    int up = 0, down = 0;
    m->doubt = 0;
    for (int k = 0; k < 3; k++) {
        int side = u[k] > 0 ? 1 : -1;
        if (!(fabs(u[k]) > unsure)) {
            m->doubt = 1;
            side = sph_ref_exact_side(org, dir, v[(k + 1) % 3], v[(k + 2) % 3]);
        }
        up |= side > 0, down |= side < 0;
    }
    m->met = up != down;
    m->far = up;
    triangle_place(f, c, a, size, m);
    return m->met || m->doubt;
}

static void triangle_image(const struct sph_facet *f, const double from[3], double st[2],
                           double slope[2][3], struct sph_texture_shape *shape) {
    double *e1 = shape->edge[0], *e2 = shape->edge[1], *n = shape->normal, along[2][3], d[2][2];
    *shape = (struct sph_texture_shape){.kind = SPH_SHAPE_TRIANGLE};
    between(f->v[1], f->v[0], e1);
    between(f->v[2], f->v[0], e2);
    cross(e1, e2, n);
    for (int i = 0; i < 3; i++) {
        between(f->v[i], (struct sph_vec){0, 0, 0}, shape->corner[i]);
        for (int k = 0; k < 2; k++)
            shape->st[i][k] = f->st[i][k];
    }
    cross(e2, n, along[0]);
    cross(n, e1, along[1]);
    for (int k = 0; k < 2; k++) {
        int sign = k ? -1 : 1; /* t is turned over */
        for (int c = 0; c < 2; c++)
            d[k][c] = sign * (f->st[c + 1][k] - f->st[0][k]);
        for (int i = 0; i < 3; i++)
            slope[k][i] = (d[k][0] * along[0][i] + d[k][1] * along[1][i]) / dot(n, n);
        st[k] = (k ? 1 - f->st[0][1] : f->st[0][0]) + dot(slope[k], from);
    }
}

static void plane_normal(const struct sph_facet *f, double normal[3]) {
    between(f->v[1], (struct sph_vec){0, 0, 0}, normal);
}

/* t = -n.from / n.dir, n of length 1: each is off by 3 ULP at most, and so by what moves the point
 * of the plane, or turns the plane around it. */
static int plane_meet(const struct sph_facet *f, const struct sph_ref_cast *c,
                      struct sph_ref_meet *m) {
    const double *dir = c->ray->dir;
    double n[3], from[3];
    for (int i = 0; i < 3; i++)
        from[i] = c->ray->org[i] - (i == 0 ? f->v[0].x : i == 1 ? f->v[0].y : f->v[0].z);
    sph_ref_facet_normal(f, n);
    double det = dot(n, dir), steep = fabs(det), level = 6 * c->dir * SPH_REF_ULP;
    m->far = det > 0;
    m->t = -dot(n, from) / det;
    m->met = m->t > 0 && m->t <= DBL_MAX;
    m->lead = 2 * c->ray->lift / steep;
    level += 2 * c->dir * c->ray->turn;
    if (!(steep > level)) { /* the ray may go along it: at the horizon */
        double low = fabs(dot(n, from)) / (steep + level);
        if (!m->met) m->t = low;
        m->slack = m->t - low;
        m->doubt = 1;
        return 1;
    }
    m->doubt = 0;
    double scale = 2 * sph_ref_size(from) + c->org + 2 * m->t * c->dir;
    m->slack = SPH_REF_ULP * (12 * scale / steep + fabs(m->t));
    return m->met;
}

static void plane_image(const struct sph_facet *f, const double from[3], double st[2],
                        double slope[2][3], struct sph_texture_shape *shape) {
    const double n[3] = {f->v[1].x, f->v[1].y, f->v[1].z};
    double along[2][3] = {{f->v[2].x, f->v[2].y, f->v[2].z}, {0}};
    cross(n, along[0], along[1]);
    cross(along[1], n, along[0]);
    for (int k = 0; k < 2; k++) {
        double rise = (k ? -1 : 1) / f->st[0][k] / sqrt(dot(along[k], along[k]));
        for (int i = 0; i < 3; i++)
            slope[k][i] = rise * along[k][i];
        st[k] = (k ? 1 - f->st[1][1] : f->st[1][0]) + dot(slope[k], from);
    }
    *shape =
        (struct sph_texture_shape){.kind = SPH_SHAPE_PLANE, .st = {{f->st[0][0], f->st[0][1]}}};
}

/* What the reference knows of each kind; from: a point seen from v[0]. */
static const struct {
    int unbounded;
    void (*normal)(const struct sph_facet *f, double normal[3]); /* of any length */
    int (*meet)(const struct sph_facet *f, const struct sph_ref_cast *cast,
                struct sph_ref_meet *meet);
    void (*image)(const struct sph_facet *f, const double from[3], double st[2], double slope[2][3],
                  struct sph_texture_shape *shape);
} kinds[SPH_KINDS] = {[SPH_TRIANGLE] = {0, triangle_normal, triangle_meet, triangle_image},
                      [SPH_PLANE] = {1, plane_normal, plane_meet, plane_image}};

int sph_ref_facet_unbounded(const struct sph_facet *f) {
    return kinds[f->kind].unbounded;
}

void sph_ref_facet_normal(const struct sph_facet *f, double normal[3]) {
    kinds[f->kind].normal(f, normal);
    double length = sqrt(dot(normal, normal));
    for (int i = 0; i < 3; i++)
        normal[i] /= length;
}

int sph_ref_facet_smooth(const struct sph_facet *f, const double at[3], double normal[3]) {
    double e1[3], e2[3], from[3], n[3], side[3], sum = 0, out[3];
    if (!f->smooth) return 0;
    between(f->v[1], f->v[0], e1);
    between(f->v[2], f->v[0], e2);
    for (int i = 0; i < 3; i++)
        from[i] = at[i] - (i == 0 ? f->v[0].x : i == 1 ? f->v[0].y : f->v[0].z);
    cross(e1, e2, n);
    cross(from, e2, side);
    double x = dot(side, n) / dot(n, n); /* part of corner 1 */
    cross(e1, from, side);
    double y = dot(side, n) / dot(n, n), part[3] = {1 - x - y, x, y};
    memset(out, 0, sizeof out);
    for (int k = 0; k < 3; k++) {
        double v[3];
        between(f->n[k], (struct sph_vec){0, 0, 0}, v);
        double length = sqrt(dot(v, v));
        sum += dot(v, n) / length;
        for (int i = 0; i < 3; i++)
            out[i] += part[k] * v[i] / length;
    }
    double length = sqrt(dot(out, out));
    if (!(length > 0)) return 0;
    for (int i = 0; i < 3; i++)
        normal[i] = (sum < 0 ? -1 : 1) * out[i] / length;
    return 1;
}

int sph_ref_facet(const struct sph_facet *f, const struct sph_ref_cast *cast,
                  struct sph_ref_meet *meet) {
    return kinds[f->kind].meet(f, cast, meet);
}

/* Edges that are off by ULP times the corners turn a triangle by that over its least height, which
 * is its area over its longest edge; between two normals at its corners lies at most 2. */
double sph_ref_facet_turn(const struct sph_facet *f, double off) {
    double e[2][3], v[3], n[3];
    if (kinds[f->kind].unbounded) return 4 * SPH_REF_ULP;
    between(f->v[0], (struct sph_vec){0, 0, 0}, v);
    between(f->v[1], f->v[0], e[0]);
    between(f->v[2], f->v[0], e[1]);
    cross(e[0], e[1], n);
    double longest = sph_ref_most(sph_ref_size(e[0]), sph_ref_size(e[1]));
    double wide = 4 * longest / sph_ref_size(n);
    return wide * SPH_REF_ULP * (sph_ref_size(v) + longest) + (f->smooth ? wide * off : 0);
}

/* Whether f lies in the plane of g: its corners do, or its point, and its normal is that of g. */
static int within(const struct sph_facet *f, const struct sph_facet *g) {
    const double tiny = 8 * SPH_REF_ULP;
    double n[3], m[3], side[3], base[3];
    sph_ref_facet_normal(g, n);
    between(g->v[0], (struct sph_vec){0, 0, 0}, base);
    if (kinds[f->kind].unbounded) {
        if (!kinds[g->kind].unbounded) return 0;
        sph_ref_facet_normal(f, m);
        cross(n, m, side);
        if (!(sph_ref_size(side) <= tiny)) return 0;
    }
    for (int k = 0; k < (kinds[f->kind].unbounded ? 1 : 3); k++) {
        double from[3];
        between(f->v[k], g->v[0], from);
        if (!(fabs(dot(n, from)) <= tiny * (sph_ref_size(base) + sph_ref_size(from)))) return 0;
    }
    return 1;
}

int sph_ref_facet_level(const struct sph_facet *a, const struct sph_facet *b) {
    return within(a, b) || within(b, a);
}

void sph_ref_facet_image(const struct sph_facet *f, const double from[3], double st[2],
                         double slope[2][3], struct sph_texture_shape *shape) {
    kinds[f->kind].image(f, from, st, slope, shape);
}
