/* bytes.c - frames of the library as bytes, for another process: see sphaera.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * A head, pixels and trails as this computer has them, and the sum of all before it.
 */
#include <stdlib.h>
#include <string.h>

#include "common/fnv.h"
#include "sphaera/opaque.h"

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

static size_t pixels(const sphaera_frame *frame) {
    return (size_t)frame->frame.width * (size_t)frame->frame.height;
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

int sphaera_frame_unpack(const sphaera_machine *machine, const uint8_t *bytes, size_t size,
                         sphaera_frame **frame, sphaera_error *error) {
    if (sph_api_null(machine, "machine", error) || sph_api_null(bytes, "bytes", error) ||
        sph_api_null(frame, "frame", error))
        return -1;
    struct head head;
    struct sph_error err = {""};
    *frame = NULL;
    if (!sound(bytes, size, &head) ||
        head.width != (uint32_t)machine->machine.regs[SPH_REG_FRAME_W] ||
        head.height != (uint32_t)machine->machine.regs[SPH_REG_FRAME_H]) {
        sph_fail(&err, "these are not the bytes of a frame of %s, or they are damaged",
                 machine->machine.name);
        return sph_api_failed(&err, error);
    }
    size_t n = (size_t)head.width * head.height;
    sphaera_frame *made = calloc(1, sizeof *made);
    if (made) made->frame.pixels = malloc(n * sizeof *made->frame.pixels);
    if (made) made->trails = malloc(n * sizeof *made->trails);
    if (made) made->machine = sph_api_hold(machine);
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
