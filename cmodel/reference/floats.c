/* floats.c - see floats.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "reference/floats.h"

#include <math.h>

static struct sph_float_roots single(int formula, const float oc[3], const float d[3], float rad) {
    float a = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    float b = oc[0] * d[0] + oc[1] * d[1] + oc[2] * d[2];
    float l2 = oc[0] * oc[0] + oc[1] * oc[1] + oc[2] * oc[2];
    float rad2 = rad * rad, c = l2 - rad2, disc;
    if (formula == SPH_F32_GEMS) {
        float along = b / a, off2 = 0;
        for (int i = 0; i < 3; i++) {
            float off = oc[i] - along * d[i];
            off2 += off * off;
        }
        disc = rad2 - off2;
        if (!(disc > 0)) return (struct sph_float_roots){0};
        float q = b < 0 ? b - sqrtf(a * disc) : b + sqrtf(a * disc);
        float t0 = c / q, t1 = q / a;
        return b < 0 ? (struct sph_float_roots){1, t1, t0} : (struct sph_float_roots){1, t0, t1};
    }
    disc = formula == SPH_F32_PAPER ? (rad2 - l2) * a + b * b : b * b - a * c;
    if (!(disc > 0)) return (struct sph_float_roots){0};
    float root = sqrtf(disc);
    return (struct sph_float_roots){1, (b - root) / a, (b + root) / a};
}

struct sph_float_roots sph_float_roots(int formula, const double org[3], const double dir[3],
                                       const double ctr[3], double rad) {
    if (formula != SPH_F64_TEXTBOOK) {
        float oc[3], d[3];
        for (int i = 0; i < 3; i++) {
            oc[i] = (float)ctr[i] - (float)org[i];
            d[i] = (float)dir[i];
        }
        return single(formula, oc, d, (float)rad);
    }
    double a = 0, b = 0, c = -rad * rad;
    for (int i = 0; i < 3; i++) {
        double oc = ctr[i] - org[i];
        a += dir[i] * dir[i];
        b += oc * dir[i];
        c += oc * oc;
    }
    double disc = b * b - a * c;
    if (!(disc > 0)) return (struct sph_float_roots){0};
    return (struct sph_float_roots){1, (b - sqrt(disc)) / a, (b + sqrt(disc)) / a};
}

struct sph_floats sph_float_between(struct sph_float_roots roots, double least, double most) {
    if (!roots.real) return (struct sph_floats){0};
    struct sph_floats r = {1, !(roots.near > least), roots.near > least ? roots.near : roots.far};
    r.hit = r.t > least && r.t < most;
    return r;
}

struct sph_floats sph_float_sphere(int formula, const struct sph_ray *ray,
                                   const struct sph_leaf *sphere) {
    double org[3], dir[3], ctr[3];
    for (int i = 0; i < 3; i++) {
        org[i] = (double)ray->org[i];
        dir[i] = (double)ray->dir[i];
        ctr[i] = (double)sphere->ctr[i];
    }
    struct sph_float_roots roots = sph_float_roots(formula, org, dir, ctr, (double)sphere->rad);
    if (!ray->inside)
        roots.far = 0;
    else if (sphere->id == ray->skip.id)
        roots.near = 0;
    return sph_float_between(roots, 0, sph_ray_ends(ray) ? 1 : INFINITY);
}

#define FORMULAS(real, name)                                                                       \
    static void cross_##name(const real a[3], const real b[3], real out[3]) {                      \
        for (int i = 0; i < 3; i++)                                                                \
            out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];            \
    }                                                                                              \
    static real dot_##name(const real a[3], const real b[3]) {                                     \
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];                                            \
    }                                                                                              \
    static struct sph_floats facet_##name(int volumes, const struct sph_ray *ray,                  \
                                          const struct sph_facet_leaf *f) {                        \
        real d[3], to[3], e1[3], e2[3], n[3], m[3];                                                \
        for (int i = 0; i < 3; i++) {                                                              \
            d[i] = (real)ray->dir[i];                                                              \
            to[i] = (real)f->v[0][i] - (real)ray->org[i];                                          \
            e1[i] = (real)f->v[1][i] - (real)f->v[0][i];                                           \
            e2[i] = (real)f->v[2][i] - (real)f->v[0][i];                                           \
            n[i] = (real)f->v[1][i];                                                               \
        }                                                                                          \
        int plane = sph_facet_is_plane(f), inside = 1;                                             \
        real det, t;                                                                               \
        if (plane || volumes) {                                                                    \
            if (!plane) cross_##name(e1, e2, n);                                                   \
            det = dot_##name(n, d);                                                                \
            t = dot_##name(n, to) / det;                                                           \
            cross_##name(d, to, m);                                                                \
            real u2 = dot_##name(m, e1), u1 = -dot_##name(m, e2), u0 = det - u1 - u2;              \
            if (!plane)                                                                            \
                inside = det > 0 ? u0 >= 0 && u1 >= 0 && u2 >= 0 : u0 <= 0 && u1 <= 0 && u2 <= 0;  \
        } else {                                                                                   \
            cross_##name(d, e2, m);                                                                \
            det = -dot_##name(e1, m);                                                              \
            real u = dot_##name(to, m) / det;                                                      \
            cross_##name(to, e1, n);                                                               \
            real v = dot_##name(d, n) / det;                                                       \
            t = dot_##name(e2, n) / det;                                                           \
            inside = u >= 0 && v >= 0 && u + v <= 1;                                               \
        }                                                                                          \
        int hit = det != 0 && inside && t > 0 && (!sph_ray_ends(ray) || t < 1);                    \
        return (struct sph_floats){hit, det > 0, (double)t};                                       \
    }
FORMULAS(float, single)
FORMULAS(double, full)

struct sph_floats sph_float_facet(int formula, const struct sph_ray *ray,
                                  const struct sph_facet_leaf *facet) {
    if (formula == SPH_F64_TEXTBOOK) return facet_full(0, ray, facet);
    return facet_single(formula == SPH_F32_PAPER, ray, facet);
}
