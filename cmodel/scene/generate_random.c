/* generate_random.c - scenes of random spheres; see generate.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * Spheres of one material follow each other: a written file then names each material once.
 * Centres and radii of the paper scenes are rounded to 1/64, so that their files are short and
 * exact.
 */
#include "scene/generate_kinds.h"
#include "scene/rng.h"

#include <math.h>

#define EYE_Z 60.0 /* paper scenes: the eye is at (0, 0, EYE_Z) */
#define ANGLE 40.0 /* degrees, vertical */
#define SEED_5 6   /* chosen for its picture */
#define SEED_100 7

static double round64(double v) {
    return round(v * 64) / 64;
}

/* The paper's set-up: eye on the z axis, spheres at z < 0, one light, dim background. */
static int start_paper(struct sph_scene *scene, struct sph_error *err) {
    sph_make_camera(scene, sph_vec_of(0, 0, EYE_Z), sph_vec_of(0, 0, 0), sph_vec_of(0, 1, 0),
                    ANGLE);
    for (int i = 0; i < 3; i++) {
        scene->ambient[i] = 0.125;
        scene->background[i] = 0.03125 * (i + 2);
    }
    if (sph_scene_add_light(scene, sph_vec_of(-40, 60, 80), 1, 1, 1, err)) return -1;
    return sph_make_palette(scene, 0.3, 40, err);
}

/* Adds n spheres with radii low..high at depths near..far in front of the eye, within the
 * picture. gap: least distance between surfaces as a part of the smaller radius; -1 lets
 * spheres cut each other. */
static int add_paper(struct sph_scene *scene, uint64_t seed, uint32_t n, double low, double high,
                     double near, double far, double gap, struct sph_error *err) {
    struct sph_rng rng = {seed};
    const double up = tan(ANGLE / 360 * M_PI);
    const double aspect = (double)scene->camera.width / scene->camera.height;
    for (uint32_t tries = 0; scene->n_spheres < n && tries < 1000 * n; tries++) {
        double depth = sph_rng_range(&rng, near, far);
        double rad = round64(sph_rng_range(&rng, low, high));
        double y = sph_rng_range(&rng, -1, 1) * (up * depth - 0.7 * rad);
        double x = sph_rng_range(&rng, -1, 1) * (up * aspect * depth - 0.7 * rad);
        struct sph_vec ctr = {round64(x), round64(y), round64(EYE_Z - depth)};
        int clear = 1;
        for (uint32_t i = 0; i < scene->n_spheres && clear; i++) {
            const struct sph_sphere *s = &scene->spheres[i];
            double dist = hypot(hypot(ctr.x - s->ctr.x, ctr.y - s->ctr.y), ctr.z - s->ctr.z);
            clear = dist > s->rad + rad + gap * fmin(s->rad, rad);
        }
        uint32_t material = scene->n_spheres * SPH_PALETTE_SIZE / n;
        if (clear && sph_scene_add_sphere(scene, ctr, rad, material, 0, err)) return -1;
    }
    return scene->n_spheres == n ? 0 : sph_fail(err, "%s: no room for the spheres", scene->name);
}

int sph_make_paper5(const struct sph_generate_options *options, struct sph_scene *scene,
                    struct sph_error *err) {
    if (start_paper(scene, err)) return -1;
    return add_paper(scene, options->seed ? options->seed : SEED_5, 5, 16, 25, 85, 125, 0.02, err);
}

int sph_make_paper100(const struct sph_generate_options *options, struct sph_scene *scene,
                      struct sph_error *err) {
    if (start_paper(scene, err)) return -1;
    return add_paper(scene, options->seed ? options->seed : SEED_100, 100, 3.5, 10, 75, 140, -1,
                     err);
}

int sph_make_random(const struct sph_generate_options *options, struct sph_scene *scene,
                    struct sph_error *err) {
    struct sph_rng rng = {options->seed};
    const double half = 50; /* of the cube's edge */
    char kind[16];          /* random, or swarm */
    snprintf(kind, sizeof kind, "%.15s", scene->name);
    if (options->n > SPH_MAX_SPHERES)
        return sph_fail(err, "%s: n %u is more than %u", kind, options->n, SPH_MAX_SPHERES);
    snprintf(scene->name, sizeof scene->name, "%s%u_seed%llu", kind, options->n,
             (unsigned long long)options->seed);
    sph_make_camera(scene, sph_vec_of(110, 80, 140), sph_vec_of(0, -4, 0), sph_vec_of(0, 1, 0), 40);
    for (int i = 0; i < 3; i++) {
        scene->ambient[i] = 0.1;
        scene->background[i] = 0.03125 * (i + 2);
    }
    if (sph_scene_add_light(scene, sph_vec_of(60, 200, 200), 0.9, 0.9, 0.85, err) ||
        sph_scene_add_light(scene, sph_vec_of(250, 40, 20), 0.25, 0.3, 0.35, err) ||
        sph_make_palette(scene, 0.2, 30, err))
        return -1;
    const double mean = half * cbrt(0.6 / options->n); /* spheres fill about 3/8 of the cube */
    for (uint32_t i = 0; i < options->n; i++) {
        double x = sph_rng_range(&rng, -half, half);
        double y = sph_rng_range(&rng, -half, half);
        double z = sph_rng_range(&rng, -half, half);
        double rad = mean * sph_rng_range(&rng, 0.5, 1.5);
        uint32_t material = (uint32_t)((uint64_t)i * SPH_PALETTE_SIZE / options->n);
        if (sph_scene_add_sphere(scene, sph_vec_of(x, y, z), rad, material, 0, err)) return -1;
    }
    return 0;
}
