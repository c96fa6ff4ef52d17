/* huge_bounds.h - what spheres far larger than the scene, and planes, leave of the grid
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_GRID_HUGE_BOUNDS_H
#define SPH_GRID_HUGE_BOUNDS_H

#include "machine/layout.h"
#include "scene/scene.h"

/* ---- a sphere so large that the grid need not hold all of it ---- */
/* The grid must hold every point that a ray meets. Let a sphere, c and r, be opaque and the eye
 * outside of it, and let B be the box of the eye and all else. Rays start in B or on the sphere
 * itself. From there they do not meet it again; from p in B they meet what is seen of it from p,
 * no farther away than its rim, T^2 = |p - c|^2 - r^2. That is largest at a corner of B. So nothing
 * of the sphere is met outside of B and T around it.
 *
 * On the grid p, c and r are off by no more than D together with what points are off, and T^2 by
 * 4 D (r + T). No step is longer than twice the side of the box of all over 2^W, D no longer than
 * twice the margin. */

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

/* ---- how large a grid planes ask for, which have no end ---- */
/* Beyond the grid a plane is lit as where the ray leaves the grid (docs/design/builder.md). Planes
 * that close a room around the eye are seen no farther than its corners; of others the grid should
 * hold so much that nobody sees the difference. */

/* Corners that so many planes may have. */
enum { SPH_CORNERS = SPH_MAX_PLANES * (SPH_MAX_PLANES - 1) * (SPH_MAX_PLANES - 2) / 6 };

/* Corners of the room that planes close around the eye, seen from the eye; 0: it is open. */
int sph_plane_bounds_corners(const struct sph_scene *scene, struct sph_vec corners[SPH_CORNERS]);

/* How far from the eye the grid should go, in units of the scene.
 *
 * Let eye and light be he and hl above a plane, and let the grid end R away. Of a frame that looks
 * along the plane, he / (2 R tan(angle/2)) of the height shows it farther than R; and its cosine
 * with the light is between 0 and hl / R there: the colour is off by less than I hl / R of white.
 * The square of that over the whole frame is that of 50 dB, 10^-5, if
 *
 *     R^3 = 10^5 he hl^2 I^2 / (2 tan(angle/2)). */
double sph_plane_bounds_reach(const struct sph_scene *scene);

#endif
