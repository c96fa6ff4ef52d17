/* generate_fixed.c - scenes without chance: interpenetrating, huge_tiny; see generate.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "scene/generate_kinds.h"

#include <math.h>

static int add_ring(struct sph_scene *scene, struct sph_vec ctr, double across, double rad, int n,
                    double start, uint32_t material, struct sph_error *err) {
    for (int i = 0; i < n; i++) {
        double angle = start + 2 * M_PI * i / n;
        struct sph_vec at = {ctr.x + across * cos(angle), ctr.y, ctr.z + across * sin(angle)};
        if (sph_scene_add_sphere(scene, at, rad, (material + (uint32_t)i) % SPH_PALETTE_SIZE, 0,
                                 err))
            return -1;
    }
    return 0;
}

/* A big sphere with a belt of spheres half sunk into it, a chain of spheres that cut their
 * neighbours, a small sphere that just breaks through a larger one, and one wholly inside. */
int sph_make_interpenetrating(const struct sph_generate_options *options, struct sph_scene *scene,
                              struct sph_error *err) {
    (void)options;
    sph_make_camera(scene, sph_vec_of(0, 5, 24), sph_vec_of(0, -0.25, 0), sph_vec_of(0, 1, 0), 30);
    for (int i = 0; i < 3; i++) {
        scene->ambient[i] = 0.1;
        scene->background[i] = 0.0625 * (i + 1);
    }
    if (sph_scene_add_light(scene, sph_vec_of(-12, 18, 20), 1, 1, 1, err) ||
        sph_make_palette(scene, 0.25, 40, err) ||
        sph_scene_add_sphere(scene, sph_vec_of(0, 0, 0), 3, 9, 0, err) ||
        sph_scene_add_sphere(scene, sph_vec_of(0, 0, 0), 2, 3, 0, err) ||
        add_ring(scene, sph_vec_of(0, 0, 0), 3, 1, 9, 0.25, 0, err) ||
        sph_scene_add_sphere(scene, sph_vec_of(0, 3, 0), 1.5, 4, 0, err) ||
        sph_scene_add_sphere(scene, sph_vec_of(0.25, 3.5, 1.25), 0.5, 1, 0, err))
        return -1;
    for (int i = 0; i < 7; i++) {
        struct sph_vec left = {-7, -4.5 + 1.5 * i, 0.5 * (i % 2)};
        struct sph_vec right = {7, -4.5 + 1.5 * i, -0.5 * (i % 2)};
        uint32_t material = (uint32_t)i;
        if (sph_scene_add_sphere(scene, left, 1.25, material, 0, err) ||
            sph_scene_add_sphere(scene, right, 0.75 + 0.125 * i, material + 4, 0, err))
            return -1;
    }
    return 0;
}

/* The huge sphere is the ground: its top is the origin. The others stand on it; they get
 * smaller ring by ring towards the front, from radius 3 to 0.02. */
int sph_make_huge_tiny(const struct sph_generate_options *options, struct sph_scene *scene,
                       struct sph_error *err) {
    (void)options;
    const double huge = 1000;
    const struct sph_vec ground = {0, -huge, 0};
    sph_make_camera(scene, sph_vec_of(0, 3.5, 13), sph_vec_of(0, 1.25, 0), sph_vec_of(0, 1, 0), 40);
    for (int i = 0; i < 3; i++) {
        scene->ambient[i] = 0.1;
        scene->background[i] = 0.25 * (i + 1);
    }
    if (sph_scene_add_light(scene, sph_vec_of(-15, 20, 15), 1, 1, 1, err) ||
        sph_make_palette(scene, 0.25, 40, err) ||
        sph_scene_add_sphere(scene, ground, huge, 11, 0, err) ||
        sph_scene_add_sphere(scene, sph_vec_of(0, 3, -2), 3, 9, 0, err))
        return -1;
    for (int ring = 0; ring < 6; ring++) {
        double rad = 1.2 * pow(0.44, ring), across = 4.5 + 1.0 * ring;
        int n = 9 + 3 * ring;
        for (int i = 0; i < n; i++) {
            double angle = 2 * M_PI * (i + 0.5 * (ring % 2)) / n;
            double x = across * cos(angle), z = -2 + across * sin(angle);
            double y = sqrt((huge + rad) * (huge + rad) - x * x - z * z) - huge;
            uint32_t material = (uint32_t)(i + 2 * ring) % (SPH_PALETTE_SIZE - 1);
            if (sph_scene_add_sphere(scene, sph_vec_of(x, y, z), rad, material, 0, err)) return -1;
        }
    }
    return 0;
}
