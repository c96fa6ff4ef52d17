/* record.h - what the live view shows, as a video in real time
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_VIEW_RECORD_H
#define SPH_VIEW_RECORD_H

#include <stdint.h>

#include "common/error.h"

enum { VIEW_RATE = 25 }; /* pictures a second of the video */

struct view_record;

/* Starts a video (image/video.h), and says on standard output what is written. NULL with a
 * message. */
struct view_record *view_record_open(const char *path, int width, int height,
                                     struct sph_error *err);

/* The window shows this from now on, a time in seconds. 0, or -1 with a message. */
int view_record_add(struct view_record *record, const uint32_t *pixels, double now,
                    struct sph_error *err);

/* Ends it, as sph_video_close(). */
int view_record_close(struct view_record *record, int failed, struct sph_error *err);

#endif
