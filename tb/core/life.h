/* life.h - many frames of one core, one behind the other, each compared
 * SPDX-License-Identifier: Apache-2.0
 *
 * Frames of two machines follow each other without a reset; then one frame after the other is cut
 * off by a reset, mostly of one clock, and the frame behind it must be whole. Registers are written
 * once a machine. A reset takes memory along, or lasts until memory has given all that it owes.
 */
#ifndef TB_LIFE_H
#define TB_LIFE_H

#include "options.h"
#include "simulate.h"

/* Says in run.failure what went wrong first. 0, 1 if something did, or 2, with a reason, if it
 * cannot be done: --then cannot be read, or the simulator cannot be driven so. */
int live(const Options &o, const sph_machine &machine, Run &run, std::string &error);

#endif
