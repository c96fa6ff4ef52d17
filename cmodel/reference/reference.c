/* reference.c - see reference.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "reference/reference.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

#include "reference/follow.h"

/* How many threads share the rows; who counts gets one. */
static int threads_of(const struct sph_reference_options *o) {
    if (o->work) return 1;
    return o->threads > 0 ? o->threads : omp_get_num_procs();
}

static uint32_t byte(double c) {
    return (uint32_t)(fmin(fmax(c, 0), 1) * 255 + 0.5);
}

void sph_ref_look(const struct sph_ref_job *j, int x, int y, struct sph_ref_seen *seen) {
    const struct sph_ref_view *v = &j->view;
    struct sph_ref_branch b = {
        .ray = {.org = {v->eye[0], v->eye[1], v->eye[2]}, .skip = SPH_ID_NONE}, .weight = 1};
    seen->pixel = (struct sph_reference_pixel){.id = SPH_ID_NONE,
                                               .reflected_id = SPH_ID_NONE,
                                               .refracted_id = SPH_ID_NONE,
                                               .distance = INFINITY};
    memset(seen->sum, 0, sizeof seen->sum);
    if (seen->log) seen->log->n = 0;
    sph_ref_view_dir(v, x, y, b.ray.dir);
    sph_ref_path_start(&b.path, b.ray.dir, v->axes[0], v->axes[1]);
    sph_ref_follow(j, b, seen);
}

static struct sph_reference_pixel render_pixel(const struct sph_ref_job *j, int x, int y,
                                               struct sph_level_work *work) {
    struct sph_ref_seen seen = {.work = work};
    sph_ref_look(j, x, y, &seen);
    for (int f = 0; f < SPH_FRAMES; f++)
        for (int i = 0; i < 3; i++)
            seen.pixel.colour[f] |= byte(seen.sum[f][i]) << (8 * i);
    return seen.pixel;
}

int sph_reference_render(const struct sph_scene *scene, const struct sph_reference_options *options,
                         struct sph_reference *out, struct sph_error *err) {
    struct sph_ref_job j = {.scene = scene, .o = options};
    int width = options->width ? options->width : scene->camera.width;
    int height = options->height ? options->height : scene->camera.height;
    if (width <= 0 || height <= 0)
        return sph_fail(err, "%s: a frame of %dx%d has no pixels", scene->path, width, height);
    if (!sph_ref_view_of(&scene->camera, width, height, &j.view))
        return sph_fail(err, "%s: the camera has no direction", scene->path);
    j.textures = (struct sph_ref_textures){scene,          options->mips, options->filter,
                                           options->lod,   j.view.screen, (double)width * height,
                                           options->spread};
    struct sph_ref_tree *tree = sph_ref_tree_counted(scene, options->kd, options->work);
    memset(&out->work, 0, sizeof out->work);
    out->width = width, out->height = height;
    out->pixels = calloc((size_t)width * (size_t)height, sizeof *out->pixels);
    if (!tree || !out->pixels) {
        sph_ref_tree_free(tree);
        sph_reference_free(out);
        return sph_fail(err, "%s: no memory for the reference", scene->path);
    }
    j.tree = tree;
#pragma omp parallel for schedule(dynamic, 4) num_threads(threads_of(options))
    for (int y = 0; y < height; y++) {
        struct sph_level_work work = {.hits = {0}};
        for (int x = 0; x < width; x++)
            out->pixels[(size_t)y * (size_t)width + (size_t)x] = render_pixel(&j, x, y, &work);
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
