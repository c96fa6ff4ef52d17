/* box_order.h - the order in which shadow rays take the children of a node; docs/design/bih.md
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_BOX_ORDER_H
#define SPH_BOX_ORDER_H

#include "common/error.h"
#include "machine/machine.h"

/* Puts the inner children of each node of boxes into the order in which a sample of the machine's
 * own shadow rays finds a hit with the fewest visits; of equal ones the order stays. Any other
 * machine, and one whose rays end at the first hit that they find, stays as it is. The machine is
 * whole but for this. -1 if memory is out. */
int sph_box_order(struct sph_machine *machine, struct sph_error *err);

#endif
