/* model_scene.h - builds and renders the scenes of scenes/ for the tests of the model
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_MODEL_SCENE_H
#define SPH_MODEL_SCENE_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "builder/build.h"
#include "common/parallel.h"
#include "naive/naive.h"
#include "render/render.h"
#include "number.h"

/* One scene for each thing that can go wrong in a picture; from the root of the repository. */
static const char *const model_scenes[] = {
    "eight_lights", "empty",      "huge_tiny", "inside", "interpenetrating", "materials",
    "no_light",     "one_sphere", "paper100",  "paper5", "sphereflake2",
};
enum { MODEL_SCENES = sizeof model_scenes / sizeof *model_scenes };

static inline struct sph_scene read_scene(const char *path) {
    struct sph_scene scene;
    struct sph_error err = {{0}};
    struct sph_read_options options = {0};
    if (sph_scene_read(path, &options, &scene, &err)) fail_msg("%s", err.text);
    return scene;
}

static inline struct sph_scene model_scene(const char *name) {
    char path[256];
    snprintf(path, sizeof path, "scenes/%s.nff", name);
    return read_scene(path);
}

/* Scenes of triangles and planes. */
static const char *const facet_scenes[] = {"tests/scenes/facets/mixed.nff",
                                           "scenes/facets/plane.nff", "scenes/facets/room.nff",
                                           "scenes/facets/triangles.nff"};
enum { FACET_SCENES = sizeof facet_scenes / sizeof *facet_scenes };

static inline struct sph_scene facet_scene(int n) {
    return read_scene(facet_scenes[n]);
}

/* Frames of the comparisons; the sanitizers slow the naive model's memory down most. */
enum {
    MODEL_W = SANITIZED ? 16 : 64,
    MODEL_H = SANITIZED ? 9 : 36,
    NAIVE_W = SANITIZED ? 6 : 32,
    NAIVE_H = SANITIZED ? 4 : 24
};

/* A small frame with every effect; a scene may be too fine for a coarse profile: 0. */
static inline int model_build(const struct sph_scene *scene, int profile, int tree, int background,
                              int width, int height, struct sph_machine *m) {
    struct sph_build_options o = {.profile = profile,
                                  .tree = tree,
                                  .background = background,
                                  .width = width,
                                  .height = height,
                                  .bg_border = 1,
                                  .max_depth = 3,
                                  .shadow = SPH_ON,
                                  .reflect = SPH_ON,
                                  .lights = SPH_AUTO,
                                  .inside = SPH_AUTO,
                                  .interpenetrate = SPH_AUTO};
    struct sph_build_report report;
    struct sph_error err = {{0}};
    if (!sph_build(scene, &o, m, &report, &err)) return 1;
    printf("# left out: %s\n", err.text);
    return 0;
}

static inline struct sph_frame model_render(const struct sph_machine *m, int how, int threads,
                                            struct sph_counters *c, int *errors) {
    struct sph_render_options o = {.traverse = how, .threads = threads};
    struct sph_frame frame;
    struct sph_error err = {{0}};
    memset(c, 0, sizeof *c);
    *errors = sph_render(m, &o, &frame, c, &err);
    if (*errors < 0) fail_msg("%s", err.text);
    return frame;
}

struct model_naive_frame {
    const struct sph_machine *m;
    struct sph_frame frame;
};

static inline void model_naive_pixels(void *user, uint32_t first, uint32_t end) {
    const struct model_naive_frame *f = user;
    for (uint32_t i = first; i < end; i++)
        f->frame.pixels[i] =
            sph_naive_pixel(f->m, (int)i % f->frame.width, (int)i / f->frame.width);
}

/* What the naive model draws. */
static inline struct sph_frame model_naive(const struct sph_machine *m) {
    struct model_naive_frame f = {m, {m->regs[SPH_REG_FRAME_W], m->regs[SPH_REG_FRAME_H], NULL}};
    uint32_t n = (uint32_t)(f.frame.width * f.frame.height);
    f.frame.pixels = calloc(n, sizeof *f.frame.pixels);
    assert_non_null(f.frame.pixels);
    sph_parallel_for(n, 16, model_naive_pixels, &f);
    return f.frame;
}

/* Pixels whose colours, id or key differ; prints the first. */
static inline int model_differ(const char *what, const struct sph_machine *m,
                               const struct sph_frame *a, const struct sph_frame *b) {
    int count = 0;
    for (int i = 0; i < a->width * a->height; i++) {
        const struct sph_pixel *p = &a->pixels[i], *q = &b->pixels[i];
        if (p->id == q->id && p->key == q->key && !memcmp(p->colour, q->colour, sizeof p->colour))
            continue;
        if (!count++)
            printf("# %s, %s, %s: pixel %d,%d id %u key %lu colours %06x %06x %06x, expected id %u "
                   "key %lu colours %06x %06x %06x\n",
                   what, m->name, sph_machine_profile(m)->name, i % a->width, i / a->width, p->id,
                   p->key, p->colour[0], p->colour[1], p->colour[2], q->id, q->key, q->colour[0],
                   q->colour[1], q->colour[2]);
    }
    if (count > 1) printf("# and %d pixels more\n", count - 1);
    return count;
}

#endif
