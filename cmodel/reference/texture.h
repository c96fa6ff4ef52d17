/* texture.h - textures of the double reference, with four ways to choose the level
 * SPDX-License-Identifier: Apache-2.0
 *
 * Ray differentials: Igehy 1999; the estimate of BMRT: Gritz and Hahn 1996, as told by Park et al.
 * 2011, section 3; the other two stand in docs/design/textures.md.
 */
#ifndef SPH_REFERENCE_TEXTURE_H
#define SPH_REFERENCE_TEXTURE_H

#include <stdint.h>

#include "scene/scene.h"
#include "scene/texture_base.h"
#include "texture/texel.h"

/* ---- the level of a hit by path length and by BMRT's estimate, arithmetic counted ---- */
/* Park et al. 2011, sections 3 and 4, and their Table I. All start from the length of the path to
 * the hit, which has to be summed up for each of them, and end with a level that is not limited. */

enum {
    SPH_WAY_BMRT,       /* edges of a triangle are there, from the intersection test */
    SPH_WAY_BMRT_ALONE, /* they are not */
    SPH_WAY_KEPT,       /* path length, log2(P_b) made before */
    SPH_WAY_ANEW,       /* path length, P_b made at the hit; edges and normal are there */
    SPH_WAY_ANEW_ALONE, /* they are not */
    SPH_WAYS
};

/* Decisions by kind of primitive, and what they took. */
struct sph_level_work {
    uint64_t hits[SPH_SHAPES];
    struct sph_flops flops[SPH_WAYS][SPH_SHAPES];
};

/* A hit. */
struct sph_choice {
    struct sph_texture_shape shape; /* `given`: for the ways that take it so */
    double from[3];                 /* sphere: the hit, from the centre */
    double length;                  /* of the path */
    double side[2];                 /* texels of the image */
};

/* log2(P_l) - log2(P_b). */
double sph_choose_path(double length, double base, struct sph_flops *flops);

/* The larger of du and dv: what a pixel at that distance covers, over |dP/ds| and |dP/dt|. */
double sph_choose_bmrt(const struct sph_choice *choice, const struct sph_texture_view *view,
                       struct sph_flops *flops);

/* Every way once; work may be NULL. level[SPH_WAYS]. */
void sph_choose_all(const struct sph_choice *choice, const struct sph_texture_view *view,
                    struct sph_level_work *work, double *level);

void sph_level_work_add(struct sph_level_work *to, const struct sph_level_work *more);

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
