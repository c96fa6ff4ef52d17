/* named_scene.c - named cases of two spheres, of two leaves and of whole scenes; see named.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdlib.h>
#include <string.h>

#include "builder/build.h"
#include "builder/emit.h"
#include "naive/naive.h"
#include "named.h"
#include "render/render.h"

/* ---- named cases 27 to 33: two spheres, by order and in scenes ---- */

static struct hard_case pair(struct hard_case c, const int64_t ctr[3], int64_t rad) {
    c.n = 2;
    for (int i = 0; i < 3; i++)
        c.sphere[1].ctr[i] = ctr[i];
    c.sphere[1].rad = rad;
    return c;
}

/* Spheres around the point (0, 0, 0), which the ray meets first on both. */
void named_same_point(struct named *n) {
    int64_t k = n->half / 16;
    for (int64_t m = 1; m < n->most / 8; m *= 5) {
        struct hard_case c = vector(V3(-4 * k, -k, 0), V3(4 * m, m, 0), V3(3 * k, 4 * k, 0), 5 * k);
        expect_first(n, pair(c, V3(2 * k, 2 * k, k), 3 * k), -1);
        expect_first(n, pair(c, V3(2 * k, 2 * k, -k), 3 * k - 1), 0);
        expect_first(n, pair(c, V3(1, 0, 0), 1), -1);
        expect_first(n, pair(c, V3(1, 0, 0), 2), 1);
    }
}

/* Along an axis with |dir| = 1 the keys are whole grid units: 100.27 and 100.76 are both 101. */
void named_tie(struct named *n) {
    for (int64_t x = 0; x < n->half - 104; x = 3 * x + 1) {
        struct hard_case c = vector(V3(0, 0, 0), V3(1, 0, 0), V3(x + 102, 1, 0), 2);
        expect_first(n, pair(c, V3(x + 103, 2, 0), 3), -1);
    }
}

/* Far root of 100 and 3: sqrt(9991) = 99.95; near roots 99.27 (equal keys), 98.76 (first) and
 * 100.27 (behind, by the lowest bit of the key). */
void named_near_far(struct named *n) {
    struct hard_case c = vector(V3(0, 0, 0), V3(1, 0, 0), V3(0, 3, 0), 100);
    expect_first(n, pair(c, V3(101, 1, 0), 2), -1);
    expect_first(n, pair(c, V3(101, 2, 0), 3), 1);
    expect_first(n, pair(c, V3(102, 1, 0), 2), 0);
    for (int64_t r = 100; r < n->half - 4; r *= 3) {
        c = vector(V3(0, 0, 0), V3(1, 0, 0), V3(0, 1, 0), r);
        expect_first(n, pair(c, V3(r + 1, 2, 0), 3), 1);
        expect_first(n, pair(c, V3(r + 2, 1, 0), 2), 0);
    }
}

void named_concentric(struct named *n) {
    int64_t x = n->half / 2;
    for (int64_t r = 1; r < n->half / 4; r = 5 * r + 1) {
        const int64_t ctr[3] = {x, 1, 0};
        struct hard_case out = vector(V3(-x, 1, 0), V3(n->most, 0, 0), ctr, r);
        struct hard_case in = vector(ctr, V3(n->most, 1, 0), ctr, r);
        expect_first(n, pair(out, ctr, r + 1), 1);
        expect_first(n, pair(in, ctr, r + 1), 0);
        out.sphere[0].rad++;
        expect_first(n, pair(out, ctr, r), 0);
    }
    named_scene(n, "concentric");
}

void named_identical(struct named *n) {
    int64_t x = n->half / 2;
    const int64_t ctr[3] = {x, 1, 0};
    struct hard_case c = vector(V3(-x, 0, 0), V3(n->most, 0, 0), ctr, x / 2);
    expect_first(n, pair(c, ctr, x / 2), -1);
    named_scene(n, "identical");
}

void named_lens(struct named *n) {
    int64_t r = n->half / 4;
    for (int64_t apart = 1; apart < r; apart *= 2) {
        struct hard_case c = vector(V3(0, 0, 0), V3(n->most, 1, 0), V3(apart, 0, 0), r);
        expect_first(n, pair(c, V3(-apart, 0, 0), r), 1); /* leaves the one behind first */
        expect_first(n, pair(c, V3(2 * apart, 0, 0), r), 0);
        c = vector(V3(-4 * r + 1, 0, 0), V3(n->most, 0, 0), V3(apart, 0, 0), r);
        expect_first(n, pair(c, V3(-apart, 0, 0), r), 1);
    }
    named_scene(n, "lens");
}

