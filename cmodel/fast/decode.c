/* decode.c - from the words of memory to nodes and records; see fast.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdlib.h>
#include <string.h>

#include "common/parallel.h"
#include "fast/packets.h"
#include "fast/prepare.h"
#include "fast/setup.h"
#include "machine/records.h"
#include "prim/prim.h"
#include "prim/sphere.h"
#include "trace/filter.h"
#include "trace/order.h"

enum { WORTH = 4096 }; /* nodes, a thread */

/* What is found on the way: nodes that the root leads to, in the order of their lines, so that the
 * children of a node stay together. */
struct job {
    const struct sph_machine *m;
    int whole;
    uint32_t lines, *number; /* of each line: 1 if it is a node, then its number */
    uint32_t *waiting;       /* nodes to look at */
    uint32_t nodes, leaves;
    struct sph_fast *to;
};

/* The head of a node; 0 if a visit would end in BAD_NODE, by the rule of sph_visit(). */
static int head(const struct job *j, uint32_t line, uint32_t *base, uint32_t *n_inner,
                uint32_t *n_leaf) {
    const uint32_t *words = sph_line(j->m, line);
    *base = sph_field(words, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS);
    *n_inner = sph_field(words, SPH_NODE_N_INNER_LSB, SPH_NODE_N_INNER_BITS);
    *n_leaf = sph_field(words, SPH_NODE_N_LEAF_LSB, SPH_NODE_N_LEAF_BITS);
    return *n_inner + *n_leaf <= 4 &&
           *base + *n_inner + sph_record_lines(j->whole, *n_leaf) <= j->lines;
}

/* Marks and counts the nodes below the root, each once though a damaged machine may have circles.
 */
static void find(struct job *j, uint32_t root) {
    uint32_t n = 0, base, n_inner, n_leaf;
    j->number[root] = 1;
    j->waiting[n++] = root;
    while (n) {
        uint32_t line = j->waiting[--n];
        j->nodes++;
        if (!head(j, line, &base, &n_inner, &n_leaf)) continue;
        j->leaves += n_leaf;
        for (uint32_t i = 0; i < n_inner; i++)
            if (!j->number[base + i]) {
                j->number[base + i] = 1;
                j->waiting[n++] = base + i;
            }
    }
}

static void read_leaf(const struct job *j, const uint32_t *record, struct sph_fast_leaf *leaf) {
    *leaf = (struct sph_fast_leaf){{0, 0, 0}, 0, 0, (uint32_t)(record - j->m->mem) + 1};
    uint32_t kind = sph_record_kind(j->whole, record);
    if (kind != SPH_SPHERE || sph_record_clear(kind, record)) return;
    struct sph_leaf sphere = sph_sphere_read(record, sph_machine_profile(j->m)->w);
    for (int i = 0; i < 3; i++)
        leaf->ctr[i] = (int32_t)sphere.ctr[i];
    leaf->rad = (int32_t)sphere.rad;
    leaf->id = sphere.id;
    leaf->record = 0;
}

/* Leaf record `number`. */
static void read_record(const struct job *j, const uint32_t *record, struct sph_fast *f,
                        uint32_t number) {
    read_leaf(j, record, &f->leaves[number]);
    if (f->triangles)
        sph_fast_triangle_read(sph_machine_profile(j->m), record, &f->triangles[number]);
}

/* Room for n leaf records; 0 if memory is out. */
static int room(const struct job *j, struct sph_fast *f, uint32_t n) {
    int triangles = j->whole && sph_fast_triangles_fit(sph_machine_profile(j->m));
    f->leaves = malloc((n + 1ull) * sizeof *f->leaves);
    f->triangles = triangles ? malloc((n + 1ull) * sizeof *f->triangles) : NULL;
    return f->leaves && (f->triangles || !triangles);
}

/* Reads a node whose first leaf record has its number, with boxes unless that is NULL, and its leaf
 * records. */
