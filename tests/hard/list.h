/* list.h - the vectors of the named cases as a list, for who drives something else than the model
 * SPDX-License-Identifier: Apache-2.0
 *
 * The benches of the RTL read it (tb/hard.h): the same vectors, in the same order, not judged.
 */
#ifndef HARD_LIST_H
#define HARD_LIST_H

#include <stddef.h>

#include "hard.h"

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

#endif
