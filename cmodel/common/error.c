/* error.c - see error.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "common/error.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

int sph_fail(struct sph_error *err, const char *format, ...) {
    if (err && !err->text[0]) {
        va_list ap;
        va_start(ap, format);
        vsnprintf(err->text, sizeof err->text, format, ap);
        va_end(ap);
        if (strchr(format, '\n')) return -1; /* a list, which no file has a word in */
        for (char *c = err->text; *c; c++)
            if (iscntrl((unsigned char)*c)) *c = *c == '\n' ? ' ' : '?';
    }
    return -1;
}

int sph_error_memory(const struct sph_error *err) {
    return strstr(err->text, "no memory") || strstr(err->text, "out of memory");
}
