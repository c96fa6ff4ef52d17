/* depth_picture.h - how many surfaces behind one another made a pixel, as colours
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TOOL_DEPTH_PICTURE_H
#define SPH_TOOL_DEPTH_PICTURE_H

#include "render/render.h"

/* A copy of the frame in the colours of Aroxa 2014, Figure 4.2f; sph_frame_free() frees it. trails:
 * one for each pixel. 0, or -1 if memory is out. */
int depth_picture(const struct sph_frame *frame, const struct sph_trail *trails,
                  struct sph_frame *painted);

#endif
