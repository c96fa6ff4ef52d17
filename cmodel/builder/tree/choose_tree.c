/* choose_tree.c - see choose_tree.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/tree/choose_tree.h"

#include <stdio.h>

#include "machine/records.h"

static uint32_t triangles_of(const struct sph_scene *scene) {
    uint32_t triangles = 0;
    for (uint32_t i = 0; i < scene->n_facets; i++)
        triangles += !sph_kind_unbounded((uint32_t)scene->facets[i].kind);
    return triangles;
}

int sph_tree_of(const struct sph_scene *scene, const struct sph_build_options *o) {
    if (o->tree != SPH_TREE_AUTO) return o->tree;
    if (o->traverse != SPH_BUILD_NEAREST) return SPH_TREE_BALANCED;
    uint32_t triangles = triangles_of(scene);
    return triangles && triangles >= scene->n_spheres ? SPH_TREE_BOX4 : SPH_TREE_REINSERTED;
}

void sph_choose_tree(const struct sph_scene *scene, struct sph_build_options *o,
                     struct sph_build_report *report) {
    if (o->tree != SPH_TREE_AUTO) return;
    o->tree = sph_tree_of(scene, o);
    snprintf(report->tree_why, sizeof report->tree_why, "chosen for %u triangles and %u spheres",
             triangles_of(scene), scene->n_spheres);
}
