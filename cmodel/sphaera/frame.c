/* frame.c - frames of the library: see sphaera.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdlib.h>
#include <string.h>

#include "common/fnv.h"
#include "render/render.h"
#include "image/image.h"
#include "sphaera/opaque.h"

enum { MOST_THREADS = 1024 };

static int render(const struct sph_machine *m, int threads, const int *stop, sphaera_frame *made,
                  struct sph_error *err) {
    struct sph_render_options options = {
        .traverse = SPH_TRAVERSE_FAST, .threads = threads, .stop = stop};
    size_t n = (size_t)m->regs[SPH_REG_FRAME_W] * (size_t)m->regs[SPH_REG_FRAME_H];
    options.trails = made->trails = calloc(n, sizeof *made->trails);
    if (!made->trails) return sph_fail(err, "no memory for a frame");
    int bits = sph_render(m, &options, &made->frame, &made->counters, err);
    made->errors = (uint32_t)bits;
    return bits < 0 ? -1 : 0;
}

int sphaera_render(const sphaera_machine *machine, int threads, sphaera_frame **frame,
                   sphaera_error *error) {
    return sphaera_render_until(machine, threads, NULL, frame, error);
}

int sphaera_render_until(const sphaera_machine *machine, int threads, const int *stop,
                         sphaera_frame **frame, sphaera_error *error) {
    if (sph_api_null(machine, "machine", error) || sph_api_null(frame, "frame", error)) return -1;
    SPH_API_ENVIRONMENT;
    struct sph_error err = {""};
    *frame = NULL;
    if (threads < 0 || threads > MOST_THREADS) {
        sph_fail(&err, "threads is %d, not 0 to %d", threads, MOST_THREADS);
        return sph_api_failed(&err, error);
    }
    sphaera_frame *made = calloc(1, sizeof *made);
    int rc = made ? render(&machine->machine, threads, stop, made, &err)
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

/* ---- as bytes: a head, pixels and trails as this machine has them, their sum ---- */

struct head {
    char magic[8]; /* "SPHFRMPK" */
    uint32_t order, pixel, trail, counters, width, height, errors;
    struct sph_counters counts;
};
static const char magic[8] = "SPHFRMPK";
enum { ORDER = 0x01020304 }; /* of bytes in a number */

static uint64_t sum_of(const uint8_t *bytes, size_t size) {
    uint64_t sum = SPH_FNV_START;
    for (size_t i = 0; i < size; i++)
        sum = sph_fnv(sum, bytes[i], 1);
    return sum;
}

static size_t size_of(size_t n) {
    return sizeof(struct head) + n * (sizeof(struct sph_pixel) + sizeof(struct sph_trail)) +
           sizeof(uint64_t);
}

size_t sphaera_frame_size(const sphaera_frame *frame) {
    return size_of(pixels(frame));
}

void sphaera_frame_pack(const sphaera_frame *frame, uint8_t *bytes) {
    size_t n = pixels(frame), size = size_of(n) - sizeof(uint64_t);
    struct head head = {.order = ORDER,
                        .pixel = sizeof(struct sph_pixel),
                        .trail = sizeof(struct sph_trail),
                        .counters = SPH_COUNTERS,
                        .width = (uint32_t)frame->frame.width,
                        .height = (uint32_t)frame->frame.height,
                        .errors = frame->errors,
                        .counts = frame->counters};
    memcpy(head.magic, magic, sizeof magic);
    memcpy(bytes, &head, sizeof head);
    memcpy(bytes + sizeof head, frame->frame.pixels, n * sizeof(struct sph_pixel));
    memcpy(bytes + sizeof head + n * sizeof(struct sph_pixel), frame->trails,
           n * sizeof(struct sph_trail));
    uint64_t sum = sum_of(bytes, size);
    memcpy(bytes + size, &sum, sizeof sum);
}

/* Whether bytes are those of a frame; *head is theirs then. */
static int sound(const uint8_t *bytes, size_t size, struct head *head) {
    uint64_t sum;
    if (size < size_of(1)) return 0;
    memcpy(head, bytes, sizeof *head);
    if (memcmp(head->magic, magic, sizeof magic) != 0 || head->order != ORDER ||
        head->pixel != sizeof(struct sph_pixel) || head->trail != sizeof(struct sph_trail) ||
        head->counters != SPH_COUNTERS || head->width > SPH_MAX_SIDE ||
        head->height > SPH_MAX_SIDE || size != size_of((size_t)head->width * head->height))
        return 0;
    memcpy(&sum, bytes + size - sizeof sum, sizeof sum);
    return sum == sum_of(bytes, size - sizeof sum);
}

int sphaera_frame_unpack(const uint8_t *bytes, size_t size, sphaera_frame **frame,
                         sphaera_error *error) {
    if (sph_api_null(bytes, "bytes", error) || sph_api_null(frame, "frame", error)) return -1;
    struct head head;
    struct sph_error err = {""};
    *frame = NULL;
    if (!sound(bytes, size, &head)) {
        sph_fail(&err, "these are not the bytes of a frame, or they are damaged");
        return sph_api_failed(&err, error);
    }
    size_t n = (size_t)head.width * head.height;
    sphaera_frame *made = calloc(1, sizeof *made);
    if (made) made->frame.pixels = malloc(n * sizeof *made->frame.pixels);
    if (made) made->trails = malloc(n * sizeof *made->trails);
    if (!made || !made->frame.pixels || !made->trails) {
        sphaera_frame_free(made);
        sph_fail(&err, "no memory for a frame");
        return sph_api_failed(&err, error);
    }
    bytes += sizeof head;
    memcpy(made->frame.pixels, bytes, n * sizeof *made->frame.pixels);
    memcpy(made->trails, bytes + n * sizeof *made->frame.pixels, n * sizeof *made->trails);
    made->frame.width = (int)head.width, made->frame.height = (int)head.height;
    made->errors = head.errors;
    made->counters = head.counts;
    *frame = made;
    return 0;
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
