/* generate_rooms.c - shells, cover, cornell, horizon: scenes that many renderers show; see
 * generate.h SPDX-License-Identifier: Apache-2.0
 *
 * `shells` is in the manner of SPD's scene of this name; the others are made by what is told of the
 * cover of a well-known book and of the box at Cornell.
 */
#include "scene/generate_kinds.h"

#include <math.h>

#include "scene/rng.h"

static int add_quad(struct sph_scene *scene, const struct sph_vec c[4], uint32_t material,
                    uint32_t group, struct sph_error *err) {
    struct sph_facet f = {.kind = SPH_TRIANGLE, .material = material, .group = group};
    for (int i = 1; i < 3; i++) {
        f.v[0] = c[0], f.v[1] = c[i], f.v[2] = c[i + 1];
        if (sph_scene_add_facet(scene, &f, err)) return -1;
    }
    return 0;
}

static void grey(double rgb[3], double value) {
    rgb[0] = rgb[1] = rgb[2] = value;
}

/* 48 * size spheres that overlap, along spirals that widen: seashells. */
int sph_make_shells(const struct sph_generate_options *options, struct sph_scene *scene,
                    struct sph_error *err) {
    if (options->size < 1 || options->size > 5)
        return sph_fail(err, "shells: size %d is not within 1 to 5", options->size);
    snprintf(scene->name, sizeof scene->name, "shells%d", options->size);
    sph_make_camera(scene, sph_vec_of(0, -6, 4), sph_vec_of(0, 0, 0.3), sph_vec_of(0, 0, 1), 40);
    grey(scene->ambient, 0.1);
    grey(scene->background, 0.3);
    if (sph_scene_add_light(scene, sph_vec_of(-6, -8, 12), 1, 1, 1, err) ||
        sph_make_palette(scene, 0.25, 40, err))
        return -1;
    for (int shell = 0; shell < options->size; shell++) {
        double turn = 2 * M_PI * shell / options->size;
        double x = options->size > 1 ? 1.9 * cos(turn) : 0, y = options->size > 1 ? sin(turn) : 0;
        for (int i = 0; i < 48; i++) {
            double wide = pow(0.94, i), angle = turn + 0.35 * i;
            struct sph_vec at = {x + 0.8 * wide * cos(angle), y + 0.8 * wide * sin(angle),
                                 1.2 * (1 - wide)};
            if (sph_scene_add_sphere(scene, at, 0.32 * wide, (uint32_t)(shell + i / 6) % 10, 0,
                                     err))
                return -1;
        }
    }
    return 0;
}

/* A sphere of radius 1000, on it one in each cell of 22 x 22 and three big ones. */
int sph_make_cover(const struct sph_generate_options *options, struct sph_scene *scene,
                   struct sph_error *err) {
    const double ground = 1000, small = 0.2;
    const struct sph_material mirror = {{0.7, 0.6, 0.5}, 0.2, 0.8, 50, 0, 1, 0, {0}, 0};
    const struct sph_material earth = {{0.5, 0.5, 0.5}, 1, 0, 1, 0, 1, 0, {0}, 0};
    const struct sph_material glass = {{1, 1, 1}, 0, 0, 50, 0.9, 1.5, 0, {.on = 1, .kr = 0.1}, 0};
    struct sph_rng rng = {options->seed};
    sph_make_camera(scene, sph_vec_of(13, 2, 3), sph_vec_of(0, 0, 0), sph_vec_of(0, 1, 0), 20);
    for (int i = 0; i < 3; i++)
        scene->ambient[i] = 0.3, scene->background[i] = 0.6 + 0.1 * i;
    if (sph_scene_add_light(scene, sph_vec_of(8, 20, 12), 0.8, 0.8, 0.8, err) ||
        sph_make_palette(scene, 0, 1, err) || sph_scene_add_material(scene, &mirror, err) ||
        sph_scene_add_material(scene, &glass, err) || sph_scene_add_material(scene, &earth, err) ||
        sph_scene_add_sphere(scene, sph_vec_of(0, -ground, 0), ground, SPH_PALETTE_SIZE + 2, 0,
                             err))
        return -1;
    for (uint32_t i = 0; i < 3; i++)
        if (sph_scene_add_sphere(scene, sph_vec_of(4.0 * i - 4, 1, 0), 1,
                                 i == 0 ? 10 : SPH_PALETTE_SIZE + i % 2, 0, err))
            return -1;
    for (int i = 0; i < 22 * 22; i++) {
        const int column = i % 22 - 11, row = i / 22 - 11;
        double x = column + sph_rng_range(&rng, 0.2, 0.8);
        double z = row + sph_rng_range(&rng, 0.2, 0.8);
        double y = sqrt((ground + small) * (ground + small) - x * x - z * z) - ground;
        double what = sph_rng_range(&rng, 0, 1);
        uint32_t plain = (uint32_t)(sph_rng_next(&rng) % SPH_PALETTE_SIZE);
        if (fabs(z) < 1.25 && fabs(fabs(x) - (fabs(x) < 2 ? 0 : 4)) < 1.25) continue;
        if (sph_scene_add_sphere(scene, sph_vec_of(x, y, z), small,
                                 what < 0.8    ? plain
                                 : what < 0.95 ? SPH_PALETTE_SIZE
                                               : SPH_PALETTE_SIZE + 1,
                                 0, err))
            return -1;
    }
    return 0;
}

