/* facet.c - see facet.h; Moller and Trumbore, Fast, minimum storage ray/triangle intersection
 * SPDX-License-Identifier: Apache-2.0
 */
#include "reference/facet.h"

#include <math.h>
#include <string.h>

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

static double triangle_meet(const struct sph_facet *f, const double from[3], const double dir[3],
                            int *far) {
    double e1[3], e2[3], p[3], q[3];
    between(f->v[1], f->v[0], e1);
    between(f->v[2], f->v[0], e2);
    cross(dir, e2, p);
    cross(from, e1, q);
    double det = dot(p, e1), x = dot(p, from) / det, y = dot(q, dir) / det;
    if (!(x >= 0) || !(y >= 0) || !(x + y <= 1)) return INFINITY;
    *far = det < 0;
    return dot(q, e2) / det;
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

static double plane_meet(const struct sph_facet *f, const double from[3], const double dir[3],
                         int *far) {
    double n[3];
    sph_ref_facet_normal(f, n);
    double det = dot(n, dir);
    *far = det > 0;
    return -dot(n, from) / det;
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

/* What the reference knows of each kind; from: the origin seen from v[0]. */
static const struct {
    int endless;
    void (*normal)(const struct sph_facet *f, double normal[3]); /* of any length */
    double (*meet)(const struct sph_facet *f, const double from[3], const double dir[3], int *far);
    void (*image)(const struct sph_facet *f, const double from[3], double st[2], double slope[2][3],
                  struct sph_texture_shape *shape);
} kinds[SPH_KINDS] = {[SPH_TRIANGLE] = {0, triangle_normal, triangle_meet, triangle_image},
                      [SPH_PLANE] = {1, plane_normal, plane_meet, plane_image}};

int sph_ref_facet_endless(const struct sph_facet *f) {
    return kinds[f->kind].endless;
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

double sph_ref_facet(const struct sph_facet *f, const double org[3], const double dir[3],
                     int *far) {
    const double from[3] = {org[0] - f->v[0].x, org[1] - f->v[0].y, org[2] - f->v[0].z};
    double t = kinds[f->kind].meet(f, from, dir, far);
    return t > 0 ? t : INFINITY;
}

void sph_ref_facet_image(const struct sph_facet *f, const double from[3], double st[2],
                         double slope[2][3], struct sph_texture_shape *shape) {
    kinds[f->kind].image(f, from, st, slope, shape);
}
