/* test_motion.c - primitives that move and grow: scene files, places, P_b that is kept
 * SPDX-License-Identifier: Apache-2.0
 */
#include "scene_files.h"
#include "textured.h"

#include "scene/affine.h"
#include "scene/generate.h"
#include "scene/motion.h"

static const struct bad bads[] = {
    {"short", CAM MAT "move 1 2\ns 0 0 0 1\n", 10, "`move`: z: `s` is not", 0, 0},
    {"grow_alone", CAM MAT "move 1 2 3 .5\ns 0 0 0 1\n", 10, "x of its middle: `s` is not", 0, 0},
    {"no_number", CAM MAT "move 1 2 nan\n", 9, "`move`: z: `nan` is not", 0, 0},
    {"end", CAM MAT "move 1 2", 9, "ends within `move`, before z", 0, 0},
    {"fly_0", CAM "fly 0 0 0 9 0 0 0\n", 8, "`fly`: frame 0 is not a whole number of 1 to", 0, 0},
    {"fly_back", CAM "fly 5 0 0 9 0 0 0\nfly 5 0 0 8 0 0 0\n", 9,
     "`fly`: frame 5 is not after frame 5", 0, 0},
    {"fly_nowhere", CAM "fly 5 1 2 3 1 2 3\n", 8, "`fly`: frame 5", 0, 0},
    {"fly_up", CAM "fly 5 0 4 0 0 0 0\n", 8, "`fly`: frame 5", 0, 0},
};
static const struct bad bads_at_3[] = {
    {"gone", CAM MAT "move 0 0 0 -.5 0 0 0\ns 0 0 0 1\n", 9, "nothing is left at frame 3", 0, 0},
    {"meet", CAM MAT "s 3 0 0 1\nmove 1 0 0\ns 0 0 0 1\n", 11,
     "at frame 3 the same sphere (centre and radius) as in line 9", 0, 0},
    {"far", CAM MAT "move 0 0 0 .05 0 0 0\ns 0 1e30 0 1\n", 10,
     "at frame 3 it is moved beyond 1e+30", 0, 0},
    {"far_plane", CAM MAT "move 0 1e30 0\nplane 0 1 0 0 1 0\n", 10,
     "at frame 3 it is moved beyond 1e+30", 0, 0},
    {"far_camera", CAM "fly 2 1e30 0 9 0 0 0\nfly 4 1e30 0 9 0 0 0\n", 8,
     "`fly`: frame 3: the camera is beyond 1e+30", 0, 0},
    {"through", CAM MAT "fly 6 0 0 -5 0 0 0\n", 9, "`fly`: frame 3", 0, 0},
};

static void refused(const struct bad *bad, uint32_t at) {
    struct sph_read_options read = {.at = at};
    struct sph_error err = {""};
    struct sph_scene scene;
    put_bad(bad);
    assert_int_equal(sph_scene_read(file_name, &read, &scene, &err), -1);
    assert_message(bad, &err);
    assert_null(scene.motions);
}

static void test_bad(void **state) {
    refused(*state, 0);
}

static void test_bad_at_3(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof bads_at_3 / sizeof *bads_at_3; i++)
        refused(&bads_at_3[i], 3);
}

/* A still sphere, then all kinds of primitives in one motion, a second motion, a still triangle. */
static const char moving[] = CAM MAT "s 9 9 9 1\n"
                                     "move 1 0 -2 .5 10 0 0\n"
                                     "s 10 2 0 1\np 3 0 0 0 2 0 0 0 2 0\n"
                                     "texture x.png 3 4\nplane 10 0 0 0 1 0\ntexture none\n"
                                     "move 0 4 0\ns 0 0 0 2\nstill\np 3 5 0 0 6 0 0 5 1 0\n";

static void read_at(const char *text, uint32_t at, struct sph_scene *scene) {
    struct sph_read_options read = {.at = at};
    struct sph_error err = {""};
    if (text) put_file(text, strlen(text));
    if (sph_scene_read(file_name, &read, scene, &err)) fail_msg("%s", err.text);
}

static void at(struct sph_vec v, double x, double y, double z) {
    assert_true(v.x == x && v.y == y && v.z == z);
}

