/* arrays.c - a scene out of arrays, built and drawn with progress, written as NFF and as layers
 * SPDX-License-Identifier: Apache-2.0
 *
 * cc arrays.c -o arrays $(pkg-config --cflags --libs sphaera)
 * ./arrays OUT.nff OUT.exr
 */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include <sphaera/sphaera.h>

static const double spheres[3][4] = {{-1, 0, 0, 1.2}, {1.4, 0.4, -1, 1}, {0.3, -0.9, 1.6, 0.3}};
static const uint32_t sphere_materials[3] = {0, 1, 0};
static const double triangles[2][3][3] = {{{-4, -1.2, -5}, {4, -1.2, -5}, {4, -1.2, 3}},
                                          {{-4, -1.2, -5}, {4, -1.2, 3}, {-4, -1.2, 3}}};
static const uint32_t triangle_materials[2] = {2, 2};
static const double materials[3][8] = {{0.9, 0.3, 0.2, 0.7, 0.3, 10, 0, 1},
                                       {0.3, 0.8, 0.4, 0.7, 0.3, 10, 0, 1},
                                       {0.8, 0.8, 0.7, 1, 0, 0, 0, 1}};
static const double lights[1][3] = {{4, 6, 8}};

/* Counts what it is told; at `most` calls it cancels. */
struct watch {
    int calls, most;
};
static int watch(void *user, int done, int all) {
    struct watch *w = user;
    return done <= all && ++w->calls >= w->most;
}

int main(int argc, char **argv) {
    sphaera_error error = {""};
    sphaera_scene *scene = NULL;
    sphaera_machine *machine = NULL;
    sphaera_frame *frame = NULL;
    sphaera_arrays arrays;
    sphaera_build_options build;
    sphaera_render_options render;
    struct watch patient = {0, 1000000}, hasty = {0, 1};
    if (argc != 3) {
        fprintf(stderr, "usage: arrays OUT.nff OUT.exr\n");
        return 2;
    }
    sphaera_arrays_init(&arrays);
    arrays.name = "table";
    arrays.from[2] = 9;
    arrays.angle = 40;
    arrays.width = 64, arrays.height = 48;
    arrays.n_spheres = 3, arrays.spheres = spheres[0];
    arrays.sphere_materials = sphere_materials;
    arrays.n_triangles = 2, arrays.triangles = triangles[0][0];
    arrays.triangle_materials = triangle_materials;
    arrays.n_materials = 3, arrays.materials = materials[0];
    arrays.n_lights = 1, arrays.lights = lights[0];
    sphaera_build_init(&build);
    build.profile = "standard";
    build.accel = "box4";
    build.samples = 2; /* a pixel of the picture is the mean of four */
    build.progress = watch, build.user = &patient;
    sphaera_render_init(&render);
    render.progress = watch;

    int bad = sphaera_scene_make(&arrays, &scene, &error);
    if (!bad) bad = sphaera_scene_write(scene, argv[1], &error);
    if (!bad) bad = sphaera_build(scene, &build, &machine, &error);
    render.user = &hasty;
    if (!bad && sphaera_render_with(machine, &render, &frame, &error))
        printf("drawing: %s\n", error.text);
    render.user = &patient;
    if (!bad) bad = sphaera_render_with(machine, &render, &frame, &error);
    if (!bad) bad = sphaera_frame_write(frame, argv[2], &error);
    if (bad) fprintf(stderr, "arrays: %s\n", error.text);
    if (!bad) {
        size_t pixels = (size_t)sphaera_frame_width(frame) * (size_t)sphaera_frame_height(frame);
        float *distance = malloc(pixels * sizeof *distance),
              *normal = malloc(3 * pixels * sizeof *normal);
        sphaera_layers layers = {0};
        layers.distance = distance;
        layers.normal = normal;
        size_t middle = pixels / 2 + (size_t)sphaera_frame_width(frame) / 2 - 12;
        if (distance && normal && !sphaera_frame_layers(frame, &layers, &error))
            printf("distance %.2f, normal z %.2f\n", distance[middle], normal[3 * middle + 2]);
        free(distance);
        free(normal);
        printf("frame   %016" PRIx64 ", told %s\n", sphaera_frame_hash(frame),
               patient.calls > 2 ? "often" : "seldom");
    }
    sphaera_frame_free(frame);
    sphaera_machine_free(machine);
    sphaera_scene_free(scene);
    return bad ? 1 : 0;
}
