/* reference.c - see reference.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "reference/reference.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

#include "reference/follow.h"

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double out[3]) {
    for (int i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

/* Scales v to length 1; 0 if it has none. */
static int unit(double v[3]) {
    double n = sqrt(dot(v, v));
    for (int i = 0; i < 3; i++)
        v[i] /= n;
    return isfinite(n) && n > 0;
}

static int camera(struct sph_ref_job *j) {
    const struct sph_camera *c = &j->scene->camera;
    double back[3] = {c->from.x - c->at.x, c->from.y - c->at.y, c->from.z - c->at.z};
    double up[3] = {c->up.x, c->up.y, c->up.z};
    if (!unit(back)) return 0;
    for (int i = 0; i < 3; i++)
        j->axes[2][i] = back[i];
    cross(up, back, j->axes[0]);
    if (!unit(j->axes[0])) return 0;
    cross(back, j->axes[0], j->axes[1]);
    j->screen = j->height / 2.0 / tan(c->angle * acos(-1.0) / 360);
    return isfinite(j->screen) && j->screen > 0;
}

static uint32_t byte(double c) {
    return (uint32_t)(fmin(fmax(c, 0), 1) * 255 + 0.5);
}

static struct sph_reference_pixel render_pixel(const struct sph_ref_job *j, int x, int y,
                                               struct sph_level_work *work) {
    struct sph_ref_seen seen = {.pixel = {.id = SPH_ID_NONE,
                                          .reflected_id = SPH_ID_NONE,
                                          .refracted_id = SPH_ID_NONE,
                                          .distance = INFINITY},
                                .work = work};
    const struct sph_camera *c = &j->scene->camera;
    struct sph_ref_branch b = {
        .ray = {.org = {c->from.x, c->from.y, c->from.z}, .skip = SPH_ID_NONE}, .weight = 1};
    for (int i = 0; i < 3; i++)
        b.ray.dir[i] = (x - (j->width - 1) / 2.0) * j->axes[0][i] +
                       ((j->height - 1) / 2.0 - y) * j->axes[1][i] - j->screen * j->axes[2][i];
    sph_ref_path_start(&b.path, b.ray.dir, j->axes[0], j->axes[1]);
    sph_ref_follow(j, b, &seen);
    for (int f = 0; f < SPH_FRAMES; f++)
        for (int i = 0; i < 3; i++)
            seen.pixel.colour[f] |= byte(seen.sum[f][i]) << (8 * i);
    return seen.pixel;
}

int sph_reference_render(const struct sph_scene *scene, const struct sph_reference_options *options,
                         struct sph_reference *out, struct sph_error *err) {
    struct sph_ref_job j = {.scene = scene, .o = options};
    j.width = options->width ? options->width : scene->camera.width;
    j.height = options->height ? options->height : scene->camera.height;
    if (j.width <= 0 || j.height <= 0)
        return sph_fail(err, "%s: a frame of %dx%d has no pixels", scene->path, j.width, j.height);
    if (!camera(&j)) return sph_fail(err, "%s: the camera has no direction", scene->path);
    j.textures = (struct sph_ref_textures){scene,        options->mips, options->filter,
                                           options->lod, j.screen,      (double)j.width * j.height};
    struct sph_ref_tree *tree = sph_ref_tree_new(scene, options->world);
    memset(&out->work, 0, sizeof out->work);
    out->width = j.width, out->height = j.height;
    out->pixels = calloc((size_t)j.width * (size_t)j.height, sizeof *out->pixels);
    if (!tree || !out->pixels) {
        sph_ref_tree_free(tree);
        sph_reference_free(out);
        return sph_fail(err, "%s: no memory for the reference", scene->path);
    }
    j.tree = tree;
#pragma omp parallel for schedule(dynamic, 4)                                                      \
    num_threads(options->threads > 0 ? options->threads : omp_get_num_procs())
    for (int y = 0; y < j.height; y++) {
        struct sph_level_work work = {.hits = {0}};
        for (int x = 0; x < j.width; x++)
            out->pixels[(size_t)y * (size_t)j.width + (size_t)x] = render_pixel(&j, x, y, &work);
#pragma omp critical
        sph_level_work_add(&out->work, &work);
    }
    sph_ref_tree_free(tree);
    return 0;
}

void sph_reference_free(struct sph_reference *r) {
    free(r->pixels);
    r->pixels = NULL;
}
