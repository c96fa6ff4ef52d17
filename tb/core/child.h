/* child.h - a simulation in a process of its own, while another one tells how far it is
 * SPDX-License-Identifier: Apache-2.0
 *
 * One core draws the whole window: cycles, misses and stalls are of a frame, and depend on nothing
 * but the machine, the core and the memory behind it.
 */
#ifndef TB_CHILD_H
#define TB_CHILD_H

#include <string>

#include "outcome.h"

/* Simulates c.window and fills in samples, run and seconds of c. Returns false with a message if
 * there is no memory or no process to be had. A process that dies counts as a failure of the run.
 */
bool simulate_watched(const Options &o, const sph_machine &machine, Outcome &c, std::string &error);

#endif
