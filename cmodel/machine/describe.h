/* describe.h - a machine in words, for `sphaera info`
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_DESCRIBE_H
#define SPH_DESCRIBE_H

#include <stdio.h>

#include "machine/machine.h"

/* Prints profile, sizes, shape of the tree and all registers by name. The machine must be valid
 * (sph_machine_validate). */
void sph_machine_describe(const struct sph_machine *m, FILE *file);

#endif
