/* grid.h - axes, grid and primary rays: real numbers to integers
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_GRID_H
#define SPH_GRID_H

#include "builder/grid/axes.h"
#include "builder/grid/bound.h"
#include "machine/profile.h"
#include "scene/scene.h"

enum { SPH_GRID_MARGIN = 4 }; /* grid units kept free at each side */

struct sph_grid {
    int axes;           /* SPH_AXES_CAMERA or SPH_AXES_SCENE */
    double camera[9];   /* rows: camera x, y, z axes in the scene's frame */
    double rotation[9]; /* rows: those of the grid */
    double origin[3];   /* coordinates of grid point 0 along them */
    struct sph_eye seen_from;
    uint32_t huge;  /* sphere that is not all on it (huge_bounds.h); n_spheres: none */
    int32_t eye[3]; /* grid units, exact */
    int log2;       /* a grid unit is 2^log2 scene units */
    double step;    /* 2^log2 */
    int w;          /* bits of a coordinate */
};

/* Finds the finest power-of-two grid of w bits, in axes that are chosen (axes.h), that holds the
 * scene (docs/design/builder.md). -1 if the camera has no direction or a number of the scene is not
 * usable. */
int sph_grid_fit(const struct sph_scene *scene, int w, int axes, struct sph_grid *grid,
                 struct sph_error *err);

/* A point, and a sphere, of the scene in grid units, to nearest (halves away from zero). */
void sph_grid_point(const struct sph_grid *grid, struct sph_vec p, int32_t out[3]);
struct sph_ball sph_grid_ball(const struct sph_grid *grid, const struct sph_sphere *sphere);

/* The same before rounding, as far away as it may be. */
void sph_grid_real(const struct sph_grid *grid, struct sph_vec p, double out[3]);

/* Whether a ball lies on the grid, with the margin. */
int sph_grid_fits(const struct sph_grid *grid, const struct sph_ball *ball);

/* How far the grid moves a point of the scene, in units of the scene. */
double sph_grid_off(const struct sph_grid *grid, struct sph_vec p);

/* Quantises all spheres. -1 for a radius that rounds to nothing and for duplicates, with line
 * and the finer profile that helps. 1 if no finer one does: then lost[i] is SPH_READ_SPHERE_SMALL
 * or SPH_READ_SPHERE_GRID for each such sphere, and stays 0 for the others. *smallest: the smallest
 * radius in grid units, unrounded. */
int sph_grid_spheres(const struct sph_grid *grid, const struct sph_scene *scene,
                     const struct sph_profile *profile, struct sph_ball *balls, uint8_t *lost,
                     double *smallest, struct sph_error *err);

/* The profiles that are finer than one and whose grids hold the scene, the coarsest first. */
struct sph_finer {
    int n, profile[SPH_PROFILES];
    struct sph_grid grid[SPH_PROFILES];
};

void sph_finer_of(const struct sph_scene *scene, const struct sph_profile *profile, int axes,
                  struct sph_finer *finer);

/* The next finer profile under which a radius is at least `units` grid units, or -1. */
int sph_grid_finer(const struct sph_scene *scene, const struct sph_profile *profile, int axes,
                   double rad, double units);

/* What of a camera makes directions: a width x height raster with a vertical field of view of
 * `angle` degrees, its middle `shift` heights to the right of the view and above it. */
struct sph_raster {
    int width, height;
    double angle, shift[2];
};

/* That of a camera for a picture of width x height pixels, seen at an angle (struct sph_eye); of a
 * wall, that of all its pictures together. */
struct sph_raster sph_raster_of(const struct sph_camera *camera, int width, int height,
                                double angle);

/* dir(x, y) = (x0 + x*pitch, y0 - y*pitch, z), integers of wd bits. */
struct sph_rays {
    int32_t x0, y0, z, pitch;
    double fov_error; /* relative, of tan(angle/2) and of the shift's rounding */
};

/* Primary rays of a raster. -1 if it is too large for wd bits. */
int sph_rays_fit(const struct sph_raster *raster, int wd, struct sph_rays *rays,
                 struct sph_error *err);

/* The same for a profile, with a screen as far away as its quotient asks; the message ends with the
 * finer profile that would do, if one does. */
int sph_rays_of(const struct sph_raster *raster, const struct sph_profile *profile,
                struct sph_rays *rays, struct sph_error *err);

/* The same rays along the axes of a grid that are not the camera's: first + x*across + y*down, of
 * 32 bits, of which the top WD are a direction. They are as long as WD bits hold. */
struct sph_steps {
    int32_t first[3], across[3], down[3];
    double off; /* relative to the middle of the picture, by roundings of the last two: at most */
};

/* -1 if the screen comes too near for the profile. */
int sph_rays_turn(const struct sph_rays *rays, const struct sph_raster *raster,
                  const struct sph_grid *grid, const struct sph_profile *profile,
                  struct sph_steps *steps, struct sph_error *err);

/* Makes rays, and steps unless they are NULL, of a wall those of the camera's picture in it, of
 * width x height pixels: they are the same, from another pixel on. */
void sph_rays_tile(const struct sph_camera *camera, int width, int height, struct sph_rays *rays,
                   struct sph_steps *steps);

#endif
