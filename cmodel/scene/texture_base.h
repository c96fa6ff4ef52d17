/* texture_base.h - P_b: how far away a pixel is as large as a texel
 * SPDX-License-Identifier: Apache-2.0
 *
 * Park et al. 2011, section 4, in five steps; what of it is taken and what is mended, and why,
 * stands in docs/design/textures.md. Every step counts its arithmetic (flops.h).
 */
#ifndef SPH_TEXTURE_BASE_H
#define SPH_TEXTURE_BASE_H

#include "math/flops.h"

enum { SPH_SHAPE_TRIANGLE, SPH_SHAPE_PLANE, SPH_SHAPE_SPHERE, SPH_SHAPES };

/* A primitive as P_b sees it; lengths in grid units. */
struct sph_texture_shape {
    int kind;            /* SPH_SHAPE_* */
    double corner[3][3]; /* triangle */
    int given;           /* triangle: 1: edges and normal are there, from the intersection test */
    double edge[2][3];   /* from corner 0 to 1, to 2 */
    double normal[3];    /* their cross product */
    double st[3][2];     /* triangle: coordinates of the corners in the image; plane: [0] one
                            repeat along s and t; sphere: [0] repeats around and down */
    double rad;          /* sphere */
};

/* What lies on a surface. */
struct sph_texture_area {
    double size;   /* T_size, of the triangle in space, grid units^2 */
    double share;  /* of the triangle in the image, in images: 1 is all of it; not negative */
    double texels; /* RES_texture, of the whole image */
};

/* What sees it. */
struct sph_texture_view {
    double distance; /* of the screen, pixels */
    double pixels;   /* RES_screen, of the frame */
    double step;     /* scene units of a grid unit */
    int literal;     /* 1: the formula as printed */
};

/* Triangle: edges, and how s and t change along them. */
void sph_texture_edges(const struct sph_texture_shape *shape, double edge[2][3], double d[2][2],
                       struct sph_flops *flops);

/* Steps 1 and 4, without RES_texture: a triangle's own, one repeat of a plane, a whole sphere. */
struct sph_texture_area sph_texture_area_of(const struct sph_texture_shape *shape, double texels,
                                            struct sph_flops *flops);

/* log2 of P_b in grid units; INFINITY without texels. The logarithms of the view are of the frame
 * and not counted. */
double sph_texture_base_log2(const struct sph_texture_area *area,
                             const struct sph_texture_view *view, struct sph_flops *flops);

/* The same, s7.8: to nearest, limited. No texels at all: the largest, level 0. */
int sph_texture_base(const struct sph_texture_area *area, const struct sph_texture_view *view,
                     struct sph_flops *flops);

#endif
