/* test_model_effects.c - the model's effects INSIDE, FIRST and INTERPENETRATE
 * SPDX-License-Identifier: Apache-2.0
 *
 * Bits are set in the machine's register. Run from the root of the repository: reads scenes/.
 */
#include "model_scene.h"

#include "scene/edit.h"
#include "scene/generate.h"
#include "validate/validate.h"

enum {
    W = MODEL_W,
    H = MODEL_H,
    MOST = 150, /* spheres that the naive model is asked for */
    REFLECT = 1 << SPH_EFFECT_REFLECT,
    BOTH = REFLECT | 1 << SPH_EFFECT_SHADOW,
    INSIDE = 1 << SPH_EFFECT_INSIDE,
    FIRST = 1 << SPH_EFFECT_FIRST,
    MEND = 1 << SPH_EFFECT_INTERPENETRATE | FIRST | INSIDE,
};

static const char *const names[] = {"random", "sphereflake", "nested",    "interpenetrating",
                                    "inside", "paper100",    "materials", "no_light",
                                    "paper5", "eight_lights"};
enum { SCENES = sizeof names / sizeof *names };

/* Spheres around the eye, in each other, and touching from outside and inside. */
static void nest(struct sph_scene *scene) {
    static const double at[][4] = {
        {0, 0, 0, 400},  {0, 0, 0, 24},   {0, 0, 0, 16},   {0, 0, 0, 8},    {32, 0, 0, 8},
        {40, 0, 0, 16},  {-32, 0, 0, 8},  {-36, 0, 0, 4},  {0, 32, 0, 8},   {0, 40, 0, 8},
        {0, -32, 16, 8}, {8, -32, 16, 8}, {4, -36, 16, 8}, {4, -32, 20, 4}, {-32, -32, 0, 8},
    };
    struct sph_error err = {{0}};
    free(scene->spheres);
    scene->spheres = NULL;
    scene->n_spheres = 0;
    for (size_t i = 0; i < sizeof at / sizeof *at; i++)
        if (sph_scene_add_sphere(scene, (struct sph_vec){at[i][0], at[i][1], at[i][2]}, at[i][3],
                                 (uint32_t)i % 5, 0, &err))
            fail_msg("%s", err.text);
}

static struct sph_scene scene_of(const char *name) {
    int random = !strcmp(name, "random"), nested = !strcmp(name, "nested");
    if (!random && !nested && strcmp(name, "sphereflake") != 0) return model_scene(name);
    struct sph_generate_options options = {.size = 1, .n = random ? 60 : 0, .seed = 3};
    struct sph_scene scene;
    struct sph_error err = {{0}};
    if (sph_generate(nested ? "paper5" : name, &options, &scene, &err)) fail_msg("%s", err.text);
    if (nested) nest(&scene);
    return scene;
}

static struct sph_machine machine(const char *name, int tree, int effects) {
    struct sph_scene scene = scene_of(name);
    struct sph_machine m;
    if (!model_build(&scene, SPH_STANDARD, tree, SPH_BG_NONE, W, H, &m)) fail_msg("%s", name);
    sph_scene_free(&scene);
    m.regs[SPH_REG_EFFECTS] = effects;
    return m;
}

/* Renders with these effects; no error is expected. */
static struct sph_frame draw(struct sph_machine *m, int effects, int how, struct sph_counters *c) {
    int errors;
    struct sph_error err = {{0}};
    m->regs[SPH_REG_EFFECTS] = effects;
    if (sph_machine_validate(m, &err)) fail_msg("%s", err.text);
    struct sph_frame frame = model_render(m, how, 0, c, &errors);
    assert_int_equal(errors, 0);
    return frame;
}

static uint64_t hits(const struct sph_frame *f) {
    uint64_t n = 0;
    for (int i = 0; i < f->width * f->height; i++)
        n += f->pixels[i].id != SPH_ID_NONE;
    return n;
}

