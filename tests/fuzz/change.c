/* change.c - see change.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "change.h"

#include <ctype.h>
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "common/number.h"

enum { CHANGES = 8, PIECE = 64 };

/* Numbers at which things end. */
static const char *const numbers[] = {
    "0",          "-0",      "1",        "-1",      "1e30",  "-1e30",    "1e31",
    "1e-30",      "1e-300",  "nan",      "inf",     "0.5",   "1e308",    "2147483647",
    "4294967296", "16383",   "16384",    "65535",   "180",   "1e-12",    "1e999",
    "0x10",       "1e7",     "16777216", "1048576", "3",     "0.999999", "1e-320",
    "5e-324",     "-1e-310", "1e-17",    "1e17",    "-1e300"};
static const uint32_t binary[] = {0,          1,          0xffffffff, 0x80000000, 0x7fffffff,
                                  0xffff,     0x10000,    0xffffff,   0x1000000,  64,
                                  0x40000000, 0x20000000, 16384,      65536,      0xfffffffe};

static uint32_t draw(uint64_t *random, size_t below) {
    *random ^= *random << 13;
    *random ^= *random >> 7;
    *random ^= *random << 17;
    return (uint32_t)((*random >> 32) % (below ? below : 1));
}

static void *grown(void *array, size_t n, size_t element) {
    if (n & (n - 1)) return array;
    array = realloc(array, (n ? 2 * n : 1) * element);
    if (!array) exit(2);
    return array;
}

static void add(struct fuzz_bytes **list, size_t *n, const uint8_t *bytes, size_t size) {
    *list = grown(*list, *n, sizeof **list);
    struct fuzz_bytes *b = &(*list)[(*n)++];
    *b = (struct fuzz_bytes){malloc(size + 1), size};
    if (!b->at) exit(2);
    memcpy(b->at, bytes, size);
}

static int by_name(const struct dirent **a, const struct dirent **b) {
    return strcmp((*a)->d_name, (*b)->d_name); /* whatever the locale */
}

static int plain(const struct dirent *entry) {
    return entry->d_name[0] != '.';
}

void fuzz_add(struct fuzz_corpus *c, const char *path) {
    static uint8_t bytes[FUZZ_SIZE];
    struct stat about;
    struct dirent **list;
    if (!stat(path, &about) && S_ISDIR(about.st_mode)) {
        int n = scandir(path, &list, plain, by_name);
        for (int i = 0; i < n; i++) {
            char name[4096];
            snprintf(name, sizeof name, "%s/%s", path, list[i]->d_name);
            fuzz_add(c, name);
            free(list[i]);
        }
        if (n >= 0) free(list);
        return;
    }
    FILE *file = fopen(path, "rb");
    if (!file) {
        perror(path);
        exit(2);
    }
    add(&c->input, &c->inputs, bytes, fread(bytes, 1, sizeof bytes, file));
    fclose(file);
}

void fuzz_add_words(struct fuzz_corpus *c, const char *path) {
    char line[1024];
    FILE *file = fopen(path, "r");
    if (!file) {
        perror(path);
        exit(2);
    }
    while (fgets(line, sizeof line, file)) {
        char *from = strchr(line, '"'), *to = line;
        if (*line == '#' || !from) continue;
        while (*++from && *from != '"') {
            uint64_t byte;
            const char digits[3] = {from[1] == 'x' ? from[2] : 0, from[1] == 'x' ? from[3] : 0, 0};
            if (*from != '\\')
                *to++ = *from;
            else if (!sph_parse_hex(digits, 255, &byte))
                *to++ = (char)byte, from += 3;
            else
                *to++ = *++from;
        }
        add(&c->word, &c->words, (const uint8_t *)line, (size_t)(to - line));
    }
    fclose(file);
}

void fuzz_corpus_free(struct fuzz_corpus *c) {
    for (size_t i = 0; i < c->inputs; i++)
        free(c->input[i].at);
    for (size_t i = 0; i < c->words; i++)
        free(c->word[i].at);
    free(c->input);
    free(c->word);
}

/* Bytes at..at+old become n others; not if there were too many then. */
static size_t put(uint8_t *to, size_t size, size_t at, size_t old, const void *bytes, size_t n) {
    uint8_t copy[FUZZ_SIZE];
    if (size - old + n > FUZZ_SIZE || n > sizeof copy) return size;
    memcpy(copy, bytes, n); /* it may be a part of `to` */
    memmove(to + at + n, to + at + old, size - at - old);
    memcpy(to + at, copy, n);
    return size - old + n;
}

/* The word, up to blanks, at a place: its start; its size in *n. */
static size_t word_at(const uint8_t *to, size_t size, size_t at, size_t *n) {
    size_t end = at;
    while (at && !isspace(to[at - 1]))
        at--;
    while (end < size && !isspace(to[end]))
        end++;
    *n = end - at;
    return at;
}

static size_t change_one(const struct fuzz_corpus *c, uint64_t *random, uint8_t *to, size_t size) {
    size_t at = draw(random, size + 1), left = size - at, n;
    uint8_t byte = (uint8_t)draw(random, 256);
    const char *number = numbers[draw(random, sizeof numbers / sizeof *numbers)];
    uint32_t word = binary[draw(random, sizeof binary / sizeof *binary)];
    const struct fuzz_bytes *other = &c->input[draw(random, c->inputs)];
    switch (draw(random, 11)) {
    case 0:
        if (left) to[at] ^= (uint8_t)(1 << (byte & 7));
        return size;
    case 1:
        if (left) to[at] = byte;
        return size;
    case 2:
        return put(to, size, at, 0, &byte, 1);
    case 3:
        n = draw(random, PIECE);
        return put(to, size, at, n < left ? n : left, "", 0);
    case 4: /* a piece of it once more */
        n = draw(random, PIECE);
        return put(to, size, at, 0, to + at, n < left ? n : left);
    case 5: /* a piece of another */
        n = draw(random, other->size + 1);
        return put(to, size, at, 0, other->at + n,
                   other->size - n < PIECE ? other->size - n : PIECE);
    case 6:
        n = word_at(to, size, at, &left);
        return put(to, size, n, left, number, strlen(number));
    case 7:
        if (!c->words) return size;
        other = &c->word[draw(random, c->words)];
        return put(to, size, at, 0, other->at, other->size);
    case 8:
        if (!c->words) return size;
        other = &c->word[draw(random, c->words)];
        n = word_at(to, size, at, &left);
        return put(to, size, n, left, other->at, other->size);
    case 9:
        at &= ~(size_t)3;
        return size - at >= 4 && size >= at ? put(to, size, at, 4, &word, 4) : size;
    default:
        return draw(random, 4) ? size : at; /* cut off */
    }
}

size_t fuzz_change(const struct fuzz_corpus *c, uint64_t *random, uint8_t *to) {
    const struct fuzz_bytes *from = &c->input[draw(random, c->inputs)];
    size_t size = from->size;
    memcpy(to, from->at, size);
    for (uint32_t left = 1 + draw(random, CHANGES); left; left--)
        size = change_one(c, random, to, size);
    return size;
}
