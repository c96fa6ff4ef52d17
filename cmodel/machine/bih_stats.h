/* bih_stats.h - what a bounding interval hierarchy is like, as Aroxa 2014 counts it
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_BIH_STATS_H
#define SPH_BIH_STATS_H

#include "machine/machine.h"

enum { SPH_BIH_BARS = 6 }; /* leaves of 0, 1, 2, 3, 4 and of more primitives */

/* The rows of his Table 4.2. */
struct sph_bih_stats {
    uint32_t inner, leaves;
    uint32_t optimized;            /* times that primitives reached over less than 1/1.3 of a box */
    uint32_t prims_min, prims_max; /* of a leaf */
    uint32_t depth_min, depth_max; /* level of a leaf, the root's is 1 */
    uint64_t prims_sum, depth_sum; /* over leaves */
    uint32_t bars[SPH_BIH_BARS];   /* leaves by primitives */
};

/* Adds a leaf. */
void sph_bih_count_leaf(struct sph_bih_stats *s, uint32_t prims, uint32_t depth);

/* Those of a valid machine with a BIH; optimized counts its fit nodes. */
void sph_bih_measure(const struct sph_machine *m, struct sph_bih_stats *s);

/* Bytes as his Figure 4.5 counts them: 12 a node, 4 a primitive for the index, 24 for the global
 * box. Planes are not in the hierarchy. */
uint64_t sph_bih_bytes(const struct sph_bih_stats *s);

/* Bytes here: lines of nodes, and of leaf records, which hold the primitives themselves. */
uint64_t sph_bih_node_bytes(const struct sph_machine *m);
uint64_t sph_bih_record_bytes(const struct sph_machine *m);

#endif
