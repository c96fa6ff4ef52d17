/* background.h - background separation: which pixels are never traced     RTL:
 * rtl/pixel/rt_pixel_scan.v SPDX-License-Identifier: Apache-2.0
 *
 * Borodavka et al. V. Register BG_MODE chooses the way, machine.def draws the words,
 * docs/design/overview.md and docs/results/effects.md explain them.
 */
#ifndef SPH_BACKGROUND_H
#define SPH_BACKGROUND_H

#include "machine/machine.h"

/* 1 if the spans or cones that BG_MODE asks for do not lie in memory: every pixel is traced then,
 * and the frame has the sticky error BAD_NODE. */
int sph_background_missing(const struct sph_machine *m);

/* 1 if the background separation says that pixel x, y (0 .. 16383) sees no sphere. */
int sph_is_background(const struct sph_machine *m, int x, int y);

#endif
