/* pictures.c - see pictures.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "tool/pictures.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "engine/layers.h"
#include "image/image.h"
#include "image/video.h"
#include "pixel/background.h"
#include "trace/bih_walk.h"
#include "trace/setup.h"

/* ---- movie ---- */

static int ends(const char *path, const char *ending) {
    size_t n = strlen(path), m = strlen(ending);
    return n > m && !strcasecmp(path + n - m, ending);
}

int movie_is(const char *path) {
    return ends(path, ".mp4") || ends(path, ".gif");
}

int movie_check(const char *path, struct sph_error *err) {
    if (!ends(path, ".mp4") || sph_video_can()) return 0;
    return sph_fail(err,
                    "%s: the program ffmpeg is not installed (`make movie-setup`); a .gif or "
                    "numbered .png needs none",
                    path);
}

/* The next picture, of the first one's size. */
static int add_frame(struct sph_video *video, const char *name, const struct sph_image *first,
                     const char *first_name, struct sph_error *err) {
    struct sph_image p;
    if (sph_image_read(name, &p, err)) return -1;
    size_t n = (size_t)p.width * (size_t)p.height;
    uint32_t *pixels = malloc(n * sizeof *pixels);
    int same = p.width == first->width && p.height == first->height && p.channels == 3, rc = -1;
    if (!same)
        sph_fail(err, "%s: not %dx%d with 3 channels, as %s has it", name, first->width,
                 first->height, first_name);
    else if (!pixels)
        sph_fail(err, "%s: out of memory", name);
    else {
        for (size_t i = 0; i < n; i++)
            pixels[i] = p.bytes[3 * i] | (uint32_t)p.bytes[3 * i + 1] << 8 |
                        (uint32_t)p.bytes[3 * i + 2] << 16;
        rc = sph_video_add(video, pixels, err);
    }
    free(pixels);
    sph_image_free(&p);
    return rc;
}

static int mp4(const char *path, const char *const *pictures, int n, double rate,
               struct sph_error *err) {
    struct sph_image first;
    if (sph_image_read(pictures[0], &first, err)) return -1;
    free(first.bytes); /* its size is still needed */
    struct sph_video *video = sph_video_open(path, first.width, first.height, rate, err);
    int rc = video ? 0 : -1;
    for (int i = 0; i < n && !rc; i++)
        rc = add_frame(video, pictures[i], &first, pictures[0], err);
    return video ? sph_video_close(video, rc, err) : -1;
}

int movie_write(const char *path, const char *const *pictures, int n, double rate,
                struct sph_error *err) {
    if (movie_check(path, err)) return -1;
    return ends(path, ".mp4") ? mp4(path, pictures, n, rate, err)
                              : sph_image_write_gif(path, pictures, n, rate, err);
}

const char *const tool_transfer_names[] = {"linear", "srgb", NULL};