/* Every pixel of the naive model is the same, whatever the effects, tree and profile. */
static void naive_is_golden(void **state) {
    (void)state;
    enum { NW = NAIVE_W * 3 / 4, NH = NAIVE_H * 3 / 4 };
    static const int sets[] = {BOTH, BOTH | FIRST,    BOTH | FIRST | INSIDE, BOTH | MEND,
                               MEND, BOTH & ~REFLECT, REFLECT | MEND};
    int wrong = 0, frames = 0;
    for (int n = 0; n < 2 * SCENES; n++) {
        struct sph_scene scene = scene_of(names[n / 2]);
        struct sph_machine m;
        assert_true(scene.n_spheres <= MOST);
        if (model_build(&scene, (n + n / 2) % SPH_PROFILES,
                        n & 1 ? SPH_TREE_PAPER : SPH_TREE_BALANCED, SPH_BG_NONE, NW, NH, &m)) {
            for (size_t set = 0; set < sizeof sets / sizeof *sets; set++, frames++) {
                struct sph_counters c;
                struct sph_frame golden = draw(&m, sets[set], SPH_TRAVERSE_TREE, &c);
                struct sph_frame naive = model_naive(&m);
                int differ = model_differ("naive", &m, &golden, &naive);
                if (differ) printf("# ... with EFFECTS %d\n", sets[set]);
                wrong += differ;
                sph_frame_free(&golden);
                sph_frame_free(&naive);
            }
            sph_machine_free(&m);
        }
        sph_scene_free(&scene);
    }
    printf("# %d frames of %dx%d\n", frames, NW, NH);
    assert_int_equal(wrong, 0);
    assert_true(frames >= 100);
}

/* FIRST shows other spheres where spheres overlap; INTERPENETRATE mends pixels and spoils none;
 * brute force shows the nearest whatever the bits say. */
static void first_and_mended(void **state) {
    (void)state;
    int first_wrong = 0, mended_wrong = 0;
    for (int n = 0; n < 2 * SCENES; n++) {
        struct sph_machine m = machine(names[n / 2], n & 1 ? SPH_TREE_PAPER : SPH_TREE_BALANCED, 0);
        struct sph_counters c;
        struct sph_frame truth = draw(&m, BOTH | INSIDE, SPH_TRAVERSE_BRUTE, &c);
        struct sph_frame near = draw(&m, BOTH | INSIDE, SPH_TRAVERSE_TREE, &c);
        struct sph_frame first = draw(&m, BOTH | INSIDE | FIRST, SPH_TRAVERSE_TREE, &c);
        struct sph_frame mended = draw(&m, BOTH | MEND, SPH_TRAVERSE_TREE, &c);
        uint64_t repeats = c.count[SPH_COUNT_RAYS_PRIMARY] - W * H;
        struct sph_frame brute = draw(&m, BOTH | MEND, SPH_TRAVERSE_BRUTE, &c);
        assert_int_equal(model_differ("nearest", &m, &near, &truth), 0);
        assert_int_equal(model_differ("brute with FIRST", &m, &brute, &truth), 0);
        assert_int_equal(c.count[SPH_COUNT_RAYS_PRIMARY], W * H);
        int n1 = 0, n2 = 0;
        uint64_t changed = 0;
        for (int i = 0; i < W * H; i++) {
            uint32_t a = truth.pixels[i].id, b = first.pixels[i].id, d = mended.pixels[i].id;
            assert_int_equal(a == SPH_ID_NONE, b == SPH_ID_NONE);
            assert_true(d == a || d == b);
            n1 += a != b, n2 += a != d, changed += b != d;
        }
        assert_true(changed <= repeats);
        printf("# %s, %s: wrong ids of %d: nearest 0, first %d, mended %d; %lu repeats\n",
               names[n / 2], n & 1 ? "paper" : "balanced", W * H, n1, n2, repeats);
        first_wrong += n1, mended_wrong += n2;
        sph_frame_free(&truth);
        sph_frame_free(&near);
        sph_frame_free(&first);
        sph_frame_free(&mended);
        sph_frame_free(&brute);
        sph_machine_free(&m);
    }
    assert_true(first_wrong > 0 && mended_wrong < first_wrong);
}

/* What the probe costs: a mirror ray for every first hit, a primary ray for every repeat. With
 * reflections it is the mirror ray that is needed anyway. */
