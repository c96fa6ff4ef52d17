/* outputs.h - files that a command writes, and what they may not overwrite
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TOOL_OUTPUTS_H
#define SPH_TOOL_OUTPUTS_H

#include <argp.h>
#include <stdio.h>

#include "error.h"
#include "scene/scene.h"

/* The most files that a command writes, sequences counted once. */
enum { TOOL_OUTPUTS = 16 };

struct tool_outputs {
    const char *path[TOOL_OUTPUTS];
    int n;
    int key[TOOL_OUTPUTS]; /* of the option, negative of a second file: the last one given counts */
};

/* Notes a file that an option will write ("-": standard output), and returns its name. */
const char *tool_output(struct tool_outputs *outputs, int key, const char *path);

/* Where text for people goes: standard output, or standard error if a file goes there. */
FILE *tool_text(void);

/* Formats of a picture: those without loss, OpenEXR, and all of light, JPEG too. */
enum { TOOL_EXACT, TOOL_EXR, TOOL_LIGHT };

/* The same for a picture. The name's ending says the format, one of kinds, TOOL_*; another is a
 * usage error. */
const char *tool_picture(const struct argp_state *state, struct tool_outputs *outputs, int key,
                         const char *option, const char *path, int kinds);

/* 0 if no output is the file at `input` or that of another option, else -1 with a message that
 * names both. Two names of one file count as the same; what is no regular file is never
 * overwritten. */
int tool_spares(const struct tool_outputs *outputs, const char *input, struct sph_error *err);

/* The same for the images of a scene and the files that it includes. */
int tool_spares_images(const struct tool_outputs *outputs, const struct sph_scene *scene,
                       struct sph_error *err);

#endif
