/* naive_frame.c - the picture of a machine, drawn by the naive model and by the golden one
 * SPDX-License-Identifier: Apache-2.0
 *
 * usage: naive-frame [--golden] FILE.sph...
 *
 * Prints `FILE HASH`, the hash of the naive model's picture as `sphaera render` has it for the
 * golden one. Exit code 1: some pixel of the golden model has other colours, id or key; the first
 * is shown. With --golden only the golden model draws.
 */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "render/render.h"
#include "naive/naive.h"
#include "validate/validate.h"

static int differ(const struct sph_pixel *a, const struct sph_pixel *b) {
    return a->id != b->id || a->key != b->key || a->texture != b->texture ||
           memcmp(a->colour, b->colour, sizeof a->colour);
}

static void show(const char *who, const struct sph_pixel *p) {
    printf("  %s: id %" PRIu32 " key %" PRIu64 " colours %06" PRIx32 " %06" PRIx32 " %06" PRIx32
           "\n",
           who, p->id, p->key, p->colour[0], p->colour[1], p->colour[2]);
}

/* Pixels that differ, or -1. */
static int frame(const char *path, int golden_only, struct sph_error *err) {
    struct sph_machine m;
    struct sph_render_options options = {.traverse = SPH_TRAVERSE_TREE, .threads = 1};
    struct sph_counters counters = {0};
    struct sph_frame golden, naive;
    int wrong = 0;
    if (sph_machine_read(path, &m, err)) return -1;
    if (sph_render(&m, &options, &golden, &counters, err) < 0) {
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
    int only = argc > 1 && !strcmp(argv[1], "--golden"), bad = 0;
    for (int i = 1 + only; i < argc; i++) {
        struct sph_error err = {{0}};
        int wrong = frame(argv[i], only, &err);
        if (wrong < 0) fprintf(stderr, "naive-frame: %s\n", err.text);
        if (wrong < 0) return 2;
        bad |= wrong > 0;
    }
    return bad;
}
