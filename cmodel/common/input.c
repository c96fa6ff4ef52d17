/* input.c - see input.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "common/input.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static const char *kind(mode_t mode) {
    return S_ISDIR(mode)                    ? "a folder"
           : S_ISFIFO(mode)                 ? "a pipe"
           : S_ISSOCK(mode)                 ? "a socket"
           : S_ISCHR(mode) || S_ISBLK(mode) ? "a device"
                                            : "of no known kind";
}

/* What is wrong with an open file; 0 if nothing. */
static int check(int file, const char *path, long long most, struct sph_error *err) {
    struct stat about;
    if (fstat(file, &about)) return sph_fail(err, "%s: cannot read: %s", path, strerror(errno));
    if (!S_ISREG(about.st_mode))
        return sph_fail(err, "%s: is %s, not a file", path, kind(about.st_mode));
    if (about.st_size > most)
        return sph_fail(err, "%s: has %lld bytes, more than the %lld that are read here", path,
                        (long long)about.st_size, most);
    return 0;
}

FILE *sph_input_open(const char *path, long long most, struct sph_error *err) {
    int file = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC); /* a pipe without a writer, too */
    if (file < 0) {
        sph_fail(err, "%s: cannot open: %s", path, strerror(errno));
        return NULL;
    }
    FILE *stream = NULL;
    if (!check(file, path, most, err)) {
        stream = fdopen(file, "rb");
        if (!stream) sph_fail(err, "%s: cannot open: %s", path, strerror(errno));
    }
    if (!stream) close(file);
    return stream;
}

int sph_input_starts(const char *path, const char *bytes, size_t n) {
    char head[16];
    FILE *file = sph_input_open(path, SPH_INPUT_ANY, NULL);
    if (!file) return 0;
    size_t got = fread(head, 1, n, file);
    fclose(file);
    return got == n && !memcmp(head, bytes, n);
}
