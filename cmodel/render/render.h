/* render.h - the golden model: machine in, frame out, bit by bit what the RTL gives
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_RENDER_H
#define SPH_RENDER_H

#include "common/error.h"
#include "engine/render_pixel.h"

/* Renders the machine's window into *frame (allocated here at the full frame size; pixels outside
 * the window are zero) and adds up *counters. Returns the sticky error bits (1 << SPH_ERROR_*),
 * or -1 with a message if memory is out, or progress() or *stop ended it. */
int sph_render(const struct sph_machine *machine, const struct sph_render_options *options,
               struct sph_frame *frame, struct sph_counters *counters, struct sph_error *err);

#endif