void named_contact(struct named *n) {
    for (int64_t r = 1; r < n->half / 4; r = 3 * r + 1) {
        struct hard_case c = vector(V3(0, -n->half, 0), V3(0, n->most, 0), V3(r, 0, 0), r);
        expect_first(n, pair(c, V3(-r, 0, 0), r), -1); /* between both: two tangents, no hit */
        c = vector(V3(-r, 0, 0), V3(n->most, 0, 0), V3(-r, 0, 0), r);
        expect_first(n, pair(c, V3(r, 0, 0), r), -1); /* out of one into the other */
        c = vector(V3(-3 * r, 0, 0), V3(n->most, 0, 0), V3(-r, 0, 0), r);
        expect_first(n, pair(c, V3(r, 0, 0), r), 0);
    }
    named_scene(n, "contact");
}

/* ---- machines of two leaves: a node of four children, a BIH; see named.h ---- */

static void put_leaf(uint32_t *line, int half, const struct sph_leaf *s) {
    int at = half * SPH_LEAF_STRIDE;
    sph_field_set(line, at + SPH_LEAF_CTR_X_LSB, SPH_LEAF_CTR_X_BITS, (uint32_t)s->ctr[0]);
    sph_field_set(line, at + SPH_LEAF_CTR_Y_LSB, SPH_LEAF_CTR_Y_BITS, (uint32_t)s->ctr[1]);
    sph_field_set(line, at + SPH_LEAF_CTR_Z_LSB, SPH_LEAF_CTR_Z_BITS, (uint32_t)s->ctr[2]);
    sph_field_set(line, at + SPH_LEAF_RAD_LSB, SPH_LEAF_RAD_BITS, (uint32_t)s->rad);
    sph_field_set(line, at + SPH_LEAF_ID_LSB, SPH_LEAF_ID_BITS, s->id);
}

/* A machine of one node with two leaves, in this order; their ids are 0 and 1. mem: 4 lines. */
void two_leaves(const struct named *n, const struct sph_leaf leaf[2], uint32_t *mem,
                struct sph_machine *m) {
    memset(m, 0, sizeof *m);
    memset(mem, 0, 4 * SPH_LINE_WORDS * sizeof *mem);
    m->mem = mem;
    m->lines = 4;
    sph_machine_set_profile(m, &sph_profiles[n->profile]);
    m->regs[SPH_REG_PRIM_BASE] = 2;
    m->regs[SPH_REG_MEM_LINES] = 4;
    m->regs[SPH_REG_N_PRIMS] = 2;
    m->regs[SPH_REG_VISIT_LIMIT] = 2;
    sph_field_set(mem, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS, 1);
    sph_field_set(mem, SPH_NODE_N_LEAF_LSB, SPH_NODE_N_LEAF_BITS, 2);
    for (int i = 0; i < 2; i++) {
        const struct sph_leaf *s = &leaf[i];
        struct sph_ball ball = {{(int32_t)s->ctr[0], (int32_t)s->ctr[1], (int32_t)s->ctr[2]},
                                (int32_t)s->rad};
        struct sph_ball child = sph_filter_leaf(&ball, n->p);
        int at = i * SPH_CHILD_STRIDE;
        sph_field_set(mem, at + SPH_CHILD_CTR_X_LSB, SPH_CHILD_CTR_X_BITS, (uint32_t)child.c[0]);
        sph_field_set(mem, at + SPH_CHILD_CTR_Y_LSB, SPH_CHILD_CTR_Y_BITS, (uint32_t)child.c[1]);
        sph_field_set(mem, at + SPH_CHILD_CTR_Z_LSB, SPH_CHILD_CTR_Z_BITS, (uint32_t)child.c[2]);
        sph_field_set(mem, at + SPH_CHILD_RAD_LSB, SPH_CHILD_RAD_BITS,
                      (uint32_t)(child.r + SPH_FILTER_MARGIN));
        put_leaf(mem + SPH_LINE_WORDS, i, s);
        put_leaf(mem + (2 + s->id) * SPH_LINE_WORDS, 0, s);
    }
}

