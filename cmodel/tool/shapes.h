/* shapes.h - texture caches of every size and shape, beside each other
 * SPDX-License-Identifier: Apache-2.0
 *
 * Shape: how many lines of memory a miss fetches (rt_cache's GROUP), and how many ways there are.
 */
#ifndef SPH_TOOL_SHAPES_H
#define SPH_TOOL_SHAPES_H

#include <jansson.h>
#include <stdint.h>
#include <stdio.h>

#include "memory/cache.h"

/* Sizes are SHAPES_SMALLEST lines of memory, twice that, and so on. */
enum { SHAPES_SIZES = 6, SHAPES_SMALLEST = 8, SHAPES = 9 };

struct shapes {
    struct sph_cache cache[SHAPES][SHAPES_SIZES]; /* without lines: too small to have a set */
};

/* All of 0 before. -1 with a message if memory is out; shapes_end() frees what there is. */
int shapes_start(struct shapes *shapes, struct sph_error *err);

/* Asks all caches for the word at an address. */
void shapes_ask(struct shapes *shapes, uint32_t word);

/* Prints hits and lines of memory fetched per texel unless `to` is NULL; returns the misses. */
json_t *shapes_tell(const struct shapes *shapes, FILE *to);

void shapes_end(struct shapes *shapes);

#endif
