/* surface.h - from a hit to a point, a normal and a reflected direction
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_SURFACE_H
#define SPH_SURFACE_H

#include <stdint.h>

#include "core/ray.h"
#include "machine/machine.h"
#include "math/arith.h"

struct sph_surface {
    int64_t point[3];   /* sW, origin of secondary rays */
    int flat;           /* the point lies in front of a facet */
    int64_t guarded[3]; /* s(W+NG), the point with its guard bits */
    int64_t normal[3];  /* sWD, normalised by one shift, towards the ray's side */
    int64_t side[3];    /* that of the primitive, where another one is interpolated: bent */
    int bent;
    struct sph_unit unit; /* of normal */
    uint64_t nn;          /* normal.normal, u(2WD) */
};

/* Hit point org + t*dir with NG guard bits that a primitive may make its normal of, t = key / a
 * rounded down to PQ bits (Borodavka et al. VI.A): guarded. A point outside the grid is limited to
 * it: returns 1. */
int sph_surface_point(const struct sph_profile *p, const struct sph_ray *ray, uint64_t key,
                      struct sph_surface *s);

/* The point of the grid where secondary rays start, from the guarded one; limited: returns 1. That
 * of a sphere is the nearest. That of a facet lies strictly in front of its plane, on the side that
 * the ray came from: each coordinate goes on to the next number of the grid along the normal
 * `vector`, turned if the hit is far (docs/design/primitives.md has the proof). */
int sph_surface_nearest(const struct sph_profile *p, struct sph_surface *s);
int sph_surface_outwards(const struct sph_profile *p, int far, const int64_t vector[3],
                         struct sph_surface *s);

/* Where a ray to a light starts: org, and by how much that was rounded, lift. */
static inline void sph_surface_spawn(const struct sph_profile *p, const struct sph_surface *s,
                                     struct sph_ray *ray) {
    for (int i = 0; i < 3; i++) {
        ray->org[i] = s->point[i];
        ray->lift[i] = s->point[i] * (1 << p->ng) - s->guarded[i];
    }
}

/* Where a refracted ray starts: the point of a sphere; strictly behind the plane of a facet, back
 * by 2 and what the quotient may have lost, 2^(W+2-PQ) if that is 1 or more, along each axis that
 * its normal looks along. Limited to the grid. */
void sph_surface_behind(const struct sph_profile *p, const struct sph_surface *s, int64_t out[3]);

/* normal, side, unit and nn from a vector of any length along the normal: turned if the hit is far;
 * -dir if it has none, as at a sphere's centre. */
void sph_surface_turn(const struct sph_profile *p, const struct sph_ray *ray, int far,
                      const int64_t vector[3], struct sph_surface *s);

/* The normal becomes an interpolated one, of any length, turned if the hit is far; nothing changes
 * if it has none. */
void sph_surface_bend(const struct sph_profile *p, int far, const int64_t vector[3],
                      struct sph_surface *s);

/* Mirror direction dir*(n.n) - 2*(dir.n)*n in exact integers, then one normalising shift to sWD
 * (Borodavka et al. VI.B without its divisions). */
void sph_reflect(const struct sph_profile *p, const int64_t dir[3], const struct sph_surface *s,
                 int64_t out[3]);

/* sph_reflect(); if the normal is interpolated, what goes behind the facet is mirrored once more,
 * at the facet (docs/design/shading.md). */
void sph_mirror(const struct sph_profile *p, const int64_t dir[3], const struct sph_surface *s,
                int64_t out[3]);

/* ---- interpolated normals of triangles (RTL: rtl/shade/rt_smooth.v) ---- */
/* Barycentric interpolation is linear in the hit point, so a record has what is linear: the normal
 * at a point of the grid, and how it turns from there on (docs/design/shading.md). */

enum {
    SPH_SMOOTH_FRACTION = 15, /* of the interpolated normal */
    SPH_SMOOTH_BITS = 20,     /* of a component of it: s4.15 */
    SPH_SMOOTH_M_STEP = SPH_SMOOTH_M_XX_BITS
};

/* n + m (guarded - b * 2^NG) * 2^-e, s4.15, limited; the difference is limited to s(W+NG). */
void sph_smooth_normal(const struct sph_profile *p, const uint32_t *record,
                       const int64_t guarded[3], int64_t normal[3]);

/* The record of a primitive's normals, NULL if it has none; of one that lies behind the end of
 * memory too, and *outside is 1. */
const uint32_t *sph_smooth_record(const struct sph_machine *m, const uint32_t *prim, int *outside);

#endif
