/* pictures.h - the pictures that people look at, of a frame
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TOOL_PICTURES_H
#define SPH_TOOL_PICTURES_H

#include "common/error.h"
#include "core/frame.h"
#include "core/trail.h"
#include "machine/machine.h"
#include "render/render.h"
#include "tool/tool.h"

/* ---- many pictures in one file that moves ---- */
/* By the ending of its name: .gif, of 256 colours a frame, which OpenImageIO writes; .mp4, H.264,
 * which the program ffmpeg makes where it is installed (`make movie-setup`). */

enum { MOVIE_RATE = 25 }; /* frames a second if nothing is asked for */

/* Is path such a file, by its ending? */
int movie_is(const char *path);

/* 0 if it could be written here, -1 with a message if a program is missing. */
int movie_check(const char *path, struct sph_error *err);

/* Writes n >= 1 pictures of one size, 8-bit RGB. 0, or -1 with a message and no file. */
int movie_write(const char *path, const char *const *pictures, int n, double rate,
                struct sph_error *err);

struct light_pictures {
    const char *picture, *exr; /* files, NULL: none */
    int layer, transfer;       /* of the frame's colours; SPH_TRANSFER_*, of picture */
    int depths;                /* 1: false colours, how many surfaces made the pixel */
};

extern const char *const tool_transfer_names[]; /* SPH_TRANSFER_*, then NULL */

/* What `-o` writes, for --help. */
#define TOOL_OUTPUT_TEXT                                                                           \
    "picture, 8-bit RGB: .png, .tif, .ppm, .bmp, .tga, .jpg; or .exr, as --exr does"

/* Keys of the options that fill it in, beside 'o'. */
enum { TOOL_KEY_EXR = 1024, TOOL_KEY_LAYER, TOOL_KEY_TRANSFER };

/* Takes such an option; ARGP_ERR_UNKNOWN if it is another. */
error_t light_option(struct light_pictures *how, struct tool_outputs *outputs, int key, char *arg,
                     struct argp_state *state);

/* Writes them, of samples x samples of the frame's pixels each. trails: as many as pixels. m: that
 * drew it, NULL: none. 0, or -1 with a message. */
int light_picture(const struct light_pictures *how, int samples, const struct sph_machine *m,
                  const struct sph_frame *frame, const struct sph_trail *trails,
                  struct sph_error *err);

/* A copy of the frame in the colours of Aroxa 2014, Figure 4.2f; sph_frame_free() frees it. trails:
 * one for each pixel. 0, or -1 if memory is out. */
int depth_picture(const struct sph_frame *frame, const struct sph_trail *trails,
                  struct sph_frame *painted);

/* Aroxa 2014, Figure 4.3: writes the colours of `layer` with a fifth more green for every inner
 * node of which the pixel's primary ray meets no child, and a fifth more blue for every node that
 * it visits. The machine has a BIH. 0, or -1 with a message. */
int walk_picture(const char *path, const struct sph_machine *m, const struct sph_frame *frame,
                 int layer, struct sph_error *err);

#endif
