/* movie.c - see movie.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "tool/movie.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "image/image.h"
#include "image/video.h"

static int ends(const char *path, const char *ending) {
    size_t n = strlen(path), m = strlen(ending);
    return n > m && !strcasecmp(path + n - m, ending);
}

int movie_is(const char *path) {
    return ends(path, ".mp4") || ends(path, ".gif");
}

int movie_check(const char *path, struct sph_error *err) {
    if (!ends(path, ".mp4") || sph_video_can()) return 0;
    return sph_fail(err,
                    "%s: the program ffmpeg is not installed (`make movie-setup`); a .gif or "
                    "numbered .png needs none",
                    path);
}

/* The next picture, of the first one's size. */
static int add(struct sph_video *video, const char *name, const struct sph_image *first,
               const char *first_name, struct sph_error *err) {
    struct sph_image p;
    if (sph_image_read(name, &p, err)) return -1;
    size_t n = (size_t)p.width * (size_t)p.height;
    uint32_t *pixels = malloc(n * sizeof *pixels);
    int same = p.width == first->width && p.height == first->height && p.channels == 3, rc = -1;
    if (!same)
        sph_fail(err, "%s: not %dx%d with 3 channels, as %s has it", name, first->width,
                 first->height, first_name);
    else if (!pixels)
        sph_fail(err, "%s: out of memory", name);
    else {
        for (size_t i = 0; i < n; i++)
            pixels[i] = p.bytes[3 * i] | (uint32_t)p.bytes[3 * i + 1] << 8 |
                        (uint32_t)p.bytes[3 * i + 2] << 16;
        rc = sph_video_add(video, pixels, err);
    }
    free(pixels);
    sph_image_free(&p);
    return rc;
}

static int mp4(const char *path, const char *const *pictures, int n, double rate,
               struct sph_error *err) {
    struct sph_image first;
    if (sph_image_read(pictures[0], &first, err)) return -1;
    free(first.bytes); /* its size is still needed */
    struct sph_video *video = sph_video_open(path, first.width, first.height, rate, err);
    int rc = video ? 0 : -1;
    for (int i = 0; i < n && !rc; i++)
        rc = add(video, pictures[i], &first, pictures[0], err);
    return video ? sph_video_close(video, rc, err) : -1;
}

int movie_write(const char *path, const char *const *pictures, int n, double rate,
                struct sph_error *err) {
    if (movie_check(path, err)) return -1;
    return ends(path, ".mp4") ? mp4(path, pictures, n, rate, err)
                              : sph_image_write_gif(path, pictures, n, rate, err);
}
