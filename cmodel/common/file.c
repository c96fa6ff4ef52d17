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
static int look_at(struct sph_output *out, const char *path, struct sph_error *err) {
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
    out->renamed = 1;
    return 0;
}

int sph_output_beside(char *name, size_t size, const char *stem, const char *ending) {
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

static int give_name(struct sph_output *out, struct sph_error *err) {
    if (!out->temporary[0]) return 0;
    int cause = rename(out->temporary, out->path) ? errno : 0;
    if (cause) unlink(out->temporary);
    sph_output_forget(out->temporary);
    if (!cause) return 0;
    return sph_fail(err, "%s: %s", out->path, strerror(cause));
}

/* Opens the temporary file; if that fails none is left. */
static void open_temporary(struct sph_output *out, const char *path) {
    int fd = sph_output_beside(out->temporary, sizeof out->temporary, path, "tmp");
    out->file = fd < 0 ? NULL : fdopen(fd, "wb");
    if (out->file) return;
    int cause = errno;
    if (fd >= 0) {
        close(fd);
        unlink(out->temporary);
        sph_output_forget(out->temporary);
    }
    out->temporary[0] = 0;
    errno = cause;
}

int sph_output_open(struct sph_output *out, const char *path, struct sph_error *err) {
    if (!strcmp(path, "-")) {
        *out = (struct sph_output){.file = stdout, .path = "standard output"};
        return 0;
    }
    if (look_at(out, path, err)) return -1;
    if (out->renamed)
        open_temporary(out, path);
    else
        out->file = fopen(out->path, "wb");
    return out->file ? 0 : sph_fail(err, "%s: %s", path, strerror(errno));
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
    if (out->temporary[0]) {
        unlink(out->temporary);
        sph_output_forget(out->temporary);
    }
    if (failed) return -1;
    return sph_fail(err, "%s: %s", out->path, cause ? strerror(cause) : "write error");
}
