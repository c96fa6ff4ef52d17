/* frame.c - frames of the library: see sphaera.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdlib.h>
#include <string.h>

#include "engine/layers.h"
#include "image/image.h"
#include "render/render.h"
#include "sphaera/opaque.h"

enum { MOST_SAMPLES = 16 };

void sphaera_render_init(sphaera_render_options *options) {
    *options = (sphaera_render_options){.size = sizeof *options, .traverse = "fast"};
}

static int render(const sphaera_machine *machine, const sphaera_render_options *o,
                  sphaera_frame *made, struct sph_error *err) {
    static const char *const ways[] = {"literal", "brute", "fast", "packets", NULL};
    const struct sph_machine *m = &machine->machine;
    struct sph_api_told told = {o->progress, o->user, 0};
    struct sph_render_options options = {.threads = o->threads};
    size_t n = (size_t)m->regs[SPH_REG_FRAME_W] * (size_t)m->regs[SPH_REG_FRAME_H];
    if (o->size != sizeof *o)
        return sph_fail(err, "render options: not those of sphaera_render_init()");
    options.traverse = sph_api_choice("traverse", o->traverse, ways, err);
    if (options.traverse < 0 || sph_api_whole("threads", o->threads, 0, SPH_API_THREADS, err))
        return -1;
    if (o->progress) options.progress = sph_api_show, options.user = &told;
    options.stop = o->stop;
    options.trails = made->trails = calloc(n, sizeof *made->trails);
    if (!made->trails) return sph_fail(err, "no memory for a frame");
    int bits = sph_render(m, &options, &made->frame, &made->counters, err);
    made->errors = (uint32_t)bits;
    if (told.end) {
        *err = (struct sph_error){""};
        return sph_fail(err, "cancelled");
    }
    return bits < 0 ? -1 : 0;
}

int sphaera_render_with(const sphaera_machine *machine, const sphaera_render_options *options,
                        sphaera_frame **frame, sphaera_error *error) {
    if (sph_api_null(machine, "machine", error) || sph_api_null(options, "options", error) ||
        sph_api_null(frame, "frame", error))
        return -1;
    SPH_API_ENVIRONMENT;
    struct sph_error err = {""};
    *frame = NULL;
    sphaera_frame *made = calloc(1, sizeof *made);
    int rc = made ? render(machine, options, made, &err) : sph_fail(&err, "no memory for a frame");
    if (made) made->machine = sph_api_hold(machine);
    if (!rc) {
        *frame = made;
        return 0;
    }
    sphaera_frame_free(made);
    return sph_api_failed(&err, error);
}

int sphaera_render(const sphaera_machine *machine, int threads, sphaera_frame **frame,
                   sphaera_error *error) {
    sphaera_render_options options;
    sphaera_render_init(&options);
    options.threads = threads;
    return sphaera_render_with(machine, &options, frame, error);
}

void sphaera_frame_free(sphaera_frame *frame) {
    if (!frame) return;
    sph_frame_free(&frame->frame);
    sphaera_machine_free(frame->machine);
    free(frame->trails);
    free(frame);
}

int sphaera_frame_width(const sphaera_frame *frame) {
    return frame->frame.width;
}

int sphaera_frame_height(const sphaera_frame *frame) {
    return frame->frame.height;
}

static size_t pixels(const sphaera_frame *frame) {
    return (size_t)frame->frame.width * (size_t)frame->frame.height;
}

int sphaera_frame_rgb(const sphaera_frame *frame, int layer, uint8_t *rgb) {
    if (!frame || !rgb || layer < 0 || layer >= SPH_FRAMES) return -1;
    for (size_t i = 0; i < pixels(frame); i++)
        for (int k = 0; k < 3; k++)
            rgb[3 * i + (size_t)k] = (uint8_t)(frame->frame.pixels[i].colour[layer] >> 8 * k);
    return 0;
}

void sphaera_frame_id(const sphaera_frame *frame, uint32_t *id) {
    _Static_assert(SPHAERA_NONE == SPH_ID_NONE, "the id of nothing");
    for (size_t i = 0; i < pixels(frame); i++)
        id[i] = frame->frame.pixels[i].id;
}

void sphaera_frame_key(const sphaera_frame *frame, uint64_t *key) {
    for (size_t i = 0; i < pixels(frame); i++)
        key[i] = frame->frame.pixels[i].key;
}

void sphaera_frame_visits(const sphaera_frame *frame, uint32_t *visits) {
    for (size_t i = 0; i < pixels(frame); i++)
        visits[i] = frame->frame.pixels[i].visits;
}

uint64_t sphaera_frame_hash(const sphaera_frame *frame) {
    return sph_frame_hash(&frame->frame);
}

uint32_t sphaera_frame_errors(const sphaera_frame *frame) {
    return frame->errors;
}

static void put3(float *to, size_t at, const float from[3]) {
    for (size_t k = 0; to && k < 3; k++)
        to[3 * at + k] = from[k];
}

int sphaera_frame_layers(const sphaera_frame *frame, const sphaera_layers *to,
                         sphaera_error *error) {
    if (sph_api_null(frame, "frame", error) || sph_api_null(to, "to", error)) return -1;
    SPH_API_ENVIRONMENT;
    for (size_t i = 0; to->texture && i < pixels(frame); i++)
        to->texture[i] = frame->frame.pixels[i].texture;
    if (!to->level && !to->normal && !to->depth && !to->distance && !to->albedo) return 0;
    struct sph_error err = {""};
    struct sph_layer *layers = sph_layers_of(&frame->machine->machine, &frame->frame);
    if (!layers) {
        sph_fail(&err, "no memory for layers");
        return sph_api_failed(&err, error);
    }
    for (size_t i = 0; i < pixels(frame); i++) {
        if (to->level) to->level[i] = layers[i].level;
        if (to->depth) to->depth[i] = layers[i].depth;
        if (to->distance) to->distance[i] = layers[i].distance;
        put3(to->normal, i, layers[i].normal);
        put3(to->albedo, i, layers[i].albedo);
    }
    free(layers);
    return 0;
}

void sphaera_picture_init(sphaera_picture_options *options) {
    *options = (sphaera_picture_options){
        .size = sizeof *options, .layer = SPH_FRAMES - 1, .transfer = "srgb"};
}

/* The colours of depths in the place of those of the pixels. */
static int paint(const sphaera_frame *frame, struct sph_frame *painted, struct sph_error *err) {
    *painted = frame->frame;
    painted->pixels = malloc(pixels(frame) * sizeof *painted->pixels);
    if (!painted->pixels) return sph_fail(err, "no memory for depths");
    for (size_t i = 0; i < pixels(frame); i++) {
        painted->pixels[i] = frame->frame.pixels[i];
        for (int layer = 0; layer < SPH_FRAMES; layer++)
            painted->pixels[i].colour[layer] = sph_depth_colours[frame->trails[i].depth];
    }
    return 0;
}

