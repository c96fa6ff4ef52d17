/* walk_picture.h - what primary rays meet of a hierarchy, as a picture
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TOOL_WALK_PICTURE_H
#define SPH_TOOL_WALK_PICTURE_H

#include "core/frame.h"
#include "machine/machine.h"

/* Aroxa 2014, Figure 4.3: writes the colours of `layer` with a fifth more green for every inner
 * node of which the pixel's primary ray meets no child, and a fifth more blue for every node that
 * it visits. The machine has a BIH. 0, or -1 with a message. */
int walk_picture(const char *path, const struct sph_machine *m, const struct sph_frame *frame,
                 int layer, struct sph_error *err);

#endif
