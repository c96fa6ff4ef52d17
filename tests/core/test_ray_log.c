/* test_ray_log.c - the rays of each pixel, as a tree, are those that the frame was made of
 * SPDX-License-Identifier: Apache-2.0
 */
#include "engine/render_pixel.h"
#include "model_scene.h"

static const char *const scenes[] = {"scenes/interpenetrating.nff", "scenes/materials.nff",
                                     "scenes/refraction/nested.nff", "scenes/refraction/four.nff"};

/* What lies between a ray and the one at whose hit it starts. */
static void check_parent(const struct sph_ray_log *log, int i) {
    const struct sph_logged *l = &log->rays[i];
    assert_int_equal(l->parent < 0, l->ray.kind == SPH_PRIMARY);
    if (l->parent < 0) return;
    const struct sph_logged *from = &log->rays[l->parent];
    assert_in_range(l->parent, 0, i - 1);
    assert_true(from->hit.key);
    assert_int_not_equal(from->ray.kind, SPH_SHADOW);
    assert_int_equal(from->depth, l->depth - (l->ray.kind != SPH_SHADOW));
    assert_int_equal(l->ray.skip.id, from->hit.id);
    assert_int_equal(l->ray.skip.inside, from->hit.far ^ (l->ray.kind == SPH_REFRACTED));
    for (int k = l->parent + 1; k < i; k++) /* its siblings start at the same point */
        if (log->rays[k].parent == l->parent && log->rays[k].ray.kind != SPH_REFRACTED &&
            l->ray.kind != SPH_REFRACTED)
            assert_memory_equal(l->ray.org, log->rays[k].ray.org, sizeof l->ray.org);
}

static void check_scene(const char *path, int first) {
    struct sph_scene scene = read_scene(path);
    struct sph_build_options o = {.profile = SPH_STANDARD,
                                  .width = MODEL_W,
                                  .height = MODEL_H,
                                  .max_depth = 4,
                                  .shadow = SPH_ON,
                                  .reflect = SPH_AUTO,
                                  .refract = SPH_AUTO,
                                  .lights = SPH_AUTO,
                                  .inside = SPH_AUTO,
                                  .traverse = first ? SPH_BUILD_FIRST : SPH_BUILD_NEAREST,
                                  .interpenetrate = SPH_AUTO};
    struct sph_build_report report;
    struct sph_error err = {{0}};
    struct sph_machine m;
    if (sph_build(&scene, &o, &m, &report, &err)) fail_msg("%s", err.text);
    static const int counted[] = {SPH_COUNT_RAYS_PRIMARY, SPH_COUNT_RAYS_SHADOW,
                                  SPH_COUNT_RAYS_REFLECTED, SPH_COUNT_RAYS_REFRACTED};
    struct sph_counters c;
    int errors;
    struct sph_frame frame = model_render(&m, SPH_TRAVERSE_TREE, 1, &c, &errors);
    uint64_t rays[4] = {0};
    for (int i = 0; i < MODEL_W * MODEL_H; i++) {
        struct sph_ray_log log = {0};
        struct sph_render_options how = {.threads = 1, .log = &log};
        struct sph_counters ignored = {{0}};
        uint32_t found = 0, visits = 0, said = 0;
        struct sph_pixel p =
            sph_render_pixel(&m, &how, i % MODEL_W, i / MODEL_W, &ignored, &said, NULL);
        assert_memory_equal(p.colour, frame.pixels[i].colour, sizeof p.colour);
        for (int k = 0; k < log.n; k++) {
            rays[log.rays[k].ray.kind]++;
            visits += log.rays[k].visits;
            check_parent(&log, k);
            if (log.rays[k].parent < 0 && log.rays[k].hit.key) found = log.rays[k].hit.id;
        }
        assert_int_equal(visits, p.visits);
        if (p.key) assert_int_equal(found, p.id);
        sph_ray_log_free(&log);
    }
    for (int kind = 0; kind < 4; kind++)
        assert_int_equal(rays[kind], c.count[counted[kind]]);
    printf("# %s: %lu shadow, %lu reflected, %lu refracted rays\n", path, rays[1], rays[2],
           rays[3]);
    sph_frame_free(&frame);
    sph_machine_free(&m);
    sph_scene_free(&scene);
}

static void test_tree_of_rays(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++)
        check_scene(scenes[i], !i);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_tree_of_rays)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
