/* cycles.h - how many clocks a core needs for a frame, without simulating it
 * SPDX-License-Identifier: Apache-2.0
 *
 * Pixels come in columns of 8 (docs/design/overview.md), and an engine has as many under way as a
 * square of 8 x 8. While it draws such a square each unit has to do what the model counts there, in
 * the clocks that machine.def knows (`load`), and the one that needs most of them ends last: the
 * frame takes the sum over all squares of the most that a unit needs. What it leaves out: waiting
 * for memory, the way of a pixel through an empty core, and rare work that no counter has.
 * docs/results/data/cycles.tsv holds it against the RTL.
 */
#ifndef SPH_TRIAL_CYCLES_H
#define SPH_TRIAL_CYCLES_H

#include "machine/machine.h"

/* Sizes of a core, by the names of rt_core's parameters. */
struct sph_core_sizes {
#define SPH_SIZE_FIELD(NAME, standard) int64_t NAME;
    SPH_EACH_SIZE(SPH_SIZE_FIELD)
};

/* The defaults, with the pace of the machine's profile: as sim/cores.py has them. */
struct sph_core_sizes sph_core_sizes_of(const struct sph_machine *m);

#define SPH_LOAD_NAME(name, ...) SPH_LOAD_##name,
enum { SPH_EACH_LOAD(SPH_LOAD_NAME) SPH_LOADS };

/* "node visits" and so on. */
const char *sph_load_name(int load);

struct sph_cycles {
    double frame;            /* clocks of the window */
    double pixel;            /* of one of its pixels */
    double binds[SPH_LOADS]; /* part of them in which this unit is the one that needs most */
    int most;                /* the one that binds longest, SPH_LOAD_*; -1: the window is empty */
    uint64_t drawn;          /* pixels that were drawn to know */
    double count[SPH_COUNTERS]; /* of the model, a pixel of these */
};

/* Of a core that has all that the machine asks for, and no more. most: about so many pixels of the
 * window are drawn, a square of each of as many runs of them; 0: all. threads: 0: all. */
struct sph_cycles sph_cycles_expect(const struct sph_machine *m, const struct sph_core_sizes *sizes,
                                    uint32_t most, int threads);

#endif
