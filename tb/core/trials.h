/* trials.h - what a host may do to a core, at random, and the clean frame behind it
 * SPDX-License-Identifier: Apache-2.0
 *
 * Each trial takes one of the machines, does something to the core, and has a clean frame of that
 * machine drawn, which must be the model's. Where the model knows what comes of a trial (random
 * words in memory and registers, limits), that frame must be the model's as well. Resets go through
 * all clocks of a machine's frame in turn, bus errors through all its requests and their beats.
 */
#ifndef TB_TRIALS_H
#define TB_TRIALS_H

#include <deque>

#include "options.h"
#include "player.h"

/* Does o.trials trials, and prints `met NUMBER EVENT` for each kind of event. */
void try_all(const Options &o, Player &player, const std::deque<Scene> &scenes);

#endif
