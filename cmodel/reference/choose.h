/* choose.h - the level of a hit by path length and by BMRT's estimate, arithmetic counted
 * SPDX-License-Identifier: Apache-2.0
 *
 * Park et al. 2011, sections 3 and 4, and their Table I. All start from the length of the path to
 * the hit, which has to be summed up for each of them, and end with a level that is not limited.
 */
#ifndef SPH_CHOOSE_H
#define SPH_CHOOSE_H

#include "scene/texture_base.h"

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

#endif
