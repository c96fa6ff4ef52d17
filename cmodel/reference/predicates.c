/* predicates.c - see predicates.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "reference/predicates.h"

#include <string.h>

struct sph_predicate_ray sph_predicate_ray(int predicate, const double org[3], const double dir[3],
                                           struct sph_flops *work) {
    struct sph_predicate_ray ray = {.a = 0};
    memcpy(ray.org, org, sizeof ray.org);
    memcpy(ray.dir, dir, sizeof ray.dir);
    if (predicate == SPH_PREDICATE_PAPER) return ray;
    ray.a = sph_f_dot(work, dir, dir);
    if (predicate == SPH_PREDICATE_GEOMETRIC) {
        double length = sph_f_root(work, ray.a);
        for (int i = 0; i < 3; i++)
            ray.dir[i] = sph_f_div(work, dir[i], length);
    }
    return ray;
}

/* k a + b^2 > 0, where k is R^2 - |VC|^2 and b is VC.d. */
static int sum(double a, double k, double b, struct sph_flops *work) {
    return sph_f_add(work, sph_f_mul(work, k, a), sph_f_mul(work, b, b)) > 0;
}

static int paper(const struct sph_predicate_ray *ray, const double vc[3], double rad2,
                 struct sph_flops *work) {
    double far2 = sph_f_dot(work, vc, vc), b = sph_f_dot(work, vc, ray->dir);
    if (b < 0 && rad2 < far2) return 0;
    double a = sph_f_dot(work, ray->dir, ray->dir);
    return sum(a, sph_f_sub(work, rad2, far2), b, work);
}

static int machine(const struct sph_predicate_ray *ray, const double vc[3], double rad,
                   struct sph_flops *work) {
    double k = sph_f_sub(work, sph_f_mul(work, rad, rad), sph_f_dot(work, vc, vc));
    double b = sph_f_dot(work, vc, ray->dir);
    return sum(ray->a, k, b, work) && (b > 0 || k > 0);
}

static int geometric(const struct sph_predicate_ray *ray, const double vc[3], double rad2,
                     struct sph_flops *work) {
    double far2 = sph_f_dot(work, vc, vc), closest = sph_f_dot(work, vc, ray->dir);
    if (far2 < rad2) return 1;
    if (closest < 0) return 0;
    double half2 = sph_f_add(work, sph_f_sub(work, rad2, far2), sph_f_mul(work, closest, closest));
    return half2 > 0;
}

static int quadratic(const struct sph_predicate_ray *ray, const double vc[3], double rad2,
                     struct sph_flops *work) {
    double half = sph_f_dot(work, vc, ray->dir), b = sph_f_mul(work, -2, half);
    double c = sph_f_sub(work, sph_f_dot(work, vc, vc), rad2);
    double ac = sph_f_mul(work, 4, sph_f_mul(work, ray->a, c));
    return sph_f_sub(work, sph_f_mul(work, b, b), ac) > 0 && (b < 0 || c < 0);
}

int sph_predicate(int predicate, const struct sph_predicate_ray *ray, const double ctr[3],
                  double rad, struct sph_flops *work) {
    double vc[3];
    sph_f_minus(work, 3, ctr, ray->org, vc);
    switch (predicate) {
    case SPH_PREDICATE_PAPER:
        return paper(ray, vc, rad * rad, work);
    case SPH_PREDICATE_MACHINE:
        return machine(ray, vc, rad, work);
    case SPH_PREDICATE_GEOMETRIC:
        return geometric(ray, vc, rad * rad, work);
    default:
        return quadratic(ray, vc, rad * rad, work);
    }
}
