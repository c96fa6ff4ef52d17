/* facet_list.h - the vectors of the named cases of facets, for who drives something else than the
 * model
 * SPDX-License-Identifier: Apache-2.0
 *
 * The bench of the RTL reads it (tb/prim/tb_facet.cpp): every vector that is judged, in the same
 * order, with the axes turned and the corners exchanged as they are there.
 */
#ifndef HARD_FACET_LIST_H
#define HARD_FACET_LIST_H

#include <stddef.h>

#include "prim/facet.h"
#include "core/ray.h"

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
