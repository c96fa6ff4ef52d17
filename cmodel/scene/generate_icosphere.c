/* generate_icosphere.c - an icosahedron cut finer and finer, a closed mesh; see generate.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "scene/generate_kinds.h"

#include <math.h>

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
