/* agglomerate.h - a binary tree made from its leaves upwards
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TREE_AGGLOMERATE_H
#define SPH_TREE_AGGLOMERATE_H

#include "builder/tree/links.h"

/* Makes the tree by joining the two balls that make the smallest one. tight: balls are the smallest
 * ones around their spheres; else around the two that are joined. It looks at 4 n^2 pairs at most,
 * and the tree does not depend on the number of threads. -1 if memory is out. */
int sph_agglomerate(struct sph_links *links, int tight);

#endif
