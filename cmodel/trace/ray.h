/* ray.h - a ray as it travels: what set-up makes of an origin and a direction
 * SPDX-License-Identifier: Apache-2.0                                  RTL: rtl/trace/rt_setup.v
 */
#ifndef SPH_RAY_H
#define SPH_RAY_H

#include <stdint.h>

#include "math/rsqrt.h"
#include "machine/profile.h"
#include "trace/across.h"

enum { SPH_PRIMARY, SPH_SHADOW, SPH_REFLECTED, SPH_REFRACTED };

/* The sphere a ray starts on: it is never hit from outside; from inside its far root counts. */
struct sph_skip {
    uint32_t id; /* SPH_ID_NONE: none */
    int inside;
};

struct sph_ray {
    int64_t org[3]; /* sW */
    int64_t dir[3]; /* sWD, not normalised: only its direction counts, but see sph_ray_ends() */
    int kind;
    struct sph_skip skip;
    int64_t lift[3]; /* to a light: org * 2^NG - the point before it was rounded, s(NG+2) */
    int inside;      /* effect INSIDE: rays may start inside a sphere, far roots count */
    int first;       /* children in the node's order, ends at the first visit that hits (FIRST) */
    /* made by set-up */
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
    int far; /* hit from inside */
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

/* Fills in everything from `a` on. */
void sph_ray_setup(const struct sph_profile *p, struct sph_ray *ray);

/* Filter depth that no point with ceil(a*t) <= key exceeds; limited to 2^(FW+1)-1. */
int32_t sph_ray_depth(const struct sph_profile *p, const struct sph_ray *ray, uint64_t key);

/* Largest filter depth: nothing lies deeper. */
static inline int32_t sph_depth_limit(const struct sph_profile *p) {
    return (2 << p->fw) - 1;
}

#endif
