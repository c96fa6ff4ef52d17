/* polygon.h - a polygon as triangles
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_SCENE_POLYGON_H
#define SPH_SCENE_POLYGON_H

#include "common/error.h"
#include "scene/scene.h"

#define SPH_MAX_CORNERS 1024

/* How far a polygon may be from flat, to be one, and from convex, as a part of its size (the
 * greatest distance of a corner from the first): files hold rounded numbers. */
#define SPH_POLYGON_FLAT 1e-3
#define SPH_POLYGON_CONVEX 1e-5

/* Turns a polygon of n = 3 .. SPH_MAX_CORNERS corners into triangles. A convex one becomes a fan:
 * one corner `first` and two that follow each other, in order; `first` is the first corner with
 * which the fewest triangles have no area. Any other one is cut by ears (ears.h). Triangles without
 * area are left out. index[n - 2][3]: corner numbers. *bent: how far the corner that is farthest
 * off is from the polygon's plane, 0 if the polygon is flat. Returns how many triangles, 0 if the
 * polygon has no area; -1 with a message (to stand behind "file:line: ") if its edges cross, seen
 * along the normal of its plane. */
int sph_polygon_cut(const struct sph_vec *corner, int n, int (*index)[3], double *bent,
                    struct sph_error *err);

/* Whether two directions are parallel, up to the rounding of their numbers, or one is zero. */
int sph_parallel(struct sph_vec a, struct sph_vec b);

/* Whether a triangle has no area, up to the rounding of its numbers. */
int sph_triangle_empty(struct sph_vec a, struct sph_vec b, struct sph_vec c);

#endif
