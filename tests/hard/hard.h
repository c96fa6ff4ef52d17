/* hard.h - hard cases: what a case is, and what is counted
 * SPDX-License-Identifier: Apache-2.0
 *
 * Data flows one way: family or named case -> check -> tally -> report. A generated case is a
 * function of seed, family, profile and number alone.
 */
#ifndef HARD_H
#define HARD_H

#include <stdint.h>
#include <stdio.h>

#include "machine/layout.h"
#include "machine/profile.h"
#include "scene/rng.h"
#include "prim/facet.h"
#include "prim/sphere.h"
#include "reference/floats.h"
#include "core/ray.h"

enum { HARD_ID = 7, HARD_OTHER = 9 }; /* ids of the first and the second sphere */

/* What a case is of, and so which of its words count. */
enum {
    HARD_SPHERES,    /* ray, sphere[n] */
    HARD_FACETS,     /* ray, facet[n], through */
    HARD_REFRACTION, /* dir of ray, v: the normal, from, to */
    HARD_AROUND,     /* v: s2.16, longitude and latitude of an image */
    HARD_TEXELS,     /* texel */
    HARD_LEVELS,     /* level */
    HARD_CLIPS,      /* ray, clip: a plane of a BIH */
    HARD_WALKS,      /* ray, sphere[2]: through a BIH and through one leaf */
    HARD_UNITS,      /* v: s(WD) */
    HARD_TIES,       /* ray, sphere[0], facet[0] */
    HARD_KINDS
};
extern const char *const hard_kinds[HARD_KINDS];

/* Of the ray, what set-up does not make. */
struct hard_case {
    int of; /* one of the above */
    struct sph_ray ray;
    struct sph_leaf sphere[2];
    struct sph_facet_leaf facet[2];
    int n;       /* spheres, facets */
    int through; /* the ray's line meets a point of each of the facets */
    int64_t v[3];
    uint32_t from, to; /* indices of refraction, thousandths */
    struct {
        int64_t at;    /* s19.20 */
        uint32_t size; /* of the level */
        int clamp;
        uint32_t near[4], far[4], wx, wy, between; /* texels of two levels, weights u0.8 */
    } texel;
    struct {
        uint32_t path; /* u(W+4).4 */
        int32_t base;  /* s7.8 */
        int levels;
    } level;
    struct {
        int axis, below;
        int64_t at; /* s(W+2) */
    } clip;
};

/* A generator that is weighted towards what makes its cases hard. */
struct hard_family {
    const char *name, *what;
    void (*make)(struct sph_rng *rng, const struct sph_profile *p, struct hard_case *c);
    int of;
};
enum { HARD_FAMILIES = 41 };
extern const struct hard_family hard_families[HARD_FAMILIES];

/* Case `number` of a family; the same for the same arguments. One in eight has the effect INSIDE
 * off. */
void hard_make(uint64_t seed, int family, int profile, uint64_t number, struct hard_case *c);

/* The model, and the formulas of floats.h, which are judged by the oracle on the same inputs. */
enum { HARD_OURS, HARD_COLUMNS = SPH_FORMULAS };
extern const char *const hard_columns[HARD_COLUMNS];

struct hard_column {
    uint64_t hit;   /* hit instead of miss, or miss instead of hit */
    uint64_t root;  /* both hit, but the near root instead of the far one, or the reverse */
    uint64_t order; /* of two hits the farther is said to be nearer */
    uint64_t tie;   /* of two hits at different t it is said that they are equal */
    double worst; /* greatest error of t along the ray, grid units, where hit and root are right */
};

/* Outputs of the model that a case compares. */
enum {
    HARD_HIT,
    HARD_FAR,
    HARD_DISC,
    HARD_KEY,
    HARD_QUOTIENT,
    HARD_T,
    HARD_POINT,
    HARD_NORMAL,
    HARD_BOUNCE,
    HARD_FILTER,
    HARD_ORDER,
    HARD_NAIVE,
    HARD_THROUGH,
    HARD_TEXTURE,
    HARD_TREE,
    HARD_UNIT,
    HARD_CHECKS
};
extern const char *const hard_checks[HARD_CHECKS];

struct hard_tally {
    uint64_t cases, hits, pairs; /* spheres tested, spheres hit, pairs of hits */
    uint64_t naive;              /* cases that the naive model decided as well */
    uint64_t points, filtered;   /* surface points; hits that a filter's child was made for */
    uint64_t wrong[HARD_CHECKS]; /* of ours */
    struct hard_column column[HARD_COLUMNS];
    double bound; /* greatest error of our t over its proved bound */
};

/* Whether a formula has anything to say of such cases: `paper` is that of our own integers, `Gems`
 * is of spheres. */
int hard_column_is_of(int column, int of);

void hard_tally_add(struct hard_tally *sum, const struct hard_tally *t);

/* Checks of ours that failed. */
uint64_t hard_tally_wrong(const struct hard_tally *t);

/* Everything that is known about one case; adds to *t. With `naive` the GMP model decides as
 * well. Mistakes of ours are described in `out` (NULL: not) and their number is returned. */
int hard_check(const struct sph_profile *p, const struct hard_case *c, int naive,
               struct hard_tally *t, FILE *out);

/* Writes a case in full, on one line. */
void hard_print(FILE *out, const struct sph_profile *p, const struct hard_case *c);

/* Every operand of three bits, every kind of ray, as rays of profile draft; every `share`th of
 * them. One of HARD_SLICES slices; returns the number of mistakes. */
enum { HARD_SLICES = 15 };
uint64_t hard_exhaustive(int slice, uint64_t share, struct hard_tally *t, FILE *out);

#endif
