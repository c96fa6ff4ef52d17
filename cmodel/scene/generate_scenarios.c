/* generate_scenarios.c - scenes of Aroxa 2014, IV.B; see generate.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * Spheres in the cube [-20, 20]^3 over a plane, eye at (0, 0, 100), a light at (0, 40, 0), the two
 * materials of his Table 4.1, every other sphere transparent. What the thesis leaves open is chosen
 * here: the lattice of Scenario 1, the side of the corner cubes, the field of view.
 */
#include "scene/generate_kinds.h"
#include "scene/rng.h"

#include <math.h>

#define HALF 20.0 /* of the cube's edge */
#define EYE_Z 100.0
#define CORNER 8.0 /* edge of a corner cube: docs/results/trees.md tells why */
#define VIEW 0.26  /* tangent of half the narrower field of view: the cube's front face, nearly */

/* Table 4.1; with `plain` the highlight is left out and the rest is what NFF has. */
static int add_materials(struct sph_scene *scene, int plain, struct sph_error *err) {
    struct sph_material red = {
        .rgb = {0.9, 0.3, 0.3}, .kd = 0.3, .ks = 0.1, .shine = 40, .sum = {1, 0.3, 0.3}};
    struct sph_material clear = {.rgb = {1, 1, 1},
                                 .kd = 0.1,
                                 .ks = 0.1,
                                 .shine = 50,
                                 .trans = 0.7,
                                 .ior = 0.95,
                                 .sum = {1, 0.1, 0}};
    if (plain) {
        red.ks = red.sum.kr, clear.ks = clear.sum.kr;
        red.sum = clear.sum = (struct sph_sum){0};
    }
    return sph_scene_add_material(scene, &red, err) || sph_scene_add_material(scene, &clear, err);
}

static int start(const struct sph_generate_options *o, int number, struct sph_scene *scene,
                 struct sph_error *err) {
    struct sph_facet plane = {.kind = SPH_PLANE, .v = {{0, -HALF, 0}, {0, 1, 0}, {1, 0, 0}}};
    double tall = (double)scene->camera.height / scene->camera.width;
    snprintf(scene->name, sizeof scene->name, "scenario%d_%u_seed%llu", number, o->n,
             (unsigned long long)o->seed);
    sph_make_camera(scene, sph_vec_of(0, 0, EYE_Z), sph_vec_of(0, 0, 0), sph_vec_of(0, 1, 0),
                    2 * atan(VIEW * fmax(1, tall)) * 180 / M_PI);
    for (int i = 0; i < 3; i++)
        scene->ambient[i] = o->plain ? 0.3 : 1;
    if (!(o->radius > 0) || o->radius > HALF)
        return sph_fail(err, "scenario%d: radius %g is not above 0 and up to %g", number, o->radius,
                        HALF);
    return sph_scene_add_light(scene, sph_vec_of(0, 2 * HALF, 0), 1, 1, 1, err) ||
                   add_materials(scene, o->plain, err) || sph_scene_add_facet(scene, &plane, err)
               ? -1
               : 0;
}

/* Adds n spheres in a lattice of equal spaces, x first: its sides are doubled x, y, z in turn until
 * it holds them. */
static int add_lattice(const struct sph_generate_options *o, uint32_t n, struct sph_scene *scene,
                       struct sph_error *err) {
    uint32_t side[3] = {1, 1, 1};
    for (int axis = 0; (uint64_t)side[0] * side[1] * side[2] < n; axis = (axis + 1) % 3)
        side[axis] *= 2;
    for (uint32_t i = 0; i < n; i++) {
        uint32_t at[3] = {i % side[0], i / side[0] % side[1], i / side[0] / side[1]};
        double p[3];
        for (int j = 0; j < 3; j++)
            p[j] = 2 * HALF * (at[j] + 0.5) / side[j] - HALF;
        uint32_t clear = (at[0] + at[1] + at[2]) & 1;
        if (sph_scene_add_sphere(scene, sph_vec_of(p[0], p[1], p[2]), o->radius, clear, 0, err))
            return -1;
    }
    return 0;
}

/* Adds n spheres, wholly within eight cubes at the corners in turn, anywhere in them. */
static int add_corners(const struct sph_generate_options *o, uint32_t n, struct sph_scene *scene,
                       struct sph_error *err) {
    struct sph_rng rng = {o->seed};
    double near = HALF - fmax(CORNER - o->radius, o->radius), far = HALF - o->radius;
    for (uint32_t i = 0; i < n; i++) {
        double p[3];
        for (int j = 0; j < 3; j++) {
            double v = sph_rng_range(&rng, near, far);
            p[j] = i >> j & 1 ? v : -v;
        }
        if (sph_scene_add_sphere(scene, sph_vec_of(p[0], p[1], p[2]), o->radius, i / 8 & 1, 0, err))
            return -1;
    }
    return 0;
}

int sph_make_scenario1(const struct sph_generate_options *o, struct sph_scene *scene,
                       struct sph_error *err) {
    return start(o, 1, scene, err) || add_lattice(o, o->n, scene, err) ? -1 : 0;
}

int sph_make_scenario2(const struct sph_generate_options *o, struct sph_scene *scene,
                       struct sph_error *err) {
    return start(o, 2, scene, err) || add_corners(o, o->n, scene, err) ? -1 : 0;
}

int sph_make_scenario3(const struct sph_generate_options *o, struct sph_scene *scene,
                       struct sph_error *err) {
    uint32_t half = o->n / 2;
    return start(o, 3, scene, err) || add_corners(o, half, scene, err) ||
                   add_lattice(o, o->n - half, scene, err)
               ? -1
               : 0;
}
