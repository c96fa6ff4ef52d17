/* axes.h - which axes the grid has
 * SPDX-License-Identifier: Apache-2.0
 *
 * In the camera's axes a pixel is the same step of one component of the direction for all rays, and
 * background can be separated. Walls and furniture stand along the scene's axes, and there a box
 * holds them with less around it; rays then ask for the effect TURNED. Spheres do not care.
 */
#ifndef SPH_AXES_H
#define SPH_AXES_H

#include "scene/scene.h"

/* ---- an eye far away from all that it sees, put nearer ---- */
/* The grid holds the eye, so one that is far away makes it coarse. But from far away all rays are
 * nearly parallel, and an eye nearer by, with a wider angle, sees nearly the same. Let the middle
 * of the scene be c deep, its nearest and farthest points u before and behind it, and let the eye
 * be put c' before the middle, with tan(angle'/2) = tan(angle/2) c / c'. What is c + v deep and x
 * off the axis is seen at x / (c + v), and now, in the same units, at (c' / c) x / (c' + v): that
 * is farther from the middle of the picture by the factor
 *
 *     c' (c + v) / (c (c' + v)),  off 1 by no more than  u (c - c') / (c (c' - u)). */

struct sph_eye {
    struct sph_vec from; /* where it is put */
    double ahead;        /* so much before where it is; 0: it stays */
    double angle;        /* degrees */
    double wider;        /* tan(angle/2) by that of the scene: c / c' */
    double off;          /* by so much of their distance from the middle points are moved in the
                            picture, at most */
};

/* The eye for coordinates of w bits. lo, hi: box of spheres and triangles, in the axes of the
 * camera (it looks along -z), seen from its eye; lo above hi: there is nothing. The eye stays where
 * something lies beside it or behind it, and unless the sum of both errors, the grid's and its own,
 * is halved at least. */
struct sph_eye sph_eye_place(const struct sph_scene *scene, const double axis[3],
                             const double lo[3], const double hi[3], int w);

struct sph_build_options;

enum { SPH_AXES_AUTO = -1, SPH_AXES_CAMERA = 0, SPH_AXES_SCENE = 1 };

/* Rows of the scene's own axes. */
extern const double sph_scene_axes[9];

/* The camera's axes in the scene's frame, as rows x (to the right), y (up) and z: it looks along
 * -z. -1 if it has none. */
int sph_camera_axes(const struct sph_scene *scene, double rows[9], struct sph_error *err);

/* SPH_AXES_CAMERA or SPH_AXES_SCENE: as asked, or for SPH_AXES_AUTO the scene's if the tree has
 * boxes or is a BIH, no background is separated, and around the primitives boxes along them have
 * less than seven eighths of the surface that boxes along the camera's have. */
int sph_axes_of(const struct sph_scene *scene, const struct sph_build_options *o);

#endif
