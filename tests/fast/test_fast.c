/* test_fast.c - the fast walk against the literal one: every pixel, counter and error
 * SPDX-License-Identifier: Apache-2.0
 *
 * Run from the root of the repository: reads scenes/. Each is drawn in one of three profiles and
 * trees; with ALL=1 in all.
 */

#include "builder/tree/box.h"
#include "drawn.h"
#include "fast/fast.h"
#include "fast/pixel.h"
#include "fast/tile.h"
#include "model_scene.h"
#include "render/render.h"
#include "scene_list.h"

enum { LANES = SPH_FAST_PLAIN + 1 };

static long frames, pixels, tiled; /* compared; frames in packets */

/* What a literal frame is compared with. */
struct expected {
    const char *what;
    const struct sph_machine *m;
    struct sph_frame frame;
    struct sph_counters c;
    struct sph_trail *trails; /* and as many for the other frame */
    int errors;
};

/* Renders in another way; fails with the first difference. */
static void same(const struct expected *e, const struct sph_fast *fast, int traverse) {
    size_t n = (size_t)e->frame.width * (size_t)e->frame.height;
    struct sph_render_options o = {
        .traverse = traverse, .threads = 1, .fast = fast, .trails = e->trails + n};
    struct sph_counters c = {{0}};
    struct sph_frame other;
    char what[256];
    int bits = sph_render(e->m, &o, &other, &c, NULL);
    snprintf(what, sizeof what, "%s, %s: %s%s", e->what, sph_machine_profile(e->m)->name,
             sph_fast_lanes(fast), traverse == SPH_TRAVERSE_PACKETS ? ", packets" : "");
    for (int i = 0; i < other.width * other.height; i++)
        if (memcmp(&e->frame.pixels[i], &other.pixels[i], sizeof *other.pixels)) {
            model_differ(what, e->m, &other, &e->frame);
            fail_msg("%s, pixel %d,%d: %u visits, expected %u", what, i % other.width,
                     i / other.width, other.pixels[i].visits, e->frame.pixels[i].visits);
        }
    for (int i = 0; i < SPH_COUNTERS; i++)
        if (c.count[i] != e->c.count[i])
            fail_msg("%s, counter %d is %lu, expected %lu", what, i, c.count[i], e->c.count[i]);
    for (size_t i = 0; i < n; i++)
        if (memcmp(&e->trails[i], &e->trails[n + i], sizeof *e->trails))
            fail_msg("%s: the trail of pixel %zu", what, i);
    if (bits != e->errors) fail_msg("%s: errors %x, expected %x", what, bits, e->errors);
    frames++;
    pixels += other.width * other.height;
    sph_frame_free(&other);
}

/* Renders literally and in the other ways. */
static void compare(const struct sph_machine *m, const char *what) {
    size_t n = (size_t)m->regs[SPH_REG_FRAME_W] * (size_t)m->regs[SPH_REG_FRAME_H];
    struct expected e = {.what = what, .m = m, .trails = calloc(2 * n, sizeof *e.trails)};
    struct sph_render_options literal = {
        .traverse = SPH_TRAVERSE_TREE, .threads = 1, .trails = e.trails};
    struct sph_fast *fast[LANES];
    int ways = sph_machine_bih(m) ? 1 : LANES;
    e.errors = sph_render(m, &literal, &e.frame, &e.c, NULL);
    for (int lanes = 0; lanes < ways; lanes++) {
        fast[lanes] = sph_fast_new(m, lanes);
        assert_non_null(fast[lanes]);
        same(&e, fast[lanes], SPH_TRAVERSE_FAST);
    }
    untell(&e.frame, &e.c);
    for (int lanes = 0; lanes < ways; lanes++) {
        same(&e, fast[lanes], SPH_TRAVERSE_PACKETS);
        tiled += sph_fast_tiles(m, fast[lanes]);
        sph_fast_free(fast[lanes]);
    }
    free(e.trails);
    sph_frame_free(&e.frame);
}

