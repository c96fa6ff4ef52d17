/* textures.h - the part of validation that looks at mapping records and images
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_MACHINE_TEXTURES_H
#define SPH_MACHINE_TEXTURES_H

#include "machine/machine.h"

/* Of a machine with TEXTURE and valid primitive records: every tex is 0 or a record behind them,
 * with a known kind and the header of an image, all of whose levels lie in memory and behind each
 * other. 0, or -1 with a message. */
int sph_validate_textures(const struct sph_machine *m, struct sph_error *err);

#endif
