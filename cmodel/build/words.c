/* words.c - primitive records to nodes and leaf records          RTL: rtl/build/rt_build.v
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdlib.h>
#include <string.h>

#include "build/build_tree.h"
#include "machine/layout.h"
#include "machine/machine.h"

enum { RECORD_WORDS = SPH_LEAF_STRIDE / 32 };

/* A field as two's complement. */
static int32_t signed_field(const uint32_t *line, int lsb, int bits) {
    return (int32_t)(sph_field(line, lsb, bits) << (32 - bits)) >> (32 - bits);
}

/* The sphere of the primitive record of number id. 0 if it is none of W bits and a radius. */
static int read_leaf(const uint32_t *line, uint32_t id, const struct sph_profile *p,
                     struct sph_bt_leaf *leaf) {
    static const int lsb[3] = {SPH_LEAF_CTR_X_LSB, SPH_LEAF_CTR_Y_LSB, SPH_LEAF_CTR_Z_LSB};
    int sound = sph_field(line, SPH_LEAF_ID_LSB, SPH_LEAF_ID_BITS) == id &&
                sph_field(line, SPH_PRIM_KIND_LSB, SPH_PRIM_KIND_BITS) == SPH_SPHERE;
    for (int i = 0; i < 3; i++) {
        leaf->ctr[i] = signed_field(line, lsb[i], SPH_LEAF_CTR_X_BITS);
        sound &= leaf->ctr[i] == signed_field(line, lsb[i], p->w);
    }
    leaf->rad = (int32_t)sph_field(line, SPH_LEAF_RAD_LSB, SPH_LEAF_RAD_BITS);
    return sound && leaf->rad && !(leaf->rad >> p->w);
}

static void put_node(uint32_t *memory, const struct sph_bt_job *job,
                     const struct sph_bt_node *node) {
    uint32_t *to = memory + (size_t)(job->root + node->line) * SPH_LINE_WORDS;
    uint32_t *record = memory + (size_t)(job->root + node->base + node->n_inner) * SPH_LINE_WORDS;
    memset(to, 0, SPH_LINE_WORDS * sizeof *to);
    memset(record, 0, (node->n_leaf + 1u) / 2 * SPH_LINE_WORDS * sizeof *record);
    sph_field_set(to, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS, job->root + node->base);
    sph_field_set(to, SPH_NODE_N_INNER_LSB, SPH_NODE_N_INNER_BITS, node->n_inner);
    sph_field_set(to, SPH_NODE_N_LEAF_LSB, SPH_NODE_N_LEAF_BITS, node->n_leaf);
    for (int i = 0; i < node->n_inner + node->n_leaf; i++) {
        static const int lsb[3] = {SPH_CHILD_CTR_X_LSB, SPH_CHILD_CTR_Y_LSB, SPH_CHILD_CTR_Z_LSB};
        int at = i * SPH_CHILD_STRIDE;
        for (int j = 0; j < 3; j++)
            sph_field_set(to, at + lsb[j], SPH_CHILD_CTR_X_BITS, (uint32_t)node->ctr[i][j]);
        sph_field_set(to, at + SPH_CHILD_RAD_LSB, SPH_CHILD_RAD_BITS,
                      (uint32_t)(node->rad[i] + SPH_FILTER_MARGIN));
    }
    for (int i = 0; i < node->n_leaf; i++)
        memcpy(record + i * RECORD_WORDS,
               memory + (size_t)(job->prim_base + node->child[node->n_inner + i]) * SPH_LINE_WORDS,
               RECORD_WORDS * sizeof *record);
}

void sph_bt_forget(struct sph_bt_kept *kept) {
    free(kept->order);
    free(kept->pairs);
    *kept = (struct sph_bt_kept){0};
}

