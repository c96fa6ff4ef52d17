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
    float normal[3]; /* of length 1, in the scene's frame, towards the eye; 0: nothing is hit */
    float albedo[3]; /* of the material, 0..1, without its image */
    float level;     /* of the image that is seen first, 0: whole size; -1: none */
};

/* A layer for each pixel of a frame that the machine drew, to be freed. NULL: memory is out. */
struct sph_layer *sph_layers_of(const struct sph_machine *m, const struct sph_frame *frame);

#endif
