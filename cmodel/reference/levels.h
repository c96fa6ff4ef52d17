/* levels.h - the levels of a textured picture, the machine's and those of other ways
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_REFERENCE_LEVELS_H
#define SPH_REFERENCE_LEVELS_H

#include "core/frame.h"
#include "reference/reference.h"

/* Pixels by the angle between ray and normal, in steps of SPH_SLANT_STEP degrees. Only those count
 * whose levels no image limits. */
#define SPH_SLANT_STEP 5
#define SPH_SLANTS (90 / SPH_SLANT_STEP)

struct sph_slant {
    uint64_t pixels, near;     /* near: path length at most a level from ray differentials */
    double path, bmrt;         /* means of level less that of ray differentials */
    double path_low, path_top; /* path: least and most */
};

/* The machine's own level less that of ray differentials, which no image limits. */
struct sph_level_error {
    uint64_t pixels;
    double mean, deviation;
};

struct sph_levels {
    uint64_t pixels;              /* that see the same primitive, and a texture, in both */
    double model_mean;            /* machine's lod against SPH_LOD_MENDED: mean of what it is off */
    double model_worst;           /* and the most */
    double mean[SPH_LODS];        /* level of each way; below: less that of SPH_LOD_RAYS */
    double off[SPH_LODS];         /* mean of the amount */
    double within_half[SPH_LODS]; /* share of pixels off by at most half a level */
    struct sph_slant slant[SPH_VIAS][SPH_SLANTS];
    struct sph_level_error error[SPH_VIAS];
};

/* Frame and reference of one scene, size and image; all zero without such pixels. */
struct sph_levels sph_levels_measure(const struct sph_frame *frame,
                                     const struct sph_reference *reference);

#endif
