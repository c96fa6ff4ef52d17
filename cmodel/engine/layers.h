/* layers.h - what compositing programs ask of a pixel besides its colour
 * SPDX-License-Identifier: Apache-2.0
 *
 * Made of what the frame has of the primary hit; the hardware does not give it.
 */
#ifndef SPH_LAYERS_H
#define SPH_LAYERS_H

#include "core/frame.h"
#include "machine/machine.h"

struct sph_layer {
    float depth;     /* along the view, in units of the scene; infinite: nothing is hit */
    float distance;  /* from the eye, the same */
    float normal[3]; /* of length 1, in the scene's frame, towards the eye; 0: nothing is hit */
    float albedo[3]; /* of the material, 0..1, without its image */
    float level;     /* of the image that is seen first, 0: whole size; -1: none */
};

/* 0xBBGGRR of a pixel that so many surfaces one after another made: Aroxa 2014, Figure 4.2f. */
extern const uint32_t sph_depth_colours[SPH_MAX_DEPTH + 2];

/* Of the pixel x, y. */
struct sph_layer sph_layer_of(const struct sph_machine *m, const struct sph_pixel *pixel, int x,
                              int y);

/* A layer for each pixel of a frame that the machine drew, to be freed. NULL: memory is out. */
struct sph_layer *sph_layers_of(const struct sph_machine *m, const struct sph_frame *frame);

#endif