static void probe_is_counted(void **state) {
    (void)state;
    struct sph_machine m = machine("nested", SPH_TREE_PAPER, 0);
    struct sph_counters c;
    m.regs[SPH_REG_MAX_DEPTH] = 1; /* every sphere there mirrors */
    for (int effects = MEND; effects <= (MEND | REFLECT); effects += REFLECT) {
        struct sph_frame first =
            draw(&m, (effects & ~MEND) | INSIDE | FIRST, SPH_TRAVERSE_TREE, &c);
        struct sph_frame mended = draw(&m, effects, SPH_TRAVERSE_TREE, &c);
        uint64_t seen = hits(&first), visits = 0;
        uint64_t repeats = c.count[SPH_COUNT_RAYS_PRIMARY] - W * H;
        assert_true(repeats > 0 && repeats < seen);
        assert_int_equal(c.count[SPH_COUNT_RAYS_REFLECTED],
                         seen + (effects & REFLECT ? repeats : 0));
        if (!(effects & REFLECT)) assert_int_equal(c.count[SPH_COUNT_QUOTIENTS], seen + repeats);
        for (int i = 0; i < W * H; i++)
            visits += mended.pixels[i].visits;
        assert_int_equal(visits, c.count[SPH_COUNT_NODE_VISITS]);
        sph_frame_free(&first);
        sph_frame_free(&mended);
    }
    sph_machine_free(&m);
}

/* In one node FIRST does what the nearest walk does: all leaves of a visit are tested. */
static void one_node(void **state) {
    (void)state;
    struct sph_scene scene = scene_of("nested");
    struct sph_machine m;
    struct sph_counters a, b;
    scene.n_spheres = 4;
    assert_true(model_build(&scene, SPH_FINE, SPH_TREE_PAPER, SPH_BG_NONE, W, H, &m));
    struct sph_frame near = draw(&m, BOTH | INSIDE, SPH_TRAVERSE_TREE, &a);
    struct sph_frame first = draw(&m, BOTH | INSIDE | FIRST, SPH_TRAVERSE_TREE, &b);
    assert_int_equal(model_differ("one node", &m, &first, &near), 0);
    assert_memory_equal(&a, &b, sizeof a);
    assert_true(a.count[SPH_COUNT_LEAF_TESTS] > a.count[SPH_COUNT_NODE_VISITS]);
    sph_frame_free(&near);
    sph_frame_free(&first);
    sph_machine_free(&m);
    sph_scene_free(&scene);
}

/* Where no ray starts in a sphere INSIDE is for nothing, also for the counters. */
static void inside(void **state) {
    (void)state;
    static const char *const scenes[] = {"paper5", "no_light", "inside", "nested"};
    for (int n = 0; n < 4; n++) {
        struct sph_machine m = machine(scenes[n], SPH_TREE_BALANCED, 0);
        struct sph_counters a, b;
        struct sph_frame on = draw(&m, BOTH | INSIDE, SPH_TRAVERSE_TREE, &a);
        struct sph_frame off = draw(&m, BOTH, SPH_TRAVERSE_TREE, &b);
        int differ = model_differ("INSIDE", &m, &off, &on);
        printf("# %s: INSIDE changes %d of %d pixels\n", scenes[n], differ, W * H);
        assert_int_equal(differ != 0, n >= 2);
        if (n < 2) assert_memory_equal(&a, &b, sizeof a);
        sph_frame_free(&on);
        sph_frame_free(&off);
        sph_machine_free(&m);
    }
}

/* No surface point where nothing starts at one: the same picture without a quotient. */
static void no_quotient(void **state) {
    (void)state;
    struct sph_machine m = machine("inside", SPH_TREE_BALANCED, 0);
    struct sph_counters a, b;
    m.regs[SPH_REG_N_LIGHTS] = m.regs[SPH_REG_MAX_DEPTH] = 0;
    struct sph_frame plain = draw(&m, INSIDE, SPH_TRAVERSE_TREE, &a);
    struct sph_frame with = draw(&m, INSIDE | REFLECT, SPH_TRAVERSE_TREE, &b);
    assert_int_equal(model_differ("no quotient", &m, &plain, &with), 0);
    assert_int_equal(a.count[SPH_COUNT_QUOTIENTS] | a.count[SPH_COUNT_SATURATIONS], 0);
    assert_int_equal(b.count[SPH_COUNT_QUOTIENTS], hits(&with));
    assert_true(hits(&with) > 0);
    sph_frame_free(&with);
    with = draw(&m, MEND, SPH_TRAVERSE_TREE, &b);
    assert_true(b.count[SPH_COUNT_QUOTIENTS] >= hits(&with));
    sph_frame_free(&plain);
    sph_frame_free(&with);
    sph_machine_free(&m);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(naive_is_golden),  cmocka_unit_test(first_and_mended),
        cmocka_unit_test(probe_is_counted), cmocka_unit_test(one_node),
        cmocka_unit_test(inside),           cmocka_unit_test(no_quotient),
    };
    return cmocka_run_group_tests_name("model effects", tests, NULL, NULL);
}
