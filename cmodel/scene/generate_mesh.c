/* generate_mesh.c - mount and tetra, in the manner of SPD's scenes of these names; see generate.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "scene/generate_kinds.h"

#include <math.h>

#include "scene/rng.h"

enum { MOST = 129 }; /* heights on a side of the largest mountain */

static int add_triangle(struct sph_scene *scene, struct sph_vec a, struct sph_vec b,
                        struct sph_vec c, uint32_t material, struct sph_error *err) {
    struct sph_facet f = {
        .kind = SPH_TRIANGLE, .v = {a, b, c}, .material = material, .group = scene->n_facets};
    return sph_scene_add_facet(scene, &f, err);
}

/* Middles of edges and squares, half as rough each time (Fournier, Fussell, Carpenter 1982). */
static void raise_mountain(double height[MOST][MOST], int cells, uint64_t seed) {
    struct sph_rng rng = {seed};
    double rough = 0.5;
    for (int step = cells; step > 1; step /= 2, rough *= 0.5)
        for (int y = 0; y <= cells; y += step / 2)
            for (int x = 0; x <= cells; x += step / 2) {
                int odd_x = x % step ? step / 2 : 0, odd_y = y % step ? step / 2 : 0;
                if (!odd_x && !odd_y) continue;
                double mean = (height[y - odd_y][x - odd_x] + height[y + odd_y][x + odd_x] +
                               height[y - odd_y][x + odd_x] + height[y + odd_y][x - odd_x]) /
                              4;
                height[y][x] = mean + sph_rng_range(&rng, -rough, rough);
            }
}

/* 2 * 4^(size + 2) triangles and four mirrors above them; the light is far away. */
int sph_make_mount(const struct sph_generate_options *options, struct sph_scene *scene,
                   struct sph_error *err) {
    static const double ball[4][4] = {{0.9, -0.2, 1.05, 0.2},
                                      {0.2, 0.9, 1.1, 0.2},
                                      {-0.3, -0.4, 1.25, 0.25},
                                      {0.7, 0.5, 0.9, 0.15}};
    const struct sph_material look[2] = {{{0.6, 0.5, 0.35}, 1, 0, 1, 0, 1, 0, {0}, 0},
                                         {{0.8, 0.85, 0.9}, 0.4, 0.6, 30, 0, 1, 0, {0}, 0}};
    static double height[MOST][MOST]; /* all is written before it is read */
    if (options->size < 1 || options->size > 5)
        return sph_fail(err, "mount: size %d is not within 1 to 5", options->size);
    int cells = 1 << (options->size + 2);
    snprintf(scene->name, sizeof scene->name, "mount%d", options->size);
    sph_make_camera(scene, sph_vec_of(2.6, 1.9, 2), sph_vec_of(0, 0, 0.35), sph_vec_of(0, 0, 1),
                    42);
    for (int i = 0; i < 3; i++) {
        scene->ambient[i] = 0.1;
        scene->background[i] = 0.078 + 0.3 * i;
    }
    if (sph_scene_add_light(scene, sph_vec_of(100, -100, 100), 1, 1, 1, err) ||
        sph_scene_add_material(scene, &look[0], err) ||
        sph_scene_add_material(scene, &look[1], err))
        return -1;
    raise_mountain(height, cells, options->seed);
    for (int i = 0; i < cells * cells; i++) {
        struct sph_vec corner[4];
        for (int k = 0; k < 4; k++) {
            int x = i % cells + (k & 1), y = i / cells + (k >> 1);
            corner[k] = sph_vec_of(3.0 * x / cells - 1.5, 3.0 * y / cells - 1.5, height[y][x]);
        }
        if (add_triangle(scene, corner[0], corner[1], corner[2], 0, err) ||
            add_triangle(scene, corner[3], corner[2], corner[1], 0, err))
            return -1;
    }
    for (int i = 0; i < 4; i++)
        if (sph_scene_add_sphere(scene, sph_vec_of(ball[i][0], ball[i][1], ball[i][2]), ball[i][3],
                                 1, 0, err))
            return -1;
    return 0;
}

/* A tetrahedron of edge 2 sqrt(2) `half` in every other corner of a cube, or the four that touch
 * its corners. */
static int add_tetrahedra(struct sph_scene *scene, struct sph_vec ctr, double half, int cuts,
                          struct sph_error *err) {
    static const int sign[4][3] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    struct sph_vec corner[4];
    for (int i = 0; i < 4; i++) {
        double by = cuts ? half / 2 : half;
        corner[i] =
            sph_vec_of(ctr.x + by * sign[i][0], ctr.y + by * sign[i][1], ctr.z + by * sign[i][2]);
        if (cuts && add_tetrahedra(scene, corner[i], half / 2, cuts - 1, err)) return -1;
    }
    if (cuts) return 0;
    return add_triangle(scene, corner[0], corner[1], corner[2], 0, err) ||
           add_triangle(scene, corner[0], corner[3], corner[1], 0, err) ||
           add_triangle(scene, corner[0], corner[2], corner[3], 0, err) ||
           add_triangle(scene, corner[1], corner[3], corner[2], 0, err);
}

/* 4^size tetrahedra, Sierpinski's. */
int sph_make_tetra(const struct sph_generate_options *options, struct sph_scene *scene,
                   struct sph_error *err) {
    const struct sph_material look = {{1, 0.2, 0.2}, 1, 0, 1, 0, 1, 0, {0}, 0};
    if (options->size < 1 || options->size > 5)
        return sph_fail(err, "tetra: size %d is not within 1 to 5", options->size);
    snprintf(scene->name, sizeof scene->name, "tetra%d", options->size);
    sph_make_camera(scene, sph_vec_of(1.25, -2.5, 1.5), sph_vec_of(0, 0, -0.05),
                    sph_vec_of(0, 0, 1), 45);
    scene->background[0] = 0.078, scene->background[1] = 0.361, scene->background[2] = 0.753;
    return sph_scene_add_light(scene, sph_vec_of(1.9, -2.9, 1.1), 1, 1, 1, err) ||
                   sph_scene_add_material(scene, &look, err) ||
                   add_tetrahedra(scene, sph_vec_of(0, 0, 0), 0.8, options->size, err)
               ? -1
               : 0;
}
