/* ray.h - a ray as it travels from stage to stage, and what it hits
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_RAY_H
#define SPH_RAY_H

#include <stdint.h>

#include "math/arith.h"
#include "machine/profile.h"

enum { SPH_PRIMARY, SPH_SHADOW, SPH_REFLECTED, SPH_REFRACTED };

/* The sphere a ray starts on: it is never hit from outside; from inside its far root counts. */
struct sph_skip {
    uint32_t id; /* SPH_ID_NONE: none */
    int inside;
};

/* Two axes across the ray, for the node filter: trace/across.h. */
struct sph_across {
    int axis_a, axis_b; /* a < b; not the axis on which |u| is smallest, of ties the lowest */
    int32_t p_a, p_b;   /* s0.17; p = (p_a, -p_b) along a and b */
    int32_t q[3];       /* s0.17 */
};

struct sph_stages;

struct sph_ray {
    int64_t org[3]; /* sW */
    int64_t dir[3]; /* sWD, not normalised: only its direction counts, but see sph_ray_ends() */
    int kind;
    struct sph_skip skip;
    int64_t lift[3]; /* to a light: org * 2^NG - the point before it was rounded, s(NG+2) */
    int inside;      /* effect INSIDE: rays may start inside a sphere, far roots count */
    int first;       /* children in the node's order, ends at the first visit that hits (FIRST) */
    struct sph_stages *stages; /* of who follows the ray: core/stages.h; NULL: nobody does */
    /* made by set-up, trace/setup.h */
    uint64_t a;           /* dir.dir, u(2WD) */
    struct sph_unit unit; /* of dir */
    struct sph_across across;
    int32_t forg[3];      /* origin in filter units, sFW, rounded half up */
    int axis, negative;   /* of the largest |unit.u|, ties to the lower axis; its sign */
    uint32_t depth_scale; /* u1.15 >= |u_axis| / |dir| * 2^(WD-h): key to filter depth */
    int depth_shift;
    int32_t depth_max; /* what lies deeper along axis cannot matter, at the ray's start */
};

struct sph_hit {
    uint64_t key; /* 0: nothing hit */
    uint32_t id;
    int16_t far;  /* hit from inside */
    int16_t fars; /* spheres that were found to hold the origin, 2: or more; the ray's own is one,
                 if it starts in there */
};

/* 1 if the ray ends at a light: its direction is the whole vector, so the light lies at t = 1,
 * where a key is `a`. What it hits there or farther away does not count. Other rays have no end. */
static inline int sph_ray_ends(const struct sph_ray *ray) {
    return ray->kind == SPH_SHADOW;
}

/* 1 if any hit will do: the ray ends with the first visit that hits, and takes the children of a
 * node in the node's order, none of them pruned by its depth. */
static inline int sph_ray_any(const struct sph_ray *ray) {
    return ray->kind == SPH_SHADOW || ray->first;
}

#endif