/* A block on the floor: four sides and the top. */
static int add_block(struct sph_scene *scene, double x, double z, double half, double high,
                     double turn, uint32_t *group, struct sph_error *err) {
    struct sph_vec low[4], top[4];
    for (int i = 0; i < 4; i++) {
        double angle = turn + M_PI / 2 * i + M_PI / 4, reach = half * sqrt(2);
        low[i] = sph_vec_of(x + reach * cos(angle), -1, z + reach * sin(angle));
        top[i] = sph_vec_of(low[i].x, high - 1, low[i].z);
    }
    for (int i = 0; i < 4; i++) {
        int k = (i + 1) % 4;
        const struct sph_vec side[4] = {low[i], top[i], top[k], low[k]};
        if (add_quad(scene, side, 0, (*group)++, err)) return -1;
    }
    return add_quad(scene, top, 0, (*group)++, err);
}

/* A room of two units with a red and a green wall, two blocks, a light below the ceiling. */
int sph_make_cornell(const struct sph_generate_options *options, struct sph_scene *scene,
                     struct sph_error *err) {
    static const double rgb[3][3] = {{0.75, 0.73, 0.7}, {0.63, 0.06, 0.05}, {0.14, 0.45, 0.09}};
    static const struct sph_vec wall[5][4] = {{{-1, -1, 1}, {1, -1, 1}, {1, -1, -1}, {-1, -1, -1}},
                                              {{-1, 1, 1}, {-1, 1, -1}, {1, 1, -1}, {1, 1, 1}},
                                              {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}},
                                              {{-1, -1, 1}, {-1, -1, -1}, {-1, 1, -1}, {-1, 1, 1}},
                                              {{1, -1, 1}, {1, 1, 1}, {1, 1, -1}, {1, -1, -1}}};
    (void)options;
    uint32_t group = 0;
    sph_make_camera(scene, sph_vec_of(0.03, 0.05, 3.9), sph_vec_of(0, 0.01, 0), sph_vec_of(0, 1, 0),
                    39);
    grey(scene->ambient, 0.15);
    if (sph_scene_add_light(scene, sph_vec_of(0, 0.9, 0), 1, 0.95, 0.85, err)) return -1;
    for (int i = 0; i < 3; i++) {
        struct sph_material m = {{rgb[i][0], rgb[i][1], rgb[i][2]}, 1, 0, 1, 0, 1, 0, {0}, 0};
        if (sph_scene_add_material(scene, &m, err)) return -1;
    }
    for (uint32_t i = 0; i < 5; i++)
        if (add_quad(scene, wall[i], i < 3 ? 0 : i - 2, group++, err)) return -1;
    return add_block(scene, -0.35, -0.3, 0.3, 1.2, 0.3, &group, err) ||
                   add_block(scene, 0.35, 0.35, 0.3, 0.6, -0.3, &group, err)
               ? -1
               : 0;
}

/* A ball above a plane that has no end. */
int sph_make_horizon(const struct sph_generate_options *options, struct sph_scene *scene,
                     struct sph_error *err) {
    (void)options;
    struct sph_facet plane = {.kind = SPH_PLANE, .material = 9, .v = {{0, -1, 0}, {0, 1, 0}}};
    plane.v[2] = sph_vec_of(1, 0, 0);
    sph_make_camera(scene, sph_vec_of(0, 0.5, 6), sph_vec_of(0, 0, 0), sph_vec_of(0, 1, 0), 40);
    for (int i = 0; i < 3; i++)
        scene->ambient[i] = 0.1, scene->background[i] = 0.3 * (i + 1);
    return sph_scene_add_light(scene, sph_vec_of(-4, 6, 5), 1, 1, 1, err) ||
                   sph_make_palette(scene, 0.25, 40, err) ||
                   sph_scene_add_sphere(scene, sph_vec_of(0, 0, 0), 1, 0, 0, err) ||
                   sph_scene_add_facet(scene, &plane, err)
               ? -1
               : 0;
}
