/* test_model_facets.c - pictures of triangles and planes: trees, brute force, the naive model
 * SPDX-License-Identifier: Apache-2.0
 *
 * Run from the root of the repository: reads tests/scenes/facets/ and scenes/.
 */
#include "model_scene.h"

#include <math.h>
#include <stdlib.h>
#include <unistd.h>

#include "scene/edit.h"
#include "scene/generate.h"
#include "scene/rng.h"
#include "validate/validate.h"

enum {
    W = MODEL_W,
    H = MODEL_H,
    MIXED = 0,           /* planes, polygons, mirrors, spheres: tests/scenes/facets/mixed.nff */
    SOUP = FACET_SCENES, /* spheres and large triangles that cut each other, a plane through them */
    MADE,                /* cones, cylinders and balls: jacks, lattice, tree, rings */
    SCENES = MADE + 4,
    MOST = 60, /* facets that the naive model is asked for */
    SHADOW = 1 << SPH_EFFECT_SHADOW,
    REFLECT = 1 << SPH_EFFECT_REFLECT,
    INSIDE = 1 << SPH_EFFECT_INSIDE,
};

static void add_facet(struct sph_scene *scene, const struct sph_facet *f) {
    struct sph_error err = {{0}};
    if (sph_scene_add_facet(scene, f, &err)) fail_msg("%s", err.text);
}

static struct sph_scene soup(void) {
    struct sph_generate_options options = {.size = 1, .n = 12, .seed = 5};
    struct sph_scene scene;
    struct sph_error err = {{0}};
    struct sph_rng rng = {7};
    if (sph_generate("random", &options, &scene, &err)) fail_msg("%s", err.text);
    struct sph_vec low = scene.spheres[0].ctr, high = low;
    for (uint32_t i = 0; i < scene.n_spheres; i++) {
        struct sph_vec c = scene.spheres[i].ctr;
        low = (struct sph_vec){fmin(low.x, c.x), fmin(low.y, c.y), fmin(low.z, c.z)};
        high = (struct sph_vec){fmax(high.x, c.x), fmax(high.y, c.y), fmax(high.z, c.z)};
    }
    for (uint32_t i = 0; i < 30; i++) {
        struct sph_facet f = {.kind = SPH_TRIANGLE, .group = i, .material = i % scene.n_materials};
        for (int j = 0; j < 3; j++)
            f.v[j] = (struct sph_vec){sph_rng_range(&rng, low.x, high.x),
                                      sph_rng_range(&rng, low.y, high.y),
                                      sph_rng_range(&rng, low.z, high.z)};
        add_facet(&scene, &f);
    }
    struct sph_facet plane = {.kind = SPH_PLANE,
                              .v = {scene.spheres[3].ctr, {0.1, -1, 0.3}, {1, 0, 0}},
                              .st = {{1, 1}},
                              .group = 30};
    add_facet(&scene, &plane);
    return scene;
}

/* A generated scene, as its file says it, with rings of nine. */
static struct sph_scene made(const char *kind) {
    struct sph_generate_options options = {.size = 1};
    struct sph_read_options coarse = {.round = 0.07};
    struct sph_scene scene, again;
    struct sph_error err = {{0}};
    char path[] = "/tmp/test_model_facets.XXXXXX";
    FILE *file = fdopen(mkstemp(path), "w");
    if (sph_generate(kind, &options, &scene, &err) || sph_scene_write(&scene, file, &err) ||
        fclose(file) || sph_scene_read(path, &coarse, &again, &err))
        fail_msg("%s", err.text);
    unlink(path);
    sph_scene_free(&scene);
    return again;
}

static struct sph_scene scene_of(int n) {
    static const char *const kinds[] = {"jacks", "lattice", "tree", "rings"};
    return n == SOUP ? soup() : n < MADE ? facet_scene(n) : made(kinds[n - MADE]);
}

static void trees_are_brute_force(void **state) {
    (void)state;
    int wrong = 0;
    for (int n = 0; n < SCENES; n++) {
        struct sph_scene scene = scene_of(n);
        for (int profile = 0; profile < SPH_PROFILES; profile++)
            for (int tree = SPH_TREE_PAPER; tree <= SPH_TREE_BALANCED; tree++) {
                struct sph_machine m;
                struct sph_counters all, some;
                struct sph_error err = {{0}};
                int errors, bad, seen = 0;
                if (scene.n_facets > MOST && tree != 1 + profile % 2) continue;
                assert_true(model_build(&scene, profile, tree, n & 1, W, H, &m));
                if (sph_machine_validate(&m, &err)) fail_msg("%s", err.text);
                struct sph_frame brute = model_render(&m, SPH_TRAVERSE_BRUTE, 0, &all, &bad);
                struct sph_frame near = model_render(&m, SPH_TRAVERSE_TREE, 0, &some, &errors);
                assert_int_equal(errors | bad, 0);
                wrong += model_differ("tree", &m, &near, &brute);
                for (int i = 0; i < W * H; i++) {
                    uint32_t id = near.pixels[i].id;
                    seen += id != SPH_ID_NONE && id >= scene.n_spheres;
                }
                const uint64_t *a = all.count, *s = some.count;
                assert_true(seen > (n < MADE ? W * H / 4 : W * H / 64));
                assert_true(s[SPH_COUNT_DIVISIONS] > 0);
                assert_true(s[SPH_COUNT_FACET_TESTS] > s[SPH_COUNT_DIVISIONS]);
                if (scene.n_facets > SPH_MAX_PLANES) /* planes are met by every ray */
                    assert_true(s[SPH_COUNT_FACET_TESTS] < a[SPH_COUNT_FACET_TESTS]);
                assert_true(!scene.n_spheres || s[SPH_COUNT_LEAF_TESTS] < a[SPH_COUNT_LEAF_TESTS]);
                assert_true(s[SPH_COUNT_ROOTS] <= s[SPH_COUNT_LEAF_TESTS]);
                sph_frame_free(&brute);
                sph_frame_free(&near);
                sph_machine_free(&m);
            }
        sph_scene_free(&scene);
    }
    assert_int_equal(wrong, 0);
}

