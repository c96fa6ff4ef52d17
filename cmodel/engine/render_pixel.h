/* render_pixel.h - one pixel of the golden model, from ray to colours
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_RENDER_PIXEL_H
#define SPH_RENDER_PIXEL_H

#include "core/render.h"

/* Renders pixel x, y; adds to *c and to the sticky *errors. Of the options traverse and fetch
 * count. trail may be NULL. */
struct sph_pixel sph_render_pixel(const struct sph_machine *m, const struct sph_render_options *o,
                                  int x, int y, struct sph_counters *c, uint32_t *errors,
                                  struct sph_trail *trail);

#endif