/* The same two leaves as a BIH of one primitive a leaf, or as one leaf. */
void two_in_bih(struct named *n, const struct sph_leaf leaf[2], int tree,
                uint32_t mem[TWO_LINES * SPH_LINE_WORDS], struct sph_machine *m) {
    struct sph_aabb box[2];
    struct sph_bih bih;
    struct sph_error err = {{0}};
    const struct sph_bih_options how = {tree == SPH_TREE_BIH ? 1 : 2, SPH_BIH_STACK + 1, 0, NULL,
                                        0};
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 3; j++) {
            box[i].lo[j] = (int32_t)(leaf[i].ctr[j] - leaf[i].rad);
            box[i].hi[j] = (int32_t)(leaf[i].ctr[j] + leaf[i].rad);
        }
    require(n, !sph_bih_build(box, 2, &how, &bih, &err), "no BIH: %s", err.text);
    uint32_t base = bih.n_nodes / 2;
    require(n, base + 3 <= TWO_LINES, "%u lines of nodes", base);
    memset(mem, 0, 4 * TWO_LINES * SPH_LINE_WORDS);
    m->mem = mem;
    m->lines = TWO_LINES;
    m->regs[SPH_REG_TREE] = tree;
    m->regs[SPH_REG_PRIM_BASE] = (int32_t)base + 1;
    m->regs[SPH_REG_MEM_LINES] = TWO_LINES;
    m->regs[SPH_REG_VISIT_LIMIT] = (int32_t)bih.n_nodes + 1;
    sph_emit_bih_nodes(&bih, 0, m);
    for (uint32_t i = 0; i < 2; i++) {
        const struct sph_leaf *s = &leaf[bih.order[i]];
        put_leaf(mem + base * SPH_LINE_WORDS, (int)i, s);
        put_leaf(mem + (base + 1 + s->id) * SPH_LINE_WORDS, 0, s);
    }
    sph_bih_free(&bih);
}

/* ---- hard cases that are whole scenes: model, brute force and naive model ---- */

enum { W = 16, H = 12 };

static int same(const struct sph_pixel *a, const struct sph_pixel *b) {
    return a->id == b->id && a->key == b->key && !memcmp(a->colour, b->colour, sizeof a->colour);
}

static int render(struct named *n, const struct sph_machine *m, int how, struct sph_frame *frame) {
    struct sph_render_options o = {.traverse = how, .threads = 1};
    struct sph_counters c = {0};
    struct sph_error err = {{0}};
    int errors = sph_render(m, &o, frame, &c, &err);
    require(n, errors == 0, "rendering: %s, errors %x", err.text, (unsigned)errors);
    return errors >= 0;
}

/* All three pictures; with `lonely` a shadow changes nothing. */
static void compare(struct named *n, const char *name, struct sph_machine *m, int lonely) {
    struct sph_frame tree, brute, dark;
    int wrong = 0;
    if (!render(n, m, SPH_TRAVERSE_TREE, &tree)) return;
    if (render(n, m, SPH_TRAVERSE_BRUTE, &brute)) {
        for (int i = 0; i < W * H; i++) {
            struct sph_pixel naive = sph_naive_pixel(m, i % W, i / W);
            wrong += !same(&tree.pixels[i], &brute.pixels[i]) || !same(&tree.pixels[i], &naive);
        }
        sph_frame_free(&brute);
    }
    require(n, !wrong, "scene %s: %d pixels differ", name, wrong);
    m->regs[SPH_REG_EFFECTS] &= ~(1 << SPH_EFFECT_SHADOW);
    wrong = 0;
    if (lonely && render(n, m, SPH_TRAVERSE_TREE, &dark)) {
        for (int i = 0; i < W * H; i++)
            wrong += !same(&tree.pixels[i], &dark.pixels[i]);
        require(n, !wrong, "scene %s: the sphere shadows itself in %d pixels", name, wrong);
        sph_frame_free(&dark);
    }
    sph_frame_free(&tree);
    n->vectors += W * H;
}

void named_scene(struct named *n, const char *name) {
    char path[1024];
    struct sph_scene scene;
    struct sph_machine m;
    struct sph_error err = {{0}};
    struct sph_read_options read = {0};
    struct sph_build_options o = {.profile = n->profile,
                                  .tree = SPH_TREE_BALANCED,
                                  .width = W,
                                  .height = H,
                                  .max_depth = 3,
                                  .shadow = 1,
                                  .reflect = 1};
    struct sph_build_report report;
    if (n->list) return; /* runs of tests/core/test_core.sh */
    snprintf(path, sizeof path, "%s:%s", n->scenes, name);
    int failed = sph_scene_read(path, &read, &scene, &err);
    require(n, !failed, "%s", err.text);
    if (failed) return;
    if (!strcmp(name, "identical"))
        require(n, scene.n_spheres == 1, "of two equal spheres %u are kept", scene.n_spheres);
    failed = sph_build(&scene, &o, &m, &report, &err);
    require(n, !failed, "%s", err.text);
    if (!failed) {
        compare(n, name, &m, !strcmp(name, "alone"));
        sph_machine_free(&m);
    }
    sph_scene_free(&scene);
}
