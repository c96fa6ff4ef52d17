/* ears.h - a polygon that is not convex as triangles, by cutting off ears
 * SPDX-License-Identifier: Apache-2.0
 *
 * Meisters, Polygons have ears, American Mathematical Monthly 82(6), 1975. All is decided by signs
 * of determinants of the numbers as they are, exactly: no tolerance.
 */
#ifndef SPH_SCENE_EARS_H
#define SPH_SCENE_EARS_H

#include "common/error.h"
#include "scene/scene.h"

/* The sign of (b - a) x (c - a), exact. */
int sph_turn(const double a[2], const double b[2], const double c[2]);

/* Cuts a polygon of n > 3 corners, whose edges may touch each other and lie on each other, as those
 * between an outline and a hole in it do, seen along -normal, counterclockwise, on the plane of two
 * axes that shows most of it. index[n - 2][3]: corner numbers, an ear in the middle; the last
 * triangle begins with corner 0. From them the outline can be told again (prim_triangle.c). 0, or
 * -1 with a message (to stand behind "file:line: ") if edges cross, or the outline goes over
 * itself. */
int sph_polygon_ears(const struct sph_vec *corner, int n, struct sph_vec normal, int (*index)[3],
                     struct sph_error *err);

#endif
