/* generate_mesh.c - meshes: mount and tetra as in SPD, an icosphere; see generate.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>

#include "scene/generate_kinds.h"
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

/* The point of the unit sphere in the middle of two: the same for both orders to the last bit, so
 * that triangles on both sides of an edge share it. */
static struct sph_vec middle(struct sph_vec a, struct sph_vec b) {
    struct sph_vec m = {a.x + b.x, a.y + b.y, a.z + b.z};
    double size = sqrt(m.x * m.x + m.y * m.y + m.z * m.z);
    return sph_vec_of(m.x / size, m.y / size, m.z / size);
}

/* Adds a triangle, or the four it is cut into, `cuts` times; corners on the unit sphere. */
static int add(struct sph_scene *scene, struct sph_vec a, struct sph_vec b, struct sph_vec c,
               int cuts, uint32_t material, struct sph_error *err) {
    if (!cuts) {
        struct sph_facet f = {
            .kind = SPH_TRIANGLE, .v = {a, b, c}, .material = material, .group = scene->n_facets};
        return sph_scene_add_facet(scene, &f, err);
    }
    struct sph_vec ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    return add(scene, a, ab, ca, cuts - 1, material, err) ||
           add(scene, b, bc, ab, cuts - 1, material, err) ||
           add(scene, c, ca, bc, cuts - 1, material, err) ||
           add(scene, ab, bc, ca, cuts - 1, material, err);
}

/* 20 * 4^size triangles over a plane, faces of the icosahedron in the colours of the palette. */
int sph_make_icosphere(const struct sph_generate_options *options, struct sph_scene *scene,
                       struct sph_error *err) {
    static const int face[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    struct sph_vec corner[12];
    double g = (1 + sqrt(5)) / 2, size = sqrt(1 + g * g), one = 1 / size, phi = g / size;
    for (int i = 0; i < 4; i++) {
        double s = i & 1 ? one : -one, t = i & 2 ? -phi : phi;
        corner[i] = sph_vec_of(s, t, 0);
        corner[4 + i] = sph_vec_of(0, s, t);
        corner[8 + i] = sph_vec_of(t, 0, s);
    }
    if (options->size < 1 || options->size > 5)
        return sph_fail(err, "icosphere: size %d is not within 1 to 5", options->size);
    snprintf(scene->name, sizeof scene->name, "icosphere%d", options->size);
    sph_make_camera(scene, sph_vec_of(1.5, 2, 5), sph_vec_of(0, -0.1, 0), sph_vec_of(0, 1, 0), 32);
    for (int i = 0; i < 3; i++) {
        scene->ambient[i] = 0.125;
        scene->background[i] = 0.25 * (i + 1);
    }
    if (sph_scene_add_light(scene, sph_vec_of(-12, 20, 16), 1, 1, 1, err) ||
        sph_make_palette(scene, 0.25, 40, err))
        return -1;
    for (uint32_t i = 0; i < 20; i++)
        if (add(scene, corner[face[i][0]], corner[face[i][1]], corner[face[i][2]], options->size,
                i % SPH_PALETTE_SIZE, err))
            return -1;
    struct sph_facet plane = {.kind = SPH_PLANE, .material = 9, .group = scene->n_facets};
    plane.v[0] = sph_vec_of(0, -1.25, 0);
    plane.v[1] = sph_vec_of(0, 1, 0);
    plane.v[2] = sph_vec_of(1, 0, 0);
    return sph_scene_add_facet(scene, &plane, err);
}
