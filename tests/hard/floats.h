/* floats.h - ray and sphere in floating point, as others write it
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef HARD_FLOATS_H
#define HARD_FLOATS_H

#include "hard.h"

struct floats {
    int hit, far;
    double t;
};

/* One of the formulas HARD_F32_TEXTBOOK to HARD_F64_TEXTBOOK: the smallest root t > 0, below 1 for
 * shadow rays. It knows no skip. */
struct floats floats_leaf(int formula, const struct sph_ray *ray, const struct sph_leaf *leaf);

/* The same of any ray: the smallest root between least and most. The formulas of float32 round what
 * they are given. */
struct floats floats_hit(int formula, const double org[3], const double dir[3], const double ctr[3],
                         double rad, double least, double most);

#endif
