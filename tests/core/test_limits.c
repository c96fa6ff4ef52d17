/* test_limits.c - rules of the model where they change: the last value on either side of a limit
 * SPDX-License-Identifier: Apache-2.0
 *
 * Each is a comparison that random numbers seldom meet with both sides equal;
 * tests/faults moves each of them by one. Run from the root of the repository: reads
 * scenes/.
 */
#include "model_scene.h"

#include "engine/render_pixel.h"
#include "pixel/background.h"
#include "shade/colour.h"
#include "shade/material.h"
#include "shade/surface.h"
#include "texture/lod.h"
#include "trace/filter.h"
#include "prim/sphere.h"
#include "trace/setup.h"

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

/* Unit vectors are a little longer than 1 now and then: cosines are not. */
static void cosines_end_at_one(void **state) {
    (void)state;
    for (int more = 0; more <= 600; more += 100) {
        const struct sph_unit n = {.u = {65536, more, 0}}, back = {.u = {-65536, -more, 0}};
        assert_int_equal(sph_lambert(&n, &n), 32768);
        assert_int_equal(sph_lambert(&n, &back), 0);
        assert_int_equal(sph_specular_cosine(&n, &n, &back), 65536);
        assert_int_equal(sph_specular_cosine(&n, &n, &n), 0);
    }
    const struct sph_unit n = {.u = {65536, 0, 0}}, half = {.u = {32768, 56756, 0}};
    assert_int_equal(sph_lambert(&n, &half), 16384);
    const struct sph_unit one = {.u = {1, 0, 0}}, below = {.u = {65535, 0, 0}};
    assert_int_equal(sph_lambert(&one, &n), 1); /* half a step, and what is less */
    assert_int_equal(sph_lambert(&one, &below), 0);
}

/* Light is at most 2^17-1, u2.15: that of one more lamp, and with the ambient one. */
static void light_ends_at_seventeen_bits(void **state) {
    (void)state;
    const struct sph_shading whole = {.ka = 256, .kd = 256};
    assert_int_equal(sph_light_add(131069, 32768, 1), 131070);
    assert_int_equal(sph_light_add(131070, 32768, 1), 131071);
    assert_int_equal(sph_light_add(131071, 32768, 1), 131071);
    assert_int_equal(sph_light_add(131071, 32768, 65535), 131071);
    assert_int_equal(sph_shading_light(&whole, 1, 131069), 131070);
    assert_int_equal(sph_shading_light(&whole, 1, 131070), 131071);
    assert_int_equal(sph_shading_light(&whole, 1, 131071), 131071);
    assert_int_equal(sph_shading_light(&whole, 65535, 131071), 131071);
}

/* Of an interpolated normal one component alone is enough; none leaves the flat one. */
static void bends_along_one_axis(void **state) {
    (void)state;
    const struct sph_profile *p = &sph_profiles[SPH_STANDARD];
    for (int axis = -1; axis < 3; axis++) {
        int64_t vector[3] = {0};
        struct sph_surface s = {.normal = {1, 2, 3}};
        if (axis >= 0) vector[axis] = -5;
        sph_surface_bend(p, 0, vector, &s);
        assert_int_equal(s.bent, axis >= 0);
        for (int i = 0; i < 3 && axis >= 0; i++)
            assert_true(i == axis ? s.normal[i] < 0 : !s.normal[i]);
        if (axis < 0) assert_int_equal(s.normal[2], 3);
    }
}

/* What shares leave to the surface's own colour: nothing from 1 on, all of it in a sum. */
static void own_share_ends_at_nothing(void **state) {
    (void)state;
    struct sph_shading look = {0};
    assert_int_equal(sph_shading_own(&look, 0, 0), 256);
    assert_int_equal(sph_shading_own(&look, 100, 155), 1);
    assert_int_equal(sph_shading_own(&look, 100, 156), 0);
    assert_int_equal(sph_shading_own(&look, 256, 256), 0);
    look.sum = 1;
    assert_int_equal(sph_shading_own(&look, 100, 156), 256);
}

