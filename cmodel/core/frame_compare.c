/* frame_compare.c - see frame_compare.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "core/frame_compare.h"

#include <inttypes.h>

static const char *const counter_names[] = {SPH_COUNTER_NAMES};
static const char *const error_names[] = {SPH_ERROR_NAMES};

static uint32_t byte_difference(uint32_t a, uint32_t b) {
    uint32_t most = 0;
    for (int shift = 0; shift < 32; shift += 8) {
        uint32_t x = a >> shift & 255, y = b >> shift & 255, d = x > y ? x - y : y - x;
        if (d > most) most = d;
    }
    return most;
}

int sph_shot_compare(const struct sph_shot *a, const struct sph_shot *b, int ignore_work,
                     struct sph_frame_difference *d) {
    *d = (struct sph_frame_difference){.x = -1, .y = -1};
    const struct sph_frame *fa = &a->frame, *fb = &b->frame;
    if (fa->width != fb->width || fa->height != fb->height) return d->size_differs = 1;
    size_t n = (size_t)fa->width * (size_t)fa->height;
    for (size_t i = 0; i < n; i++) {
        const struct sph_pixel *p = &fa->pixels[i], *q = &fb->pixels[i];
        int differs = p->id != q->id || p->key != q->key;
        if (!ignore_work && (p->visits != q->visits || p->texture != q->texture)) differs = 1;
        if (p->texture >> SPH_LOD_LSB != q->texture >> SPH_LOD_LSB) differs = 1;
        for (int f = 0; f < SPH_FRAMES; f++) {
            uint32_t by = byte_difference(p->colour[f], q->colour[f]);
            if (by) differs = 1;
            if (by > d->max_colour) d->max_colour = by;
        }
        if (differs && !d->pixels++) {
            d->x = (int)(i % (size_t)fa->width);
            d->y = (int)(i / (size_t)fa->width);
        }
    }
    for (int i = 0; i < SPH_COUNTERS && !ignore_work; i++)
        if (sph_counter_both(i) && a->counters.count[i] != b->counters.count[i])
            d->counters |= 1u << i;
    d->errors = a->errors ^ b->errors;
    return d->pixels || d->counters || d->errors;
}

static void explain_pixel(const struct sph_pixel *p, const struct sph_pixel *q, const char *name_a,
                          const char *name_b, FILE *file) {
    fprintf(file, "  %-10s %18.18s %18.18s\n", "", name_a, name_b);
    for (int f = 0; f < SPH_FRAMES; f++)
        fprintf(file, "  colour[%d]  %#18.6" PRIx32 " %#18.6" PRIx32 "%s\n", f, p->colour[f],
                q->colour[f], p->colour[f] != q->colour[f] ? " *" : "");
    fprintf(file, "  %-10s %#18" PRIx32 " %#18" PRIx32 "%s\n", "id", p->id, q->id,
            p->id != q->id ? " *" : "");
    fprintf(file, "  %-10s %#18" PRIx64 " %#18" PRIx64 "%s\n", "key", p->key, q->key,
            p->key != q->key ? " *" : "");
    fprintf(file, "  %-10s %18" PRIu32 " %18" PRIu32 "%s\n", "visits", p->visits, q->visits,
            p->visits != q->visits ? " *" : "");
    fprintf(file, "  %-10s %#18" PRIx32 " %#18" PRIx32 "%s\n", "texture", p->texture, q->texture,
            p->texture != q->texture ? " *" : "");
}

void sph_shot_explain(const struct sph_shot *a, const struct sph_shot *b,
                      const struct sph_frame_difference *d, const char *name_a, const char *name_b,
                      FILE *file) {
    const struct sph_frame *fa = &a->frame, *fb = &b->frame;
    if (d->size_differs) {
        fprintf(file, "sizes differ: %dx%d and %dx%d\n", fa->width, fa->height, fb->width,
                fb->height);
        return;
    }
    uint64_t n = (uint64_t)fa->width * (uint64_t)fa->height;
    fprintf(file, "%" PRIu64 " of %" PRIu64 " pixels differ, colours by up to %" PRIu32 "\n",
            d->pixels, n, d->max_colour);
    if (d->pixels) {
        size_t at = (size_t)d->y * (size_t)fa->width + (size_t)d->x;
        fprintf(file, "first at x %d y %d:\n", d->x, d->y);
        explain_pixel(&fa->pixels[at], &fb->pixels[at], name_a, name_b, file);
    }
    for (int i = 0; i < SPH_COUNTERS; i++)
        if (d->counters >> i & 1)
            fprintf(file, "counter %s: %" PRIu64 " and %" PRIu64 "\n", counter_names[i],
                    a->counters.count[i], b->counters.count[i]);
    for (int i = 0; i < SPH_ERRORS; i++)
        if (d->errors >> i & 1)
            fprintf(file, "error %s: only in %s\n", error_names[i],
                    a->errors >> i & 1 ? name_a : name_b);
}
