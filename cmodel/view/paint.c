/* paint.c - see paint.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "view/paint.h"

#include <math.h>
#include <stdlib.h>

#include "engine/layers.h"
#include "image/image.h"

enum {
    AMPLIFY = 16,
    HOTTEST = 1024, /* visits */
    SMALLEST = 8    /* level */
};
static const uint32_t no_level = 0x404040;

uint8_t *view_paint_table(struct sph_error *err) {
    uint8_t *bytes = malloc(VIEW_LIGHTS);
    if (!bytes) sph_fail(err, "no memory for the light of a picture");
    for (int i = 0; bytes && i < VIEW_LIGHTS; i++)
        bytes[i] = sph_linear_byte((float)fmin(i / 256.0, 255), SPH_TRANSFER_SRGB);
    return bytes;
}

static uint32_t rgb(int r, int g, int b) {
    return (uint32_t)r | (uint32_t)g << 8 | (uint32_t)b << 16;
}

static int byte(double part) {
    return (int)lround(255 * fmax(0, fmin(1, part)));
}

uint32_t view_heat(double part) {
    static const int ends[][3] = {{0, 0, 0},     {0, 0, 255}, {0, 255, 255},  {0, 255, 0},
                                  {255, 255, 0}, {255, 0, 0}, {255, 255, 255}};
    int steps = (int)(sizeof ends / sizeof *ends) - 1, from[3];
    double at = fmax(0, fmin(1, part)) * steps;
    int i = at < steps ? (int)at : steps - 1;
    for (int c = 0; c < 3; c++)
        from[c] = (int)lround(ends[i][c] + (at - i) * (ends[i + 1][c] - ends[i][c]));
    return rgb(from[0], from[1], from[2]);
}

/* As sph_image_write_difference() has it. */
static uint32_t difference(const struct view_truth *truth, const struct view_cell *cell) {
    int by[3], any = 0;
    for (int c = 0; c < 3; c++) {
        int a = (int)(truth->colour >> 8 * c & 255);
        int off = abs(a - (int)(cell->colour[SPH_FRAMES - 1] >> 8 * c & 255));
        by[c] = AMPLIFY * off < 255 ? AMPLIFY * off : 255;
        any |= off;
    }
    return any ? rgb(by[0], by[1], by[2]) : truth->id != cell->id ? rgb(0, 0, 255) : 0;
}

uint32_t view_paint(const struct view_paint *how, const struct view_cell *cell, size_t at) {
    const uint16_t *light = cell->light[how->layer < SPH_FRAMES ? how->layer : SPH_FRAMES - 1];
    int hit = isfinite(cell->distance), grey;
    switch (how->layer) {
    case VIEW_DEPTHS:
        return sph_depth_colours[cell->depth];
    case VIEW_VISITS:
        return view_heat(log2(1.0 + cell->visits) / log2(1.0 + HOTTEST));
    case VIEW_LEVELS:
        return cell->level < 0 ? no_level : view_heat(cell->level / SMALLEST);
    case VIEW_NORMALS:
        if (!hit) return 0;
        return rgb(byte((1 + cell->normal[0]) / 2), byte((1 + cell->normal[1]) / 2),
                   byte((1 + cell->normal[2]) / 2));
    case VIEW_DISTANCE:
        grey = hit ? byte(how->distance / (how->distance + cell->distance)) : 0;
        return rgb(grey, grey, grey);
    case VIEW_DIFFERENCE:
        if (how->truth) return difference(&how->truth[at], cell);
        break; /* light, until it is known */
    default:
        break;
    }
    return rgb(how->srgb[light[0]], how->srgb[light[1]], how->srgb[light[2]]);
}
