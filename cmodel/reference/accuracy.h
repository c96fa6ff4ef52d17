/* accuracy.h - what a machine's frame gets wrong, by kinds of mistakes
 * SPDX-License-Identifier: Apache-2.0
 *
 * All against the double reference, which sees the scene before quantisation.
 */
#ifndef SPH_ACCURACY_H
#define SPH_ACCURACY_H

#include "machine/machine.h"
#include "reference/reference.h"
#include "engine/render_pixel.h"

/* A render of the model with its trails; ids in both are numbers of the scene. */
struct sph_accuracy_frame {
    const struct sph_machine *machine;
    const struct sph_frame *frame;
    const struct sph_trail *trails; /* as many as pixels */
    const int *lights;              /* number in the scene of each light of the machine */
    double ahead, wider;    /* of the machine's eye: builder/grid/axes.h; 0 and 1 if it stays */
    const uint32_t *places; /* NULL, or where the pixels are: as sph_reference_options has them */
};

/* Makes the machine's ids in frame and trails (as many as pixels) the scene's, which are others
 * where build left something out; numbers: of sph_build_options. */
void sph_accuracy_number(const uint32_t *numbers, struct sph_frame *frame,
                         struct sph_trail *trails);

/* Pixels of the last four are those that see the same sphere in both. */
struct sph_accuracy {
    struct sph_image_error image;
    uint64_t same;      /* pixels that see the same sphere */
    uint64_t shadow;    /* a light that both take to shine on this side is blocked in one alone */
    uint64_t reflected; /* the mirror ray finds another sphere, or none, in one of them */
    uint64_t refracted; /* the refracted ray does */
    double t_worst;     /* distance from the eye along the ray, error in grid units */
    double t_mean;      /* mean of its magnitude */
    int x, y;           /* pixel of t_worst in the machine's frame, -1 if there is none */
};

/* Compares frame and reference of equal size (sizes differ: image.pixels is 0, nothing counts). */
struct sph_accuracy sph_accuracy_measure(const struct sph_accuracy_frame *f,
                                         const struct sph_reference *reference);

#endif
