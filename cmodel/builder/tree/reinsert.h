/* reinsert.h - a binary tree made better by moving nodes to where they grow others least
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TREE_REINSERT_H
#define SPH_TREE_REINSERT_H

#include "builder/tree/links.h"

/* Moves nodes until a round saves next to nothing, ten rounds at most. A node looks at 256 places
 * at most, and the tree does not depend on the number of threads. -1 if memory is out. */
int sph_reinsert(struct sph_links *links);

#endif
