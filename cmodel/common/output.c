/* output.c - see output.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "common/output.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Chooses the temporary name of path; nothing is opened. */
static int choose_name(struct sph_output *out, const char *path, struct sph_error *err) {
    struct stat st;
    memset(out, 0, sizeof *out);
    if (!*path) return sph_fail(err, "empty output file name");
    if (strlen(path) + 32 > sizeof out->path)
        return sph_fail(err, "%.80s...: file name too long", path);
    snprintf(out->path, sizeof out->path, "%s", path);
    if (stat(path, &st)) {
        if (errno != ENOENT) return sph_fail(err, "%s: %s", path, strerror(errno));
    } else if (S_ISDIR(st.st_mode)) {
        return sph_fail(err, "%s: %s", path, strerror(EISDIR));
    } else if (!S_ISREG(st.st_mode)) {
        return 0;
    }
    snprintf(out->temporary, sizeof out->temporary, "%.4060s.%ld.tmp", path, (long)getpid());
    return 0;
}

static const char *target(const struct sph_output *out) {
    return out->temporary[0] ? out->temporary : out->path;
}

static int give_name(struct sph_output *out, struct sph_error *err) {
    if (!out->temporary[0] || !rename(out->temporary, out->path)) return 0;
    int cause = errno;
    unlink(out->temporary);
    return sph_fail(err, "%s: %s", out->path, strerror(cause));
}

int sph_output_open(struct sph_output *out, const char *path, struct sph_error *err) {
    if (!strcmp(path, "-")) {
        *out = (struct sph_output){.file = stdout, .path = "standard output"};
        return 0;
    }
    if (choose_name(out, path, err)) return -1;
    out->file = fopen(target(out), "wb");
    if (!out->file) return sph_fail(err, "%s: %s", path, strerror(errno));
    return 0;
}

int sph_output_close(struct sph_output *out, int failed, struct sph_error *err) {
    errno = 0;
    int bad = ferror(out->file) || fflush(out->file);
    int cause = errno;
    if (out->file != stdout && fclose(out->file) && !bad) {
        bad = 1;
        cause = errno;
    }
    if (!bad && !failed) return give_name(out, err);
    if (out->temporary[0]) unlink(out->temporary);
    if (failed) return -1;
    return sph_fail(err, "%s: %s", out->path, cause ? strerror(cause) : "write error");
}
