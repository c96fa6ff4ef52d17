/* links.h - a binary tree of balls or boxes whose nodes can change places
 * SPDX-License-Identifier: Apache-2.0
 *
 * What is to be small is the sum of R^2 of the inner nodes' balls: a ball is met by a ray with a
 * probability like R^2. Balls are floats, since they only steer where a node goes; those of memory
 * are made in exact integers afterwards. In a tree of boxes nodes are boxes, met like their area.
 */
#ifndef SPH_TREE_LINKS_H
#define SPH_TREE_LINKS_H

#include <math.h>

#include "builder/tree/split.h"

#define SPH_LINK_NONE UINT32_MAX /* parent of the root */

struct sph_link_ball { /* grid units */
    union {
        struct {
            float c[3], r; /* r with the margin of a node */
        };
        struct {
            float lo[3], hi[3]; /* in a tree of boxes */
        };
    };
};

struct sph_links {
    const struct sph_ball *balls; /* the n >= 2 spheres */
    const struct sph_aabb *boxes; /* of each, in a tree of boxes; NULL: it is one of balls */
    uint32_t n, root;
    float margin;               /* of each radius, grid units */
    struct sph_link_ball *ball; /* 2n-1: node i < n is sphere i, those from n on are inner ones */
    uint32_t *parent;           /* 2n-1 */
    uint32_t (*child)[2];       /* n-1: of node n+i */
    uint32_t *order, *count;    /* n, n-1: spheres from left to right; of node n+i their number */
    struct sph_ball *sorted;    /* n: spheres in that order. By sph_links_fit() */
    uint8_t *stale; /* n-1: other spheres are below it than when its ball was made; all above too */
    uint32_t exact; /* the balls of no more spheres are the smallest ones */
    struct sph_link_pair *pairs;         /* n-1: what sph_links_fit() fills, unless NULL */
    const struct sph_progress *progress; /* of sph_reinsert(), or NULL */
};

/* An inner node as a search reads it, which finds in one place what it asks of both children. The
 * root is the first one; a node stands before those below it, and the left ones before the right
 * ones. A side of a pair is called by place * 2 + side. */
struct sph_link_pair {
    struct sph_link_ball ball[2]; /* of the children */
    uint32_t child[2];            /* their places, or SPH_PAIR_LEAF | sphere */
    uint32_t above;               /* the side that it is below; NONE for the root */
    uint32_t node;
};

/* Memory for n >= 2 spheres, whose balls are set, or boxes; no inner node is. -1 if it is out; what
 * is there is to be freed. */
int sph_links_new(const struct sph_ball *balls, const struct sph_aabb *boxes, uint32_t n,
                  double margin, struct sph_links *links);

void sph_links_free(struct sph_links *links);

/* Takes over the pairs of a split. */
void sph_links_take(struct sph_links *links, const struct sph_split *split);

/* Puts the tree in place of the pairs of a split of the same spheres, and fills the costs. */
void sph_links_give(struct sph_links *links, struct sph_split *split);

/* Fills order, sorted, count and pairs and makes the balls of inner nodes: the smallest one around
 * the spheres of each where they are no more than `most`, unless it is there, and around the balls
 * of the children elsewhere; boxes are around those of the children. Returns the sum of areas. Does
 * not depend on the number of threads. */
double sph_links_fit(struct sph_links *links, uint32_t most);

/* A ball, or box, around two others. */
struct sph_link_ball sph_link_merge(const struct sph_links *links, const struct sph_link_ball *a,
                                    const struct sph_link_ball *b);

/* The smallest ball around n spheres, with the margin. */
struct sph_link_ball sph_link_around(const struct sph_links *links, const uint32_t *spheres,
                                     uint32_t n);

/* All nodes below `top` and `top` itself, children before their parent, left before right: the
 * first one, and the one after `node`, which is NONE after the root. */
uint32_t sph_link_leftmost(const struct sph_links *links, uint32_t top);
uint32_t sph_link_next(const struct sph_links *links, uint32_t node);

/* The box around two. */
static inline struct sph_link_ball sph_link_box(const struct sph_link_ball *a,
                                                const struct sph_link_ball *b) {
    struct sph_link_ball out;
    for (int i = 0; i < 3; i++) {
        out.lo[i] = a->lo[i] < b->lo[i] ? a->lo[i] : b->lo[i];
        out.hi[i] = a->hi[i] > b->hi[i] ? a->hi[i] : b->hi[i];
    }
    return out;
}

/* How far apart the centres are. */
static inline float sph_link_apart(const struct sph_link_ball *a, const struct sph_link_ball *b) {
    float x = a->c[0] - b->c[0], y = a->c[1] - b->c[1], z = a->c[2] - b->c[2];
    return sqrtf(x * x + y * y + z * z);
}

/* Half the surface of a box, as float and in grid units. */
static inline float sph_link_surface(const float lo[3], const float hi[3]) {
    float x = hi[0] - lo[0], y = hi[1] - lo[1], z = hi[2] - lo[2];
    return x * y + y * z + z * x;
}

/* What a ray meets it like: R^2, or half the surface. */
static inline float sph_link_area(const struct sph_links *l, const struct sph_link_ball *a) {
    return l->boxes ? sph_link_surface(a->lo, a->hi) : a->r * a->r;
}

/* Every ball of an inner node is to be made. */
void sph_links_renew(struct sph_links *links);

/* The child of an inner node that is not `node`. */
static inline uint32_t sph_link_other(const struct sph_links *l, uint32_t parent, uint32_t node) {
    const uint32_t *child = l->child[parent - l->n];
    return child[child[0] == node];
}

/* ---- a binary tree made better by moving nodes to where they grow others least ---- */

/* Moves nodes until a round saves next to nothing, ten rounds at most. A node looks at 256 places
 * at most, and the tree does not depend on the number of threads. -1 if memory is out. */
int sph_reinsert(struct sph_links *links);

#endif
