/* paint.h - what is known of a pixel, and its colour in each layer
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_VIEW_PAINT_H
#define SPH_VIEW_PAINT_H

#include <stdint.h>

#include "common/error.h"
#include "machine/layout.h"
#include "view/keys.h"

/* A pixel as the workers leave it: enough for every layer, so that another one asks for no ray. */
struct view_cell {
    uint32_t colour[SPH_FRAMES];   /* 0xBBGGRR, as a frame has them */
    uint16_t light[SPH_FRAMES][3]; /* u8.8, what the colours are rounded from */
    uint32_t id, visits;           /* as a frame has them */
    float normal[3];               /* scene's frame; 0: nothing is hit */
    float distance;                /* scene units along the ray; infinite: nothing is hit */
    float level;                   /* of layers.h */
    uint8_t depth;                 /* surfaces one after another */
};

/* What the double reference says of a pixel. */
struct view_truth {
    uint32_t colour, id; /* of the deepest layer */
};

struct view_paint {
    int layer;                      /* VIEW_* of keys.h */
    double distance;                /* that is half bright */
    const uint8_t *srgb;            /* of light u8.8 as a byte: view_paint_table() */
    const struct view_truth *truth; /* of the same camera, NULL: not yet known */
};

enum { VIEW_LIGHTS = 65536 };

/* The table, to be freed: the bytes that `sphaera render` writes. NULL with a message. */
uint8_t *view_paint_table(struct sph_error *err);

/* 0xBBGGRR of the cell at place `at` of the frame. */
uint32_t view_paint(const struct view_paint *how, const struct view_cell *cell, size_t at);

/* A colour for 0 .. 1: black, blue, cyan, green, yellow, red, white; beyond that the ends. */
uint32_t view_heat(double part);

#endif
