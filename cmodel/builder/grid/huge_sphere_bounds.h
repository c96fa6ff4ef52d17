/* huge_sphere_bounds.h - a sphere so large that the grid need not hold all of it
 * SPDX-License-Identifier: Apache-2.0
 *
 * The grid must hold every point that a ray meets. Let a sphere, c and r, be opaque and the eye
 * outside of it, and let B be the box of the eye and all else. Rays start in B or on the sphere
 * itself. From there they do not meet it again; from p in B they meet what is seen of it from p,
 * no farther away than its rim, T^2 = |p - c|^2 - r^2. That is largest at a corner of B. So nothing
 * of the sphere is met outside of B and T around it.
 *
 * On the grid p, c and r are off by no more than D together with what points are off, and T^2 by
 * 4 D (r + T). No step is longer than twice the side of the box of all over 2^W, D no longer than
 * twice the margin.
 */
#ifndef SPH_HUGE_SPHERE_BOUNDS_H
#define SPH_HUGE_SPHERE_BOUNDS_H

#include "scene/scene.h"

struct sph_box {
    double lo[3], hi[3];
};

/* Adds a ball to a box. */
void sph_box_add(struct sph_box *box, const double at[3], double rad);

/* The longest side. */
double sph_box_side(const struct sph_box *box);

/* The largest sphere, if the grid may do without a part of it; n_spheres: none. */
uint32_t sph_huge_sphere_find(const struct sph_scene *scene);

/* at: its centre, from the eye. rest: box of the eye and all else. *box, of everything, becomes
 * smaller: centre and what is met. 0 if it does not. */
int sph_huge_sphere_cut(const double at[3], double rad, const struct sph_box *rest, int w,
                        struct sph_box *box);

#endif
