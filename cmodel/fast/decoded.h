/* decoded.h - a machine's tree as the fast walk reads it
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_FAST_DECODED_H
#define SPH_FAST_DECODED_H

#include "core/tracer.h"
#include "fast/fast.h"
#include "fast/triangle.h"
#include "machine/box.h"

/* A node: one line of the processor's cache. The children of a number, leaves behind inner ones. */
struct sph_fast_node {
    int16_t xy[4][2], zr[4][2]; /* centre and radius of child 0..3, filter units */
    int32_t square[4];          /* of the radius, in units of filter's distances; no child: -1 */
    uint32_t inner, leaf;       /* child i is the node inner + i, or the record leaf + i */
    uint8_t n_inner, tests;
    uint8_t leaves;  /* bit 2 i: child i is a leaf */
    uint8_t bad;     /* the error BAD_NODE when it is visited; it has no child then */
    int8_t outer[4]; /* -1: child i is no node */
};

/* Coordinate k of child i's centre. */
static inline int16_t sph_fast_ctr(const struct sph_fast_node *n, int k, int i) {
    return k < 2 ? n->xy[i][k] : n->zr[i][0];
}

/* A node's boxes. */
struct sph_fast_boxes {
    int32_t lo[3][4], hi[3][4]; /* planes of child 0..3, steps; where there is none, 0 */
    struct sph_box_frame frame;
};

/* A leaf record. */
struct sph_fast_leaf {
    int32_t ctr[3], rad;
    uint32_t id;
    uint32_t record; /* no sphere, or a clear one: the word of memory where it begins, plus 1 */
};

struct sph_fast {
    struct sph_tracer tracer; /* first: core/tracer.h */
    const struct sph_machine *m;
    struct sph_fast_node
        *nodes; /* the root is number `root`; none of a BIH, whose root is a line */
    struct sph_fast_boxes *boxes; /* of nodes by number, whose spheres are 0 then; else NULL */
    struct sph_fast_leaf *leaves;
    struct sph_fast_triangle *triangles; /* of leaf records by number; NULL: all are unknown */
    uint32_t root, n_nodes, visit_limit;
    int whole, clear; /* of the machine's effects, as sph_ray_query has them */
    int no_root;      /* it, or what registers of a BIH name, does not lie in memory */
    struct sph_hit (*walk)(const struct sph_fast *, const struct sph_ray *, struct sph_counters *,
                           uint32_t *, uint32_t *);
    const struct sph_packet_way *packet; /* NULL: not for this tree */
    /* sph_fast_prepare() of n rays; NULL: one after another */
    void (*prepare)(const struct sph_profile *, struct sph_ray *, int);
    const char *lanes;
};

/* The walks of a BIH, and of nodes of boxes, whose children are tested one after another or at
 * once. NULL where the compiler knows no AVX2. */
struct sph_hit sph_fast_walk_bih(const struct sph_fast *f, const struct sph_ray *ray,
                                 struct sph_counters *c, uint32_t *visits, uint32_t *errors);

struct sph_hit sph_fast_walk_boxes(const struct sph_fast *f, const struct sph_ray *ray,
                                   struct sph_counters *c, uint32_t *visits, uint32_t *errors);
extern struct sph_hit (*const sph_fast_walk_boxes_avx2)(const struct sph_fast *,
                                                        const struct sph_ray *,
                                                        struct sph_counters *, uint32_t *,
                                                        uint32_t *);

/* The walks of spheres: four children one after another, or at once. NULL where the compiler knows
 * no AVX2 or no NEON. */
struct sph_hit sph_fast_walk_plain(const struct sph_fast *f, const struct sph_ray *ray,
                                   struct sph_counters *c, uint32_t *visits, uint32_t *errors);
extern struct sph_hit (*const sph_fast_walk_avx2)(const struct sph_fast *, const struct sph_ray *,
                                                  struct sph_counters *, uint32_t *, uint32_t *);
struct sph_hit sph_fast_walk_any_avx2(const struct sph_fast *f, const struct sph_ray *ray,
                                      struct sph_counters *c, uint32_t *visits, uint32_t *errors);
extern struct sph_hit (*const sph_fast_walk_neon)(const struct sph_fast *, const struct sph_ray *,
                                                  struct sph_counters *, uint32_t *, uint32_t *);

#endif