static void read_node(const struct job *j, uint32_t line, struct sph_fast *f,
                      struct sph_fast_node *node, struct sph_fast_boxes *boxes) {
    uint32_t base, n_inner, n_leaf, leaf = node->leaf;
    memset(node, 0, sizeof *node);
    for (int i = 0; i < 4; i++) {
        node->square[i] = -1;
        node->outer[i] = -1;
    }
    node->bad = !head(j, line, &base, &n_inner, &n_leaf);
    if (node->bad) return;
    node->leaf = leaf - n_inner;
    node->n_inner = (uint8_t)n_inner;
    node->tests = (uint8_t)(n_inner + n_leaf);
    if (n_inner) node->inner = j->number[base];
    if (boxes) boxes->frame = sph_box_frame_read(sph_line(j->m, line), sph_machine_profile(j->m));
    for (int i = 0; i < node->tests && boxes; i++) {
        struct sph_box_planes planes = sph_box_planes_read(sph_line(j->m, line), i);
        for (int k = 0; k < 3; k++) {
            boxes->lo[k][i] = planes.lo[k];
            boxes->hi[k][i] = planes.hi[k];
        }
    }
    for (uint32_t i = 0; i < n_inner; i++)
        node->outer[i] = 0;
    for (uint32_t i = n_inner; i < node->tests; i++)
        node->leaves |= (uint8_t)(1 << 2 * i);
    for (int i = 0; i < node->tests && !boxes; i++) {
        struct sph_child child = sph_child_read(sph_line(j->m, line), i);
        int32_t rad = child.rad << SPH_FILTER_FRACTION;
        node->xy[i][0] = (int16_t)child.ctr[0];
        node->xy[i][1] = (int16_t)child.ctr[1];
        node->zr[i][0] = (int16_t)child.ctr[2];
        node->zr[i][1] = (int16_t)child.rad;
        node->square[i] = rad * rad;
    }
    for (uint32_t i = 0; i < n_leaf; i++)
        read_record(j, sph_record(j->m, j->whole, base + n_inner, i), f, leaf + i);
}

static void read_nodes(void *user, uint32_t first, uint32_t end) {
    const struct job *j = user;
    for (uint32_t i = first; i < end; i++)
        read_node(j, j->waiting[i], j->to, &j->to->nodes[i],
                  j->to->boxes ? &j->to->boxes[i] : NULL);
}

/* 0 if memory is out. */
static int decode(struct job *j, struct sph_fast *f) {
    uint32_t root = (uint32_t)j->m->regs[SPH_REG_ROOT], at = 0, leaf = 0;
    j->number = calloc(j->lines, sizeof *j->number);
    j->waiting = malloc(j->lines * sizeof *j->waiting);
    if (!j->number || !j->waiting) return 0;
    find(j, root);
    f->n_nodes = j->nodes;
    f->nodes = aligned_alloc(sizeof *f->nodes, j->nodes * sizeof *f->nodes);
    int good = room(j, f, j->leaves);
    if (j->m->regs[SPH_REG_TREE] == SPH_TREE_BOX4) {
        f->boxes = aligned_alloc(sizeof(int32_t[4]), j->nodes * sizeof *f->boxes);
        if (!f->boxes) return 0;
        memset(f->boxes, 0, j->nodes * sizeof *f->boxes);
    }
    if (!f->nodes || !good) return 0;
    for (uint32_t line = 0; line < j->lines; line++)
        if (j->number[line]) {
            j->waiting[at] = line;
            j->number[line] = at++;
        }
    f->root = j->number[root];
    for (uint32_t i = 0, base, n_inner, n_leaf; i < j->nodes; i++) {
        f->nodes[i].leaf = leaf;
        if (head(j, j->waiting[i], &base, &n_inner, &n_leaf)) leaf += n_leaf;
    }
    j->to = f;
    sph_parallel_for(j->nodes, WORTH, read_nodes, j);
    return 1;
}

static int known(const struct sph_machine *m) {
    int tree = m->regs[SPH_REG_TREE];
    return sph_machine_bih(m) || tree == SPH_TREE_PAPER || tree == SPH_TREE_BALANCED ||
           tree == SPH_TREE_REINSERTED || tree == SPH_TREE_BOX4 || tree == SPH_TREE_HW;
}

/* Whether the registers of a BIH let a ray start, as in sph_bih_walk(). */
static int sound(const struct job *j) {
    const int32_t *r = j->m->regs;
    return (uint32_t)r[SPH_REG_ROOT] < j->lines &&
           (uint64_t)(uint32_t)r[SPH_REG_LEAF_BASE] + (uint32_t)r[SPH_REG_N_PRIMS] <= j->lines &&
           (uint32_t)r[SPH_REG_N_LOOSE] <= (uint32_t)r[SPH_REG_N_PRIMS];
}

