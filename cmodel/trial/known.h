/* known.h - cells and clocks of cores that somebody has synthesised or routed, for an ECP5
 * SPDX-License-Identifier: Apache-2.0
 *
 * known_table.h has them, written by `python3 -m lab known` from docs/results/data. All other sizes
 * of these cores are those that their profile has by itself.
 */
#ifndef SPH_TRIAL_KNOWN_H
#define SPH_TRIAL_KNOWN_H

struct sph_known_core {
    const char *profile, *effects; /* as PROFILE and EFFECTS of make have them */
    int pipes;
    int lut4eq, mult, bram;     /* LUT4 and two for each CCU2C, MULT18X18D, DP16KD; 0: not known */
    double worst, median, best; /* MHz after routing, speed grade 8; 0: not known */
    int seeds;                  /* that they are of */
};

/* That very core, or NULL. */
const struct sph_known_core *sph_known_core(const char *profile, const char *effects, int pipes);

#endif
