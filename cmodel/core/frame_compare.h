/* frame_compare.h - frame against frame, exactly
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_FRAME_COMPARE_H
#define SPH_FRAME_COMPARE_H

#include <stdint.h>
#include <stdio.h>

#include "core/frame_file.h"

struct sph_frame_difference {
    int size_differs;    /* then nothing else was compared */
    uint64_t pixels;     /* pixels with any field different */
    int x, y;            /* the first of them, row by row */
    uint32_t max_colour; /* largest difference of a colour byte in any of the frames */
    uint32_t counters;   /* bit i: counter i differs; only those that both sides must have */
    uint32_t errors;     /* error bits that only one side has */
};

/* Compares size first, then every field of every pixel, counters and error bits; with
 * ignore_work neither visits, sums of texel addresses nor counters, which another tree or traversal
 * changes. Returns 1 if anything differs, else 0. */
int sph_shot_compare(const struct sph_shot *a, const struct sph_shot *b, int ignore_work,
                     struct sph_frame_difference *d);

/* Says in words what differs, the first pixel field by field. name_a and name_b head the columns.
 */
void sph_shot_explain(const struct sph_shot *a, const struct sph_shot *b,
                      const struct sph_frame_difference *d, const char *name_a, const char *name_b,
                      FILE *file);

#endif