static void places(void **state) {
    (void)state;
    struct sph_scene rest, s, again;
    struct sph_error err = {""};
    read_at(moving, 0, &rest);
    at(rest.spheres[1].ctr, 10, 2, 0);
    if (sph_scene_at(&rest, 2, &s, &err)) fail_msg("%s", err.text);
    static const uint32_t motion[] = {0, 1, 2, 1, 1, 0};
    for (int i = 0; i < 6; i++)
        assert_int_equal(i < 3 ? s.spheres[i].motion : s.facets[i - 3].motion, motion[i]);
    at(s.spheres[0].ctr, 9, 9, 9);
    at(s.spheres[1].ctr, 12, 4, -4); /* twice as far from 10 0 0, and two steps on */
    assert_true(s.spheres[1].rad == 2 && s.spheres[2].rad == 2);
    at(s.spheres[2].ctr, 0, 8, 0);
    at(s.facets[0].v[0], -8, 0, -4);
    at(s.facets[0].v[1], -4, 0, -4);
    at(s.facets[0].v[2], -8, 4, -4);
    at(s.facets[1].v[0], 12, 0, -4);
    at(s.facets[1].v[1], 0, 1, 0); /* a direction */
    assert_true(s.facets[1].st[0][0] == 6 && s.facets[1].st[0][1] == 8);
    at(s.facets[2].v[1], 6, 0, 0);
    at(rest.spheres[1].ctr, 10, 2, 0); /* stays as it was */
    at(rest.facets[0].v[1], 2, 0, 0);
    FILE *file = fopen(file_name, "w"); /* what is written moves as well */
    assert_non_null(file);
    assert_int_equal(sph_scene_write(&rest, file, &err), 0);
    fclose(file);
    read_at(NULL, 2, &again);
    assert_same_scene(&s, &again);
    assert_same_facets(&s, &again);
    sph_scene_free(&again);
    sph_scene_at_free(&s);
    sph_scene_free(&rest);
}

/* Equal steps are a straight line, places are met, and behind the last one the camera stays. */
static void flies(void **state) {
    (void)state;
    static const char text[] = CAM "fly 4 4 2 5 0 2 0\nfly 8 8 4 5 0 4 0\nfly 12 8 4 -3 1 0 0\n";
    struct sph_scene rest, s, again;
    struct sph_error err = {""};
    read_at(text, 0, &rest);
    at(rest.camera.from, 0, 0, 5);
    static const uint32_t frames[] = {2, 4, 12, 99};
    static const double from[][3] = {{2, 1, 5}, {4, 2, 5}, {8, 4, -3}, {8, 4, -3}};
    static const double look[][3] = {{0, 1, 0}, {0, 2, 0}, {1, 0, 0}, {1, 0, 0}};
    for (int i = 0; i < 4; i++) {
        if (sph_scene_at(&rest, frames[i], &s, &err)) fail_msg("%s", err.text);
        at(s.camera.from, from[i][0], from[i][1], from[i][2]);
        at(s.camera.at, look[i][0], look[i][1], look[i][2]);
        sph_scene_at_free(&s);
    }
    if (sph_scene_at(&rest, 7, &s, &err)) fail_msg("%s", err.text);
    FILE *file = fopen(file_name, "w");
    assert_non_null(file);
    assert_int_equal(sph_scene_write(&rest, file, &err), 0);
    fclose(file);
    read_at(NULL, 7, &again);
    assert_same_scene(&s, &again);
    at(again.camera.from, s.camera.from.x, s.camera.from.y, s.camera.from.z);
    sph_scene_free(&again);
    sph_scene_at_free(&s);
    sph_scene_free(&rest);
}

/* What is generated goes once round, and every part moves as far. */
static void generated(void **state) {
    (void)state;
    struct sph_generate_options o = {.drift = .25, .orbit = 10, .size = 1};
    struct sph_scene scene;
    struct sph_error err = {""};
    if (sph_generate("jacks", &o, &scene, &err)) fail_msg("%s", err.text);
    assert_int_equal(scene.n_flights, 36);
    assert_int_equal(scene.flights[35].frame, 36);
    struct sph_vec back = sph_vec_sub(scene.flights[35].from, scene.camera.from);
    assert_true(sph_vec_length(back) < 1e-9 * sph_vec_length(scene.camera.from));
    assert_int_equal(scene.n_motions, scene.n_spheres + scene.n_frusta + 1); /* the floor */
    for (uint32_t i = 0; i < scene.n_motions; i++)
        assert_float_equal(sph_vec_length(scene.motions[i].step), .25, 1e-12);
    for (uint32_t i = 1; i < scene.n_facets; i++)
        assert_int_equal(scene.facets[i].motion == scene.facets[i - 1].motion,
                         scene.facets[i].frustum == scene.facets[i - 1].frustum);
    sph_scene_free(&scene);
}

/* A sequence builds, bit for bit, what each frame alone does; still primitives keep P_b while the
 * grid's step stays, and what moves has it made anew. */
