/* check.h - what the checks of a case share; see hard.h
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef HARD_CHECK_H
#define HARD_CHECK_H

#include "exact.h"
#include "facet.h"

struct job {
    const struct sph_profile *p;
    const struct hard_case *c;
    struct sph_ray ray; /* set up */
    int naive, mistakes;
    struct hard_tally *t;
    FILE *out;
};

/* What is said of one sphere, of one facet. */
struct sphere_answer {
    struct exact exact;
    uint64_t key; /* of the model, 0: none */
    int hit;
    struct sph_floats floats[HARD_COLUMNS];
};
struct facet_answer {
    struct facet_exact exact;
    uint64_t key;
    int hit;
    struct sph_floats floats[HARD_COLUMNS];
};

/* The model of one of them against oracle and naive model, floats beside it. */
void check_sphere(struct job *j, const struct sph_leaf *s, struct sphere_answer *a);
void check_facet(struct job *j, const struct sph_facet_leaf *f, struct facet_answer *a);

/* Counts a mistake of ours, and says so. */
void job_wrong(struct job *j, int check, const char *what);

/* Of two hits: the sign of t1 - t2, the keys, what floats say of each (f NULL: nothing). */
void job_order(struct job *j, int order, const uint64_t key[2], const struct sph_floats *f,
               const struct sph_floats *g);

/* One for each kind of case but spheres: the model against its oracle and the naive model; floats.
 */
typedef void job_check(struct job *j);
job_check check_facets, check_refraction, check_around, check_texels, check_levels, check_clips,
    check_walks, check_units, check_ties;

#endif
