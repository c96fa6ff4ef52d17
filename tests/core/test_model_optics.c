/* test_model_optics.c - refraction and Whitted's sum: the golden model against the naive one
 * SPDX-License-Identifier: Apache-2.0
 *
 * Run from the root of the repository: reads scenes/.
 */
#include "model_scene.h"

#include "scene/rng.h"
#include "validate/validate.h"

enum { W = NAIVE_W / 2, H = NAIVE_H / 2 };

static const char *const scenes[] = {"tests/scenes/refraction/mixed.nff",
                                     "scenes/refraction/four.nff", "scenes/refraction/index.nff",
                                     "scenes/refraction/water.nff"};
enum { SCENES = sizeof scenes / sizeof *scenes };

static struct sph_scene scene_of(int n) {
    struct sph_scene scene;
    struct sph_error err = {{0}};
    if (sph_scene_read(scenes[n], NULL, &scene, &err)) fail_msg("%s", err.text);
    return scene;
}

static struct sph_build_options options(int profile, int depth) {
    return (struct sph_build_options){.profile = profile,
                                      .tree = SPH_TREE_BALANCED,
                                      .width = W,
                                      .height = H,
                                      .max_depth = depth,
                                      .shadow = SPH_AUTO,
                                      .reflect = SPH_AUTO,
                                      .refract = SPH_AUTO,
                                      .specular = SPH_AUTO,
                                      .lights = SPH_AUTO,
                                      .inside = SPH_AUTO,
                                      .interpenetrate = SPH_AUTO};
}

static struct sph_machine built(const struct sph_scene *scene, const struct sph_build_options *o) {
    struct sph_machine m;
    struct sph_build_report report;
    struct sph_error err = {{0}};
    if (sph_build(scene, o, &m, &report, &err)) fail_msg("%s", err.text);
    if (sph_machine_validate(&m, &err)) fail_msg("%s", err.text);
    return m;
}

/* Pixels that the naive model sees otherwise. */
static int against_naive(const struct sph_machine *m, struct sph_counters *c) {
    int errors;
    struct sph_frame golden = model_render(m, SPH_TRAVERSE_TREE, 0, c, &errors);
    struct sph_frame naive = model_naive(m);
    assert_int_equal(errors, 0);
    int wrong = model_differ("naive", m, &golden, &naive);
    sph_frame_free(&golden);
    sph_frame_free(&naive);
    return wrong;
}

static void naive_is_golden(void **state) {
    (void)state;
    int wrong = 0;
    uint64_t refracted = 0, powers = 0;
    for (int n = 0; n < SCENES; n++) {
        struct sph_scene scene = scene_of(n);
        for (int profile = 0; profile < SPH_PROFILES; profile++) {
            struct sph_build_options o = options(profile, SANITIZED ? 2 : 4);
            struct sph_machine m = built(&scene, &o);
            struct sph_counters c;
            wrong += against_naive(&m, &c);
            refracted += c.count[SPH_COUNT_RAYS_REFRACTED];
            powers += c.count[SPH_COUNT_POWERS];
            sph_machine_free(&m);
        }
        sph_scene_free(&scene);
    }
    printf("# %lu refracted rays, %lu highlights\n", refracted, powers);
    assert_int_equal(wrong, 0);
    assert_true(refracted > 10 * W * H && powers > 5 * W * H);
}

/* The same with parts left out, and with a cut root. */
static void naive_without(void **state) {
    (void)state;
    struct sph_error err = {{0}};
    struct sph_profile cut;
    assert_int_equal(sph_profile_parse("standard:pr=9,ng=1", &cut, &err), 0);
    int wrong = 0;
    for (int way = 0; way < 5; way++) {
        struct sph_scene scene = scene_of(0);
        struct sph_build_options o = options(SPH_STANDARD, 3);
        if (way == 0) o.widths = &cut;
        if (way == 1) o.reflect = SPH_OFF; /* mirror rays of what is reflected wholly remain */
        if (way == 2) o.refract = SPH_OFF;
        if (way == 3) o.specular = SPH_OFF;
        if (way == 4) o.shadow = SPH_OFF;
        struct sph_machine m = built(&scene, &o);
        struct sph_counters c;
        wrong += against_naive(&m, &c);
        assert_int_equal(way == 2, !c.count[SPH_COUNT_RAYS_REFRACTED]);
        assert_int_equal(way == 2 || way == 3, !c.count[SPH_COUNT_POWERS]);
        assert_true(c.count[SPH_COUNT_RAYS_REFLECTED] > 0 || SANITIZED);
        sph_machine_free(&m);
        sph_scene_free(&scene);
    }
    assert_int_equal(wrong, 0);
}

static double uniform(struct sph_rng *rng) {
    return sph_rng_range(rng, 0, 1);
}