/* A surface that follows a smooth one on a path is not smooth; its normal is its own. */
static void turned_normals_are_not_bent(void **state) {
    (void)state;
    const struct sph_profile *p = &sph_profiles[SPH_DRAFT];
    const struct sph_ray ray = {.dir = {0, 0, -1000}};
    const int64_t smooth[3] = {100, 0, 100}, flat[3] = {0, 0, 100};
    struct sph_surface s = {0};
    sph_surface_turn(p, &ray, 0, flat, &s);
    sph_surface_bend(p, 0, smooth, &s);
    assert_true(s.bent && s.normal[0] == s.normal[2] && !s.side[0]);
    sph_surface_turn(p, &ray, 0, smooth, &s);
    assert_false(s.bent);
    assert_memory_equal(s.side, s.normal, sizeof s.side);
    sph_surface_turn(p, &ray, 1, flat, &s);
    assert_true(!s.normal[0] && !s.normal[1] && s.normal[2] < 0);
    for (int i = 0; i < 3; i++) { /* along one axis alone it is a normal, along none -dir */
        int64_t along[3] = {0};
        along[i] = 100;
        sph_surface_turn(p, &ray, 0, along, &s);
        for (int k = 0; k < 3; k++)
            assert_int_equal(s.normal[k] > 0, i == k);
        along[i] = 0;
        sph_surface_turn(p, &ray, 0, along, &s);
        assert_true(!s.normal[0] && !s.normal[1] && s.normal[2] > 0);
    }
}

/* A machine of one sphere that has no more than so many effects. */
static struct sph_machine one_sphere(int effects) {
    struct sph_scene scene = model_scene("one_sphere");
    struct sph_machine m;
    assert_true(model_build(&scene, SPH_STANDARD, SPH_TREE_BALANCED, SPH_BG_RECT, 16, 9, &m));
    sph_scene_free(&scene);
    m.regs[SPH_REG_EFFECTS] = effects | 1 << SPH_EFFECT_INSIDE;
    m.regs[SPH_REG_BG_COLOUR] = 0x804020;
    return m;
}

static struct sph_pixel pixel_of(const struct sph_machine *m, int x, int y, struct sph_counters *c,
                                 struct sph_trail *trail) {
    const struct sph_render_options o = {.threads = 1};
    uint32_t errors = 0;
    memset(c, 0, sizeof *c);
    struct sph_pixel pixel = sph_render_pixel(m, &o, x, y, c, &errors, trail);
    assert_int_equal(errors, 0);
    return pixel;
}

/* A pixel that is left out has the colour of the background in every frame and in its sums. */
static void background_in_every_frame(void **state) {
    (void)state;
    struct sph_machine m = one_sphere(0);
    struct sph_counters c;
    struct sph_trail trail;
    for (int traced = 0; traced < 2; traced++) { /* a ray that finds nothing gives the same */
        if (traced) m.regs[SPH_REG_BG_MODE] = 0;
        struct sph_pixel pixel = pixel_of(&m, 0, 0, &c, &trail);
        assert_int_equal(c.count[SPH_COUNT_BACKGROUND], !traced);
        assert_int_equal(c.count[SPH_COUNT_RAYS_PRIMARY], traced);
        assert_int_equal(pixel.key, 0);
        for (int f = 0; f < SPH_FRAMES; f++) {
            assert_int_equal(pixel.colour[f], 0x804020);
            assert_int_equal(trail.sum[f][0], 0x2000);
            assert_int_equal(trail.sum[f][1], 0x4000);
            assert_int_equal(trail.sum[f][2], 0x8000);
        }
    }
    sph_machine_free(&m);
}

/* Point and normal cost a quotient: nothing asks for it without lights and such effects. */
static void quotients_that_are_needed(void **state) {
    static const int needs[] = {SPH_EFFECT_REFLECT, SPH_EFFECT_REFRACT, SPH_EFFECT_TEXTURE,
                                SPH_EFFECT_INTERPENETRATE};
    (void)state;
    for (int i = -2; i < 4; i++) { /* -2: nothing, -1: lights */
        struct sph_machine m = one_sphere(i < 0 ? 0 : 1 << needs[i]);
        struct sph_counters c;
        if (i != -1) m.regs[SPH_REG_N_LIGHTS] = 0;
        assert_true(pixel_of(&m, 8, 4, &c, NULL).key);
        assert_int_equal(c.count[SPH_COUNT_QUOTIENTS], i > -2);
        assert_int_equal(c.count[SPH_COUNT_SATURATIONS], 0); /* far from the ends of the grid */
        sph_machine_free(&m);
    }
}