/* The second model draws the same, whatever the machine asks for. */
static void naive_is_golden(void **state) {
    (void)state;
    enum { NW = NAIVE_W * 3 / 4, NH = NAIVE_H * 3 / 4 };
    static const int effects[] = {SHADOW | REFLECT | INSIDE, SHADOW | REFLECT, INSIDE, 0};
    int wrong = 0;
    for (int n = 0; n < SCENES; n++) {
        struct sph_scene scene = scene_of(n);
        for (int i = 0; i < SPH_PROFILES + 3; i++) { /* all effects, then fewer of them */
            if (scene.n_facets > MOST || (n != MIXED && i % 4)) continue;
            struct sph_machine m;
            struct sph_counters c;
            int errors, profile = (i + n) % SPH_PROFILES;
            assert_true(model_build(&scene, profile, SPH_TREE_BALANCED, i & 1, NW, NH, &m));
            m.regs[SPH_REG_EFFECTS] =
                1 << SPH_EFFECT_FACETS | effects[i < SPH_PROFILES ? 0 : i - SPH_PROFILES + 1];
            struct sph_frame golden = model_render(&m, SPH_TRAVERSE_TREE, 0, &c, &errors);
            struct sph_frame naive = model_naive(&m);
            wrong += model_differ("naive", &m, &golden, &naive);
            sph_frame_free(&golden);
            sph_frame_free(&naive);
            sph_machine_free(&m);
        }
        sph_scene_free(&scene);
    }
    assert_int_equal(wrong, 0);
}

/* A triangle that nothing sees, in the middle of a sphere: leaf lines are whole ones, the picture
 * stays. */
static void spheres_stay_spheres(void **state) {
    (void)state;
    struct sph_scene scene = model_scene("paper5");
    struct sph_machine m;
    struct sph_counters c[2];
    int errors;
    assert_true(model_build(&scene, SPH_FINE, SPH_TREE_BALANCED, SPH_BG_NONE, 64, 36, &m));
    struct sph_frame before = model_render(&m, SPH_TRAVERSE_TREE, 0, &c[0], &errors);
    sph_machine_free(&m);
    struct sph_vec o = scene.spheres[2].ctr;
    double r = scene.spheres[2].rad / 8;
    struct sph_facet f = {.kind = SPH_TRIANGLE, .v = {o, {o.x + r, o.y, o.z}, {o.x, o.y + r, o.z}}};
    add_facet(&scene, &f);
    assert_true(model_build(&scene, SPH_FINE, SPH_TREE_BALANCED, SPH_BG_NONE, 64, 36, &m));
    assert_true(sph_machine_effect(&m, SPH_EFFECT_FACETS));
    struct sph_frame after = model_render(&m, SPH_TRAVERSE_TREE, 0, &c[1], &errors);
    assert_int_equal(model_differ("hidden triangle", &m, &after, &before), 0);
    assert_true(c[1].count[SPH_COUNT_FACET_TESTS] > 0 && !c[0].count[SPH_COUNT_FACET_TESTS]);
    sph_frame_free(&before);
    sph_frame_free(&after);
    sph_machine_free(&m);
    sph_scene_free(&scene);
}

/* A root with three leaf lines where memory has but two left. */
static void leaves_beyond_memory(void **state) {
    (void)state;
    struct sph_scene scene = scene_of(MIXED);
    struct sph_machine m;
    struct sph_counters c;
    int errors;
    assert_true(model_build(&scene, SPH_DRAFT, SPH_TREE_PAPER, SPH_BG_NONE, 4, 4, &m));
    for (uint32_t room = 2; room < 4; room++) {
        uint32_t *root = m.mem + (size_t)m.regs[SPH_REG_ROOT] * SPH_LINE_WORDS;
        sph_field_set(root, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS, m.lines - room);
        sph_field_set(root, SPH_NODE_N_INNER_LSB, SPH_NODE_N_INNER_BITS, 0);
        sph_field_set(root, SPH_NODE_N_LEAF_LSB, SPH_NODE_N_LEAF_BITS, 3);
        struct sph_frame frame = model_render(&m, SPH_TRAVERSE_TREE, 1, &c, &errors);
        assert_int_equal(errors, room < 3 ? 1 << SPH_ERROR_BAD_NODE : 0);
        sph_frame_free(&frame);
    }
    sph_machine_free(&m);
    sph_scene_free(&scene);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(trees_are_brute_force),
        cmocka_unit_test(naive_is_golden),
        cmocka_unit_test(spheres_stay_spheres),
        cmocka_unit_test(leaves_beyond_memory),
    };
    return cmocka_run_group_tests_name("model_facets", tests, NULL, NULL);
}
