/* output.c - see output.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "common/output.h"

#include <dirent.h>
#include <errno.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

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
    if (!out->temporary[0]) return 0;
    int cause = rename(out->temporary, out->path) ? errno : 0;
    if (cause) unlink(out->temporary);
    sph_output_forget(out->temporary);
    if (!cause) return 0;
    return sph_fail(err, "%s: %s", out->path, strerror(cause));
}

int sph_output_open(struct sph_output *out, const char *path, struct sph_error *err) {
    if (!strcmp(path, "-")) {
        *out = (struct sph_output){.file = stdout, .path = "standard output"};
        return 0;
    }
    if (choose_name(out, path, err)) return -1;
    if (out->temporary[0]) sph_output_note(out->temporary);
    out->file = fopen(target(out), "wb");
    if (out->file) return 0;
    sph_fail(err, "%s: %s", path, strerror(errno));
    if (out->temporary[0]) sph_output_forget(out->temporary);
    return -1;
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
