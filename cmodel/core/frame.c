/* frame.c - see frame.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "core/frame.h"

#include <stdlib.h>

#include "common/fnv.h"

#define P SPH_FNV_PRIME

/* sph_fnv() of a number into both hashes, whose products do not wait for each other; the bytes of 0
 * above the number take one product. */
static inline void add(struct sph_hashes *h, uint64_t value, int bytes) {
    static const uint64_t power[] = {1,
                                     P,
                                     P * P,
                                     P * P * P,
                                     P * P * P * P,
                                     P * P * P * P * P,
                                     P * P * P * P * P * P,
                                     P * P * P * P * P * P * P,
                                     P * P * P * P * P * P * P * P};
    for (; value; value >>= 8, bytes--) {
        h->frame = (h->frame ^ (value & 255)) * P;
        h->picture = (h->picture ^ (value & 255)) * P;
    }
    h->frame *= power[bytes];
    h->picture *= power[bytes];
}

struct sph_hashes sph_frame_hashes(const struct sph_frame *frame) {
    struct sph_hashes h = {SPH_FNV_START, SPH_FNV_START};
    add(&h, (uint64_t)frame->width, 4);
    add(&h, (uint64_t)frame->height, 4);
    size_t n = (size_t)frame->width * (size_t)frame->height;
    for (size_t i = 0; i < n; i++) {
        const struct sph_pixel *p = &frame->pixels[i];
        for (int f = 0; f < SPH_FRAMES; f++)
            add(&h, p->colour[f], 4);
        add(&h, p->id, 4);
        h.frame = sph_fnv(h.frame, p->visits, 4);
        if (p->key && p->texture != SPH_NO_TEXTURE) {
            h.frame = sph_fnv(h.frame, p->texture, 4);
            h.picture = sph_fnv(h.picture, p->texture >> SPH_LOD_LSB, 4);
        }
        add(&h, p->key, 8);
    }
    return h;
}

uint64_t sph_frame_hash(const struct sph_frame *frame) {
    return sph_frame_hashes(frame).frame;
}

uint64_t sph_frame_picture_hash(const struct sph_frame *frame) {
    return sph_frame_hashes(frame).picture;
}

void sph_frame_free(struct sph_frame *frame) {
    free(frame->pixels);
    frame->pixels = NULL;
}
