/* bih.h - builds a bounding interval hierarchy in integers of the grid; docs/design/bih.md
 * SPDX-License-Identifier: Apache-2.0
 *
 * Aroxa 2014, III.B: the widest axis is cut in its middle, primitives go to a side by the centres
 * of their boxes, and two planes say how far each side reaches.
 */
#ifndef SPH_BUILD_BIH_H
#define SPH_BUILD_BIH_H

#include "builder/grid/facets.h"
#include "common/parallel.h"
#include "machine/bih_stats.h"

/* How a node is cut: `listing` does what Listings 3.3 and 3.4 say and no more. `full` has what the
 * counts of Table 4.2 show besides: halves are of a regular grid, a node around much less than its
 * space is a node of its own (fit), and a half without primitives is an empty leaf. */
enum { SPH_BIH_FULL, SPH_BIH_LISTING };

struct sph_aabb {
    int32_t lo[3], hi[3]; /* grid units, both ends belong to it */
};

/* Half the surface, from lo to hi; 0 if there is nothing in it. In refit.c. */
double sph_aabb_area(const struct sph_aabb *box);

/* One node; an even index is a left child or the root, the odd one behind it the right child. */
struct sph_bih_node {
    int axis;               /* SPH_BIH_LEAF: a leaf */
    int fit;                /* one child, at `child`, between clip_l and clip_r */
    uint32_t child;         /* index of the left child */
    int32_t clip_l, clip_r; /* grid units, without margin */
    uint32_t first, count;  /* of `order`, if a leaf */
};

/* Clips that no primitive is on the side of. */
#define SPH_BIH_NOTHING_BELOW INT32_MIN
#define SPH_BIH_NOTHING_ABOVE INT32_MAX

struct sph_bih {
    struct sph_bih_node *nodes; /* root, an unused one, then pairs; malloc */
    uint32_t n_nodes;           /* with the unused ones */
    uint32_t *order;            /* indices of boxes as leaves hold them; malloc */
    struct sph_aabb box;        /* around all; lo > hi if there are none */
    struct sph_bih_stats stats;
};

struct sph_bih_options {
    uint32_t max_prims; /* a leaf of no more is not cut, at least 1; UINT32_MAX: one leaf */
    uint32_t max_depth; /* levels, 1 .. SPH_BIH_STACK + 1 */
    int how;            /* SPH_BIH_FULL, SPH_BIH_LISTING */
    const struct sph_progress *progress; /* NULL, or who is told how far it is */
    uint32_t fit; /* percent of what is in a box that makes it too large (struct sph_bih_node);
                     0: SPH_BIH_FIT, UINT32_MAX: no box is */
};

enum { SPH_BIH_FIT = 130 }; /* the thesis's */

/* Builds over n boxes. -1 if memory is out; what is in *bih then is to be freed too. */
int sph_bih_build(const struct sph_aabb *boxes, uint32_t n, const struct sph_bih_options *options,
                  struct sph_bih *bih, struct sph_error *err);

void sph_bih_free(struct sph_bih *bih);

#endif
