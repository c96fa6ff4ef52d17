/* frame.c - frames of the library: see sphaera.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdlib.h>
#include <string.h>

#include "render/render.h"
#include "image/image.h"
#include "sphaera/opaque.h"

enum { MOST_THREADS = 1024 };

static int render(const struct sph_machine *m, int threads, sphaera_frame *made,
                  struct sph_error *err) {
    struct sph_render_options options = {.traverse = SPH_TRAVERSE_FAST, .threads = threads};
    size_t n = (size_t)m->regs[SPH_REG_FRAME_W] * (size_t)m->regs[SPH_REG_FRAME_H];
    options.trails = made->trails = calloc(n, sizeof *made->trails);
    if (!made->trails) return sph_fail(err, "no memory for a frame");
    int bits = sph_render(m, &options, &made->frame, &made->counters, err);
    made->errors = (uint32_t)bits;
    return bits < 0 ? -1 : 0;
}

int sphaera_render(const sphaera_machine *machine, int threads, sphaera_frame **frame,
                   sphaera_error *error) {
    if (sph_api_null(machine, "machine", error) || sph_api_null(frame, "frame", error)) return -1;
    SPH_API_ENVIRONMENT;
    struct sph_error err = {""};
    *frame = NULL;
    if (threads < 0 || threads > MOST_THREADS) {
        sph_fail(&err, "threads is %d, not 0 to %d", threads, MOST_THREADS);
        return sph_api_failed(&err, error);
    }
    sphaera_frame *made = calloc(1, sizeof *made);
    int rc = made ? render(&machine->machine, threads, made, &err)
                  : sph_fail(&err, "no memory for a frame");
    if (!rc) {
        *frame = made;
        return 0;
    }
    sphaera_frame_free(made);
    return sph_api_failed(&err, error);
}

void sphaera_frame_free(sphaera_frame *frame) {
    if (!frame) return;
    sph_frame_free(&frame->frame);
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

int sphaera_frame_write(const sphaera_frame *frame, const char *path, sphaera_error *error) {
    if (sph_api_null(frame, "frame", error) || sph_api_null(path, "path", error)) return -1;
    SPH_API_ENVIRONMENT;
    struct sph_error err = {""};
    struct sph_linear light = {0};
    const char *format = sph_image_format(path, &err);
    int rc =
        format ? sph_linear_of(&frame->frame, frame->trails, SPH_FRAMES - 1, 1, &light, &err) : -1;
    if (!rc)
        rc = strcmp(format, "openexr")
                 ? sph_linear_write(path, &light, SPH_TRANSFER_SRGB, &err)
                 : sph_linear_write_exr(path, &light, &frame->frame, NULL, &err);
    sph_linear_free(&light);
    return rc ? sph_api_failed(&err, error) : 0;
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
