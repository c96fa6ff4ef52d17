/* energy.h - what a pixel takes of a core in standard cells, without simulating its cells
 * SPDX-License-Identifier: Apache-2.0
 *
 * A clock of the idle core takes an energy in proportion to its LUT4eq, and each event that the
 * model counts one of its own: docs/results/silicon.md has them, fitted to netlists that drew
 * frames, and how far they are off. known_table.h is written from it.
 */
#ifndef SPH_TRIAL_ENERGY_H
#define SPH_TRIAL_ENERGY_H

#include "trial/cycles.h"
#include "trial/known.h"

enum { SPH_ENERGY_PARTS = 11 };

struct sph_energy {
    double pixel; /* nJ; 0: not known of such a core */
    int parts;
    struct {
        const char *name; /* "idle clock", "node visit" */
        double pixel;     /* nJ */
    } part[SPH_ENERGY_PARTS];
};

/* Of a core with one pipe, all whose words some core has that was measured; of others, and of
 * profiles that nobody has measured, nothing. */
struct sph_energy sph_energy_expect(const struct sph_known_core *core,
                                    const struct sph_cycles *cycles);

#endif
