/* check.h - what the checks of a case share; see hard.h
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef HARD_CHECK_H
#define HARD_CHECK_H

#include "hard.h"

struct job {
    const struct sph_profile *p;
    const struct hard_case *c;
    struct sph_ray ray; /* set up */
    int naive, mistakes;
    struct hard_tally *t;
    FILE *out;
};

/* Counts a mistake of ours, and says so. */
void job_wrong(struct job *j, int check, const char *what);

/* Of two hits: the sign of t1 - t2, the keys, what floats say of each (f NULL: nothing). */
void job_order(struct job *j, int order, const uint64_t key[2], const struct sph_floats *f,
               const struct sph_floats *g);

/* One for each kind of case but spheres: the model against its oracle and the naive model; floats.
 */
typedef void job_check(struct job *j);
job_check check_facets, check_refraction, check_around, check_texels, check_levels, check_clips,
    check_walks, check_units;

#endif
