/* error.h - errors are values: a message that names file, line and field
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_ERROR_H
#define SPH_ERROR_H

/* First error wins: later ones do not overwrite the text. text[0] == 0 means no error. */
struct sph_error {
    char text[512];
};

/* Stores a printf-style message in *err unless it already holds one; always returns -1,
 * so that callers write `return sph_fail(err, "%s:%d: ...", ...)`. err may be NULL. Of what a file
 * said, ends of lines become blanks and other control characters `?`: a message is one line. */
int sph_fail(struct sph_error *err, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Whether the message says that there is no memory: what failed may do with more, and what else is
 * tried in its place would be another answer. */
int sph_error_memory(const struct sph_error *err);

#endif
