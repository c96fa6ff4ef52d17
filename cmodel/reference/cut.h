/* cut.h - how much of a picture shows planes beyond the grid of a machine, in a wrong light
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_REFERENCE_CUT_H
#define SPH_REFERENCE_CUT_H

#include "machine/machine.h"
#include "scene/scene.h"

struct sph_cut {
    uint64_t pixels, beyond; /* of the frame; those that see a plane so, sph_ends_show() */
    uint32_t plane;          /* facet of the scene: the one that the most of them see */
    double nearest;          /* the least distance from the eye there, in units of the scene */
    uint64_t sample,
        later; /* pixels of a small frame; those that do so in mirrors or glass alone */
};

/* Looks at the scene as it is written, through the machine's frame and as deep as it follows rays.
 * 0, or -1 with a message if memory is out. */
int sph_cut_measure(const struct sph_scene *scene, const struct sph_machine *machine,
                    struct sph_cut *cut, struct sph_error *err);

#endif
