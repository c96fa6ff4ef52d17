/* share.h - one window, several processes
 * SPDX-License-Identifier: Apache-2.0
 *
 * Two threads in one verilated model are slower than one; two processes are twice as fast. The
 * window is cut into bands of rows of equal work. The work is known beforehand: it is the number
 * of node visits that the golden model counted for each pixel.
 *
 *   rows 0 .. 95   process 0        run[0]        samples: one array for all,
 *   rows 96 .. 179 process 1        run[1]        each process writes its own rows
 */
#ifndef TB_SHARE_H
#define TB_SHARE_H

#include <string>
#include <vector>

#include "outcome.h"

/* Bands of whole tiles of 8 rows, at most `parts` of them, none empty. */
std::vector<Window> share_out(const sph_frame &model, const Window &window, int parts);

/* Simulates c.window in bands and fills in samples, runs, total and seconds of c. Returns false
 * with a message if there is no memory or no process to be had. A process that dies counts as a
 * failure of its run. */
bool simulate_shared(const Options &o, const sph_machine &machine, Outcome &c, std::string &error);

#endif
