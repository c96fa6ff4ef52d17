/* price.h - what accuracy costs in time: machines of a scene beside each other
 * SPDX-License-Identifier: Apache-2.0
 *
 * A row is a machine and the core that draws it: how far its picture is from the scene, measured
 * and expected; clocks of the core, and what was measured of its cells and its clock.
 */
#ifndef SPH_TRIAL_PRICE_H
#define SPH_TRIAL_PRICE_H

#include "trial/choose.h"
#include "trial/cycles.h"
#include "trial/energy.h"
#include "trial/known.h"

enum { SPH_PRICE_ROWS = 16 };

struct sph_price_options {
    struct sph_error_bound bound;
    const struct sph_profile *only; /* NULL: a row for each profile; else one of these widths */
    uint32_t most;                  /* pixels of a sample: sph_yardstick_make() */
    int more;                       /* 1: rows of single knobs too */
    int met;                        /* 1: machines without what no ray of the frame meets */
    int threads;                    /* 0: all */
};

struct sph_price_row {
    char name[96]; /* "standard", "standard, 2 pipes", "standard:pq=13" */
    struct sph_profile profile;
    int built; /* 0: why it cannot be, in `why`, and nothing below is set */
    char why[512];
    struct sph_estimate expected;
    struct sph_accuracy accuracy; /* measured, of `pixels` of image */
    uint64_t wrong;               /* of them: sph_trial */
    double wrong_most, psnr_least;
    struct sph_cycles cycles;
    struct sph_core_sizes sizes;
    char tree[24], core[160];    /* of the machine; effects as EFFECTS of make has them */
    struct sph_known_core known; /* cells and clock of this core, or estimated, or all 0 */
    double milliseconds;         /* a frame at that clock; 0: it is not known */
    struct sph_energy energy;    /* in standard cells */
    int keeps;                   /* what is asked for, measured */
};

struct sph_price {
    int width, height, sampled; /* sampled: of the pixels some */
    int n, best;                /* rows; the cheapest that keeps, -1: none does */
    struct sph_price_row row[SPH_PRICE_ROWS];
    char tried[512]; /* single knobs that do not pay, so that they have no row; "a, b" */
};

/* Builds, draws and measures every row for the size, depth, tree and effects of the options. A
 * profile that cannot hold the scene is a row that says why. The cheapest row is that of the first
 * profile that keeps what is asked for: psnr_least is at least bound.psnr, and no point is expected
 * to be moved by more than bound.pixels. Single knobs are those of that row, or of the finest that
 * was built; they pay if the picture stays as good with fewer bits, or its clocks are fewer. 0, or
 * -1 with a message: no memory, or a size that is none. */
int sph_price_make(const struct sph_scene *scene, const struct sph_build_options *build,
                   const struct sph_price_options *options, struct sph_price *price,
                   struct sph_error *err);

/* What to say under the rows: which one is cheapest, or what comes nearest and what it lacks. */
void sph_price_says(const struct sph_price *price, const struct sph_error_bound *bound, char *text,
                    size_t size);

#endif
