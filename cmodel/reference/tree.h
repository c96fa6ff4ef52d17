/* tree.h - nearest sphere or facet on a ray, in double precision
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_REFERENCE_TREE_H
#define SPH_REFERENCE_TREE_H

#include <stdint.h>

#include "machine/layout.h"
#include "reference/ray.h"
#include "scene/scene.h"

struct sph_ref_tree; /* boxes of two children, split at the median; or a kd-tree */

/* What a tree is, and what rays did in it. */
struct sph_ref_work {
    uint64_t nodes, node_bytes, bytes; /* bytes: nodes and numbers of primitives */
    double build_seconds;              /* of processor */
    uint64_t rays, steps, tests;       /* nodes visited; primitives tested */
};

/* Builds a tree over the scene's spheres and triangles, beside its planes, which end nowhere; NULL
 * if memory is out. The scene must outlive it. */
struct sph_ref_tree *sph_ref_tree_new(const struct sph_scene *scene);

/* The same, or a kd-tree (kd.h) in its place. All rays are counted in *work, which is set here,
 * unless it is NULL: from one thread. */
struct sph_ref_tree *sph_ref_tree_counted(const struct sph_scene *scene, int kd,
                                          struct sph_ref_work *work);
void sph_ref_tree_free(struct sph_ref_tree *tree);

/* What the ray sees before t_max. Of surfaces that lie in one place, as far as doubles can tell,
 * that with the lowest number is seen; what lies where the ray starts, or ends at t_max, is not
 * met. any_hit: whichever hit is found first will do. */
struct sph_ref_hit sph_ref_trace(const struct sph_ref_tree *tree, const struct sph_ref_ray *ray,
                                 double t_max, int any_hit);

/* Where the ray meets one sphere or facet, INFINITY if it does not. */
double sph_ref_meet(const struct sph_ref_tree *tree, uint32_t id, const struct sph_ref_ray *ray);

#endif
