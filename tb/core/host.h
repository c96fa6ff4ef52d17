/* host.h - a core as its host sees it, a clock at a time
 * SPDX-License-Identifier: Apache-2.0
 *
 * The memory behind it and random waits at its ports are the simulator's: see memory.h.
 */
#ifndef TB_HOST_H
#define TB_HOST_H

#include <functional>
#include <memory>

#include "memory.h"
#include "simulate.h"

class Host {
  public:
    /* Inputs, as they are in the next clock. */
    struct Pins {
        bool rst, start, keep_cache, cfg_valid;
        int cfg_addr, count_addr;
        uint32_t cfg_data;
    } pins = {false, false, false, false, 0, 0, 0};
    /* Outputs behind the clock's edge. */
    struct Seen {
        bool busy;
        uint32_t errors;
        uint64_t count; /* counter that was addressed in the clock */
        bool known;     /* it has no unknown bits */
    };
    /* Percent of clocks in which no pixel is taken, up to 100. */
    int pix_stall = 0;
    virtual ~Host() = default;
    virtual Seen clock() = 0;
    virtual Memory &memory() = 0;
    /* Is called with each pixel that leaves; may be empty. */
    std::function<void(int x, int y, const sph_pixel &pixel)> pixel;
};

/* Value of a register; the window may be smaller than the machine's. */
int32_t register_of(const sph_machine &machine, const Window &w, int number);

/* Writes the machine's registers, those of the window as given. */
void configure(Host &host, const sph_machine &machine, const Window &w);

/* Starts a frame that is to be spoilt: `clocks` clocks, then a reset of `length`, at least 1, and
 * of memory too; or, if memory is left alone, until it has given all that it was asked for. No
 * pixel is passed on. */
void interrupt(Host &host, int64_t clocks, int length, bool drain);

/* A core that was in reset for some clocks, registers not yet written; nothing in a simulator that
 * cannot be driven so. Says in run.failure if a handshake breaks or an assertion fails. */
std::unique_ptr<Host> make_host(const Options &o, const sph_machine &machine, Run &run);

#endif
