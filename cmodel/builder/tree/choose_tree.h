/* choose_tree.h - the tree of a scene that none was asked for
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_CHOOSE_TREE_H
#define SPH_CHOOSE_TREE_H

#include "builder/build.h"

/* The tree, where options->tree is SPH_TREE_AUTO: nodes of four boxes if the scene has triangles,
 * and at least as many as spheres, else of four spheres. Around triangles boxes save visits and
 * tests (docs/results/trees.md has the counts); around spheres they save fewer visits, ask for
 * more tests, and are the larger core. What takes the first hit walks spheres. */
int sph_tree_of(const struct sph_scene *scene, const struct sph_build_options *options);

/* Puts it there; report->tree_why says why. */
void sph_choose_tree(const struct sph_scene *scene, struct sph_build_options *options,
                     struct sph_build_report *report);

#endif
