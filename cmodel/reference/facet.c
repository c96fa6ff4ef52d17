/* facet.c - see facet.h; Moller and Trumbore, Fast, minimum storage ray/triangle intersection
 * SPDX-License-Identifier: Apache-2.0
 */
#include "reference/facet.h"

#include <math.h>

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

void sph_ref_facet_normal(const struct sph_facet *f, double normal[3]) {
    double e1[3], e2[3];
    if (f->kind == SPH_PLANE) {
        between(f->v[1], (struct sph_vec){0, 0, 0}, normal);
    } else {
        between(f->v[1], f->v[0], e1);
        between(f->v[2], f->v[0], e2);
        cross(e1, e2, normal);
    }
    double length = sqrt(dot(normal, normal));
    for (int i = 0; i < 3; i++)
        normal[i] /= length;
}

double sph_ref_facet(const struct sph_facet *f, const double org[3], const double dir[3],
                     int *far) {
    double e1[3], e2[3], p[3], q[3],
        from[3] = {org[0] - f->v[0].x, org[1] - f->v[0].y, org[2] - f->v[0].z}, t;
    if (f->kind == SPH_PLANE) {
        sph_ref_facet_normal(f, p);
        double det = dot(p, dir);
        *far = det > 0;
        t = -dot(p, from) / det;
    } else {
        between(f->v[1], f->v[0], e1);
        between(f->v[2], f->v[0], e2);
        cross(dir, e2, p);
        cross(from, e1, q);
        double det = dot(p, e1), x = dot(p, from) / det, y = dot(q, dir) / det;
        if (!(x >= 0) || !(y >= 0) || !(x + y <= 1)) return INFINITY;
        *far = det < 0;
        t = dot(q, e2) / det;
    }
    return t > 0 ? t : INFINITY;
}
