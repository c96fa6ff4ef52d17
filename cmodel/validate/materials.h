/* materials.h - the words of primitive records that refraction and Whitted's sum ask for
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_MACHINE_MATERIALS_H
#define SPH_MACHINE_MATERIALS_H

#include "machine/machine.h"

/* Whether REFRACT goes with the profile. 0, or -1 with a message.
 */
int sph_validate_optics(const struct sph_machine *m, struct sph_error *err);

/* Of a machine with REFRACT or SUM, whose primitive records lie in memory: shares, powers and
 * indices of refraction are in their ranges. 0, or -1 with a message. */
int sph_validate_materials(const struct sph_machine *m, struct sph_error *err);

#endif