/* What is reflected wholly takes the share of what cannot go on, up to all of it. */
static void reflected_wholly(void **state) {
    (void)state;
    struct sph_machine m = one_sphere(1 << SPH_EFFECT_REFLECT | 1 << SPH_EFFECT_REFRACT);
    uint32_t *prim = sph_line(&m, (size_t)m.regs[SPH_REG_PRIM_BASE]);
    int wholly = 0;
    sph_field_set(prim, SPH_PRIM_INDEX_LSB, SPH_PRIM_INDEX_BITS, SPH_INDEX_ONE / 2);
    for (uint32_t share = 127; share <= 200; share++) {
        sph_field_set(prim, SPH_PRIM_KR_LSB, SPH_PRIM_KR_BITS, share);
        sph_field_set(prim, SPH_PRIM_KT_LSB, SPH_PRIM_KT_BITS, share);
        for (int x = 0; x < 16; x++) {
            struct sph_counters c;
            struct sph_pixel pixel = pixel_of(&m, x, 4, &c, NULL);
            if (!pixel.key || c.count[SPH_COUNT_RAYS_REFRACTED]) continue;
            assert_int_equal(c.count[SPH_COUNT_RAYS_REFLECTED], 1);
            if (share >= 128) assert_int_equal(pixel.colour[SPH_FRAMES - 1], 0x804020);
            wholly++;
        }
    }
    assert_true(wholly > 0);
    sph_machine_free(&m);
}

/* A cone that a pixel just touches does not hold it: f and b are more than 0 within. */
static void cones_are_open(void **state) {
    (void)state;
    uint32_t mem[SPH_CONE_LINES * SPH_LINE_WORDS];
    for (int f = -1; f <= 1; f++)
        for (int b = -1; b <= 1; b++)
            for (uint32_t inside = 0; inside < 2; inside++) {
                struct sph_machine m = {.mem = mem, .lines = SPH_CONE_LINES};
                memset(mem, 0, sizeof mem);
                sph_machine_set_profile(&m, &sph_profiles[SPH_STANDARD]);
                m.regs[SPH_REG_MEM_LINES] = SPH_CONE_LINES;
                m.regs[SPH_REG_BG_MODE] = 3;
                m.regs[SPH_REG_BG_COUNT] = 1;
                for (int word = 0; word < 4; word++)
                    mem[SPH_CONE_F_LSB / 32 + word] = (uint32_t)(word ? f >> 1 : f);
                for (int word = 0; word < 2; word++)
                    mem[SPH_CONE_B_LSB / 32 + word] = (uint32_t)(word ? b >> 1 : b);
                sph_field_set(mem, SPH_CONE_INSIDE_LSB, SPH_CONE_INSIDE_BITS, inside);
                assert_int_equal(sph_is_background(&m, 0, 0), !(f > 0 && (inside || b > 0)));
            }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(far_key_is_at_least_one),
        cmocka_unit_test(filter_keeps_what_ends_at_the_origin),
        cmocka_unit_test(visits_up_to_the_limit),
        cmocka_unit_test(colour_ends_at_white),
        cmocka_unit_test(shares_end_at_sixteen_bits),
        cmocka_unit_test(logarithm_below_a_power),
        cmocka_unit_test(cosines_end_at_one),
        cmocka_unit_test(light_ends_at_seventeen_bits),
        cmocka_unit_test(bends_along_one_axis),
        cmocka_unit_test(own_share_ends_at_nothing),
        cmocka_unit_test(turned_normals_are_not_bent),
        cmocka_unit_test(background_in_every_frame),
        cmocka_unit_test(quotients_that_are_needed),
        cmocka_unit_test(reflected_wholly),
        cmocka_unit_test(cones_are_open),
    };
    return cmocka_run_group_tests_name("limits", tests, NULL, NULL);
}
