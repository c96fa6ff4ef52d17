/* generate_parts.c - what makers of scenes share: camera, palette; see generate_kinds.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "scene/generate_kinds.h"

void sph_make_camera(struct sph_scene *scene, struct sph_vec from, struct sph_vec at,
                     struct sph_vec up, double angle) {
    scene->camera.from = from;
    scene->camera.at = at;
    scene->camera.up = up;
    scene->camera.angle = angle;
    scene->camera.hither = 0.01;
}

int sph_make_palette(struct sph_scene *scene, double ks, double shine, struct sph_error *err) {
    static const double rgb[SPH_PALETTE_SIZE][3] = {
        {0.90, 0.22, 0.20}, {0.20, 0.45, 0.90}, {0.98, 0.78, 0.20}, {0.25, 0.70, 0.35},
        {0.95, 0.52, 0.15}, {0.55, 0.30, 0.75}, {0.20, 0.75, 0.80}, {0.95, 0.55, 0.70},
        {0.65, 0.80, 0.25}, {0.92, 0.90, 0.85}, {0.60, 0.40, 0.25}, {0.35, 0.40, 0.55},
    };
    for (int i = 0; i < SPH_PALETTE_SIZE; i++) {
        struct sph_material m = {
            {rgb[i][0], rgb[i][1], rgb[i][2]}, 1 - ks, ks, shine, 0, 1, 0, {0}, 0};
        if (sph_scene_add_material(scene, &m, err)) return -1;
    }
    return 0;
}
