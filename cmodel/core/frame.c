/* frame.c - see frame.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "core/frame.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/fnv.h"
#include "common/file.h"

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

/* ---- frame_file ---- */

enum { VERSION = 2, MAX_SIDE = 65536, PIXEL_BYTES = 4 * (SPH_FRAMES + 3) + 8 };
static const char magic[8] = {'S', 'P', 'H', 'F', 'R', 'A', 'M', 'E'};

/* A file and the running hash of what went through it. */
struct stream {
    FILE *file;
    uint64_t hash;
    int bad;
};

static void write_bytes(struct stream *s, uint64_t value, int bytes) {
    for (int i = 0; i < bytes; i++)
        if (putc((int)(value >> 8 * i & 255), s->file) == EOF) s->bad = 1;
    s->hash = sph_fnv(s->hash, value, bytes);
}

static uint64_t read_bytes(struct stream *s, int bytes) {
    uint64_t value = 0;
    for (int i = 0; i < bytes; i++) {
        int c = getc(s->file);
        if (c == EOF) return s->bad = 1, 0;
        value |= (uint64_t)c << 8 * i;
    }
    s->hash = sph_fnv(s->hash, value, bytes);
    return value;
}

int sph_shot_write(const struct sph_shot *shot, const char *path, struct sph_error *err) {
    struct sph_output out;
    if (sph_output_open(&out, path, err)) return -1;
    struct stream s = {out.file, SPH_FNV_START, 0};
    const struct sph_frame *f = &shot->frame;
    for (size_t i = 0; i < sizeof magic; i++)
        write_bytes(&s, (uint64_t)magic[i], 1);
    const uint32_t head[] = {VERSION,    (uint32_t)f->width, (uint32_t)f->height,
                             SPH_FRAMES, SPH_COUNTERS,       shot->errors};
    for (size_t i = 0; i < sizeof head / sizeof *head; i++)
        write_bytes(&s, head[i], 4);
    for (int i = 0; i < SPH_COUNTERS; i++)
        write_bytes(&s, shot->counters.count[i], 8);
    size_t n = (size_t)f->width * (size_t)f->height;
    for (size_t i = 0; i < n; i++) {
        const struct sph_pixel *p = &f->pixels[i];
        for (int j = 0; j < SPH_FRAMES; j++)
            write_bytes(&s, p->colour[j], 4);
        write_bytes(&s, p->id, 4);
        write_bytes(&s, p->visits, 4);
        write_bytes(&s, p->texture, 4);
        write_bytes(&s, p->key, 8);
    }
    write_bytes(&s, s.hash, 8);
    return sph_output_close(&out, 0, err);
}

/* Whether the file is as long as its header says; what follows may then be believed to be there. */
static int check_bytes(FILE *file, const char *path, long long pixels, struct sph_error *err) {
    long at = ftell(file), bytes = -1;
    if (at >= 0 && !fseek(file, 0, SEEK_END)) bytes = ftell(file);
    if (bytes < 0 || fseek(file, at, SEEK_SET)) return sph_fail(err, "%s: cannot be read", path);
    long long need = at + 8ll * SPH_COUNTERS + PIXEL_BYTES * pixels + 8;
    if (bytes == need) return 0;
    return sph_fail(err, "%s: frame file %s: %ld bytes, %lld by its header", path,
                    bytes < need ? "ends early" : "is too long", bytes, need);
}

static int read_head(struct stream *s, const char *path, struct sph_shot *shot,
                     struct sph_error *err) {
    char found[sizeof magic];
    for (size_t i = 0; i < sizeof magic; i++)
        found[i] = (char)read_bytes(s, 1);
    if (s->bad || memcmp(found, magic, sizeof magic))
        return sph_fail(err, "%s: not a frame file", path);
    uint32_t version = (uint32_t)read_bytes(s, 4), width = (uint32_t)read_bytes(s, 4);
    uint32_t height = (uint32_t)read_bytes(s, 4), frames = (uint32_t)read_bytes(s, 4);
    uint32_t counters = (uint32_t)read_bytes(s, 4);
    shot->errors = (uint32_t)read_bytes(s, 4);
    if (s->bad) return sph_fail(err, "%s: frame file ends in its header", path);
    if (version != VERSION || frames != SPH_FRAMES || counters != SPH_COUNTERS)
        return sph_fail(err, "%s: frame file of version %u with %u frames and %u counters", path,
                        version, frames, counters);
    if (!width || !height || width > MAX_SIDE || height > MAX_SIDE)
        return sph_fail(err, "%s: frame size %ux%u", path, width, height);
    shot->frame.width = (int)width;
    shot->frame.height = (int)height;
    return check_bytes(s->file, path, (long long)width * height, err);
}

static int read_all(struct stream *s, const char *path, struct sph_shot *shot,
                    struct sph_error *err) {
    if (read_head(s, path, shot, err)) return -1;
    for (int i = 0; i < SPH_COUNTERS; i++)
        shot->counters.count[i] = read_bytes(s, 8);
    size_t n = (size_t)shot->frame.width * (size_t)shot->frame.height;
    shot->frame.pixels = calloc(n, sizeof *shot->frame.pixels);
    if (!shot->frame.pixels) return sph_fail(err, "%s: no memory for the frame", path);
    for (size_t i = 0; i < n && !s->bad; i++) {
        struct sph_pixel *p = &shot->frame.pixels[i];
        for (int j = 0; j < SPH_FRAMES; j++)
            p->colour[j] = (uint32_t)read_bytes(s, 4);
        p->id = (uint32_t)read_bytes(s, 4);
        p->visits = (uint32_t)read_bytes(s, 4);
        p->texture = (uint32_t)read_bytes(s, 4);
        p->key = read_bytes(s, 8);
    }
    uint64_t hash = s->hash;
    if (read_bytes(s, 8) != hash && !s->bad)
        return sph_fail(err, "%s: frame file is damaged (checksum)", path);
    if (s->bad) return sph_fail(err, "%s: frame file ends early", path);
    return 0;
}

int sph_shot_read(const char *path, struct sph_shot *shot, struct sph_error *err) {
    memset(shot, 0, sizeof *shot);
    FILE *file = sph_input_open(path, SPH_INPUT_ANY, err);
    if (!file) return -1;
    struct stream s = {file, SPH_FNV_START, 0};
    int rc = read_all(&s, path, shot, err);
    fclose(file);
    if (rc) {
        free(shot->frame.pixels);
        shot->frame.pixels = NULL;
    }
    return rc;
}

/* ---- frame_compare ---- */

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
