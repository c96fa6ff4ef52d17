/* reference.c - see reference.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "reference/reference.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/parallel.h"
#include "reference/drift.h"
#include "reference/follow.h"

enum { PIXELS = 512 }; /* that are worth a thread */

static uint32_t byte(double c) {
    return (uint32_t)(fmin(fmax(c, 0), 1) * 255 + 0.5);
}

void sph_ref_sample_of(const struct sph_ref_job *j, int x, int y, struct sph_ref_seen *seen) {
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
    sph_ref_drift_start(&b.ray);
    sph_ref_path_start(&b.path, b.ray.dir, v->axes[0], v->axes[1]);
    sph_ref_follow(j, b, seen);
}

static struct sph_reference_pixel render_pixel(const struct sph_ref_job *j, int x, int y,
                                               struct sph_level_work *work) {
    struct sph_ref_seen seen = {.work = work};
    sph_ref_sample_of(j, x, y, &seen);
    for (int f = 0; f < SPH_FRAMES; f++)
        for (int i = 0; i < 3; i++)
            seen.pixel.colour[f] |= byte(seen.sum[f][i]) << (8 * i);
    return seen.pixel;
}

struct picture {
    const struct sph_ref_job *job;
    struct sph_reference *out;
};

static void render_pixels(void *user, uint32_t first, uint32_t end) {
    const struct picture *p = user;
    const uint32_t *places = p->job->o->places, width = (uint32_t)p->job->view.width;
    struct sph_level_work work = {.hits = {0}};
    for (uint32_t i = first; i < end; i++) {
        uint32_t at = places ? places[i] : i;
        p->out->pixels[i] = render_pixel(p->job, (int)(at % width), (int)(at / width), &work);
    }
    sph_parallel_lock();
    sph_level_work_add(&p->out->work, &work);
    sph_parallel_unlock();
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
    out->width = options->places ? (int)options->n_places : width;
    out->height = options->places ? 1 : height;
    uint32_t n = (uint32_t)out->width * (uint32_t)out->height;
    out->pixels = calloc(n, sizeof *out->pixels);
    if (!tree || !out->pixels) {
        sph_ref_tree_free(tree);
        sph_reference_free(out);
        return sph_fail(err, "%s: no memory for the reference", scene->path);
    }
    j.tree = tree;
    struct picture picture = {&j, out};
    int before = sph_parallel_most(options->work ? 1 : options->threads); /* who counts gets one */
    sph_parallel_for(n, PIXELS, render_pixels, &picture);
    sph_parallel_most(before);
    sph_ref_tree_free(tree);
    return 0;
}

void sph_reference_free(struct sph_reference *r) {
    free(r->pixels);
    r->pixels = NULL;
}
