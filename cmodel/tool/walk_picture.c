/* walk_picture.c - see walk_picture.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "tool/walk_picture.h"

#include <stdlib.h>
#include <string.h>

#include "image/image.h"
#include "pixel/walk.h"
#include "trace/bih_walk.h"
#include "trace/setup.h"

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
