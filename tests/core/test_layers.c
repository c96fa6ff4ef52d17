/* test_layers.c - what compositing programs get of a pixel, against the sphere of the scene
 * SPDX-License-Identifier: Apache-2.0
 *
 * Run from the root of the repository: reads scenes/.
 */
#include "model_scene.h"

#include <math.h>

#include "engine/layers.h"
#include "scene/vector.h"

/* What is seen of the only sphere of a scene lies on it, where the normal says, as far ahead as the
 * depth says, in the pixel; nothing else has a layer. How many pixels see it. */
static int check(const struct sph_scene *scene, const struct sph_machine *m,
                 const struct sph_frame *frame, const struct sph_layer *layers) {
    const struct sph_sphere *ball = scene->spheres;
    const struct sph_camera *c = &scene->camera;
    struct sph_vec ahead = sph_vec_sub(c->at, c->from), away = sph_vec_add(ball->ctr, c->from, -1);
    ahead = sph_vec_add((struct sph_vec){0, 0, 0}, ahead, 1 / sqrt(sph_vec_dot(ahead, ahead)));
    double error = 1e-3 * sqrt(sph_vec_dot(away, away));
    int seen = 0;
    assert_true(m->grid_log2 < log2(error));
    for (int i = 0; i < frame->width * frame->height; i++) {
        const struct sph_layer *l = &layers[i];
        struct sph_vec n = {l->normal[0], l->normal[1], l->normal[2]};
        if (!frame->pixels[i].key) {
            assert_true(isinf(l->depth) && l->depth > 0 && l->level == -1);
            assert_true(sph_vec_dot(n, n) == 0 && l->albedo[0] + l->albedo[1] + l->albedo[2] == 0);
            continue;
        }
        struct sph_vec at = sph_vec_add(ball->ctr, n, ball->rad), way = sph_vec_sub(at, c->from);
        double up = 0.5 - (i / frame->width + 0.5) / frame->height;
        double rise = 2 * tan(c->angle * M_PI / 360) * up; /* of the scene's own up, y */
        assert_true(fabs(sph_vec_dot(n, n) - 1) < 1e-5 && sph_vec_dot(n, way) < error);
        assert_true(fabs(l->depth - sph_vec_dot(way, ahead)) < error);
        assert_true(fabs(way.y / sph_vec_dot(way, ahead) - rise) < 1e-3);
        for (int k = 0; k < 3; k++) { /* a byte's share of 255 */
            double byte = round(255 * scene->materials[0].rgb[k]);
            assert_true(fabs(l->albedo[k] - byte / 255) < 1e-6);
        }
        assert_true(l->level == -1);
        seen++;
    }
    return seen;
}

static void layers_of_a_sphere(void **state) {
    (void)state;
    for (int whole = 0; whole < 2; whole++) { /* all pixels see it from near by */
        struct sph_scene scene = model_scene("one_sphere");
        struct sph_machine m;
        struct sph_counters counted;
        int errors, n = MODEL_W * MODEL_H;
        if (whole) scene.camera.from = (struct sph_vec){0.9, 0, 0.9};
        assert_true(
            model_build(&scene, SPH_FINE, SPH_TREE_BALANCED, SPH_BG_NONE, MODEL_W, MODEL_H, &m));
        struct sph_frame frame = model_render(&m, SPH_TRAVERSE_TREE, 1, &counted, &errors);
        struct sph_layer *layers = sph_layers_of(&m, &frame);
        assert_non_null(layers);
        int seen = check(&scene, &m, &frame, layers);
        assert_true(whole ? seen == n : seen > n / 10 && seen < n / 2);
        free(layers);
        struct sph_pixel pixel = frame.pixels[MODEL_H / 2 * MODEL_W + MODEL_W / 2];
        pixel.texture = 640u << SPH_LOD_LSB | 77; /* as if it had an image */
        assert_true(sph_layer_of(&m, &pixel, MODEL_W / 2, MODEL_H / 2).level == 2.5f);
        m.regs[SPH_REG_MEM_LINES] = m.regs[SPH_REG_PRIM_BASE]; /* its record is not in memory */
        assert_true(isinf(sph_layer_of(&m, &pixel, MODEL_W / 2, MODEL_H / 2).depth));
        sph_frame_free(&frame);
        sph_machine_free(&m);
        sph_scene_free(&scene);
    }
}

/* A normal has length 1, however short that of the machine is: of a sphere of few grid units. */
static void normals_of_a_small_sphere(void **state) {
    (void)state;
    struct sph_scene scene = model_scene("one_sphere");
    struct sph_machine m;
    struct sph_counters counted;
    int errors, seen = 0;
    scene.camera.from = (struct sph_vec){0, 0, 100};
    scene.camera.angle = 2;
    assert_true(model_build(&scene, SPH_DRAFT, SPH_TREE_BALANCED, SPH_BG_NONE, 16, 9, &m));
    struct sph_frame frame = model_render(&m, SPH_TRAVERSE_TREE, 1, &counted, &errors);
    struct sph_layer *layers = sph_layers_of(&m, &frame);
    for (int i = 0; i < 16 * 9; i++) {
        const float *n = layers[i].normal;
        double square = (double)n[0] * n[0] + (double)n[1] * n[1] + (double)n[2] * n[2];
        if (frame.pixels[i].key) seen++, assert_true(fabs(square - 1) < 1e-6);
    }
    assert_true(seen > 9);
    free(layers);
    sph_frame_free(&frame);
    sph_machine_free(&m);
    sph_scene_free(&scene);
}

/* The depth view has a colour of its own for each number of surfaces. */
static void depth_colours_differ(void **state) {
    (void)state;
    for (int i = 0; i < SPH_MAX_DEPTH + 2; i++)
        for (int k = 0; k < i; k++)
            assert_int_not_equal(sph_depth_colours[i], sph_depth_colours[k]);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(layers_of_a_sphere),
                                       cmocka_unit_test(normals_of_a_small_sphere),
                                       cmocka_unit_test(depth_colours_differ)};
    return cmocka_run_group_tests_name("layers", tests, NULL, NULL);
}