error_t light_option(struct light_pictures *how, struct tool_outputs *outputs, int key, char *arg,
                     struct argp_state *state) {
    const char *format;
    switch (key) {
    case 'o':
        format =
            sph_image_format(tool_picture(state, outputs, key, "--output", arg, TOOL_LIGHT), NULL);
        if (format && !strcmp(format, "openexr"))
            how->exr = arg;
        else
            how->picture = arg;
        return 0;
    case TOOL_KEY_EXR:
        how->exr = tool_picture(state, outputs, key, "--exr", arg, TOOL_EXR);
        return 0;
    case TOOL_KEY_LAYER:
        how->layer = (int)tool_number(state, "--layer", arg, 0, SPH_FRAMES - 1);
        return 0;
    case TOOL_KEY_TRANSFER:
        how->transfer = tool_choice(state, "--transfer", arg, tool_transfer_names);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

/* m NULL: no machine drew it, and there are no layers. */
static int write_exr(const char *path, const struct sph_machine *m, const struct sph_linear *light,
                     const struct sph_frame *frame, struct sph_error *err) {
    struct sph_layer *layers = m ? sph_layers_of(m, frame) : NULL;
    if (m && !layers) return sph_fail(err, "%s: no memory for its layers", path);
    int rc = sph_linear_write_exr(path, light, frame, layers, err);
    free(layers);
    return rc;
}

static int write(const struct light_pictures *how, int samples, const struct sph_machine *m,
                 const struct sph_frame *frame, const struct sph_trail *trails,
                 struct sph_error *err) {
    struct sph_linear light = {0};
    int rc = sph_linear_of(frame, trails, how->layer, samples, &light, err);
    if (!rc && how->picture) rc = sph_linear_write(how->picture, &light, how->transfer, err);
    if (!rc && how->exr) rc = write_exr(how->exr, m, &light, frame, err);
    sph_linear_free(&light);
    return rc;
}

int light_picture(const struct light_pictures *how, int samples, const struct sph_machine *m,
                  const struct sph_frame *frame, const struct sph_trail *trails,
                  struct sph_error *err) {
    struct sph_frame painted;
    if (!how->depths) return write(how, samples, m, frame, trails, err);
    if (depth_picture(frame, trails, &painted)) return sph_fail(err, "no memory for depths");
    int rc = write(how, samples, m, &painted, NULL, err);
    sph_frame_free(&painted);
    return rc;
}

int depth_picture(const struct sph_frame *frame, const struct sph_trail *trails,
                  struct sph_frame *painted) {
    size_t n = (size_t)frame->width * (size_t)frame->height;
    *painted = (struct sph_frame){frame->width, frame->height, malloc(n * sizeof *frame->pixels)};
    if (!painted->pixels) return -1;
    for (size_t i = 0; i < n; i++) {
        painted->pixels[i] = frame->pixels[i];
        for (int layer = 0; layer < SPH_FRAMES; layer++)
            painted->pixels[i].colour[layer] = sph_depth_colours[trails[i].depth];
    }
    return 0;
}

enum { FIFTH = 51 }; /* of 255 */

/* Adds n fifths to a channel of a colour 0xBBGGRR. */
static uint32_t add(uint32_t colour, int channel, uint32_t n) {
    uint32_t is = colour >> 8 * channel & 255, more = n < 5 ? n * FIFTH : 255;
    if (more > 255 - is) more = 255 - is;
    return colour + (more << 8 * channel);
}

/* The colour with what the primary ray of pixel x, y meets. */
static uint32_t tint(const struct sph_machine *m, int x, int y, uint32_t colour) {
    struct sph_ray ray = {.kind = SPH_PRIMARY,
                          .skip = {SPH_ID_NONE, 0},
                          .inside = sph_machine_effect(m, SPH_EFFECT_INSIDE)};
    struct sph_counters counters = {{0}};
    uint32_t visits = 0, errors = 0, gaps = 0;
    for (int i = 0; i < 3; i++)
        ray.org[i] = m->regs[SPH_REG_EYE_X + i];
    sph_primary_dir(m, x, y, ray.dir);
    sph_ray_setup(sph_machine_profile(m), &ray);
    sph_bih_walk(m, &ray, &counters, &visits, &errors, &gaps);
    return add(add(colour, 1, gaps), 2, visits);
}

int walk_picture(const char *path, const struct sph_machine *m, const struct sph_frame *frame,
                 int layer, struct sph_error *err) {
    struct sph_frame picture = *frame;
    size_t n = (size_t)frame->width * (size_t)frame->height;
    picture.pixels = malloc(n * sizeof *picture.pixels);
    if (!picture.pixels) return sph_fail(err, "%s: out of memory", path);
    memcpy(picture.pixels, frame->pixels, n * sizeof *picture.pixels);
    for (size_t i = 0; i < n; i++) {
        int x = (int)(i % (size_t)frame->width), y = (int)(i / (size_t)frame->width);
        uint32_t *colour = &picture.pixels[i].colour[layer];
        *colour = tint(m, x, y, *colour);
    }
    int rc = sph_image_write(path, &picture, layer, err);
    free(picture.pixels);
    return rc;
}
