/* test_model.c - the golden model against brute force, the naive model and itself
 * SPDX-License-Identifier: Apache-2.0
 *
 * Run from the root of the repository: reads scenes/.
 */
#include "model_scene.h"

enum { W = MODEL_W, H = MODEL_H };

/* Both trees see on every pixel what a test of all spheres sees. */
static void tree_is_brute_force(void **state) {
    (void)state;
    int wrong = 0, frames = 0;
    for (int n = 0; n < MODEL_SCENES; n++) {
        struct sph_scene scene = model_scene(model_scenes[n]);
        for (int profile = 0; profile < SPH_PROFILES; profile++)
            for (int tree = SPH_TREE_PAPER; tree <= SPH_TREE_BALANCED; tree++) {
                struct sph_machine m;
                struct sph_counters c;
                int errors;
                if (!model_build(&scene, profile, tree, SPH_BG_NONE, W, H, &m)) continue;
                struct sph_frame brute = model_render(&m, SPH_TRAVERSE_BRUTE, 0, &c, &errors);
                struct sph_frame near = model_render(&m, SPH_TRAVERSE_TREE, 0, &c, &errors);
                assert_int_equal(errors, 0);
                wrong +=
                    model_differ(tree == SPH_TREE_PAPER ? "paper" : "balanced", &m, &near, &brute);
                frames++;
                sph_frame_free(&brute);
                sph_frame_free(&near);
                sph_machine_free(&m);
            }
        sph_scene_free(&scene);
    }
    printf("# %d frames of %dx%d\n", frames, W, H);
    assert_int_equal(wrong, 0);
    assert_true(frames >= 6 * MODEL_SCENES);
}

/* Every pixel of the second model, written from the definitions, is the same. */
static void naive_is_golden(void **state) {
    (void)state;
    enum { NW = NAIVE_W, NH = NAIVE_H, MOST = 150 /* spheres */ };
    int wrong = 0, frames = 0;
    for (int n = 0; n < MODEL_SCENES; n++) {
        struct sph_scene scene = model_scene(model_scenes[n]);
        for (int profile = 0; profile < SPH_PROFILES && scene.n_spheres <= MOST; profile++) {
            struct sph_machine m;
            struct sph_counters c;
            int errors;
            if (!model_build(&scene, profile, SPH_TREE_BALANCED, n & 1, NW, NH, &m)) continue;
            struct sph_frame golden = model_render(&m, SPH_TRAVERSE_TREE, 0, &c, &errors);
            struct sph_frame naive = model_naive(&m);
            wrong += model_differ("naive", &m, &golden, &naive);
            frames++;
            sph_frame_free(&golden);
            sph_frame_free(&naive);
            sph_machine_free(&m);
        }
        sph_scene_free(&scene);
    }
    printf("# %d frames of %dx%d\n", frames, NW, NH);
    assert_int_equal(wrong, 0);
    assert_true(frames >= 20);
}

/* The background rectangle only leaves out pixels that see no sphere. */
static void background_changes_nothing(void **state) {
    (void)state;
    int wrong = 0;
    uint64_t skipped = 0;
    for (int n = 0; n < MODEL_SCENES; n++) {
        struct sph_scene scene = model_scene(model_scenes[n]);
        struct sph_machine on, off;
        struct sph_counters c;
        int errors, profile = n % SPH_PROFILES;
        if (!model_build(&scene, profile, SPH_TREE_BALANCED, SPH_BG_RECT, W, H, &on) ||
            !model_build(&scene, profile, SPH_TREE_BALANCED, SPH_BG_NONE, W, H, &off))
            fail_msg("%s", model_scenes[n]);
        struct sph_frame b = model_render(&off, SPH_TRAVERSE_TREE, 0, &c, &errors);
        struct sph_frame a = model_render(&on, SPH_TRAVERSE_TREE, 0, &c, &errors);
        wrong += model_differ("background", &on, &a, &b);
        skipped += c.count[SPH_COUNT_BACKGROUND];
        sph_frame_free(&a);
        sph_frame_free(&b);
        sph_machine_free(&on);
        sph_machine_free(&off);
        sph_scene_free(&scene);
    }
    printf("# %lu pixels left out\n", skipped);
    assert_int_equal(wrong, 0);
    assert_true(skipped > 0);
}

