/* number.h - text to numbers: of scene files, of command lines, of the environment
 * SPDX-License-Identifier: Apache-2.0
 *
 * The one place where that is done. Nothing depends on the locale, wraps around, or is left over.
 */
#ifndef SPH_NUMBER_H
#define SPH_NUMBER_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define SPH_NUMBER_MAX 1e30 /* greatest size of a real number: squares and products stay finite */

/* Reads all of text as a decimal number, correctly rounded. 0; -1 if it is not one; -2 if it is
 * larger than SPH_NUMBER_MAX. */
int sph_parse_number(const char *text, double *value);

/* Takes decimal digits, or a whole number that may begin with - and may be hexadecimal behind 0x,
 * from *text, which then points behind it. 0; -1 if there is none or it is not low .. high: then
 * nothing is taken. */
int sph_take_count(const char **text, uint64_t low, uint64_t high, uint64_t *value);
int sph_take_whole(const char **text, int64_t low, int64_t high, int64_t *value);

/* The same of hexadecimal digits without 0x, as simulators print them: a number up to high. */
int sph_take_hex(const char **text, uint64_t high, uint64_t *value);

/* Takes a character. 0, or -1 if another one stands there. */
static inline int sph_take_char(const char **text, char c) {
    if (!c || **text != c) return -1;
    ++*text;
    return 0;
}

/* The same of all of the text. */
static inline int sph_parse_count(const char *text, uint64_t low, uint64_t high, uint64_t *value) {
    return sph_take_count(&text, low, high, value) || *text ? -1 : 0;
}
static inline int sph_parse_whole(const char *text, int64_t low, int64_t high, int64_t *value) {
    return sph_take_whole(&text, low, high, value) || *text ? -1 : 0;
}
static inline int sph_parse_hex(const char *text, uint64_t high, uint64_t *value) {
    return sph_take_hex(&text, high, value) || *text ? -1 : 0;
}

#ifdef __cplusplus
}
#endif

#endif
