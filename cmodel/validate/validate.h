/* validate.h - is a machine one that the hardware may run?
 * SPDX-License-Identifier: Apache-2.0
 *
 * Whoever has validated a machine need not look again: model and RTL end every ray of it without an
 * error bit.
 */
#ifndef SPH_VALIDATE_H
#define SPH_VALIDATE_H

#include "machine/machine.h"

/* Reads and validates a machine file. 0, or -1 with a message; on failure there is nothing to free.
 */
int sph_machine_read(const char *path, struct sph_machine *m, struct sph_error *err);

/* Checks a machine in memory: every register and record in range, every child address, tree depth,
 * ids. 0, or -1 with a message. */
int sph_machine_validate(const struct sph_machine *m, struct sph_error *err);

#endif