static const char show[] =
    "v from 0 0 5 at 0 0 0 up 0 1 0 angle 40 resolution 16 12\n" MAT "texture x.png 2 1\n"
    "s 2 0 -5 1.37\nplane 0 -2 0 0 1 0\n"
    "move .11 0 -.3 .07 0 0 0\ns -1 0 0 1\ntt x.png 0 0 0 0 0 1 .3 0 1 0 0 1 .2 0 1\n"
    "move 0 0 -40\ntexture none\ns 0 3 -30 1\n";

/* Such a sequence: its scene at rest, what is kept of it, options of a build with two images. */
struct sequence {
    struct sph_scene rest;
    struct sph_texture_bases bases;
    struct sph_mip mips[2];
    struct sph_build_options o;
};

static void sequence_start(struct sequence *q, const char *text) {
    struct sph_error err = {""};
    read_at(text, 0, &q->rest);
    assert_int_equal(sph_bases_start(&q->bases, &q->rest, &err), 0);
    q->mips[0] = q->mips[1] = textured_mip(64, 32, NULL);
    q->o = textured_options;
    q->o.mips = q->mips;
    q->o.bases = &q->bases;
}

static void sequence_end(struct sequence *q) {
    sph_bases_end(&q->bases);
    sph_scene_free(&q->rest);
    free(q->mips[0].texels);
}

static void scene_at(const struct sequence *q, uint32_t frame, struct sph_scene *scene) {
    struct sph_error err = {""};
    if (sph_scene_at(&q->rest, frame, scene, &err)) fail_msg("%s", err.text);
}

static void kept(void **state) {
    (void)state;
    struct sequence q;
    struct sph_scene s;
    int other_steps = 0, all_kept = 0;
    double step = 0;
    sequence_start(&q, show);
    assert_int_equal(q.rest.n_textures, 2);
    for (uint32_t frame = 0; frame < 9; frame++) {
        struct sph_build_report alone, kept_report;
        scene_at(&q, frame, &s);
        struct sph_build_options o = q.o;
        o.bases = NULL;
        struct sph_machine one = textured_build(&s, &o, &alone);
        struct sph_machine m = textured_build(&s, &q.o, &kept_report);
        assert_int_equal(one.lines, m.lines);
        assert_memory_equal(one.mem, m.mem, (size_t)m.lines * SPH_LINE_WORDS * sizeof *m.mem);
        assert_memory_equal(one.regs, m.regs, sizeof m.regs);
        assert_int_equal(alone.bases_computed, 4);
        assert_int_equal(alone.bases_kept, 0);
        int same = frame && kept_report.grid_step == step;
        other_steps += frame && !same;
        all_kept += same;
        assert_int_equal(kept_report.bases_kept, same ? 2 : 0);
        assert_int_equal(kept_report.bases_computed, same ? 2 : 4);
        assert_true(same ? kept_report.bases_flops.mul < alone.bases_flops.mul
                         : kept_report.bases_flops.mul == alone.bases_flops.mul);
        step = kept_report.grid_step;
        sph_machine_free(&one);
        sph_machine_free(&m);
        sph_scene_at_free(&s);
    }
    assert_true(other_steps >= 2 && all_kept >= 4);
    sequence_end(&q);
}

/* Still primitives of a grid with the scene's axes keep P_b, wherever the eye flies. */
static const char passing[] =
    "v from 0 0 5 at 0 0 0 up 0 1 0 angle 40 resolution 16 12\n" MAT "texture x.png 2 1\n"
    "fly 8 3 1 4 0 0 -1\n"
    "s 2 0 -5 1.37\ntt x.png 0 0 0 0 0 1 .3 0 1 0 0 1 .2 0 1\n";

static void kept_from_afar(void **state) {
    (void)state;
    struct sequence q;
    struct sph_scene s;
    sequence_start(&q, passing);
    q.o.axes = SPH_AXES_SCENE;
    for (uint32_t frame = 0; frame < 9; frame++) {
        struct sph_build_report report;
        scene_at(&q, frame, &s);
        struct sph_machine m = textured_build(&s, &q.o, &report);
        assert_true(sph_machine_effect(&m, SPH_EFFECT_TURNED));
        assert_int_equal(report.bases_kept, frame ? 2 : 0);
        sph_machine_free(&m);
        sph_scene_at_free(&s);
    }
    sequence_end(&q);
}

int main(void) {
    const struct CMUnitTest others[] = {
        cmocka_unit_test(test_bad_at_3), cmocka_unit_test(places),
        cmocka_unit_test(flies),         cmocka_unit_test(generated),
        cmocka_unit_test(kept),          cmocka_unit_test(kept_from_afar)};
    return run_cases("motion", test_bad, bads, sizeof bads / sizeof bads[0], others,
                     sizeof others / sizeof others[0]);
}