/* A scene in a profile and tree, as it asks and with other effects of rays; 0: too fine for it. */
static int scene_in(const struct sph_scene *scene, const char *path, int profile, int tree) {
    static const int turned[] = {1 << SPH_EFFECT_INSIDE, 1 << SPH_EFFECT_FIRST,
                                 1 << SPH_EFFECT_FIRST | 1 << SPH_EFFECT_INTERPENETRATE,
                                 1 << SPH_EFFECT_SHADOW | 1 << SPH_EFFECT_REFLECT};
    struct sph_machine m;
    if (!model_build(scene, profile, tree, SPH_BG_NONE, SANITIZED ? 8 : 32, SANITIZED ? 5 : 18, &m))
        return 0;
    int effects = m.regs[SPH_REG_EFFECTS];
    compare(&m, path);
    for (size_t i = 0; i < sizeof turned / sizeof *turned; i++) {
        m.regs[SPH_REG_EFFECTS] = effects ^ turned[i];
        compare(&m, path);
    }
    m.regs[SPH_REG_EFFECTS] = effects;
    m.regs[SPH_REG_LEAST_WEIGHT] = effects >> SPH_EFFECT_REFLECT & 1 ? 40 : 0;
    compare(&m, path);
    m.regs[SPH_REG_LEAST_WEIGHT] = 0;
    struct sph_profile cut = m.profile;
    cut.pr = cut.w;
    sph_machine_set_profile(&m, &cut);
    compare(&m, path);
    sph_machine_free(&m);
    return 1;
}

static void every_scene(void **state) {
    static const char *const patterns[] = {"scenes/*.nff", "scenes/facets/*.nff",
                                           "scenes/refraction/*.nff", "tests/scenes/facets/*.nff"};
    static const int trees[] = {SPH_TREE_PAPER, SPH_TREE_BALANCED, SPH_TREE_REINSERTED,
                                SPH_TREE_BIH,   SPH_TREE_BRUTE,    SPH_TREE_BOX4,
                                SPH_TREE_HW};
    int drawn = 0;
    struct scene_list found = list_scenes(patterns, sizeof patterns / sizeof *patterns);
    (void)state;
    for (size_t i = 0; i < found.n; i++) {
        struct sph_scene scene = read_scene(found.name[i]);
        for (int p = 0; p < SPH_PROFILES; p++)
            for (int t = 0; t < (int)(sizeof trees / sizeof *trees); t++)
                if (getenv("ALL") || (i + (size_t)p + (size_t)t) % 3 == 0)
                    drawn += scene_in(&scene, found.name[i], p, trees[t]);
        sph_scene_free(&scene);
    }
    assert_true(drawn > 60);
}

/* The root its own children, each as large as can be: a stack that is full. */
static void circle(int tree) {
    struct sph_scene scene = model_scene("paper100");
    struct sph_machine m;
    assert_true(model_build(&scene, SPH_STANDARD, tree, SPH_BG_NONE, 6, 4, &m));
    uint32_t root = (uint32_t)m.regs[SPH_REG_ROOT], *line = sph_line(&m, root);
    for (uint32_t children = 1; children <= 4; children++) {
        memset(line, 0, SPH_LINE_WORDS * sizeof *line);
        sph_field_set(line, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS, root);
        sph_field_set(line, SPH_NODE_N_INNER_LSB, SPH_NODE_N_INNER_BITS, children);
        if (tree == SPH_TREE_BOX4) {
            int32_t end = 1 << (m.profile.w - 1);
            struct sph_aabb whole = {{-end, -end, -end}, {end, end, end}};
            struct sph_aabb boxes[4] = {whole, whole, whole, whole};
            sph_box_put(line, boxes, (int)children, &m.profile);
        }
        for (int i = 0; i < (int)children && tree != SPH_TREE_BOX4; i++)
            sph_field_set(line, i * SPH_CHILD_STRIDE + SPH_CHILD_RAD_LSB, SPH_CHILD_RAD_BITS,
                          (1u << SPH_CHILD_RAD_BITS) - 1);
        for (m.regs[SPH_REG_VISIT_LIMIT] = 10; m.regs[SPH_REG_VISIT_LIMIT] < 20;
             m.regs[SPH_REG_VISIT_LIMIT]++)
            compare(&m, "circles");
    }
    sph_machine_free(&m);
    sph_scene_free(&scene);
}

static void circles(void **state) {
    (void)state;
    circle(SPH_TREE_BALANCED);
    circle(SPH_TREE_BOX4);
}

