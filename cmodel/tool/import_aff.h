/* import_aff.h - AFF scenes into NFF scenes of one frame each
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TOOL_IMPORT_AFF_H
#define SPH_TOOL_IMPORT_AFF_H

#include "tool/sequence.h"

struct tool_import_aff {
    struct sph_read_options read;
    struct tool_frames frames;
    int width, height;  /* 0: the scene's */
    const char *output; /* NULL: standard output */
    const struct tool_outputs *outputs;
};

/* Writes the AFF scene at path as NFF, or each frame into a file of its own; names of images become
 * absolute. 0, or -1 with a message. */
int tool_import_aff(const char *path, const struct tool_import_aff *how, struct sph_error *err);

#endif
