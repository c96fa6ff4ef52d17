/* ray.h - a ray of the double reference, and how far double precision may be off along it
 * SPDX-License-Identifier: Apache-2.0
 *
 * No hit is a point: it is a stretch of the ray, t - slack .. t + slack, that holds the true t of
 * the surface as it was written. The bounds are of first order, with SPH_REF_ULP for each product
 * of three factors and each sum of three terms: eight times what one rounding may lose. As much is
 * granted to every coordinate of the scene, which is a decimal number, or the result of a few
 * operations, rounded to a double.
 */
#ifndef SPH_REFERENCE_RAY_H
#define SPH_REFERENCE_RAY_H

#include <math.h>
#include <stdint.h>

#define SPH_REF_ULP 0x1p-50

struct sph_ref_ray {
    double org[3], dir[3];
    uint32_t skip;    /* sphere or facet that the ray starts on, SPH_ID_NONE: none */
    int inside;       /* it starts inside that sphere */
    int light;        /* it goes to a light: what lets shadow rays pass is not met */
    double lift;      /* how far org may be from that surface: what is as near to org is not met */
    double off, turn; /* how far org and dir may be from those of exact arithmetic: units of length,
                         radians; they make a hit doubtful, but do not change it */
};

struct sph_ref_hit {
    double t;     /* INFINITY: none */
    uint32_t id;  /* spheres, then facets, as the scene has them */
    int far;      /* the origin is inside; facet: its normal looks along the ray */
    double slack; /* of t */
    int doubt;    /* it may be another one, or none, for all that doubles can tell */
};

/* A ray on its way through many tests: what all of them need. */
struct sph_ref_cast {
    const struct sph_ref_ray *ray;
    double org, dir; /* largest magnitude of a component */
    double edge[2];  /* a volume below size * (edge[0] + size * edge[1]) has no certain sign */
};

/* Where the ray meets one primitive. */
struct sph_ref_meet {
    double t, slack;
    double lead; /* t may be so much less, because org is not quite on its surface */
    int far;
    int met;   /* 0 with doubt: it is missed by less than is certain */
    int doubt; /* whether the ray meets it is not certain */
};

/* The lesser and the greater of two numbers; what is no number is no case, as it is of fmin(). */
static inline double sph_ref_least(double a, double b) {
    return a < b ? a : b;
}

static inline double sph_ref_most(double a, double b) {
    return a > b ? a : b;
}

/* The largest magnitude of a component. */
static inline double sph_ref_size(const double v[3]) {
    return sph_ref_most(sph_ref_most(fabs(v[0]), fabs(v[1])), fabs(v[2]));
}

#endif
