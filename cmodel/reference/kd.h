/* kd.h - a kd-tree by surface area, in double precision, to compare the machine's trees with
 * SPDX-License-Identifier: Apache-2.0
 *
 * Cells are cut where boxes begin or end and the surface-area heuristic says that it is cheapest;
 * a box that is cut is in both cells. Nothing notes which primitives a ray has met before.
 */
#ifndef SPH_REFERENCE_KD_H
#define SPH_REFERENCE_KD_H

#include <stdint.h>

/* A primitive's box. */
struct sph_ref_item {
    double low[3], high[3];
    uint32_t id;
};

struct sph_kd; /* 8 + 1.3 log2 n levels of cuts at most */

/* Tests a primitive; what it returns is the t beyond which the ray is of no interest. */
typedef double sph_kd_test(void *user, uint32_t id);

/* Builds a tree over n boxes; NULL if memory is out. */
struct sph_kd *sph_kd_new(const struct sph_ref_item *items, uint32_t n);
void sph_kd_free(struct sph_kd *kd);

/* Tests what is in the cells that the ray passes, near first, until limit. Returns how many nodes
 * were visited. */
uint64_t sph_kd_walk(const struct sph_kd *kd, const double org[3], const double dir[3],
                     double limit, sph_kd_test *test, void *user);

uint64_t sph_kd_nodes(const struct sph_kd *kd);
uint64_t sph_kd_node_bytes(void);
uint64_t sph_kd_bytes(const struct sph_kd *kd); /* nodes and numbers of primitives */

#endif
