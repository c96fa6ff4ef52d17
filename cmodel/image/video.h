/* video.h - pictures one after another into a video, by the program ffmpeg
 * SPDX-License-Identifier: Apache-2.0
 *
 * Where ffmpeg is not installed, or the name ends as one of a picture, they become numbered
 * pictures, NAME-0000.png and so on.
 */
#ifndef SPH_VIDEO_H
#define SPH_VIDEO_H

#include <stdint.h>

#include "common/error.h"

struct sph_video;

/* Whether ffmpeg is installed. */
int sph_video_can(void);

/* Starts a video of width x height pixels and so many pictures a second in the file at path, whose
 * ending says its format. NULL with a message. */
struct sph_video *sph_video_open(const char *path, int width, int height, double rate,
                                 struct sph_error *err);

/* What is written: "PATH, by ffmpeg", or the names of pictures and why. */
const char *sph_video_how(const struct sph_video *video);

/* The next picture, pixels of 0xBBGGRR, row 0 on top. 0, or -1 with a message. */
int sph_video_add(struct sph_video *video, const uint32_t *pixels, struct sph_error *err);

/* Ends the video, which gets its name only now; with failed != 0 it is removed. 0, or -1 (with a
 * message unless failed). */
int sph_video_close(struct sph_video *video, int failed, struct sph_error *err);

#endif
