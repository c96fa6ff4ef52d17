/* bound.h - bounding spheres: near optimal in double, then safe in exact integers
 * SPDX-License-Identifier: Apache-2.0
 *
 * A filter unit is 2^k grid units, k = W - FW. A sphere in filter units holds a grid sphere
 * (ctr, rad) iff rf*2^k - rad >= |cf*2^k - ctr|; all of it is decided in integers.
 */
#ifndef SPH_BOUND_H
#define SPH_BOUND_H

#include <stdint.h>

#include "machine/profile.h"

/* A sphere of integers: grid units, or filter units where a comment says so. */
struct sph_ball {
    int32_t c[3];
    int32_t r;
};

/* The smallest s with s*s >= v, for 0 <= v < 2^62. */
int64_t sph_ceil_sqrt(int64_t v);

/* v / 2^k to nearest, halves up: the filter coordinate of a grid coordinate, kept inside FW bits
 * (the radius makes up for it). */
int32_t sph_filter_coord(int64_t v, const struct sph_profile *profile);

/* The smallest radius in filter units with which a sphere at filter point cf holds the ball. */
int32_t sph_filter_radius(const int32_t cf[3], const struct sph_ball *ball, int k);

/* The sphere in filter units, without margin, that holds one leaf. */
struct sph_ball sph_filter_leaf(const struct sph_ball *leaf, const struct sph_profile *profile);

/* The ball that holds the whole grid, in grid units. */
struct sph_ball sph_grid_whole(const struct sph_profile *profile);

/* The sphere in filter units, without margin, around the whole grid. */
struct sph_ball sph_filter_whole(const struct sph_profile *profile);

/* The smallest sphere (centre, radius) around balls[index[0..n-1]], or balls[0..n-1] if index is
 * NULL, n >= 1, up to rounding of double: farthest-first pivoting over supports of at most four
 * spheres. */
void sph_enclose(const struct sph_ball *balls, const uint32_t *index, uint32_t n, double out[4]);

/* The same as a sphere in filter units that holds every ball exactly, without margin; for few
 * balls the eight filter points around the centre compete. Balls of triangles may stick out of the
 * grid: what no sphere around the grid holds gets that sphere, which holds all that is in them. */
struct sph_ball sph_filter_enclose(const struct sph_ball *balls, const uint32_t *index, uint32_t n,
                                   const struct sph_profile *profile);

/* The same of balls whose smallest sphere is known. */
struct sph_ball sph_filter_around(const struct sph_ball *balls, const uint32_t *index, uint32_t n,
                                  const double sphere[4], const struct sph_profile *profile);

#endif