/* Order and binary tree. */
static int plan(const struct sph_bt_leaf *leaves, uint32_t n, int mode, uint32_t rounds,
                const struct sph_profile *profile, struct sph_bt_kept *kept) {
    uint64_t *spare = malloc((2ull * n + 1) * sizeof *spare);
    kept->order = malloc((n + 1ull) * sizeof *kept->order);
    kept->pairs = calloc(n + 1ull, sizeof *kept->pairs);
    kept->n = n, kept->mode = mode;
    int made = spare && kept->order && kept->pairs;
    if (made) {
        sph_bt_order(leaves, n, mode, profile, kept->order, spare);
        for (uint32_t i = 0; mode == SPH_BUILD_CURVE && made && i <= rounds; i++)
            made = !sph_bt_join(leaves, n, profile, kept->order, kept->pairs, &kept->root);
    }
    if (!made) sph_bt_forget(kept);
    free(spare);
    return made;
}

int sph_bt_tree(const struct sph_bt_leaf *leaves, uint32_t n, int mode, uint32_t rounds,
                const struct sph_profile *profile, struct sph_bt_kept *kept,
                struct sph_bt_node **nodes, uint32_t *n_nodes, struct sph_error *err) {
    struct sph_bt_kept own = {0}, *it = kept ? kept : &own;
    struct sph_bt_ball *balls = malloc((n + 1ull) * sizeof *balls);
    *nodes = malloc((n + 1ull) * sizeof **nodes);
    int made = balls && *nodes;
    if (made && mode != SPH_BUILD_REFIT) {
        sph_bt_forget(it);
        made = plan(leaves, n, mode, rounds, profile, it);
    }
    if (made) {
        *n_nodes = it->mode == SPH_BUILD_PAPER
                       ? sph_bt_groups(leaves, it->order, n, profile, balls, *nodes)
                       : sph_bt_nodes(leaves, it->order, n, it->pairs, it->root, profile, *nodes);
    } else {
        free(*nodes);
        *nodes = NULL;
    }
    free(balls);
    sph_bt_forget(&own);
    return made ? 0 : sph_fail(err, "out of memory for a tree of %u spheres", n);
}

int sph_bt_refused(const struct sph_bt_job *job, uint32_t most) {
    const struct sph_bt_kept *kept = job->kept;
    int refits = kept && kept->order && kept->n == job->n;
    int knows = job->mode == SPH_BUILD_CURVE || job->mode == SPH_BUILD_PAPER ||
                (job->mode == SPH_BUILD_REFIT && refits);
    return (job->n > most ? SPH_BT_MANY : 0) |
           (job->lines < sph_bt_lines(job->n) ? SPH_BT_ROOM : 0) | (knows ? 0 : SPH_BT_MODE);
}

int sph_bt_words(uint32_t *memory, const struct sph_bt_job *job, uint32_t most,
                 const struct sph_profile *profile, uint32_t *written, struct sph_error *err) {
    uint32_t n_nodes, n = job->n;
    *written = 0;
    int wrong = sph_bt_refused(job, most);
    if (wrong) return wrong;
    struct sph_bt_leaf *leaves = malloc((n + 1ull) * sizeof *leaves);
    struct sph_bt_node *nodes = NULL;
    if (!leaves) return sph_fail(err, "out of memory for %u spheres", n);
    for (uint32_t id = 0; id < n; id++)
        if (!read_leaf(memory + (size_t)(job->prim_base + id) * SPH_LINE_WORDS, id, profile,
                       &leaves[id]))
            wrong = SPH_BT_RECORD;
    int failed = wrong ? wrong
                       : sph_bt_tree(leaves, n, job->mode, job->rounds, profile, job->kept, &nodes,
                                     &n_nodes, err);
    if (!failed) {
        const struct sph_bt_node *end = &nodes[n_nodes - 1];
        for (uint32_t i = 0; i < n_nodes; i++)
            put_node(memory, job, &nodes[i]);
        *written = end->base + end->n_inner + (end->n_leaf + 1u) / 2;
    }
    free(leaves);
    free(nodes);
    return failed;
}
