/* facet.h - the exact test of a ray and a triangle or plane
 * SPDX-License-Identifier: Apache-2.0
 *
 * t = num/det is never formed: with N = e1 x e2 (plane: its normal), det = N.dir and num = N.A0,
 * A0 = v0 - org, all is decided by signs of exact integers. Why no ray slips between two triangles:
 * docs/design/primitives.md. With Aj = vj - org, A1 = A0 + e1 and A2 = A0 + e2,
 *
 *     U2 = dir.(A0 x A1) = dir.(A0 x e1) =  (dir x A0).e1
 *     U1 = dir.(A2 x A0) = dir.(e2 x A0) = -(dir x A0).e2
 *     U0 = dir.(A1 x A2)       U0 + U1 + U2 = dir.(e1 x e2) = det
 *
 * so Ui is six times the signed volume of org, org+dir and the edge opposite corner i. The widths
 * of that page hold, with S = 2^W - 1, D = 2^(WD-1), n = 2^23, because
 *
 * N      |N_i| is twice the area of the triangle's shadow in a square of side S: at most S^2.
 * det    |N.dir| <= D (|N_x| + |N_y| + |N_z|) <= 3 S^2 D < 2^(2W+WD+1). Ui is the same for the
 *        triangle of org and two corners, which lies in the box too.
 * num    N.A0 is six times the volume of a tetrahedron in a cube of side S. The volume is linear in
 *        each corner, so it is largest with all four at corners of the cube: 2 S^3 < 2^(3W+1). For
 *        a plane 3 n S < 2^(W+25) <= 2^(3W+1).
 * a num' a <= 3 D^2: at most 6 S^3 D^2 = 1.5 * 2^(2WD) S^3 < 2^(3W+2WD+1); for a plane
 *        9 n S D^2 < 9 * 2^(W+2WD+21) < 2^(W+2WD+25).
 * key    |t dir_i| <= S + 1 along the longest axis, where the ray ends, so for each i; a*t = sum of
 *        dir_i * (t dir_i) is at most 3 (S+1) D < 2^(W+WD+1), a whole number, and the ceiling too.
 * end    det' <= 3 n D and room <= S + 1; num' <= 3 n S and size <= D. room >= 1, so t > 0.
 * add    det' room < num' size, so that 1 <= ceil(det' room / num') <= size: 0 <= add < size <= D,
 *        and key + add < 3 (S+1) D + D < 2^(W+WD+1).
 */
#ifndef SPH_FACET_H
#define SPH_FACET_H

#include <stdint.h>

#include "core/ray.h"
#include "machine/layout.h"
#include "math/fx.h"
#include "shade/surface.h"

struct sph_facet_leaf {
    int kind;        /* SPH_TRIANGLE; SPH_PLANE and what no machine has: a plane */
    int64_t v[3][3]; /* sW corners; plane: v[0] a point of it, v[1] its normal N (s24) */
    uint32_t id;
    uint32_t before, after; /* its group: ids id-before .. id+after */
};

static inline int sph_facet_is_plane(const struct sph_facet_leaf *f) {
    return f->kind != SPH_TRIANGLE;
}

/* det and num are given with a miss too. */
struct sph_facet_result {
    int hit;      /* t > 0, on the triangle or the plane; shadow ray: ahead and t < 1 */
    int far;      /* det > 0: the normal looks along the ray */
    sph_u128 det; /* |N.dir|, u(2W+WD+1) */
    sph_i128 num; /* N.A0, negated if N.dir < 0: t = num/det; s(3W+2) */
    uint64_t add; /* to the key; u(WD-1) */
}; /* of a plane beyond the grid: |dir_k|, the room along k, its rank (docs/design/primitives.md) */

/* Whether the ray starts on a facet of this one's group. */
int sph_facet_own(const struct sph_ray *ray, const struct sph_facet_leaf *facet);

/* Valid for every operand in range; dir = 0, a ray in the plane and an origin on it miss. A facet
 * of the group that the ray starts on misses; to a light also one that does not lie ahead of the
 * point which its origin was rounded from. */
struct sph_facet_result sph_facet_test(const struct sph_profile *p, const struct sph_ray *ray,
                                       const struct sph_facet_leaf *facet);

/* ceil(a*t) + add of a hit of no shadow ray, 1 .. 3 * 2^(W+WD-1) + 2^(WD-1): orders it among facets
 * and spheres; *divisions counts. */
uint64_t sph_facet_key(const struct sph_ray *ray, const struct sph_facet_result *r,
                       uint64_t *divisions);

/* The surface at a hit on a facet with the normal of its record, s24; 1 if the point was limited.
 */
static inline int sph_surface_facet(const struct sph_profile *p, const struct sph_ray *ray,
                                    const struct sph_hit *hit, const int64_t normal[3],
                                    struct sph_surface *s) {
    int saturated = sph_surface_point(p, ray, hit->key, s);
    saturated |= sph_surface_outwards(p, hit->far, normal, s);
    sph_surface_turn(p, ray, hit->far, normal, s);
    return saturated;
}

/* ---- the normal that a triangle's primitive record has ---- */

/* The normal of a triangle of grid points (sW, W <= 24): (v1-v0) x (v2-v0), shifted so that the
 * largest component fills 24 bits, sign included, and rounded half away from zero; what is not 0
 * stays at least 1, so that the signs are exact. 0 if the corners are on one line: no normal, no
 * area. */
int sph_triangle_normal(const int32_t (*v)[3], int32_t normal[3]);

#endif
