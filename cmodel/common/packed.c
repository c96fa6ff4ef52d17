/* packed.c - see packed.h; by zlib
 * SPDX-License-Identifier: Apache-2.0
 */
#include "common/packed.h"

#include <errno.h>
#include <limits.h>
#include <string.h>
#include <unistd.h>
#include <zlib.h>

#include "common/file.h"

enum { DAMAGED = EBADMSG }; /* errno of a packed file that does not unpack */

static ssize_t unpack(void *packed, char *to, size_t size) {
    int end = Z_OK, got = gzread(packed, to, size < INT_MAX ? (unsigned)size : INT_MAX);
    if (got < (int)size) gzerror(packed, &end);
    if (got > 0 || (!got && end != Z_BUF_ERROR)) return got; /* that it is cut off comes next */
    if (end != Z_ERRNO) errno = DAMAGED;
    return -1;
}

static int close_packed(void *packed) {
    gzclose(packed);
    return 0;
}

int sph_input_packed(const char *path) {
    return sph_input_starts(path, "\x1f\x8b", 2);
}

FILE *sph_input_text(const char *path, struct sph_error *err) {
    static const cookie_io_functions_t calls = {.read = unpack, .close = close_packed};
    FILE *file = sph_input_open(path, SPH_INPUT_ANY, err);
    if (!file || !sph_input_packed(path)) return file;
    int copy = dup(fileno(file));
    gzFile packed = copy < 0 ? NULL : gzdopen(copy, "rb");
    if (!packed && copy >= 0) close(copy);
    fclose(file);
    file = packed ? fopencookie(packed, "rb", calls) : NULL;
    if (file) return file;
    if (packed) gzclose(packed);
    sph_fail(err, "%s: no memory to unpack", path);
    return NULL;
}

const char *sph_input_why(void) {
    return errno == DAMAGED ? "what gzip has packed is damaged or cut off" : strerror(errno);
}
