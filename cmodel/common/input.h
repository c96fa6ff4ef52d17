/* input.h - files that are read: regular ones, of a size that their reader can bear
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_INPUT_H
#define SPH_INPUT_H

#include <stdio.h>

#ifdef __cplusplus
extern "C" {
#endif

#include "common/error.h"

#define SPH_INPUT_ANY (1ll << 62) /* bytes: the reader keeps no more than it can use */

/* Opens the regular file at path, of at most `most` bytes, for reading. NULL with "path: message":
 * missing, no permission, a folder, a device, a pipe, a socket, too large. Never waits. */
FILE *sph_input_open(const char *path, long long most, struct sph_error *err);

/* Whether the file at path starts with these n bytes, at most 16; 0 if it cannot be opened. */
int sph_input_starts(const char *path, const char *bytes, size_t n);

#ifdef __cplusplus
}
#endif

#endif
