/* facet.h - hard cases of ray and facet: what the named ones are made with
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef HARD_FACET_H
#define HARD_FACET_H

#include "list.h"
#include "hard.h"
#include "named.h"

/* ---- ray and facet in exact integers, by volumes of four points ---- */

/* t = num/det where the ray meets the facet's plane; det >= 0, and 0 for a ray along it. */
struct facet_exact {
    int hit, far;
    int ended;    /* t is that of the end of the world, before the plane is met */
    int met;      /* the ray's line meets the plane ahead of the origin, and before a light */
    uint64_t key; /* of a hit, of no shadow ray */
    sph_i128 num, det;
    sph_i128 own_num, own_det; /* of the plane, wherever the ray ends */
};

struct facet_exact exact_facet(const struct sph_profile *p, const struct sph_ray *ray,
                               const struct sph_facet_leaf *f);

/* Sign of t1 - t2 of the planes, exactly; both det > 0, both num >= 0. */
int exact_facet_order(const struct facet_exact *e1, const struct facet_exact *e2);

/* A primary ray and a facet of id HARD_ID; near and far are of its normal (e1 x e2): towards the
 * ray's origin, or along the ray. */
struct hard_facet triangle(const int64_t org[3], const int64_t dir[3], const int64_t v0[3],
                           const int64_t v1[3], const int64_t v2[3]);
struct hard_facet plane(const int64_t org[3], const int64_t dir[3], const int64_t point[3],
                        const int64_t normal[3]);

/* The triangle at x with an edge on the z axis and a corner at y = height, normal towards -x. */
struct hard_facet wall(const int64_t org[3], const int64_t dir[3], int64_t x, int64_t height,
                       int64_t width);

/* ceil(a*t) of a ray that has gone x along an axis when its direction says d. */
uint64_t key_at(const int64_t dir[3], int64_t x, int64_t d);

/* The case with each axis in each place and a triangle's corners in each order, as a ray of its
 * kind: the model against the naive one and the expected outcome; a key of 0 is not fixed. */
void expect_facet(struct named *n, struct hard_facet c, int outcome, uint64_t key);

/* Both facets of one ray, or a sphere and a facet: each as with ORACLE; then both orders of storage
 * (and of ids, of two facets) through tree and brute force. winner: which is hit first, -1 if the
 * keys are equal: the one with the smaller id, a sphere before a facet. */
void expect_first_facet(struct named *n, struct hard_facet c, const struct sph_facet_leaf *other,
                        int winner);
void expect_first_sphere(struct named *n, struct hard_facet c, const struct sph_leaf *sphere,
                         int winner);

/* A machine of one node with two leaves, stored in this order or the other one: f[i] with ids[i],
 * or the sphere, of id 0, where f[i] is NULL. Every ray passes the node. */
enum { TWO_RECORDS = 8 };
void two_records(const struct named *n, const struct sph_facet_leaf *const f[2],
                 const struct sph_leaf *sphere, int order, const uint32_t ids[2],
                 uint32_t mem[TWO_RECORDS * SPH_LINE_WORDS], struct sph_machine *m);

#endif