/* The leaf records of a BIH; 0 if memory is out. */
static int decode_bih(const struct job *j, struct sph_fast *f) {
    uint32_t n = (uint32_t)j->m->regs[SPH_REG_N_PRIMS];
    f->root = (uint32_t)j->m->regs[SPH_REG_ROOT];
    f->walk = sph_fast_walk_bih;
    f->lanes = "bih";
    f->no_root = !sound(j);
    if (f->no_root) return 1;
    if (!room(j, f, n)) return 0;
    for (uint32_t i = 0; i < n; i++)
        read_record(j, sph_record(j->m, j->whole, (uint32_t)j->m->regs[SPH_REG_LEAF_BASE], i), f,
                    i);
    return 1;
}

/* The nodes of a tree of spheres or boxes; 0 if memory is out. */
static int decode_tree(struct job *j, struct sph_fast *f, int lanes) {
    f->no_root = (uint32_t)j->m->regs[SPH_REG_ROOT] >= j->lines;
    f->walk = sph_fast_walk_plain;
    f->packet = &sph_packet_plain;
    f->lanes = "plain";
    int boxes = j->m->regs[SPH_REG_TREE] == SPH_TREE_BOX4;
    if (boxes) {
        f->walk = sph_fast_walk_boxes;
        f->packet = NULL;
    }
#if defined __x86_64__
    if (lanes == SPH_FAST_BEST && SPH_ORDER_IN_LANES && sph_fast_walk_avx2 &&
        __builtin_cpu_supports("avx2")) {
        f->walk = boxes ? sph_fast_walk_boxes_avx2 : sph_fast_walk_avx2;
        f->packet = boxes ? NULL : sph_packet_avx2;
        f->lanes = "avx2";
    }
#elif defined __aarch64__
    if (lanes == SPH_FAST_BEST && SPH_ORDER_IN_LANES && !boxes) {
        f->walk = sph_fast_walk_neon;
        f->lanes = "neon";
    }
#else
    (void)lanes;
#endif
    return f->no_root || decode(j, f);
}

struct sph_fast *sph_fast_new(const struct sph_machine *m, int lanes) {
    struct job j = {.m = m, .whole = sph_whole(m), .lines = (uint32_t)m->regs[SPH_REG_MEM_LINES]};
    struct sph_fast *f = known(m) ? calloc(1, sizeof *f) : NULL;
    if (!f) return NULL;
    f->tracer = (struct sph_tracer){sph_fast_prepare, sph_fast_trace};
    f->m = m;
    f->whole = j.whole;
    f->clear = sph_machine_effect(m, SPH_EFFECT_CLEAR);
    f->visit_limit = (uint32_t)m->regs[SPH_REG_VISIT_LIMIT];
#if defined __x86_64__
    if (lanes == SPH_FAST_BEST && __builtin_cpu_supports("avx2"))
        f->prepare = sph_fast_prepare_avx2;
#endif
    int good = sph_machine_bih(m) ? decode_bih(&j, f) : decode_tree(&j, f, lanes);
    free(j.number);
    free(j.waiting);
    if (good) return f;
    sph_fast_free(f);
    return NULL;
}

void sph_fast_free(struct sph_fast *fast) {
    if (!fast) return;
    free(fast->nodes);
    free(fast->boxes);
    free(fast->leaves);
    free(fast->triangles);
    free(fast);
}

const char *sph_fast_lanes(const struct sph_fast *fast) {
    return fast->lanes;
}

void sph_fast_prepare_all(const struct sph_fast *fast, struct sph_ray *rays, int n) {
    const struct sph_profile *p = sph_machine_profile(fast->m);
    if (fast->prepare) {
        fast->prepare(p, rays, n);
        return;
    }
    for (int i = 0; i < n; i++)
        sph_fast_prepare(p, &rays[i]);
}

struct sph_hit sph_fast_trace(const struct sph_fast *fast, const struct sph_ray *ray,
                              struct sph_counters *c, uint32_t *visits, uint32_t *errors) {
    if (!fast->no_root) return fast->walk(fast, ray, c, visits, errors);
    *errors |= 1u << SPH_ERROR_BAD_NODE;
    return (struct sph_hit){0, SPH_ID_NONE, 0, 0};
}
