/* texture.h - textures of the double reference, with four ways to choose the level
 * SPDX-License-Identifier: Apache-2.0
 *
 * Ray differentials: Igehy 1999; the estimate of BMRT: Gritz and Hahn 1996, as told by Park et al.
 * 2011, section 3; the other two stand in docs/design/textures.md.
 */
#ifndef SPH_REFERENCE_TEXTURE_H
#define SPH_REFERENCE_TEXTURE_H

#include <stdint.h>

#include "reference/choose.h"
#include "scene/scene.h"
#include "texture/mip.h"

enum {
    SPH_LOD_MENDED, /* length of the path, P_b as the machine has it; spread, if the machine does */
    SPH_LOD_PRINTED, /* the same, P_b as the paper prints it */
    SPH_LOD_BMRT,    /* the longer side of a pixel at the path's length, over each axis */
    SPH_LOD_RAYS,    /* ray differentials: the longer edge of the pixel's footprint */
    SPH_LODS
};

/* What all lookups of a picture share. */
struct sph_ref_textures {
    const struct sph_scene *scene;
    const struct sph_mip *mips; /* of the scene's textures, as sph_build_options has them */
    int filter;                 /* SPH_FILTER_* */
    int lod;                    /* SPH_LOD_*: the one that colours see */
    double screen;              /* distance of the screen, pixels */
    double pixels;              /* of the frame */
    int spread;                 /* 1: SPH_LOD_MENDED goes by what spheres spread */
};

/* What travels with a ray from the eye on: its length, and how its origin and unit direction change
 * from pixel to pixel, along x and along y. */
struct sph_ref_path {
    double length;
    double org[2][3], dir[2][3];
    double wide, spread; /* length as spheres spread it, and how fast it grows */
};

/* A primary ray; right and up: what dir changes by from a pixel to the next. */
void sph_ref_path_start(struct sph_ref_path *path, const double dir[3], const double right[3],
                        const double up[3]);

/* On to the hit at t * dir, on a surface with that normal, of any length. */
void sph_ref_path_hit(struct sph_ref_path *path, const double dir[3], double t,
                      const double normal[3]);

/* Reflected there; the unit normal changes by curvature times the point: 1 / radius of a sphere
 * seen from outside, -1 / radius from inside, 0 of a facet. dir: before. */
void sph_ref_path_mirror(struct sph_ref_path *path, const double dir[3], const double normal[3],
                         double curvature);

/* Refracted there; ratio: index of refraction before over that behind. */
void sph_ref_path_refract(struct sph_ref_path *path, const double dir[3], const double normal[3],
                          double curvature, double ratio);

/* Colour 0..1 at the point `at` of a primitive (spheres, then facets), and the level of each way,
 * limited to the image's. 0 if it has no texture: rgb is 1, lod is not set. work: what choosing
 * took is added, may be NULL. */
int sph_ref_texture(const struct sph_ref_textures *textures, uint32_t id, const double at[3],
                    const struct sph_ref_path *path, double rgb[3], double lod[SPH_LODS],
                    struct sph_level_work *work);

#endif
