/* error.c - see error.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "common/error.h"

#include <stdarg.h>
#include <stdio.h>

int sph_fail(struct sph_error *err, const char *format, ...) {
    if (err && !err->text[0]) {
        va_list ap;
        va_start(ap, format);
        vsnprintf(err->text, sizeof err->text, format, ap);
        va_end(ap);
    }
    return -1;
}
