/* cell.c - one pixel of the live view, by the golden model; see workers.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>

#include "engine/layers.h"
#include "engine/render_pixel.h"
#include "fast/pixel.h"
#include "pixel/background.h"
#include "view/workers.h"

/* Scene units along the primary ray. */
static float distance(const struct sph_machine *m, uint64_t key, int x, int y) {
    int64_t d[3];
    if (!key) return INFINITY;
    sph_primary_dir(m, x, y, d);
    double length = sqrt((double)(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]));
    return (float)ldexp((double)key / length, m->grid_log2); /* key / a * length */
}

void view_cell_draw(struct sph_machine *m, const struct view_aim *aim,
                    const struct sph_render_options *how, int x, int y, struct view_cell *cell) {
    struct sph_counters counters = {{0}};
    struct sph_trail trail;
    uint32_t errors = 0;
    view_aim_pixel(aim, x, y, m);
    int fast = how->fast && sph_fast_shades(m);
    struct sph_pixel pixel =
        (fast ? sph_fast_pixel : sph_render_pixel)(m, how, x, y, &counters, &errors, &trail);
    struct sph_layer layer = sph_layer_of(m, &pixel, x, y);
    *cell = (struct view_cell){.id = pixel.id,
                               .visits = pixel.visits,
                               .distance = distance(m, pixel.key, x, y),
                               .level = layer.level,
                               .depth = (uint8_t)trail.depth};
    for (int f = 0; f < SPH_FRAMES; f++) {
        cell->colour[f] = pixel.colour[f];
        for (int c = 0; c < 3; c++)
            cell->light[f][c] = (uint16_t)trail.sum[f][c];
    }
    for (int i = 0; i < 3; i++)
        cell->normal[i] = layer.normal[i];
}
