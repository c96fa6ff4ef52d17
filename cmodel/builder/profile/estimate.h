/* estimate.h - how far a profile's picture will be from the scene, before it is drawn
 * SPDX-License-Identifier: Apache-2.0
 *
 * Rays of some pixels and of their neighbours go through the scene in double precision; what the
 * grid, the directions and the quotient of a profile can move on their way is known. The bounds:
 * docs/design/builder.md.
 */
#ifndef SPH_ESTIMATE_H
#define SPH_ESTIMATE_H

#include "builder/build.h"

struct sph_estimate {
    int fits;      /* 0: camera or scene do not fit the profile, nothing below is set */
    double pixels; /* the farthest that a point which the eye sees is moved, pixels */
    double wrong;  /* the part of the frame's pixels that see another primitive, or none, at most */
    double psnr;   /* dB of the deepest colours, at least */
};

/* Estimates n profiles for the frame, effects and depth of the options; at most SPH_ESTIMATES. 0,
 * or -1 with a message if memory is out. */
enum { SPH_ESTIMATES = 8 };
int sph_estimate(const struct sph_scene *scene, const struct sph_build_options *options,
                 const struct sph_profile *profiles, int n, struct sph_estimate *estimates,
                 struct sph_error *err);

#endif
