/* list.h - the vectors of the named cases as a list, for who drives something else than the model
 * SPDX-License-Identifier: Apache-2.0
 *
 * The benches of the RTL read it (tb/hard.h): the same vectors, in the same order, not judged.
 */
#ifndef HARD_LIST_H
#define HARD_LIST_H

#include <stddef.h>

#include "core/ray.h"
#include "hard.h"
#include "prim/facet.h"

enum {
    HARD_RAY,
    HARD_ROOT,
    HARD_QUOTIENT_OF,
    HARD_MIRROR,
    HARD_POINT_AT,
    HARD_REFRACT,
    HARD_CASE /* of another kind than spheres, whole */
};

struct hard_item {
    int what, named;           /* which of the enum above; number of the named case */
    struct hard_case c;        /* HARD_RAY: each sphere counts on its own; HARD_POINT_AT: one */
    sph_u128 x;                /* HARD_ROOT: the radicand */
    uint64_t key, a;           /* HARD_QUOTIENT_OF: key / a; HARD_POINT_AT: key */
    int64_t dir[3], normal[3]; /* HARD_MIRROR, HARD_REFRACT */
    uint32_t from, to;         /* HARD_REFRACT: indices, thousandths */
};

struct hard_list {
    struct hard_item *items;
    size_t n, room;
    int named; /* the case that adds */
};

/* All vectors of a profile; the caller frees items. Ends the program if memory does not do. */
struct hard_list hard_list_named(int profile);

/* Adds a copy, with the number of the case. */
void hard_list_add(struct hard_list *list, struct hard_item item);

const char *hard_named_name(int number);

/* ---- the vectors of the named cases of facets, for who drives something else than the model
 * ---- */
/* The bench of the RTL reads it (tb/prim/tb_facet.cpp): every vector that is judged, in the same
 * order, with the axes turned and the corners exchanged as they are there. */

struct hard_facet {
    int named;          /* number of the named case */
    struct sph_ray ray; /* what set-up does not make */
    struct sph_facet_leaf facet;
};

struct hard_facets {
    struct hard_facet *items;
    size_t n, room;
};

/* All vectors of a profile; the caller frees items. Ends the program if memory does not do. */
struct hard_facets hard_facets_named(int profile);

#endif
