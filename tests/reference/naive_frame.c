/* naive_frame.c - the picture of a machine, drawn by the naive model and by the golden one
 * SPDX-License-Identifier: Apache-2.0
 *
 * usage: naive-frame [--golden] [--poke=LINE:LSB:WIDTH=VALUE]... FILE.sph...
 *
 * Prints `FILE HASH`, the hash of the naive model's picture as `sphaera render` has it for the
 * golden one. Exit code 1: some pixel of the golden model has other colours, id, key or texels; the
 * first is shown. With --golden only the golden model draws. --poke is that of sim/core.sh.
 */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/number.h"
#include "render/render.h"
#include "naive/naive.h"
#include "validate/validate.h"

static int differ(const struct sph_pixel *a, const struct sph_pixel *b) {
    return a->id != b->id || a->key != b->key || a->texture != b->texture ||
           memcmp(a->colour, b->colour, sizeof a->colour);
}

static void show(const char *who, const struct sph_pixel *p) {
    printf("  %s: id %" PRIu32 " key %" PRIu64 " colours %06" PRIx32 " %06" PRIx32 " %06" PRIx32
           " texture %08" PRIx32 "\n",
           who, p->id, p->key, p->colour[0], p->colour[1], p->colour[2], p->texture);
}

enum { POKES = 8 };

/* What overwrites the memory of the machines that are drawn. */
static struct poke { uint64_t line, lsb, width, value; } pokes[POKES];
static int n_pokes;

static int poke_read(const char *text) {
    struct poke *p = &pokes[n_pokes];
    if (n_pokes == POKES || sph_take_count(&text, 0, UINT32_MAX, &p->line) ||
        sph_take_char(&text, ':') || sph_take_count(&text, 0, 255, &p->lsb) ||
        sph_take_char(&text, ':') || sph_take_count(&text, 1, 32, &p->width) ||
        sph_take_char(&text, '=') || sph_take_count(&text, 0, UINT32_MAX, &p->value) || *text ||
        p->lsb + p->width > 256)
        return -1;
    return n_pokes++;
}

static int poke(struct sph_machine *m, struct sph_error *err) {
    for (int i = 0; i < n_pokes; i++) {
        const struct poke *p = &pokes[i];
        if (p->line >= m->lines)
            return sph_fail(err, "--poke: there is no line %" PRIu64 " of memory", p->line);
        sph_field_set(m->mem + (size_t)SPH_LINE_WORDS * p->line, (int)p->lsb, (int)p->width,
                      (uint32_t)p->value);
    }
    return 0;
}

/* Pixels that differ, or -1. */
static int frame(const char *path, int golden_only, struct sph_error *err) {
    struct sph_machine m;
    struct sph_render_options options = {.traverse = SPH_TRAVERSE_TREE, .threads = 1};
    struct sph_counters counters = {0};
    struct sph_frame golden, naive;
    int wrong = 0;
    if (sph_machine_read(path, &m, err)) return -1;
    if (poke(&m, err) || sph_render(&m, &options, &golden, &counters, err) < 0) {
        sph_machine_free(&m);
        return -1;
    }
    naive = golden;
    naive.pixels = calloc((size_t)(golden.width * golden.height), sizeof *naive.pixels);
    for (int i = 0; naive.pixels && !golden_only && i < golden.width * golden.height; i++) {
        naive.pixels[i] = sph_naive_pixel(&m, i % golden.width, i / golden.width);
        if (!differ(&golden.pixels[i], &naive.pixels[i])) continue;
        if (!wrong++) {
            printf("%s: pixel %d, %d\n", path, i % golden.width, i / golden.width);
            show("golden", &golden.pixels[i]);
            show("naive", &naive.pixels[i]);
        }
    }
    if (wrong) printf("%s: %d mismatches\n", path, wrong);
    printf("%s %016" PRIx64 "\n", path, sph_frame_picture_hash(golden_only ? &golden : &naive));
    free(naive.pixels);
    sph_frame_free(&golden);
    sph_machine_free(&m);
    return wrong;
}

int main(int argc, char **argv) {
    int only = 0, bad = 0;
    for (int i = 1; i < argc; i++) {
        if (!strcmp(argv[i], "--golden")) {
            only = 1;
            continue;
        }
        if (!strncmp(argv[i], "--poke=", 7)) {
            if (poke_read(argv[i] + 7) >= 0) continue;
            fprintf(stderr, "naive-frame: %s: LINE:LSB:WIDTH=VALUE, at most %d\n", argv[i], POKES);
            return 2;
        }
        struct sph_error err = {{0}};
        int wrong = frame(argv[i], only, &err);
        if (wrong < 0) fprintf(stderr, "naive-frame: %s\n", err.text);
        if (wrong < 0) return 2;
        bad |= wrong > 0;
    }
    return bad;
}
