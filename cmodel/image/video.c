/* video.c - see video.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "image/video.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "common/file.h"
#include "image/image.h"

extern char **environ;

enum { LONGEST = 4096 };

struct sph_video {
    int width, height;
    double rate;
    char path[LONGEST], how[LONGEST + 128];
    struct sph_output out; /* that ffmpeg writes */
    pid_t child;           /* ffmpeg; 0: pictures */
    int to; /* its standard input, a socket: writing to a dead one is an error, no signal */
    unsigned number;
    struct sph_frame frame; /* of a numbered picture */
    uint8_t *rgb;
};

/* Where the ending of a name begins: its dot, or its end. */
static size_t ending(const char *path) {
    const char *slash = strrchr(path, '/'), *dot = strrchr(path, '.');
    return !dot || (slash && dot < slash) ? strlen(path) : (size_t)(dot - path);
}

/* Starts ffmpeg with v->to as its input; errno's number if that fails, ENOENT: not installed. */
static int spawn(struct sph_video *v) {
    int ends[2], error;
    char size[32], rate[32];
    const char *fit = strcasecmp(v->path + ending(v->path), ".gif") != 0
                          ? "pad=ceil(iw/2)*2:ceil(ih/2)*2,format=yuv420p"
                          : "null";
    snprintf(size, sizeof size, "%dx%d", v->width, v->height);
    snprintf(rate, sizeof rate, "%g", v->rate);
    const char *const words[] = {
        "ffmpeg",         "-loglevel", "error",      "-y", "-f", "rawvideo", "-pix_fmt", "rgb24",
        "-video_size",    size,        "-framerate", rate, "-i", "pipe:0",   "-vf",      fit,
        v->out.temporary, NULL};
    char *const *argv = (char *const *)(const void *)words; /* posix_spawn writes to none */
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t plain; /* signals as a program expects them, whatever this one blocks */
    sigset_t none, usual;
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends)) return errno;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], 0);
    sigemptyset(&none);
    sigemptyset(&usual);
    sigaddset(&usual, SIGPIPE);
    sigaddset(&usual, SIGXFSZ);
    posix_spawnattr_init(&plain);
    posix_spawnattr_setsigmask(&plain, &none);
    posix_spawnattr_setsigdefault(&plain, &usual);
    posix_spawnattr_setflags(&plain, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    error = posix_spawnp(&v->child, "ffmpeg", &actions, &plain, argv, environ);
    posix_spawnattr_destroy(&plain);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    v->to = ends[0];
    if (error) close(v->to), v->child = 0;
    return error;
}

/* Whether a program ended well. */
static int ended(pid_t child) {
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR) return 0;
    return WIFEXITED(status) && !WEXITSTATUS(status);
}

int sph_video_can(void) {
    char *const words[] = {"ffmpeg", "-version", NULL};
    posix_spawn_file_actions_t quiet;
    pid_t child;
    if (posix_spawn_file_actions_init(&quiet)) return 0;
    posix_spawn_file_actions_addopen(&quiet, 1, "/dev/null", O_WRONLY, 0);
    int error = posix_spawnp(&child, words[0], &quiet, NULL, words, environ);
    posix_spawn_file_actions_destroy(&quiet);
    return !error && ended(child);
}

struct sph_video *sph_video_open(const char *path, int width, int height, double rate,
                                 struct sph_error *err) {
    struct sph_video *v = calloc(1, sizeof *v);
    size_t pixels = (size_t)width * (size_t)height, stem = ending(path);
    const char *why = "";
    if (v) {
        *v = (struct sph_video){.width = width, .height = height, .rate = rate};
        v->rgb = malloc(3 * pixels);
        v->frame = (struct sph_frame){width, height, calloc(pixels, sizeof *v->frame.pixels)};
    }
    if (!v || !v->rgb || !v->frame.pixels || strlen(path) >= sizeof v->path) {
        sph_fail(err, "%.400s: no memory for a video of %dx%d", path, width, height);
        sph_video_close(v, 1, NULL);
        return NULL;
    }
    snprintf(v->path, sizeof v->path, "%s", path);
    snprintf(v->how, sizeof v->how, "%s, by ffmpeg", path);
    if (!sph_image_format(path, NULL)) {
        char last[LONGEST + 4]; /* ffmpeg goes by it */
        snprintf(last, sizeof last, "tmp%s", path + stem);
        if (sph_output_open_named(&v->out, path, last, err)) {
            sph_video_close(v, 1, NULL);
            return NULL;
        }
        int error = spawn(v);
        if (!error) return v;
        sph_output_close(&v->out, 1, NULL);
        why = error == ENOENT ? ": ffmpeg is not installed" : ": ffmpeg does not start";
    }
    v->path[stem] = 0;
    snprintf(v->how, sizeof v->how, "%s-0000.png and so on%s", v->path, why);
    return v;
}

const char *sph_video_how(const struct sph_video *v) {
    return v->how;
}

static int add_picture(struct sph_video *v, const uint32_t *pixels, struct sph_error *err) {
    char name[LONGEST + 64];
    snprintf(name, sizeof name, "%s-%04u.png", v->path, v->number++);
    for (size_t i = 0; i < (size_t)v->width * (size_t)v->height; i++)
        v->frame.pixels[i].colour[0] = pixels[i] & 0xffffff;
    return sph_image_write(name, &v->frame, 0, err);
}

int sph_video_add(struct sph_video *v, const uint32_t *pixels, struct sph_error *err) {
    size_t n = (size_t)v->width * (size_t)v->height, sent = 0;
    if (!v->child) return add_picture(v, pixels, err);
    for (size_t i = 0; i < 3 * n; i++)
        v->rgb[i] = (uint8_t)(pixels[i / 3] >> 8 * (i % 3));
    while (sent < 3 * n) {
        ssize_t some = send(v->to, v->rgb + sent, 3 * n - sent, MSG_NOSIGNAL);
        if (some < 0 && errno == EINTR) continue;
        if (some < 0) return sph_fail(err, "%.400s: ffmpeg has ended", v->path);
        sent += (size_t)some;
    }
    v->number++;
    return 0;
}

int sph_video_close(struct sph_video *v, int failed, struct sph_error *err) {
    int rc = failed ? -1 : 0;
    if (!v) return rc;
    if (v->child) {
        close(v->to);
        if (!ended(v->child) && !rc) rc = sph_fail(err, "%.400s: ffmpeg failed", v->path);
        rc = sph_output_close(&v->out, rc, err);
    }
    free(v->rgb);
    sph_frame_free(&v->frame);
    free(v);
    return rc;
}
