/* made_scene.h - scenes made in code for the tests of the double reference
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TEST_MADE_SCENE_H
#define SPH_TEST_MADE_SCENE_H

#include "model_scene.h"

#include "reference/reference.h"

typedef long double wide; /* 11 bits more than a double */

static inline struct sph_vec vec(const double v[3]) {
    return (struct sph_vec){v[0], v[1], v[2]};
}

static inline wide dotw(const wide a[3], const wide b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void crossw(const wide a[3], const wide b[3], wide out[3]) {
    for (int i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

enum { SIDE = 33, MOST = 64 };

static struct {
    struct sph_scene scene;
    struct sph_sphere spheres[4];
    struct sph_facet facets[MOST];
    struct sph_material materials[MOST];
} made;

/* Nothing but a light and the eye, which looks along -z from 10. */
static inline struct sph_scene *bare(void) {
    memset(&made, 0, sizeof made);
    struct sph_scene *s = &made.scene;
    *s = (struct sph_scene){.path = "made here", .n_lights = 1, .n_materials = MOST};
    s->camera =
        (struct sph_camera){{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 30, .width = SIDE, .height = SIDE};
    s->lights[0] = (struct sph_light){{3, 4, 20}, {0.75, 0.75, 0.75}, 0};
    s->ambient[0] = s->ambient[1] = 0.25;
    s->spheres = made.spheres, s->facets = made.facets, s->materials = made.materials;
    for (int i = 0; i < MOST; i++)
        made.materials[i] =
            (struct sph_material){.rgb = {1.0 / (1 + i), i * 0.01, 0.5}, .kd = 0.7, .ks = 0.3};
    return s;
}

static inline void add(struct sph_scene *s, int kind, uint32_t group, const double v[3][3]) {
    uint32_t i = s->n_facets++;
    s->facets[i] = (struct sph_facet){.kind = kind, .group = group, .material = i % MOST};
    for (int k = 0; k < 3; k++)
        s->facets[i].v[k] = vec(v[k]);
}

static inline struct sph_reference render(const struct sph_scene *s, int width, int height) {
    struct sph_reference_options o = {.width = width,
                                      .height = height,
                                      .max_depth = 4,
                                      .shadow = 1,
                                      .reflect = 1,
                                      .refract = 1,
                                      .specular = 1};
    struct sph_reference r;
    struct sph_error err = {{0}};
    if (sph_reference_render(s, &o, &r, &err)) fail_msg("%s", err.text);
    return r;
}

#endif
