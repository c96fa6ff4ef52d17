/* refit.c - builds a tree or refits the one that is kept; see refit.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/tree/refit.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "builder/tree/box.h"

void sph_kept_free(struct sph_kept_tree *kept) {
    free(kept->kinds);
    free(kept->tree.nodes);
    sph_bih_free(&kept->bih);
    *kept = (struct sph_kept_tree){.how = kept->how, .loss = kept->loss};
}

int sph_kept_fits(const struct sph_kept_tree *kept, const struct sph_plants *p, const char *path,
                  struct sph_error *err) {
    if (kept->kind != p->kind) return sph_fail(err, "%s: the tree is of another kind", path);
    if (kept->n_spheres != p->n_spheres || kept->n_facets != p->facets->n)
        return sph_fail(err,
                        "%s: %u spheres, %u triangles and planes on the grid, the tree is of %u "
                        "and %u",
                        path, p->n_spheres, p->facets->n, kept->n_spheres, kept->n_facets);
    for (uint32_t i = 0; i < p->facets->n; i++)
        if (kept->kinds[i] != p->facets->list[i].kind)
            return sph_fail(err, "%s: primitive %u is of another kind than that of the tree", path,
                            p->n_spheres + i);
    return 0;
}

/* Whether what is kept is to be refitted to these primitives. */
static int same(const struct sph_kept_tree *kept, const struct sph_plants *p) {
    struct sph_error unsaid = {""};
    return kept->how != SPH_REFIT_KEEP && !sph_kept_fits(kept, p, "", &unsaid);
}

/* Forgets what is kept, and notes what the next tree is made of. */
static int note(struct sph_kept_tree *kept, const struct sph_plants *p, double cost,
                struct sph_error *err) {
    sph_kept_free(kept);
    kept->kinds = malloc(p->facets->n + 1ull);
    if (!kept->kinds) return sph_fail(err, "out of memory for %u primitives", p->facets->n);
    for (uint32_t i = 0; i < p->facets->n; i++)
        kept->kinds[i] = (uint8_t)p->facets->list[i].kind;
    kept->kind = p->kind;
    kept->n_spheres = p->n_spheres, kept->n_facets = p->facets->n;
    kept->built = cost;
    kept->cost = 1;
    return 0;
}

/* A copy of `bytes`; malloc, NULL with a message if memory is out. */
static void *copy(const void *from, size_t bytes, struct sph_error *err) {
    void *to = malloc(bytes + 1);
    if (to && bytes) memcpy(to, from, bytes);
    if (!to) sph_fail(err, "out of memory to keep a tree");
    return to;
}

/* What became of a refitted tree: 1 if it is good enough. */
static int taken(struct sph_kept_tree *kept, double cost) {
    double over = kept->built > 0 ? cost / kept->built : 1;
    kept->refitted = kept->how != SPH_REFIT_AUTO || over <= 1 + kept->loss;
    if (kept->refitted) kept->cost = over;
    return kept->refitted;
}

/* Keeps a tree that was built, without what it was collapsed from. */
static int remember_tree(const struct sph_plants *p, struct sph_kept_tree *kept,
                         const struct sph_tree *tree, struct sph_error *err) {
    double cost;
    if (sph_tree_cost(p, tree, &cost, err) || note(kept, p, cost, err)) return -1;
    kept->tree = *tree;
    kept->tree.split = NULL, kept->tree.seen = NULL;
    kept->tree.nodes = copy(tree->nodes, tree->n_nodes * sizeof *tree->nodes, err);
    if (!kept->tree.nodes) kept->kind = 0;
    return kept->tree.nodes ? 0 : -1;
}

int sph_tree_next(const struct sph_plants *p, struct sph_kept_tree *kept, struct sph_tree *tree,
                  struct sph_error *err) {
    if (!kept || kept->how == SPH_REFIT_OFF) return sph_tree_build(p, tree, err);
    double cost;
    if (same(kept, p)) {
        struct sph_tree old = kept->tree;
        old.nodes = copy(old.nodes, old.n_nodes * sizeof *old.nodes, err);
        int failed =
            !old.nodes || sph_tree_refit(p, &old, err) || sph_tree_cost(p, &old, &cost, err);
        if (!failed && taken(kept, cost)) {
            *tree = old;
            return 0;
        }
        free(old.nodes);
        if (failed) return -1;
    }
    return sph_tree_build(p, tree, err) ? -1 : remember_tree(p, kept, tree, err);
}

int sph_tree_again(const struct sph_plants *p, struct sph_kept_tree *kept,
                   const struct sph_machine *m, struct sph_tree *tree, struct sph_error *err) {
    free(tree->nodes);
    tree->nodes = NULL;
    tree->seen = m;
    tree->progress = (struct sph_progress){0};
    if (sph_tree_build(p, tree, err)) return -1;
    return kept && kept->how != SPH_REFIT_OFF ? remember_tree(p, kept, tree, err) : 0;
}

/* A BIH with arrays of its own. */
static int duplicate(const struct sph_bih *from, uint32_t n, struct sph_bih *to,
                     struct sph_error *err) {
    *to = *from;
    to->nodes = copy(from->nodes, from->n_nodes * sizeof *to->nodes, err);
    to->order = copy(from->order, n * sizeof *to->order, err);
    return to->nodes && to->order ? 0 : -1;
}

