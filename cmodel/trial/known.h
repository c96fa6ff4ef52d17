/* known.h - cells and clocks of cores that somebody has synthesised or routed, for an ECP5
 * SPDX-License-Identifier: Apache-2.0
 *
 * known_table.h has them, written by `python3 -m lab known` from docs/results/data. All other sizes
 * of these cores are those that their profile has by itself. What a core of one pipe lacks there is
 * estimated: its cells are those of the nearest core of its profile, and what the words cost in
 * which they differ, a median over all pairs of cores in the table that tell; its clock is that of
 * the nearest core that was routed. Of cores whose cells are known the estimate is off by 2.2 % in
 * the mean and 14 % at most (tests/trial/test_known.c).
 */
#ifndef SPH_TRIAL_KNOWN_H
#define SPH_TRIAL_KNOWN_H

struct sph_known_core {
    const char *profile, *effects; /* as PROFILE and EFFECTS of make have them */
    int pipes;
    int lut4eq, mult, bram;     /* LUT4 and two for each CCU2C, MULT18X18D, DP16KD; 0: not known */
    double worst, median, best; /* MHz after routing, speed grade 8; 0: not known */
    int seeds;                  /* that they are of */
    int cells_estimated, clock_estimated; /* 1: of other cores */
};

/* What is known of a core, or estimated. Of widths or words that no core in the table has, nothing:
 * all is 0. */
struct sph_known_core sph_known_core(const char *profile, const char *effects, int pipes);

/* The same without what the table has of it. */
struct sph_known_core sph_known_estimate(const char *profile, const char *effects, int pipes);

#endif
