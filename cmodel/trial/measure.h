/* measure.h - a machine of a scene drawn and compared with the scene as it is written
 * SPDX-License-Identifier: Apache-2.0
 *
 * The yardstick is the double reference. It is drawn once for a scene, a camera and a size; then
 * any number of machines are measured by it. Of a large frame a sample will do: the frame is cut
 * into equal cells, and of each the pixel counts that a fixed random number names. Every pixel is
 * as likely as any other to be one, so that means over the sample are those of the frame; what it
 * can miss has a bound.
 */
#ifndef SPH_TRIAL_MEASURE_H
#define SPH_TRIAL_MEASURE_H

#include "builder/build.h"
#include "core/frame.h"
#include "reference/accuracy.h"

/* What a picture should be. The scene belongs to the caller and must outlive it. */
struct sph_yardstick {
    const struct sph_scene *scene;
    int width, height;              /* of the frame, pixels */
    uint32_t *places;               /* of the sample, y * width + x; NULL: every pixel counts */
    struct sph_reference reference; /* of these pixels in their order, or of the whole frame */
    double seconds;                 /* of processor, all threads */
};

struct sph_yardstick_options {
    uint32_t most; /* pixels of the sample at most; 0: the whole frame */
    int lod;       /* SPH_LOD_*, of the reference */
    int threads;   /* 0: all */
    int as_asked;  /* 1: shadows, mirrors, glass and highlights that are off are so here, too */
};

/* Draws the yardstick for the size, depth and textures that build options ask for, with all other
 * effects that the scene has. Images are options->mips. 0, or -1 with a message and nothing to
 * free: as sph_reference_render(). */
int sph_yardstick_make(const struct sph_scene *scene, const struct sph_build_options *options,
                       const struct sph_yardstick_options *how, struct sph_yardstick *yardstick,
                       struct sph_error *err);

void sph_yardstick_free(struct sph_yardstick *yardstick);

/* A machine, what it drew and how good that is. */
struct sph_trial {
    struct sph_machine machine;
    struct sph_build_report report;
    struct sph_shot shot;         /* pixels as those of the yardstick's reference, counters of them
                                     alone; ids of the scene */
    uint32_t *numbers;            /* of sph_build_options */
    struct sph_trail *trails;     /* of these pixels */
    struct sph_accuracy accuracy; /* of these pixels */
    uint64_t wrong;               /* of them: another object than the scene's, or none in one */
    double wrong_most;            /* part of the frame's pixels that is wrong at most */
    double psnr_least;            /* dB of the deepest colours of the frame, at least */
    double seconds;               /* of drawing, of processor, all threads */
};

/* Bounds of a sample hold with this probability. That of wrong pixels is Clopper and Pearson's; for
 * a pixel out of each cell it is a little too wide (W. Hoeffding, Ann. Math. Stat. 27, 1956). That
 * of dB is sph_squares_psnr_least(). */
#define SPH_TRIAL_SURE 0.975

/* Squared errors of some pixels, in integers: their order, and so threads, change nothing. */
struct sph_squares {
    uint64_t n;
    uint64_t square;  /* sum over pixels and channels, levels^2 */
    uint64_t weighed; /* u32.32, what sph_squares_psnr_least() goes by */
};

void sph_squares_add(struct sph_squares *s, uint32_t colour, uint32_t like);

/* dB if n pixels have these errors together. No error: INFINITY. */
double sph_squares_psnr(const struct sph_squares *s, uint64_t n);

/* dB, at least, of the frame that they are a sample of, whatever its errors are like: of all
 * SPH_PROFILES machines measured by one yardstick with probability SPH_TRIAL_SURE. With errors x of
 * pixels, 0..1, of mean m, the mean of the product of all 1 - b x is at most (1 - b m)^n, for any b
 * below 1; Markov's inequality then bounds m (I. Waudby-Smith, A. Ramdas, J. R. Stat. Soc. B 86,
 * 2024, with one bet b). */
double sph_squares_psnr_least(const struct sph_squares *s);

/* Builds a machine of the yardstick's scene, draws its pixels and measures them. The options may
 * ask for any profile, tree and effects; size, depth and images must be those of the yardstick.
 * options->numbers is not used. 0, or -1 with a message and nothing to free: of build, or no
 * memory. */
int sph_trial_measure(const struct sph_yardstick *yardstick,
                      const struct sph_build_options *options, int threads, struct sph_trial *trial,
                      struct sph_error *err);

/* The same in two steps, of a machine that was built already: trial->machine, report and numbers
 * are set, all else is 0, and sph_trial_free() is the caller's also after -1. Draws; then judges,
 * and ids of frame and trails become the scene's, which are others where build left something out.
 */
int sph_trial_draw(const struct sph_yardstick *yardstick, int threads, struct sph_trial *trial,
                   struct sph_error *err);
void sph_trial_judge(const struct sph_yardstick *yardstick, struct sph_trial *trial);

void sph_trial_free(struct sph_trial *trial);

/* The largest part of a whole of which k of n random ones, or fewer, are still to be expected with
 * probability 1 - SPH_TRIAL_SURE: Clopper and Pearson, Biometrika 26, 1934. n = 0: 1. */
double sph_trial_at_most(uint64_t k, uint64_t n);

#endif
