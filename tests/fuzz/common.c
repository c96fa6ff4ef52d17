/* common.c - see fuzz.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <ctype.h>
#include <dirent.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

void fuzz_write(const char *name, const uint8_t *data, size_t size) {
    FILE *file = fopen(name, "wb");
    if (!file || fwrite(data, 1, size, file) != size || fclose(file)) {
        perror(name);
        exit(2);
    }
}

void fuzz_same(const char *name, const uint8_t *data, size_t size) {
    FILE *file = fopen(name, "rb");
    if (!file) fuzz_fail("%s: was not written", name);
    size_t at = 0;
    int c;
    while ((c = getc(file)) != EOF) {
        if (at == size || c != data[at]) fuzz_fail("%s: differs at byte %zu", name, at);
        at++;
    }
    fclose(file);
    if (at != size) fuzz_fail("%s: has %zu bytes, not %zu", name, at, size);
}

void fuzz_no_rest(void) {
    DIR *folder = opendir(".");
    if (!folder) exit(2);
    for (struct dirent *entry; (entry = readdir(folder));)
        if (strstr(entry->d_name, ".tmp")) fuzz_fail("%s: is left behind", entry->d_name);
    closedir(folder);
}
