/* build_tree.h - the tree that hardware builds                    RTL: rtl/build/rt_build.v
 * SPDX-License-Identifier: Apache-2.0
 *
 * Spheres are sorted along a curve, those that are near each other on it are joined to a binary
 * tree, and of this, from the root down, nodes of four are made. Or they are sorted by z and merged
 * by four. All of it is integers, and bit for bit what rt_build does: docs/design/build_tree.md.
 *
 *     order.c   keys of the centres, sorted
 *     join.c    the binary tree: two clusters are joined that have each other as the nearest; the
 *               order is that of its leaves from then on
 *     nodes.c   nodes of four of it
 *     groups.c  nodes of four of the order by z, level by level
 *     bound.c   spheres around children
 *     words.c   records in memory words to nodes and leaf records in memory words
 */
#ifndef SPH_BUILD_TREE_H
#define SPH_BUILD_TREE_H

#include <stdint.h>

#include "common/error.h"
#include "machine/profile.h"

enum { SPH_BT_CHILDREN = 4 };

/* A sphere in grid units. */
struct sph_bt_leaf {
    int32_t ctr[3]; /* sW */
    int32_t rad;    /* uW, above 0 */
};

/* Two clusters that were joined. Its number is the index of the last sphere of the left one. */
struct sph_bt_pair {
    uint32_t left, right; /* numbers of the two; of a cluster of one sphere any */
    uint32_t cut;         /* place of the tree's order that the left one ends with */
    uint32_t size; /* the longest edge of the box around both, in units of 2^(W + 2 - SIDE) */
};

struct sph_bt_node {
    uint32_t base;                   /* line of its first child, counted from the root's */
    uint32_t line;                   /* its own */
    uint32_t child[SPH_BT_CHILDREN]; /* n_inner node indices, then n_leaf sphere indices */
    int32_t ctr[SPH_BT_CHILDREN][3]; /* filter units: the sphere around a child, */
    int32_t rad[SPH_BT_CHILDREN];    /* without margin */
    uint8_t n_inner, n_leaf;
};

/* A sphere in filter units, without margin. */
struct sph_bt_ball {
    int32_t ctr[3], rad;
};

/* In grid units. */
struct sph_bt_box {
    int64_t lo[3], hi[3];
};

/* A box of nothing, to which spheres are added. */
struct sph_bt_box sph_bt_nothing(void);

/* Makes a box hold a sphere, given in units of 2^k grid units. */
void sph_bt_add(struct sph_bt_box *box, const int32_t ctr[3], int32_t rad, int k);

/* The sphere around places first .. last of an order, with the smallest radius around its centre
 * that holds them all. One that is larger than that around the grid becomes it. */
void sph_bt_enclose(const struct sph_bt_leaf *leaves, const uint32_t *order, uint32_t first,
                    uint32_t last, const struct sph_profile *profile, struct sph_bt_ball *ball);

/* The sphere in the middle of a box that reaches its farthest corner (Borodavka et al., IV). */
void sph_bt_on_box(const struct sph_bt_box *box, const struct sph_profile *profile,
                   struct sph_bt_ball *ball);

/* Places of n spheres, those of equal keys by index; order[place] is an index. mode:
 * SPH_BUILD_CURVE, along the Morton curve through their centres, or SPH_BUILD_PAPER, by falling z.
 * spare: 2n words. */
void sph_bt_order(const struct sph_bt_leaf *leaves, uint32_t n, int mode,
                  const struct sph_profile *profile, uint32_t *order, uint64_t *spare);

/* A round. The binary tree: n - 1 of pairs[0 .. n-1] by their number, *root that of its root (if
 * there is none, any), and in place of the order along which they are joined that of its leaves. -1
 * if memory is out. */
int sph_bt_join(const struct sph_bt_leaf *leaves, uint32_t n, const struct sph_profile *profile,
                uint32_t *order, struct sph_bt_pair *pairs, uint32_t *root);

/* Nodes of four in the order in which they are written, the root first; nodes: room for n, or for
 * one. Returns how many. */
uint32_t sph_bt_nodes(const struct sph_bt_leaf *leaves, const uint32_t *order, uint32_t n,
                      const struct sph_bt_pair *pairs, uint32_t root,
                      const struct sph_profile *profile, struct sph_bt_node *nodes);

/* Nodes of four of an order by z in the order in which they stand in memory, the root first; nodes:
 * room for n, or for one; balls: as many, which are lost. Returns how many. */
uint32_t sph_bt_groups(const struct sph_bt_leaf *leaves, const uint32_t *order, uint32_t n,
                       const struct sph_profile *profile, struct sph_bt_ball *balls,
                       struct sph_bt_node *nodes);

/* What stays of a build for SPH_BUILD_REFIT: all but the spheres. {0}: nothing does. */
struct sph_bt_kept {
    uint32_t n, root;
    int mode;                  /* SPH_BUILD_CURVE, SPH_BUILD_PAPER */
    uint32_t *order;           /* malloc; NULL: nothing is kept */
    struct sph_bt_pair *pairs; /* malloc */
};

void sph_bt_forget(struct sph_bt_kept *kept);

/* All of it. mode: one of SPH_BUILD_*; rounds: of joining along its own order that follow the first
 * one, with SPH_BUILD_CURVE; kept: of the build before, becomes that of this one, may be
 * NULL. *nodes is malloc'd; -1 with a message if memory is out. */
int sph_bt_tree(const struct sph_bt_leaf *leaves, uint32_t n, int mode, uint32_t rounds,
                const struct sph_profile *profile, struct sph_bt_kept *kept,
                struct sph_bt_node **nodes, uint32_t *n_nodes, struct sph_error *err);

/* Lines that nodes and leaf records of n spheres take at most. */
static inline uint64_t sph_bt_lines(uint32_t n) {
    return n ? 2ull * n : 1;
}

/* What memory gives and what is wanted, as the ports of rt_build have it. */
struct sph_bt_job {
    uint32_t n;               /* spheres */
    uint32_t prim_base;       /* line of the primitive record of sphere 0 */
    uint32_t root;            /* line of the root: nodes and leaf records follow */
    uint32_t lines;           /* that they may take */
    int mode;                 /* SPH_BUILD_CURVE, _PAPER, _REFIT */
    uint32_t rounds;          /* as sph_bt_tree() has it, 0 to 3 */
    struct sph_bt_kept *kept; /* what rt_build holds of the build before; NULL: nothing, ever */
};

/* Reasons why nothing was written; sticky bits of rt_build. */
enum {
    SPH_BT_MANY = 1,   /* more spheres than it was built for */
    SPH_BT_ROOM = 2,   /* fewer lines than sph_bt_lines() */
    SPH_BT_RECORD = 4, /* a number not of W bits, a radius of 0, another id or kind of primitive */
    SPH_BT_BUS = 8,    /* memory answered with an error */
    SPH_BT_MODE = 16   /* no mode, or a refit of another number of spheres than were built last */
};

/* SPH_BT_MANY, _ROOM, _MODE: why a job is not begun. most: spheres that fit the hardware. */
int sph_bt_refused(const struct sph_bt_job *job, uint32_t most);

/* Nodes and leaf records of the primitive records that memory holds. most: as above.
 * *written: lines from the root's on. Returns 0, or reasons of the above; -1 with a
 * message if memory is out. */
int sph_bt_words(uint32_t *memory, const struct sph_bt_job *job, uint32_t most,
                 const struct sph_profile *profile, uint32_t *written, struct sph_error *err);

#endif
