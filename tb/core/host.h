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
#include "random.h"
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

/* ---- memory, waits and rules around the ports of a core, in any simulator ---- */
/* A simulator gives step(): inputs low, all settles, outputs are looked at, a rising edge. In every
 * clock the rules of docs/reference/core.md are held: what waits for ready stays; an idle core asks
 * for nothing, gives nothing and keeps its errors; errors stay until a start; a reset leaves
 * nothing; lines lie in memory; when busy_o falls, memory owes nothing. */

class PortHost : public Host {
  public:
    PortHost(const Options &o, const sph_machine &machine, Run &run);
    Seen clock() override;
    Memory &memory() override { return memory_; }
    uint64_t cycle() const { return cycle_; }

  protected:
    struct Inputs {
        Pins pins;
        Memory::Offer memory;
        bool pix_ready;
    };
    struct Outputs {
        /* before the edge */
        bool req_valid, rsp_ready, pix_valid;
        uint32_t req_line, req_tag, pix_frame;
        int x, y;
        sph_pixel pixel;
        /* behind it */
        Seen seen;
    };
    virtual void step(const Inputs &in, Outputs &out) = 0;
    /* The 72 bits of pix_colour_o, words of 32. */
    static void colours(const uint32_t *words, sph_pixel &pixel);

    const Options &o_;
    Run &run_;

  private:
    /* Payload of an output that waits for ready: must not change. */
    struct Held {
        bool waits;
        int x, y;
        sph_pixel pixel;
    };
    void hold(const char *port, Held &held, bool valid, bool ready, const Held &now);
    void hold_rules(const Inputs &in, const Outputs &out);
    void wrong(const char *what);

    Memory memory_;
    Random random_;
    Held request_ = {false, 0, 0, {}}, pixel_ = {false, 0, 0, {}};
    Seen before_ = {false, 0, 0, true}; /* behind the edge before this clock */
    bool reset_ = false;                /* there was one: outputs are known */
    int clearing_ = 0;                  /* clocks in which a start may still clear errors */
    uint64_t cycle_ = 0;
};

#endif