static void threads_change_nothing(void **state) {
    (void)state;
    struct sph_scene scene = model_scene("paper100");
    struct sph_machine m;
    struct sph_counters c[2];
    int errors;
    assert_true(model_build(&scene, SPH_STANDARD, SPH_TREE_BALANCED, SPH_BG_NONE, W, H, &m));
    struct sph_frame a = model_render(&m, SPH_TRAVERSE_TREE, 1, &c[0], &errors);
    struct sph_frame b = model_render(&m, SPH_TRAVERSE_TREE, 2, &c[1], &errors);
    assert_memory_equal(a.pixels, b.pixels, W * H * sizeof *a.pixels);
    assert_memory_equal(&c[0], &c[1], sizeof c[0]);
    m.regs[SPH_REG_WIN_X0] = W / 6,
    m.regs[SPH_REG_WIN_X1] = W / 2; /* a window is a part of the frame */
    m.regs[SPH_REG_WIN_Y0] = H / 5, m.regs[SPH_REG_WIN_Y1] = H / 2;
    struct sph_frame part = model_render(&m, SPH_TRAVERSE_TREE, 2, &c[1], &errors);
    const struct sph_pixel none = {0};
    for (int i = 0; i < W * H; i++) {
        int x = i % W, y = i / W, in = x >= W / 6 && x < W / 2 && y >= H / 5 && y < H / 2;
        assert_memory_equal(&part.pixels[i], in ? &a.pixels[i] : &none, sizeof none);
    }
    sph_frame_free(&a);
    sph_frame_free(&b);
    sph_frame_free(&part);
    sph_machine_free(&m);
    sph_scene_free(&scene);
}

/* Layer d of a deep render is what a render of depth d shows. */
static void layers_are_depths(void **state) {
    (void)state;
    for (int n = 0; n < MODEL_SCENES; n++) {
        struct sph_scene scene = model_scene(model_scenes[n]);
        struct sph_machine m;
        struct sph_counters c;
        struct sph_frame f[3];
        int errors, changed = 0;
        assert_true(model_build(&scene, SPH_FINE, SPH_TREE_BALANCED, SPH_BG_NONE, W, H, &m));
        for (int depth = 0; depth < 3; depth++) {
            m.regs[SPH_REG_MAX_DEPTH] = depth;
            f[depth] = model_render(&m, SPH_TRAVERSE_TREE, 0, &c, &errors);
        }
        for (int i = 0; i < W * H; i++) {
            const uint32_t *deep = f[2].pixels[i].colour, *one = f[1].pixels[i].colour;
            for (int layer = 0; layer < SPH_FRAMES; layer++) {
                assert_int_equal(f[0].pixels[i].colour[layer], deep[0]);
                if (layer) assert_int_equal(one[layer], deep[1]);
            }
            changed += deep[0] != deep[2];
        }
        printf("# %s: reflections change %d of %d pixels\n", model_scenes[n], changed, W * H);
        for (int depth = 0; depth < 3; depth++)
            sph_frame_free(&f[depth]);
        sph_machine_free(&m);
        sph_scene_free(&scene);
    }
}

/* No channel is off by more than a least weight's part of 255, and there are fewer rays. */
static void least_weight_is_a_bound(void **state) {
    (void)state;
    static const int least[] = {1, 8, 40, SPH_LEAST_WEIGHT_MAX};
    uint64_t left_out[4] = {0};
    for (int n = 0; n < MODEL_SCENES; n++) {
        struct sph_scene scene = model_scene(model_scenes[n]);
        struct sph_machine m;
        struct sph_counters all, c;
        int errors;
        assert_true(model_build(&scene, SPH_FINE, SPH_TREE_BALANCED, SPH_BG_NONE, W, H, &m));
        struct sph_frame whole = model_render(&m, SPH_TRAVERSE_TREE, 0, &all, &errors);
        for (int k = 0; k < 4; k++) {
            m.regs[SPH_REG_LEAST_WEIGHT] = least[k];
            struct sph_frame f = model_render(&m, SPH_TRAVERSE_TREE, 0, &c, &errors);
            int bound = (255 * least[k] + SPH_LEAST_WEIGHT_MAX - 1) / SPH_LEAST_WEIGHT_MAX;
            for (int i = 0; i < W * H * SPH_FRAMES * 3; i++) {
                int layer = i / 3 % SPH_FRAMES, bit = 8 * (i % 3);
                int a = whole.pixels[i / 3 / SPH_FRAMES].colour[layer] >> bit & 255;
                int b = f.pixels[i / 3 / SPH_FRAMES].colour[layer] >> bit & 255;
                assert_in_range(abs(a - b), 0, bound + 1); /* 1: each is rounded */
            }
            assert_true(c.count[SPH_COUNT_RAYS_REFLECTED] <= all.count[SPH_COUNT_RAYS_REFLECTED]);
            left_out[k] += all.count[SPH_COUNT_RAYS_REFLECTED] - c.count[SPH_COUNT_RAYS_REFLECTED];
            sph_frame_free(&f);
        }
        sph_frame_free(&whole);
        sph_machine_free(&m);
        sph_scene_free(&scene);
    }
    printf("# left out: %lu, %lu, %lu, %lu mirror rays\n", left_out[0], left_out[1], left_out[2],
           left_out[3]);
    assert_true(left_out[1] < left_out[2] && left_out[2] < left_out[3]);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tree_is_brute_force),        cmocka_unit_test(naive_is_golden),
        cmocka_unit_test(background_changes_nothing), cmocka_unit_test(threads_change_nothing),
        cmocka_unit_test(layers_are_depths),          cmocka_unit_test(least_weight_is_a_bound),
    };
    return cmocka_run_group_tests_name("model", tests, NULL, NULL);
}
