/* common.c - see fuzz.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <ctype.h>
#include <dirent.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "common/fnv.h"
#include "fuzz.h"

void fuzz_fail(const char *format, ...) {
    va_list ap;
    va_start(ap, format);
    fputs("fuzz: ", stderr);
    vfprintf(stderr, format, ap);
    fputc('\n', stderr);
    va_end(ap);
    abort();
}

uint64_t fuzz_hash(const uint8_t *data, size_t size) {
    uint64_t hash = SPH_FNV_START;
    for (size_t i = 0; i < size; i++)
        hash = sph_fnv(hash, data[i], 1);
    return hash ^ hash >> 29;
}

/* What is wrong with a file as a whole, or with the machine that would be built of it. */
static const char *const whole[] = {
    "the file is empty",
    "the text is empty",
    "no camera",
    "frame ",
    "camera: ",
    "no atom",
    "no points",
    "is a folder",
    "cannot ",
    "no memory",
    "out of memory",
    "profile ",
    "with ",
    "`fly`",
    "the radii of",
    "the animation",
    "light ",
    "sphere ",
    "triangle ",
    "face ",
};

void fuzz_message(const struct sph_error *err, const char *path, int lines) {
    size_t n = strlen(path), length = strlen(err->text);
    const char *rest = err->text + n + 1;
    if (!length) fuzz_fail("%s: refused without a message", path);
    if (length + 1 == sizeof err->text) fuzz_fail("message is cut: %s", err->text);
    for (const char *c = err->text; *c; c++)
        if (iscntrl((unsigned char)*c)) fuzz_fail("byte 0x%02x in: %s", *c, err->text);
    if (strncmp(err->text, path, n) != 0 || err->text[n] != ':' || length < n + 4)
        fuzz_fail("message does not name %s: %s", path, err->text);
    if (!lines || (isdigit((unsigned char)*rest) && *rest != '0')) return;
    while (*rest == ' ')
        rest++;
    for (size_t i = 0; i < sizeof whole / sizeof *whole; i++)
        if (!strncmp(rest, whole[i], strlen(whole[i]))) return;
    fuzz_fail("message without a line: %s", err->text);
}

/* Files that are written for each input stay open: to open and to empty one costs more than many an
 * input. */
static struct open_file {
    char name[32];
    int file;
} open_files[4];

static int file_of(const char *name) {
    struct open_file *f = open_files;
    while (f < open_files + 3 && f->name[0] && strcmp(f->name, name) != 0)
        f++;
    if (!strcmp(f->name, name)) return f->file;
    snprintf(f->name, sizeof f->name, "%s", name);
    return f->file = open(name, O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
}

void fuzz_write(const char *name, const uint8_t *data, size_t size) {
    int file = file_of(name);
    if (file < 0 || pwrite(file, data, size, 0) != (ssize_t)size || ftruncate(file, (off_t)size)) {
        perror(name);
        exit(2);
    }
}

void fuzz_same(const char *name, const uint8_t *data, size_t size) {
    static uint8_t part[1 << 16];
    int file = open(name, O_RDONLY | O_CLOEXEC);
    if (file < 0) fuzz_fail("%s: was not written", name);
    size_t at = 0;
    for (ssize_t n; (n = read(file, part, sizeof part)) > 0; at += (size_t)n)
        for (size_t i = 0; i < (size_t)n; i++)
            if (at + i >= size || part[i] != data[at + i])
                fuzz_fail("%s: differs at byte %zu", name, at + i);
    close(file);
    if (at != size) fuzz_fail("%s: has %zu bytes, not %zu", name, at, size);
}

/* Calls of fuzz_no_rest() for one look into the folder. */
enum { LOOK = 16 };

void fuzz_no_rest(void) {
    static unsigned calls;
    if (calls++ % LOOK) return;
    DIR *folder = opendir(".");
    if (!folder) exit(2);
    for (struct dirent *entry; (entry = readdir(folder));)
        if (strstr(entry->d_name, ".tmp")) fuzz_fail("%s: is left behind", entry->d_name);
    closedir(folder);
}
