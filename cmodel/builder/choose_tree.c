/* choose_tree.c - see choose_tree.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/choose_tree.h"

#include <stdio.h>

#include "prim/prim.h"

void sph_choose_tree(const struct sph_scene *scene, struct sph_build_options *o,
                     struct sph_build_report *report) {
    uint32_t triangles = 0;
    if (o->tree != SPH_TREE_AUTO) return;
    for (uint32_t i = 0; i < scene->n_facets; i++)
        triangles += !sph_prim_of((uint32_t)scene->facets[i].kind)->loose;
    int boxes = triangles && triangles >= scene->n_spheres;
    o->tree = o->traverse != SPH_BUILD_NEAREST ? SPH_TREE_BALANCED
              : boxes                          ? SPH_TREE_BOX4
                                               : SPH_TREE_REINSERTED;
    snprintf(report->tree_why, sizeof report->tree_why, "chosen for %u triangles and %u spheres",
             triangles, scene->n_spheres);
}
