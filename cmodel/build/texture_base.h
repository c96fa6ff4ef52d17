/* texture_base.h - P_b: how far away a pixel is as large as a texel
 * SPDX-License-Identifier: Apache-2.0
 *
 * Park et al. 2011, section 4, in five steps; what of it is taken and what is mended, and why,
 * stands in docs/lod.md.
 */
#ifndef SPH_TEXTURE_BASE_H
#define SPH_TEXTURE_BASE_H

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

/* log2 of P_b in grid units; INFINITY without texels. */
double sph_texture_base_log2(const struct sph_texture_area *area,
                             const struct sph_texture_view *view);

/* The same, s7.8: to nearest, limited. No texels at all: the largest, level 0. */
int sph_texture_base(const struct sph_texture_area *area, const struct sph_texture_view *view);

#endif
