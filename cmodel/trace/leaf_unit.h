/* leaf_unit.h - exact tests of leaf records, the best hit kept        RTL: rtl/trace/rt_leaf_unit.v
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_LEAF_UNIT_H
#define SPH_LEAF_UNIT_H

#include "trace/traverse.h"

/* Tests the sphere of a leaf record of half 0 or 1 of a line, or with `whole` what stands in a leaf
 * line of a machine with FACETS; a hit that comes first replaces *best: the smaller key, then the
 * smaller id. Of no kind: a miss and an error. A shadow ray has key 1 for any hit. */
void sph_leaf_visit(const struct sph_profile *p, const struct sph_ray *ray, const uint32_t *line,
                    int half, int whole, struct sph_hit *best, struct sph_counters *c,
                    uint32_t *errors);

#endif