int sph_bih_next(const struct sph_plants *p, const struct sph_aabb *boxes, uint32_t n,
                 const struct sph_bih_options *options, struct sph_kept_tree *kept,
                 struct sph_bih *bih, struct sph_error *err) {
    if (!kept || kept->how == SPH_REFIT_OFF) return sph_bih_build(boxes, n, options, bih, err);
    if (same(kept, p)) {
        if (duplicate(&kept->bih, n, bih, err)) return -1;
        sph_bih_refit(boxes, bih);
        if (taken(kept, sph_bih_cost(bih))) return 0;
        sph_bih_free(bih);
    }
    if (sph_bih_build(boxes, n, options, bih, err) || note(kept, p, sph_bih_cost(bih), err))
        return -1;
    if (!duplicate(bih, n, &kept->bih, err)) return 0;
    kept->kind = 0;
    return -1;
}

/* Areas of the boxes of nodes; what holds a plane, or is above one, is the whole grid, which every
 * ray meets. */
static int box_cost(const struct sph_plants *p, const struct sph_tree *tree, double *cost,
                    struct sph_error *err) {
    struct sph_aabb *boxes = sph_box_nodes(p, tree, err);
    double sum = 0, most = 0, end = 2.0 * (1 << (p->profile->w - 1)), whole = 3 * end * end;
    if (!boxes) return -1;
    for (uint32_t i = 0; i < tree->n_nodes; i++) {
        double area = sph_aabb_area(&boxes[i]);
        if (area >= whole) continue;
        sum += area;
        if (area > most) most = area;
    }
    free(boxes);
    *cost = most > 0 ? sum / most : 0;
    return 0;
}

int sph_tree_cost(const struct sph_plants *p, const struct sph_tree *tree, double *cost,
                  struct sph_error *err) {
    int32_t whole = sph_filter_whole(p->profile).r;
    double sum = 0, most = 0;
    if (p->kind == SPH_TREE_BOX4) return box_cost(p, tree, cost, err);
    for (uint32_t i = 0; i < tree->n_nodes; i++) {
        const struct sph_ball *ball = &tree->nodes[i].ball;
        if (ball->r >= whole) continue; /* above planes: met by every ray */
        double r = ball->r + SPH_FILTER_MARGIN;
        sum += r * r;
        if (r * r > most) most = r * r;
    }
    *cost = most > 0 ? sum / most : 0;
    return 0;
}

static const struct sph_aabb NOTHING = {{INT32_MAX, INT32_MAX, INT32_MAX},
                                        {INT32_MIN, INT32_MIN, INT32_MIN}};

static void widen(struct sph_aabb *box, const struct sph_aabb *by) {
    for (int i = 0; i < 3; i++) {
        if (by->lo[i] < box->lo[i]) box->lo[i] = by->lo[i];
        if (by->hi[i] > box->hi[i]) box->hi[i] = by->hi[i];
    }
}

/* Planes of a node and of all below it; the box around the primitives there. An empty side has the
 * clips that no primitive is on the side of, which are the ends of NOTHING. */
static struct sph_aabb refit(const struct sph_aabb *boxes, struct sph_bih *bih, uint32_t number) {
    struct sph_bih_node *node = &bih->nodes[number];
    struct sph_aabb all = NOTHING;
    if (node->axis == SPH_BIH_LEAF) {
        for (uint32_t i = 0; i < node->count; i++)
            widen(&all, &boxes[bih->order[node->first + i]]);
        return all;
    }
    struct sph_aabb left = refit(boxes, bih, node->child), right = left;
    if (!node->fit) right = refit(boxes, bih, node->child + 1);
    node->clip_l = node->fit ? left.lo[node->axis] : left.hi[node->axis];
    node->clip_r = node->fit ? left.hi[node->axis] : right.lo[node->axis];
    all = left;
    widen(&all, &right);
    return all;
}

void sph_bih_refit(const struct sph_aabb *boxes, struct sph_bih *bih) {
    bih->box = refit(boxes, bih, 0);
}

double sph_aabb_area(const struct sph_aabb *b) {
    double x = (double)b->hi[0] - b->lo[0], y = (double)b->hi[1] - b->lo[1],
           z = (double)b->hi[2] - b->lo[2];
    return x < 0 || y < 0 || z < 0 ? 0 : x * y + y * z + z * x;
}

/* Areas of the spaces of a node and of all below it. */
static double cost(const struct sph_bih *bih, uint32_t number, struct sph_aabb space) {
    const struct sph_bih_node *node = &bih->nodes[number];
    double sum = sph_aabb_area(&space);
    if (node->axis == SPH_BIH_LEAF) return sum;
    struct sph_aabb left = space, right = space;
    if (node->fit && node->clip_l > left.lo[node->axis]) left.lo[node->axis] = node->clip_l;
    int32_t end = node->fit ? node->clip_r : node->clip_l;
    if (end < left.hi[node->axis]) left.hi[node->axis] = end;
    if (node->clip_r > right.lo[node->axis]) right.lo[node->axis] = node->clip_r;
    sum += cost(bih, node->child, left);
    return node->fit ? sum : sum + cost(bih, node->child + 1, right);
}

double sph_bih_cost(const struct sph_bih *bih) {
    double whole = sph_aabb_area(&bih->box);
    return whole > 0 ? cost(bih, 0, bih->box) / whole : 0;
}
