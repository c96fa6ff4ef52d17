/* frame.c - see frame.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "core/frame.h"

#include <stdlib.h>

#include "common/fnv.h"

static uint64_t hash_frame(const struct sph_frame *frame, int visits) {
    uint64_t hash = SPH_FNV_START;
    hash = sph_fnv(hash, (uint64_t)frame->width, 4);
    hash = sph_fnv(hash, (uint64_t)frame->height, 4);
    size_t n = (size_t)frame->width * (size_t)frame->height;
    for (size_t i = 0; i < n; i++) {
        const struct sph_pixel *p = &frame->pixels[i];
        for (int f = 0; f < SPH_FRAMES; f++)
            hash = sph_fnv(hash, p->colour[f], 4);
        hash = sph_fnv(hash, p->id, 4);
        if (visits) hash = sph_fnv(hash, p->visits, 4);
        if (p->key && p->texture != SPH_NO_TEXTURE)
            hash = sph_fnv(hash, visits ? p->texture : p->texture >> SPH_LOD_LSB, 4);
        hash = sph_fnv(hash, p->key, 8);
    }
    return hash;
}

uint64_t sph_frame_hash(const struct sph_frame *frame) {
    return hash_frame(frame, 1);
}

uint64_t sph_frame_picture_hash(const struct sph_frame *frame) {
    return hash_frame(frame, 0);
}

void sph_frame_free(struct sph_frame *frame) {
    free(frame->pixels);
    frame->pixels = NULL;
}
