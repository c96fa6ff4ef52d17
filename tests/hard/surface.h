/* surface.h - hit point, normal and mirror direction by definition, twice
 * SPDX-License-Identifier: Apache-2.0
 *
 * exact_* in 128 bits, for every case; naive_* in GMP with the rounded steps of the naive model.
 */
#ifndef HARD_SURFACE_H
#define HARD_SURFACE_H

#include "hard.h"
#include "math/arith.h"
#include "shade/surface.h"

/* 1 if mant * 2^-exp is key / a rounded down as docs/reference/machine_file.md says. */
int exact_is_quotient(const struct sph_profile *p, uint64_t key, uint64_t a,
                      const struct sph_quotient *q);

/* v by one shift to s(bits), rounded half up and limited. */
void exact_normalise(const sph_i128 v[3], int bits, int64_t out[3]);

/* Point, normal and nn at t = *q; returns 1 if the point was limited. */
int exact_surface(const struct sph_profile *p, const struct sph_ray *ray,
                  const struct sph_quotient *q, int far, const struct sph_leaf *sphere,
                  struct sph_surface *s);
void exact_reflect(const struct sph_profile *p, const int64_t dir[3], const int64_t normal[3],
                   int64_t out[3]);

/* The refracted direction, |d x n|^2 by components, the root of a float mended to floor; 0: all is
 * reflected. */
int exact_refract(const struct sph_profile *p, const int64_t dir[3], const int64_t normal[3],
                  uint32_t from, uint32_t to, int64_t out[3]);

/* The same from the key on, and the unit vector of the normal. */
int naive_surface(const struct sph_profile *p, const struct sph_ray *ray, uint64_t key, int far,
                  const struct sph_leaf *sphere, struct sph_surface *s);

#endif