/* Spheres and materials at random, many of them in one another. */
static void naive_random(void **state) {
    (void)state;
    enum { N = 9, MATERIALS = 5, RUNS = SANITIZED ? 2 : 24 };
    struct sph_rng rng = {20140};
    int wrong = 0;
    for (int run = 0; run < RUNS; run++) {
        struct sph_material materials[MATERIALS];
        struct sph_sphere spheres[N];
        for (int i = 0; i < MATERIALS; i++) {
            struct sph_material *m = &materials[i];
            *m = (struct sph_material){.kd = uniform(&rng), .ks = uniform(&rng)};
            for (int k = 0; k < 3; k++)
                m->rgb[k] = uniform(&rng);
            m->shine = 1 + 254 * uniform(&rng);
            m->trans = i % 2 ? uniform(&rng) : 0;
            m->ior = i % 3 ? 0.8 + uniform(&rng) : 0.25 + 3.75 * uniform(&rng);
            m->sum = (struct sph_sum){
                .on = i != 4, .ka = uniform(&rng), .kr = i % 3 ? uniform(&rng) : 0};
        }
        for (int i = 0; i < N; i++)
            spheres[i] = (struct sph_sphere){
                .ctr = {6 * uniform(&rng) - 3, 4 * uniform(&rng) - 2, 6 * uniform(&rng) - 3},
                .rad = 0.1 + 2 * uniform(&rng) * uniform(&rng),
                .material = (uint32_t)i % MATERIALS};
        struct sph_scene scene = {
            .name = "random",
            .path = "random",
            .camera = {.from = {0, 0, 8}, .up = {0, 1, 0}, .angle = 40, .width = W, .height = H},
            .background = {0.1, 0.5, 0.9},
            .ambient = {0.3, 0.5, 0.7},
            .n_lights = 2,
            .lights = {{{5, 5, 5}, {1, 0.9, 0.8}, 0},
                       {{-1, 3, 6 * uniform(&rng)}, {0.3, 0.4, 0.5}, 0}},
            .n_materials = MATERIALS,
            .n_spheres = N,
            .materials = materials,
            .spheres = spheres};
        struct sph_build_options o = options(run % SPH_PROFILES, 1 + run % 5);
        o.least_weight = run % 2 ? (int)(SPH_LEAST_WEIGHT_MAX * uniform(&rng) / 4) : 0;
        struct sph_machine m = built(&scene, &o);
        struct sph_counters c;
        wrong += against_naive(&m, &c);
        sph_machine_free(&m);
    }
    assert_int_equal(wrong, 0);
}

/* Shares of any bits in the records, which no scene has: more than 1 counts as 1. */
static void shares_end_at_one(void **state) {
    (void)state;
    static const int lsb[] = {SPH_PRIM_KR_LSB, SPH_PRIM_KT_LSB, SPH_PRIM_KA_LSB, SPH_PRIM_KD_LSB};
    struct sph_rng rng = {2570};
    int wrong = 0;
    for (int profile = 0; profile < SPH_PROFILES; profile++) {
        struct sph_scene scene = scene_of(0);
        struct sph_build_options o = options(profile, 2);
        struct sph_machine m = built(&scene, &o);
        for (int id = 0; id < m.regs[SPH_REG_N_PRIMS]; id++) {
            uint32_t *line =
                m.mem + (size_t)SPH_LINE_WORDS * (size_t)(m.regs[SPH_REG_PRIM_BASE] + id);
            for (int i = 0; i < 4; i++)
                sph_field_set(line, lsb[i], 9, (uint32_t)(512 * uniform(&rng)));
        }
        struct sph_counters c;
        wrong += against_naive(&m, &c);
        sph_machine_free(&m);
        sph_scene_free(&scene);
    }
    assert_int_equal(wrong, 0);
}

/* Trees, and no tree: the same frame, the same rays. */
static void tree_is_brute_force(void **state) {
    (void)state;
    int wrong = 0;
    for (int n = 0; n < SCENES; n++) {
        struct sph_scene scene = scene_of(n);
        for (int tree = SPH_TREE_PAPER; tree <= SPH_TREE_BIH; tree++) {
            struct sph_build_options o = options(n % SPH_PROFILES, 5);
            o.tree = tree;
            struct sph_machine m = built(&scene, &o);
            struct sph_counters near_c, brute_c;
            int errors;
            struct sph_frame near = model_render(&m, SPH_TRAVERSE_TREE, 0, &near_c, &errors);
            struct sph_frame brute = model_render(&m, SPH_TRAVERSE_BRUTE, 0, &brute_c, &errors);
            wrong += model_differ("tree", &m, &near, &brute);
            assert_int_equal(near_c.count[SPH_COUNT_RAYS_REFRACTED],
                             brute_c.count[SPH_COUNT_RAYS_REFRACTED]);
            assert_int_equal(near_c.count[SPH_COUNT_POWERS], brute_c.count[SPH_COUNT_POWERS]);
            sph_frame_free(&near);
            sph_frame_free(&brute);
            sph_machine_free(&m);
        }
        sph_scene_free(&scene);
    }
    assert_int_equal(wrong, 0);
}

/* The three frames are those of depth 0, 1 and as many as there are. */
static void frames_are_depths(void **state) {
    (void)state;
    struct sph_scene scene = scene_of(0);
    struct sph_frame frame[5];
    struct sph_counters c;
    int errors, changed[5] = {0};
    for (int depth = 0; depth < 5; depth++) {
        struct sph_build_options o = options(SPH_STANDARD, depth);
        struct sph_machine m = built(&scene, &o);
        frame[depth] = model_render(&m, SPH_TRAVERSE_TREE, 0, &c, &errors);
        sph_machine_free(&m);
        for (int i = 0; i < W * H; i++) {
            const uint32_t *now = frame[depth].pixels[i].colour;
            for (int f = 0; f < SPH_FRAMES; f++)
                assert_int_equal(now[f], frame[f < depth && f < 2 ? f : depth].pixels[i].colour[2]);
            if (depth) changed[depth] += now[2] != frame[depth - 1].pixels[i].colour[2];
        }
    }
    printf("# pixels that a depth more changes: %d %d %d %d\n", changed[1], changed[2], changed[3],
           changed[4]);
    for (int depth = 0; depth < 5; depth++) {
        if (depth) assert_true(changed[depth] > W * H / 2);
        sph_frame_free(&frame[depth]);
    }
    sph_scene_free(&scene);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(naive_is_golden),   cmocka_unit_test(naive_without),
        cmocka_unit_test(naive_random),      cmocka_unit_test(tree_is_brute_force),
        cmocka_unit_test(frames_are_depths), cmocka_unit_test(shares_end_at_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
