/* pixel.h - a pixel of spheres without images, glass and highlights: what sph_render_pixel() gives
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_FAST_PIXEL_H
#define SPH_FAST_PIXEL_H

#include "engine/render_pixel.h"
#include "fast/fast.h"

/* 1 if sph_fast_pixel() knows every effect that the machine asks for. */
int sph_fast_shades(const struct sph_machine *m);

/* As sph_render_pixel() of such a machine, with o->fast, without a log: textures there are none. */
struct sph_pixel sph_fast_pixel(const struct sph_machine *m, const struct sph_render_options *o,
                                int x, int y, struct sph_counters *c, uint32_t *errors,
                                struct sph_trail *trail);

#endif
