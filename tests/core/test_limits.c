/* test_limits.c - rules of the model where they change: the last value on either side of a limit
 * SPDX-License-Identifier: Apache-2.0
 *
 * Each is a comparison that random numbers seldom meet with both sides equal;
 * tests/hard/mutants.txt moves each of them by one. Run from the root of the repository: reads
 * scenes/.
 */
#include "model_scene.h"

#include "shade/colour.h"
#include "texture/lod.h"
#include "trace/filter.h"
#include "prim/leaf.h"

/* The far key is b + root, rounded up, and at least 1: eight bits of a root of ten are up to three
 * too small, and a key of 0 would be a miss. */
static void far_key_is_at_least_one(void **state) {
    (void)state;
    const struct {
        int64_t b;
        uint64_t key;
    } cases[] = {{-1003, 1}, {-1002, 1}, {-1001, 1}, {-1000, 1}, {-999, 2}, {0, 1001}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const struct sph_leaf_result far = {
            .hit = 1, .far = 1, .b = cases[i].b, .disc = 1003 * 1003};
        uint64_t roots = 0;
        assert_int_equal(sph_leaf_key_bits(&far, 8, &roots), cases[i].key);
        assert_int_equal(roots, 1);
    }
}

/* A sphere of the filter that ends where the ray starts is kept, one that ends before is not. */
static void filter_keeps_what_ends_at_the_origin(void **state) {
    (void)state;
    for (int axis = 0; axis < 3; axis++)
        for (int sign = -1; sign <= 1; sign += 2) {
            struct sph_ray ray = {.kind = SPH_PRIMARY, .skip = {SPH_ID_NONE, 0}, .inside = 1};
            struct sph_child child = {{0, 0, 0}, 5};
            int32_t near;
            ray.dir[axis] = 100 * sign;
            sph_ray_setup(&sph_profiles[SPH_DRAFT], &ray);
            child.ctr[axis] = -5 * sign;
            assert_int_equal(sph_filter(&ray, &child, ray.depth_max, &near), 1);
            assert_int_equal(near, -10);
            child.ctr[axis] = -6 * sign;
            assert_int_equal(sph_filter(&ray, &child, ray.depth_max, &near), 0);
        }
}

/* A ray may visit VISIT_LIMIT nodes, and no more. */
static void visits_up_to_the_limit(void **state) {
    (void)state;
    struct sph_scene scene = model_scene("paper100");
    struct sph_machine m;
    struct sph_counters c;
    int errors;
    uint32_t most = 0;
    assert_true(model_build(&scene, SPH_DRAFT, SPH_TREE_BALANCED, SPH_BG_NONE, 16, 9, &m));
    m.regs[SPH_REG_EFFECTS] = 1 << SPH_EFFECT_INSIDE; /* one ray a pixel */
    struct sph_frame free = model_render(&m, SPH_TRAVERSE_TREE, 1, &c, &errors);
    for (int i = 0; i < 16 * 9; i++)
        if (free.pixels[i].visits > most) most = free.pixels[i].visits;
    assert_int_equal(errors, 0);
    assert_true(most > 1);
    for (uint32_t limit = most - 1; limit <= most; limit++) {
        m.regs[SPH_REG_VISIT_LIMIT] = (int32_t)limit;
        struct sph_frame ends = model_render(&m, SPH_TRAVERSE_TREE, 1, &c, &errors);
        assert_int_equal(errors, limit == most ? 0 : 1 << SPH_ERROR_VISIT_LIMIT);
        for (int i = 0; i < 16 * 9; i++) {
            uint32_t visits = free.pixels[i].visits;
            assert_int_equal(ends.pixels[i].visits, visits < limit ? visits : limit);
        }
        sph_frame_free(&ends);
    }
    sph_frame_free(&free);
    sph_machine_free(&m);
    sph_scene_free(&scene);
}

/* A surface is at most as bright as 255.0, u8.8. */
static void colour_ends_at_white(void **state) {
    (void)state;
    assert_int_equal(sph_surface_colour(255, 32767), 65278);
    assert_int_equal(sph_surface_colour(255, 32768), 65280);
    assert_int_equal(sph_surface_colour(255, 32769), 65280);
    assert_int_equal(sph_surface_colour(255, 131071), 65280);
}

/* The sum of shares stays at 2^16-1, in every frame that the surface is part of. */
static void shares_end_at_sixteen_bits(void **state) {
    (void)state;
    const uint32_t white[3] = {65280, 65280, 65280}, step[3] = {254, 255, 256};
    struct sph_shares s = {0};
    sph_shares_add(&s, 0, 1 << 16, 1 << 16, white);
    sph_shares_add(&s, 0, 1 << 16, 1 << 16, step);
    for (int f = 0; f < SPH_FRAMES; f++) {
        assert_int_equal(s.sum[f][0], 65534);
        assert_int_equal(s.sum[f][1], 65535);
        assert_int_equal(s.sum[f][2], 65535);
        assert_int_equal(sph_shares_colour(&s, f), 0xffffff);
    }
    sph_shares_add(&s, 0, 1 << 16, 1 << 16, white);
    for (int f = 0; f < SPH_FRAMES; f++)
        for (int i = 0; i < 3; i++)
            assert_int_equal(s.sum[f][i], 65535);
}

/* What nine bits round up to the next power of two has that one's logarithm. */
static void logarithm_below_a_power(void **state) {
    (void)state;
    for (int top = 10; top <= 32; top++)
        assert_int_equal(sph_log2((uint32_t)((1ull << top) - 1)), top << 8);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(far_key_is_at_least_one),
        cmocka_unit_test(filter_keeps_what_ends_at_the_origin),
        cmocka_unit_test(visits_up_to_the_limit),
        cmocka_unit_test(colour_ends_at_white),
        cmocka_unit_test(shares_end_at_sixteen_bits),
        cmocka_unit_test(logarithm_below_a_power),
    };
    return cmocka_run_group_tests_name("limits", tests, NULL, NULL);
}
