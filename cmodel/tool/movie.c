/* movie.c - see movie.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "tool/movie.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/wait.h>
#include <unistd.h>

#include "image/image.h"

extern char **environ;

static int ends(const char *path, const char *ending) {
    size_t n = strlen(path), m = strlen(ending);
    return n > m && !strcasecmp(path + n - m, ending);
}

int movie_is(const char *path) {
    return ends(path, ".mp4") || ends(path, ".gif");
}

/* Starts ffmpeg; input: what it reads, -1: nothing. What it prints on stdout is thrown away. */
static int start(char *const *words, int input, pid_t *pid) {
    posix_spawn_file_actions_t files;
    if (posix_spawn_file_actions_init(&files)) return ENOMEM;
    if (input >= 0)
        posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
    else
        posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    int failed = posix_spawnp(pid, words[0], &files, NULL, words, environ);
    posix_spawn_file_actions_destroy(&files);
    return failed;
}

/* Whether the program ended well. */
static int finished(pid_t pid) {
    int status;
    while (waitpid(pid, &status, 0) < 0)
        if (errno != EINTR) return 0;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

int movie_check(const char *path, struct sph_error *err) {
    char *words[] = {"ffmpeg", "-loglevel", "error", "-version", NULL};
    pid_t pid;
    if (!ends(path, ".mp4") || (!start(words, -1, &pid) && finished(pid))) return 0;
    return sph_fail(err,
                    "%s: the program ffmpeg is not installed (`make movie-setup`); a .gif or "
                    "numbered .png needs none",
                    path);
}

/* The bytes of every picture, one behind the other; the first, which is read, has the size. */
static int feed(FILE *to, const char *const *pictures, int n, const struct sph_image *size,
                struct sph_error *err) {
    for (int i = 0; i < n; i++) {
        struct sph_image p;
        if (sph_image_read(pictures[i], &p, err)) return -1;
        int same = p.width == size->width && p.height == size->height && p.channels == 3;
        size_t bytes = (size_t)p.width * (size_t)p.height * (size_t)p.channels;
        int written = same && fwrite(p.bytes, 1, bytes, to) == bytes;
        sph_image_free(&p);
        if (!same)
            return sph_fail(err, "%s: not %dx%d with 3 channels, as %s has it", pictures[i],
                            size->width, size->height, pictures[0]);
        if (!written) return sph_fail(err, "%s: ffmpeg takes no more", pictures[i]);
    }
    return 0;
}

/* Frames with odd sides get a row or a column more: H.264 in 4:2:0 has none. */
static int mp4(const char *path, const char *const *pictures, int n, double rate,
               struct sph_error *err) {
    char size[32], hertz[32], part[4096];
    struct sph_image first;
    int ends_of[2];
    pid_t pid;
    if (sph_image_read(pictures[0], &first, err)) return -1;
    snprintf(size, sizeof size, "%dx%d", first.width, first.height);
    free(first.bytes); /* its size is still needed */
    first.bytes = NULL;
    snprintf(hertz, sizeof hertz, "%g", rate);
    if (snprintf(part, sizeof part, "%s.tmp", path) >= (int)sizeof part)
        return sph_fail(err, "%s: the name is too long", path);
    char *words[] = {"ffmpeg",      "-loglevel", "error",      "-y",
                     "-f",          "rawvideo",  "-pix_fmt",   "rgb24",
                     "-video_size", size,        "-framerate", hertz,
                     "-i",          "-",         "-vf",        "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                     "-pix_fmt",    "yuv420p",   "-f",         "mp4",
                     part,          NULL};
    if (pipe(ends_of)) return sph_fail(err, "%s: %s", path, strerror(errno));
    fcntl(ends_of[1], F_SETFD, FD_CLOEXEC);
    int failed = start(words, ends_of[0], &pid);
    close(ends_of[0]);
    FILE *to = failed ? NULL : fdopen(ends_of[1], "wb");
    if (!to) {
        close(ends_of[1]);
        return failed ? movie_check(path, err) : sph_fail(err, "%s: out of memory", path);
    }
    void (*before)(int) = signal(SIGPIPE, SIG_IGN); /* should ffmpeg end early */
    int rc = feed(to, pictures, n, &first, err);
    if (fclose(to) && !rc) rc = sph_fail(err, "%s: ffmpeg takes no more", path);
    signal(SIGPIPE, before);
    if (!finished(pid) && !rc) rc = sph_fail(err, "%s: ffmpeg failed", path);
    if (!rc && rename(part, path)) rc = sph_fail(err, "%s: %s", path, strerror(errno));
    if (rc) unlink(part);
    return rc;
}

int movie_write(const char *path, const char *const *pictures, int n, double rate,
                struct sph_error *err) {
    if (movie_check(path, err)) return -1;
    return ends(path, ".mp4") ? mp4(path, pictures, n, rate, err)
                              : sph_image_write_gif(path, pictures, n, rate, err);
}
