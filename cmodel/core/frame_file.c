/* frame_file.c - see frame_file.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "core/frame_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/fnv.h"
#include "common/input.h"
#include "common/output.h"

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
