/* judge.h - dB of a scene's picture in some widths, drawn and not estimated
 * SPDX-License-Identifier: Apache-2.0
 *
 * What is drawn is the picture alone: of a tree that is quick to build, since pixels do not depend
 * on it, pixel by pixel, and no longer than it takes to know that a bound is missed.
 */
#ifndef SPH_TRIAL_JUDGE_H
#define SPH_TRIAL_JUDGE_H

#include "builder/profile/estimate.h"
#include "trial/measure.h"

/* Pixels of a frame that are drawn at most, which is about a second of work; those of a larger
 * frame are a sample. Scenes of more primitives are not judged: their trees take longer. */
enum { SPH_JUDGE_PIXELS = 1 << 19, SPH_JUDGE_PRIMS = 1 << 17 };

struct sph_measured {
    uint64_t pixels, of; /* compared, of the frame's; pixels 0: it was not measured, or cannot be
                            built */
    int memory;          /* it was not measured because memory is short */
    int left;            /* the bound is missed: some were not drawn, and psnr is what it is at
                            most */
    double psnr;         /* dB of the deepest colours */
    double psnr_least;   /* of the frame: psnr, or of a sample what SPH_TRIAL_SURE tells */
};

struct sph_judge {
    struct sph_scene scene; /* as it is to be drawn: fewer lights, if so many were asked for */
    struct sph_build_options options;
    struct sph_yardstick yardstick;
    uint64_t decidable; /* pixels of it that doubles can tell */
    struct sph_progress
        quiet; /* asks who watches the build whether it goes on, and tells nothing */
};

/* Why a picture of these options cannot be judged: it is not meant to be that of the scene as it is
 * written, or it takes too long. NULL if it can. */
const char *sph_judge_cannot(const struct sph_scene *scene, const struct sph_build_options *o);

/* Draws the yardstick of a scene that sph_judge_cannot() has nothing against and that outlives
 * *judge. 0, or -1 with a message: as sph_yardstick_make(). */
int sph_judge_begin(const struct sph_scene *scene, const struct sph_build_options *o,
                    struct sph_judge *judge, struct sph_error *err);
void sph_judge_end(struct sph_judge *judge);

/* Builds and draws the picture of some widths, until it is whole, its dB are below enough, or who
 * watches the build has ended it. What cannot be built has pixels 0. */
struct sph_measured sph_judge_widths(const struct sph_judge *judge,
                                     const struct sph_profile *widths, double enough);

/* The same of one yardstick that is used once, and of all pixels: -1 with a message as
 * sph_judge_begin(). */
int sph_judge_once(const struct sph_scene *scene, const struct sph_build_options *o,
                   const struct sph_profile *widths, struct sph_measured *measured,
                   struct sph_error *err);

/* ---- what is asked for, and what is known ---- */

/* What a picture must not miss: how far a point that the eye sees is moved at most, in pixels, and
 * dB of its colours. */
struct sph_error_bound {
    double pixels, psnr;
};

#define SPH_ERROR_BOUND_PIXELS 0.125
#define SPH_ERROR_BOUND_PSNR 45.0

/* What is known of the picture of some widths. */
struct sph_known_picture {
    struct sph_estimate expected; /* its dB are a mean, its pixels a bound */
    struct sph_measured measured;
};

/* Whether that is within the bound: measured if it was, else expected. */
int sph_picture_keeps(const struct sph_known_picture *p, const struct sph_error_bound *bound);

/* "measured 47.0 dB of 57600 pixels, 0.012 pixels off at most", or "expected 45.4 dB, a mean, ...";
 * returns text. */
const char *sph_picture_says(const struct sph_known_picture *p, char *text, size_t size);

#endif
