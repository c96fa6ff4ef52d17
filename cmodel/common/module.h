/* module.h - objects that the tool loads when it needs what hangs on a large library
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_MODULE_H
#define SPH_MODULE_H

#include <stddef.h>

/* Loads NAME: sphaera_NAME.so beside the program or shared library that this is part of, or in the
 * folder above, as they are built, or ../lib/sphaera/NAME.so, as they are installed. NULL with the
 * loader's reason in why. */
void *sph_module_load(const char *name, char *why, size_t size);

#endif
