/* reference.c - see reference.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "reference/reference.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/parallel.h"
#include "reference/follow.h"

enum { PIXELS = 512, TOLD = 1 << 13 }; /* that are worth a thread; between two asks for the end */

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
    uint32_t from; /* of the pixels at hand */
};

static void render_pixels(void *user, uint32_t first, uint32_t end) {
    const struct picture *p = user;
    const uint32_t *places = p->job->o->places, width = (uint32_t)p->job->view.width;
    struct sph_level_work work = {.hits = {0}};
    for (uint32_t i = p->from + first; i < p->from + end; i++) {
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
    j.textures =
        (struct sph_ref_textures){scene,          options->mips,        options->filter,
                                  options->lod,   j.view.window.screen, (double)width * height,
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
    struct picture picture = {&j, out, 0};
    uint32_t part = options->progress && options->progress->show ? TOLD : n;
    int end = 0;
    int before = sph_parallel_most(options->work ? 1 : options->threads); /* who counts gets one */
    for (uint32_t *from = &picture.from; *from < n && !end; *from += part) {
        end = sph_progress_at(options->progress, (double)*from / n);
        if (!end)
            sph_parallel_for(n - *from < part ? n - *from : part, PIXELS, render_pixels, &picture);
    }
    sph_parallel_most(before);
    sph_ref_tree_free(tree);
    if (!end) return 0;
    sph_reference_free(out);
    return sph_fail(err, "%s: cancelled", scene->path);
}

void sph_reference_free(struct sph_reference *r) {
    free(r->pixels);
    r->pixels = NULL;
}

/* ---- how far a frame is from the reference, see reference.h ---- */

enum { FAR_OFF = 8 };

static const double FULL = 255.0 * 255.0 * 3; /* squared error of black against white */

/* Adds the squared differences of three channels to *sum; returns the largest difference. */
static int differ(uint32_t a, uint32_t b, double *sum) {
    int worst = 0;
    for (int shift = 0; shift < 24; shift += 8) {
        int d = abs((int)(a >> shift & 255) - (int)(b >> shift & 255));
        *sum += (double)d * d;
        worst = d > worst ? d : worst;
    }
    return worst;
}

struct sph_image_error sph_reference_compare(const struct sph_frame *frame,
                                             const struct sph_reference *reference) {
    struct sph_image_error e = {.pixels = 0};
    double sum[SPH_FRAMES] = {0};
    if (frame->width != reference->width || frame->height != reference->height) return e;
    e.pixels = (uint64_t)frame->width * (uint64_t)frame->height;
    for (uint64_t i = 0; i < e.pixels; i++) {
        const struct sph_pixel *p = &frame->pixels[i];
        const struct sph_reference_pixel *r = &reference->pixels[i];
        int worst = 0;
        if (r->doubt) {
            e.undecidable++;
            continue;
        }
        for (int layer = 0; layer < SPH_FRAMES; layer++)
            worst = differ(p->colour[layer], r->colour[layer], &sum[layer]);
        e.far_off += worst > FAR_OFF;
        e.worst = worst > e.worst ? worst : e.worst;
        if ((p->id == SPH_ID_NONE) != (r->id == SPH_ID_NONE))
            e.silhouette++;
        else if (p->id != r->id)
            e.wrong_id++;
    }
    double n = (double)(e.pixels - e.undecidable);
    for (int layer = 0; layer < SPH_FRAMES; layer++)
        e.psnr[layer] = sum[layer] > 0 ? 10 * log10(FULL * n / sum[layer]) : INFINITY;
    return e;
}
