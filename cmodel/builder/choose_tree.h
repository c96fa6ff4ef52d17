/* choose_tree.h - the tree of a scene that none was asked for
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_CHOOSE_TREE_H
#define SPH_CHOOSE_TREE_H

#include "builder/build.h"

/* Where options->tree is SPH_TREE_AUTO: a BIH with a primitive a leaf if the scene has more
 * triangles than spheres, else nodes of four children; report->tree_why says so. A test of a
 * triangle takes ten clocks and a BIH asks for fewer of them; of spheres it asks for more, and for
 * more visits. What takes the first hit walks nodes of four children. */
void sph_choose_tree(const struct sph_scene *scene, struct sph_build_options *options,
                     struct sph_build_report *report);

#endif