/* Bits of memory turned over, limits of visits, registers beyond memory: the same errors. */
static void damage(struct sph_machine *m, const char *name, int times) {
    struct sph_rng rng = {seed()};
    size_t bytes = (size_t)m->lines * SPH_LINE_WORDS * sizeof *m->mem;
    uint32_t *sound = malloc(bytes);
    int effects = m->regs[SPH_REG_EFFECTS], root = m->regs[SPH_REG_ROOT];
    memcpy(sound, m->mem, bytes);
    for (int i = 0; i < times; i++) {
        uint64_t flips = 1 + sph_rng_next(&rng) % 40, turn = sph_rng_next(&rng);
        memcpy(m->mem, sound, bytes);
        for (uint64_t j = 0; j < flips; j++) {
            uint64_t r = sph_rng_next(&rng);
            m->mem[(r >> 5) % (m->lines * SPH_LINE_WORDS)] ^= 1u << (r & 31);
        }
        m->regs[SPH_REG_VISIT_LIMIT] = turn & 1 ? 200 : (int32_t)(turn >> 8 & 7);
        m->regs[SPH_REG_EFFECTS] = effects ^ (int)(turn >> 1 & 1) << SPH_EFFECT_FIRST;
        m->regs[SPH_REG_ROOT] =
            turn >> 16 & 15 ? root : (int32_t)((turn >> 20) % (m->lines + 2ull));
        compare(m, name);
    }
    memcpy(m->mem, sound, bytes);
    m->regs[SPH_REG_ROOT] = -1;
    compare(m, name);
    free(sound);
}

static void damaged(void **state) {
    static const char *const names[] = {"scenes/interpenetrating.nff", "scenes/paper100.nff",
                                        "tests/scenes/facets/mixed.nff"};
    (void)state;
    static const int trees[] = {SPH_TREE_BALANCED, SPH_TREE_BIH, SPH_TREE_BOX4};
    enum { TREES = sizeof trees / sizeof *trees };
    for (size_t i = 0; i < TREES * sizeof names / sizeof *names; i++) {
        const char *name = names[i / TREES];
        struct sph_scene scene = read_scene(name);
        struct sph_machine m;
        int tree = trees[i % TREES];
        assert_true(model_build(&scene, SPH_STANDARD, tree, SPH_BG_NONE, 12, 7, &m));
        damage(&m, name, SANITIZED ? 30 : 200);
        m.regs[SPH_REG_N_LOOSE] = m.regs[SPH_REG_N_PRIMS] + 1;
        compare(&m, name);
        sph_machine_free(&m);
        sph_scene_free(&scene);
    }
    printf("# SEED=%lu: %ld frames, %ld pixels, %ld in packets\n", seed(), frames, pixels, tiled);
    assert_true(tiled > 100);
}

/* The fast walk shades no more than what it knows, and all of that. */
static void known_effects(void **state) {
    (void)state;
    const uint32_t all = 1 << SPH_EFFECT_SHADOW | 1 << SPH_EFFECT_REFLECT | 1 << SPH_EFFECT_INSIDE |
                         1 << SPH_EFFECT_FIRST | 1 << SPH_EFFECT_TURNED | 1 << SPH_EFFECT_CAMERA;
    for (int bit = 0; bit < 32; bit++) {
        const struct sph_machine m = {.regs = {[SPH_REG_EFFECTS] = (int32_t)(1u << bit)}};
        assert_int_equal(sph_fast_shades(&m), all >> bit & 1);
    }
}

/* What no walk here knows is left to the literal one. */
static void unknown_trees(void **state) {
    struct sph_scene scene = model_scene("paper5");
    struct sph_machine m;
    struct sph_counters c, expected;
    int errors, literal;
    (void)state;
    assert_true(model_build(&scene, SPH_STANDARD, SPH_TREE_PAPER, SPH_BG_NONE, 12, 7, &m));
    m.regs[SPH_REG_TREE] = 0;
    assert_null(sph_fast_new(&m, SPH_FAST_BEST));
    struct sph_frame a = model_render(&m, SPH_TRAVERSE_FAST, 1, &c, &errors);
    struct sph_frame b = model_render(&m, SPH_TRAVERSE_TREE, 1, &expected, &literal);
    assert_int_equal(model_differ("no tree", &m, &a, &b), 0);
    assert_memory_equal(&c, &expected, sizeof c);
    assert_int_equal(errors, literal);
    sph_frame_free(&a);
    sph_frame_free(&b);
    sph_machine_free(&m);
    sph_scene_free(&scene);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_scene), cmocka_unit_test(circles),
                                       cmocka_unit_test(damaged), cmocka_unit_test(unknown_trees),
                                       cmocka_unit_test(known_effects)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
