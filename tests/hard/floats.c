/* floats.c - see floats.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * Compiled without contraction: every operation rounds.
 *   textbook  disc = b^2 - a*c, c = |oc|^2 - rad^2, t = (b -+ sqrt(disc)) / a
 *   paper     disc = k*a + b^2, k = rad^2 - |oc|^2 (Borodavka et al. VI.A)
 *   gems      Haines et al., Ray Tracing Gems ch. 7: disc = rad^2 - |f + (b/a)*dir|^2, f = -oc;
 *             q = b + sign(b)*sqrt(a*disc), roots c/q and q/a
 */
#include "floats.h"

#include <math.h>

/* What counts of t. */
struct range {
    double least, most;
};

/* The roots in order: the first that lies ahead counts, and for shadow rays before the light. */
static struct floats ahead(double near, double far, struct range range) {
    struct floats r = {1, !(near > range.least), near > range.least ? near : far};
    r.hit = r.t > range.least && r.t < range.most;
    return r;
}

static struct floats single(int formula, const float oc[3], const float d[3], float rad,
                            struct range range) {
    float a = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    float b = oc[0] * d[0] + oc[1] * d[1] + oc[2] * d[2];
    float l2 = oc[0] * oc[0] + oc[1] * oc[1] + oc[2] * oc[2];
    float rad2 = rad * rad, c = l2 - rad2, disc;
    if (formula == HARD_F32_GEMS) {
        float along = b / a, off2 = 0;
        for (int i = 0; i < 3; i++) {
            float off = oc[i] - along * d[i];
            off2 += off * off;
        }
        disc = rad2 - off2;
        if (!(disc > 0)) return (struct floats){0, 0, 0};
        float q = b < 0 ? b - sqrtf(a * disc) : b + sqrtf(a * disc);
        float t0 = c / q, t1 = q / a;
        return b < 0 ? ahead(t1, t0, range) : ahead(t0, t1, range);
    }
    disc = formula == HARD_F32_PAPER ? (rad2 - l2) * a + b * b : b * b - a * c;
    if (!(disc > 0)) return (struct floats){0, 0, 0};
    float root = sqrtf(disc);
    return ahead((b - root) / a, (b + root) / a, range);
}

struct floats floats_hit(int formula, const double org[3], const double dir[3], const double ctr[3],
                         double rad, double least, double most) {
    struct range range = {least, most};
    if (formula != HARD_F64_TEXTBOOK) {
        float oc[3], d[3];
        for (int i = 0; i < 3; i++) {
            oc[i] = (float)ctr[i] - (float)org[i];
            d[i] = (float)dir[i];
        }
        return single(formula, oc, d, (float)rad, range);
    }
    double a = 0, b = 0, c = -rad * rad;
    for (int i = 0; i < 3; i++) {
        double oc = ctr[i] - org[i];
        a += dir[i] * dir[i];
        b += oc * dir[i];
        c += oc * oc;
    }
    double disc = b * b - a * c;
    if (!(disc > 0)) return (struct floats){0, 0, 0};
    return ahead((b - sqrt(disc)) / a, (b + sqrt(disc)) / a, range);
}

struct floats floats_leaf(int formula, const struct sph_ray *ray, const struct sph_leaf *leaf) {
    double org[3], dir[3], ctr[3];
    for (int i = 0; i < 3; i++) {
        org[i] = (double)ray->org[i];
        dir[i] = (double)ray->dir[i];
        ctr[i] = (double)leaf->ctr[i];
    }
    return floats_hit(formula, org, dir, ctr, (double)leaf->rad, 0,
                      ray->kind == SPH_SHADOW ? 1 : INFINITY);
}
