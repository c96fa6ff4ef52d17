/* named_scene.c - hard cases that are whole scenes: model, brute force and naive model
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdlib.h>
#include <string.h>

#include "builder/build.h"
#include "named.h"
#include "naive/naive.h"
#include "render/render.h"

enum { W = 16, H = 12 };

static int same(const struct sph_pixel *a, const struct sph_pixel *b) {
    return a->id == b->id && a->key == b->key && !memcmp(a->colour, b->colour, sizeof a->colour);
}

static int render(struct named *n, const struct sph_machine *m, int how, struct sph_frame *frame) {
    struct sph_render_options o = {.traverse = how, .threads = 1};
    struct sph_counters c = {0};
    struct sph_error err = {{0}};
    int errors = sph_render(m, &o, frame, &c, &err);
    require(n, errors == 0, "rendering: %s, errors %x", err.text, (unsigned)errors);
    return errors >= 0;
}

/* All three pictures; with `lonely` a shadow changes nothing. */
static void compare(struct named *n, const char *name, struct sph_machine *m, int lonely) {
    struct sph_frame tree, brute, dark;
    int wrong = 0;
    if (!render(n, m, SPH_TRAVERSE_TREE, &tree)) return;
    if (render(n, m, SPH_TRAVERSE_BRUTE, &brute)) {
        for (int i = 0; i < W * H; i++) {
            struct sph_pixel naive = sph_naive_pixel(m, i % W, i / W);
            wrong += !same(&tree.pixels[i], &brute.pixels[i]) || !same(&tree.pixels[i], &naive);
        }
        sph_frame_free(&brute);
    }
    require(n, !wrong, "scene %s: %d pixels differ", name, wrong);
    m->regs[SPH_REG_EFFECTS] &= ~(1 << SPH_EFFECT_SHADOW);
    wrong = 0;
    if (lonely && render(n, m, SPH_TRAVERSE_TREE, &dark)) {
        for (int i = 0; i < W * H; i++)
            wrong += !same(&tree.pixels[i], &dark.pixels[i]);
        require(n, !wrong, "scene %s: the sphere shadows itself in %d pixels", name, wrong);
        sph_frame_free(&dark);
    }
    sph_frame_free(&tree);
    n->vectors += W * H;
}

void named_scene(struct named *n, const char *name) {
    char path[1024];
    struct sph_scene scene;
    struct sph_machine m;
    struct sph_error err = {{0}};
    struct sph_read_options read = {0};
    struct sph_build_options o = {.profile = n->profile,
                                  .tree = SPH_TREE_BALANCED,
                                  .width = W,
                                  .height = H,
                                  .max_depth = 3,
                                  .shadow = 1,
                                  .reflect = 1};
    struct sph_build_report report;
    if (n->list) return; /* runs of tests/core/test_core.sh */
    snprintf(path, sizeof path, "%s/%s.nff", n->scenes, name);
    int failed = sph_scene_read(path, &read, &scene, &err);
    require(n, !failed, "%s", err.text);
    if (failed) return;
    if (!strcmp(name, "identical"))
        require(n, scene.n_spheres == 1, "of two equal spheres %u are kept", scene.n_spheres);
    failed = sph_build(&scene, &o, &m, &report, &err);
    require(n, !failed, "%s", err.text);
    if (!failed) {
        compare(n, name, &m, !strcmp(name, "alone"));
        sph_machine_free(&m);
    }
    sph_scene_free(&scene);
}
