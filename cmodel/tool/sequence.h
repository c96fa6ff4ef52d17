/* sequence.h - several frames of a moving scene in one run
 * SPDX-License-Identifier: Apache-2.0
 *
 * The scene and its images are read once, and P_b of still primitives is made once; everything else
 * is built for each frame.
 */
#ifndef SPH_TOOL_SEQUENCE_H
#define SPH_TOOL_SEQUENCE_H

#include <jansson.h>

#include "tool/tool.h"

struct tool_frames {
    int on;
    uint32_t first, last;
    int progress; /* shown though stderr is no terminal */
};

/* "A..B" of option --frames, A <= B. */
void tool_frames_parse(const struct argp_state *state, const char *arg, struct tool_frames *frames);

/* What is done with a frame that is built; entry: its part of the report. */
typedef int tool_take(void *user, uint32_t frame, const struct tool_built *built, json_t *entry,
                      struct sph_error *err);

/* Builds each frame of the scene at path and hands it over; user's own. Prints a line for each on
 * `to` unless that is NULL, and adds it to `list`. The first failure ends it: -1 with a message. */
int tool_each_frame(const char *path, const struct tool_source *source,
                    const struct tool_frames *frames, FILE *to, json_t *list, tool_take *take,
                    void *user, struct sph_error *err);

/* The same for frames that `take` writes to the picture *picture, numbered: they are put into one
 * file that moves (pictures.h), and into a folder beside it meanwhile. */
int tool_movie_of(const char *movie, const char **picture, const char *path,
                  const struct tool_source *source, const struct tool_frames *frames, FILE *to,
                  json_t *list, tool_take *take, void *user, struct sph_error *err);

/* path with the frame's number, four digits or more, before its ending: a.png is a-0007.png. NULL
 * stays NULL; else the caller frees. */
char *tool_numbered(const char *path, uint32_t frame);

/* ---- a pair of eyes ---- */

/* Wrong usage if an output is standard output. */
void tool_stereo_check(const struct argp_state *state, const struct tool_outputs *outputs);

/* What a command does with its options; returns its exit code. */
typedef int tool_draw(void *user);

/* Does it for the left and for the right one of two eyes so far apart, scene units, before one
 * screen (--eye-shift): a.png is a-left.png and a-right.png. source: the command's own, and names[]
 * its n files, which are changed meanwhile. The first failure ends it. */
int tool_stereo(double apart, struct tool_source *source, const char **names[], int n,
                tool_draw *draw, void *user);

/* P_b made and kept, and what making took, into a report's object. */
void report_bases(json_t *report, const struct sph_build_report *build);

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
