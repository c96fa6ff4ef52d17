/* refit.h - the tree of a frame out of that of the frame before
 * SPDX-License-Identifier: Apache-2.0
 *
 * What moves a little needs no other tree: nodes keep their children, and the sphere or the planes
 * of each are made anew around what is below it now, by the same exact integers as when a tree is
 * built. Pixels do not depend on the tree, so only visits change. What they are expected to be is
 * the cost: the sum over the nodes of the chance that a ray which meets the root meets them, R^2 of
 * spheres and the area of boxes over that of the root.
 *
 * The rule (SPH_REFIT_AUTO): a tree is refitted as long as its cost is at most 1 + loss times what
 * it was when it was built, and is built anew otherwise.
 */
#ifndef SPH_REFIT_H
#define SPH_REFIT_H

#include "builder/tree/bih.h"
#include "builder/tree/tree.h"

/* KEEP: every tree is built and kept. ONLY: other primitives than those of the kept tree are an
 * error, so that it does not change. */
enum { SPH_REFIT_OFF, SPH_REFIT_ON, SPH_REFIT_AUTO, SPH_REFIT_KEEP, SPH_REFIT_ONLY };

/* What the frames of a sequence share; all zero before the first. One sequence has one profile and
 * one way of building. */
struct sph_kept_tree {
    int how;     /* SPH_REFIT_* */
    double loss; /* by which a refitted tree may cost more, such as 0.1 */

    int kind; /* SPH_TREE_*, 0: nothing is kept */
    uint32_t n_spheres, n_facets;
    uint8_t *kinds; /* of facets */
    struct sph_tree tree;
    struct sph_bih bih;
    double built; /* cost of the tree when it was built */

    int refitted; /* of the newest frame: 1 if its tree was */
    double cost;  /* of its tree over `built` */
};

void sph_kept_free(struct sph_kept_tree *kept);

/* 0 if the kept tree is one of these primitives, wherever they are; -1 with a message that says
 * which are others, behind `path`. */
int sph_kept_fits(const struct sph_kept_tree *kept, const struct sph_plants *plants,
                  const char *path, struct sph_error *err);

/* sph_tree_build(), or the kept tree refitted to the same primitives in other places. kept may be
 * NULL. */
int sph_tree_next(const struct sph_plants *plants, struct sph_kept_tree *kept,
                  struct sph_tree *tree, struct sph_error *err);

/* The tree just built, whose binary tree was kept, collapsed again by the rays of a machine. */
int sph_tree_again(const struct sph_plants *plants, struct sph_kept_tree *kept,
                   const struct sph_machine *machine, struct sph_tree *tree, struct sph_error *err);

/* sph_bih_build() likewise; plants: what the n boxes are of. The kept tree is the box's own. */
int sph_bih_next(const struct sph_plants *plants, const struct sph_aabb *boxes, uint32_t n,
                 const struct sph_bih_options *options, struct sph_kept_tree *kept,
                 struct sph_bih *bih, struct sph_error *err);

/* New spheres for every node of a finished tree, whose leaves are ids, and children near first.
 * -1 if memory is out. In tighten.c. */
int sph_tree_refit(const struct sph_plants *plants, struct sph_tree *tree, struct sph_error *err);

/* New planes for every node, and the box around all. */
void sph_bih_refit(const struct sph_aabb *boxes, struct sph_bih *bih);

/* Expected visits of a ray that meets the root: of a tree of boxes by their areas, of others by the
 * spheres of nodes. -1 if memory is out. */
int sph_tree_cost(const struct sph_plants *plants, const struct sph_tree *tree, double *cost,
                  struct sph_error *err);
double sph_bih_cost(const struct sph_bih *bih);

#endif
