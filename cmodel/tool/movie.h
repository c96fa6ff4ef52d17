/* movie.h - many pictures in one file that moves
 * SPDX-License-Identifier: Apache-2.0
 *
 * By the ending of its name: .gif, of 256 colours a frame, which OpenImageIO writes; .mp4, H.264,
 * which the program ffmpeg makes where it is installed (`make movie-setup`).
 */
#ifndef SPH_TOOL_MOVIE_H
#define SPH_TOOL_MOVIE_H

#include "common/error.h"

enum { MOVIE_RATE = 25 }; /* frames a second if nothing is asked for */

/* Is path such a file, by its ending? */
int movie_is(const char *path);

/* 0 if it could be written here, -1 with a message if a program is missing. */
int movie_check(const char *path, struct sph_error *err);

/* Writes n >= 1 pictures of one size, 8-bit RGB. 0, or -1 with a message and no file. */
int movie_write(const char *path, const char *const *pictures, int n, double rate,
                struct sph_error *err);

#endif
