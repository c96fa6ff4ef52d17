/* record.c - see record.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "view/record.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "image/video.h"

struct view_record {
    struct sph_video *video;
    double start; /* of the video; 0: nothing was shown */
    long written;
    size_t size;
    uint32_t *shown; /* until the next one */
};

struct view_record *view_record_open(const char *path, int width, int height,
                                     struct sph_error *err) {
    struct view_record *r = calloc(1, sizeof *r);
    size_t size = (size_t)width * (size_t)height * sizeof *r->shown;
    if (r) *r = (struct view_record){.size = size, .shown = malloc(size)};
    if (r && r->shown) r->video = sph_video_open(path, width, height, VIEW_RATE, err);
    if (r && r->video) {
        printf("record   %s\n", sph_video_how(r->video));
        fflush(stdout);
        return r;
    }
    sph_fail(err, "%s: no memory for a video", path);
    if (r) free(r->shown);
    free(r);
    return NULL;
}

int view_record_add(struct view_record *r, const uint32_t *pixels, double now,
                    struct sph_error *err) {
    if (r->start <= 0) r->start = now;
    long due = (long)((now - r->start) * VIEW_RATE) + 1;
    int rc = 0;
    /* what was shown until now, and then at least the first of the new ones */
    for (; !rc && r->written && r->written < due - 1; r->written++)
        rc = sph_video_add(r->video, r->shown, err);
    memcpy(r->shown, pixels, r->size);
    if (!rc && r->written < due) {
        rc = sph_video_add(r->video, pixels, err);
        r->written++;
    }
    return rc;
}

int view_record_close(struct view_record *r, int failed, struct sph_error *err) {
    int rc = failed;
    if (!rc && r->written) rc = sph_video_add(r->video, r->shown, err); /* the last one as well */
    rc = sph_video_close(r->video, rc, err);
    free(r->shown);
    free(r);
    return rc;
}
