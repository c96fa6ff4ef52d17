/* file.c - see file.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include "common/file.h"

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

/* ---- output ---- */

/* What is noted, the newest first, and whose else is cleaned. */
struct note {
    struct note *next;
    char path[];
};
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static struct note *notes;
static void (*others)(void);

void sph_output_note(const char *path) {
    size_t size = strlen(path) + 1;
    struct note *n = malloc(sizeof *n + size);
    if (!n) return;
    memcpy(n->path, path, size);
    pthread_mutex_lock(&lock);
    n->next = notes;
    notes = n;
    pthread_mutex_unlock(&lock);
}

void sph_output_forget(const char *path) {
    pthread_mutex_lock(&lock);
    for (struct note **at = &notes; *at; at = &(*at)->next) {
        struct note *n = *at;
        if (strcmp(n->path, path) != 0) continue;
        *at = n->next;
        free(n);
        break;
    }
    pthread_mutex_unlock(&lock);
}

void sph_output_also(void (*clean)(void)) {
    pthread_mutex_lock(&lock);
    others = clean;
    pthread_mutex_unlock(&lock);
}

static void remove_folder(const char *path) {
    DIR *folder = opendir(path);
    if (!folder) return;
    for (struct dirent *entry; (entry = readdir(folder)) != NULL;)
        unlinkat(dirfd(folder), entry->d_name, 0);
    closedir(folder);
    rmdir(path);
}

void sph_output_clean(void) {
    pthread_mutex_lock(&lock); /* for good */
    for (const struct note *n = notes; n; n = n->next)
        if (unlink(n->path) && errno != ENOENT) remove_folder(n->path);
    if (others) others();
}

/* Looks what path is; nothing is opened. */
static int look_at(struct sph_output *out, const char *path, int named, struct sph_error *err) {
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
        return named ? sph_fail(err, "%s: is %s, not a file", path, kind(st.st_mode)) : 0;
    }
    out->renamed = 1;
    return 0;
}

/* Makes an empty file that nobody else has, with the rights that a new file gets: into name, of
 * `size` bytes, stem.RANDOM.ending. It is noted. Its descriptor, or -1 with errno set. */
static int make_beside(char *name, size_t size, const char *stem, const char *ending) {
    for (int i = 0; i < 100; i++) {
        uint64_t number;
        if (getrandom(&number, sizeof number, 0) != sizeof number) return -1;
        int n = snprintf(name, size, "%s.%016" PRIx64 ".%s", stem, number, ending);
        if (n < 0 || (size_t)n >= size) return errno = ENAMETOOLONG, -1;
        int fd = open(name, O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
        if (fd >= 0) sph_output_note(name);
        if (fd >= 0 || errno != EEXIST) return fd;
    }
    return -1;
}

static void remove_temporary(const struct sph_output *out) {
    unlink(out->temporary);
    sph_output_forget(out->temporary);
}

static int give_name(struct sph_output *out, struct sph_error *err) {
    if (!out->temporary[0]) return 0;
    if (rename(out->temporary, out->path)) {
        sph_fail(err, "%s: %s", out->path, strerror(errno));
        remove_temporary(out);
        return -1;
    }
    sph_output_forget(out->temporary);
    return 0;
}

/* Opens the temporary file; if that fails none is left. */
static void open_temporary(struct sph_output *out, const char *ending) {
    int fd = make_beside(out->temporary, sizeof out->temporary, out->path, ending);
    out->file = fd < 0 ? NULL : fdopen(fd, "wb");
    if (out->file) return;
    int cause = errno;
    if (fd >= 0) {
        close(fd);
        remove_temporary(out);
    }
    out->temporary[0] = 0;
    errno = cause;
}

static int open_any(struct sph_output *out, const char *path, const char *ending, int named,
                    struct sph_error *err) {
    if (look_at(out, path, named, err)) return -1;
    if (out->renamed)
        open_temporary(out, ending);
    else
        out->file = fopen(out->path, "wb");
    return out->file ? 0 : sph_fail(err, "%s: %s", path, strerror(errno));
}

int sph_output_open(struct sph_output *out, const char *path, struct sph_error *err) {
    if (strcmp(path, "-") != 0) return open_any(out, path, "tmp", 0, err);
    *out = (struct sph_output){.file = stdout, .path = "standard output"};
    return 0;
}

int sph_output_open_named(struct sph_output *out, const char *path, const char *ending,
                          struct sph_error *err) {
    return open_any(out, path, ending, 1, err);
}

/* A file system that has nothing to wait for says EINVAL. */
static int to_disk(FILE *file) {
    return fsync(fileno(file)) && errno != EINVAL;
}

/* Why a write failed, which a stream does not keep: the next one, to a file that will be removed,
 * fails as well. */
static int why_failed(const struct sph_output *out) {
    errno = 0;
    if (out->temporary[0] && write(fileno(out->file), "", 1) < 0) return errno;
    return 0;
}

int sph_output_close(struct sph_output *out, int failed, struct sph_error *err) {
    int bad = ferror(out->file), cause = bad && !failed ? why_failed(out) : 0;
    if (!bad && (fflush(out->file) || (out->temporary[0] && !failed && to_disk(out->file)))) {
        bad = 1;
        cause = errno;
    }
    if (out->file != stdout && fclose(out->file) && !bad) {
        bad = 1;
        cause = errno;
    }
    if (!bad && !failed) return give_name(out, err);
    if (out->temporary[0]) remove_temporary(out);
    if (failed) return -1;
    return sph_fail(err, "%s: %s", out->path, cause ? strerror(cause) : "write error");
}
