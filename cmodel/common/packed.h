/* packed.h - texts that are read, as they are or packed by gzip
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_COMMON_PACKED_H
#define SPH_COMMON_PACKED_H

#include <stdio.h>

#include "common/error.h"

/* Opens the regular file at path, of any size: what is read of one that gzip has packed is
 * unpacked. It has no descriptor then. NULL with a message as of sph_input_open(). */
FILE *sph_input_text(const char *path, struct sph_error *err);

/* Whether the file at path is packed by gzip; 0 if it cannot be opened. */
int sph_input_packed(const char *path);

/* Why reading has just failed, in words: errno, or that what is packed is damaged. */
const char *sph_input_why(void);

#endif