static int write_light(const sphaera_frame *frame, const char *path, int exr, int transfer,
                       const struct sph_linear *light, struct sph_error *err) {
    if (!exr) return sph_linear_write(path, light, transfer, err);
    struct sph_layer *layers = sph_layers_of(&frame->machine->machine, &frame->frame);
    if (!layers) return sph_fail(err, "%s: no memory for its layers", path);
    int rc = sph_linear_write_exr(path, light, &frame->frame, layers, err);
    free(layers);
    return rc;
}

static int write(const sphaera_frame *frame, const char *path, const sphaera_picture_options *o,
                 struct sph_error *err) {
    static const char *const transfers[] = {"linear", "srgb", NULL}; /* SPH_TRANSFER_* */
    struct sph_linear light = {0};
    struct sph_frame painted = {0};
    if (o->size != sizeof *o)
        return sph_fail(err, "picture options: not those of sphaera_picture_init()");
    int transfer = sph_api_choice("transfer", o->transfer, transfers, err);
    int samples = o->samples ? o->samples : frame->machine->samples;
    if (transfer < 0 || sph_api_whole("layer", o->layer, 0, SPH_FRAMES - 1, err) ||
        sph_api_whole("depths", o->depths, 0, 1, err) ||
        sph_api_whole("samples", samples, 1, MOST_SAMPLES, err))
        return -1;
    if (o->depths && samples > 1)
        return sph_fail(err, "depths are false colours, samples is %d", samples);
    const char *format = sph_image_format(path, err);
    if (!format || (o->depths && paint(frame, &painted, err))) return -1;
    int rc = sph_linear_of(o->depths ? &painted : &frame->frame, o->depths ? NULL : frame->trails,
                           o->layer, samples, &light, err);
    if (!rc) rc = write_light(frame, path, !strcmp(format, "openexr"), transfer, &light, err);
    sph_linear_free(&light);
    free(painted.pixels);
    return rc;
}

int sphaera_frame_write_with(const sphaera_frame *frame, const char *path,
                             const sphaera_picture_options *options, sphaera_error *error) {
    if (sph_api_null(frame, "frame", error) || sph_api_null(path, "path", error) ||
        sph_api_null(options, "options", error))
        return -1;
    SPH_API_ENVIRONMENT;
    struct sph_error err = {""};
    return write(frame, path, options, &err) ? sph_api_failed(&err, error) : 0;
}

int sphaera_frame_write(const sphaera_frame *frame, const char *path, sphaera_error *error) {
    sphaera_picture_options options;
    sphaera_picture_init(&options);
    return sphaera_frame_write_with(frame, path, &options, error);
}

static const char *const names[SPH_COUNTERS] = {SPH_COUNTER_NAMES};

const char *sphaera_counter_name(int number) {
    return number >= 0 && number < SPH_COUNTERS ? names[number] : NULL;
}

uint64_t sphaera_frame_counter(const sphaera_frame *frame, int number) {
    return number >= 0 && number < SPH_COUNTERS ? frame->counters.count[number] : 0;
}

int sphaera_counter_find(const char *name) {
    for (int i = 0; name && i < SPH_COUNTERS; i++)
        if (!strcmp(names[i], name)) return i;
    return -1;
}

int sphaera_counter_exact(int number) {
    return number >= 0 && number < SPH_COUNTERS && sph_counter_both(number);
}
