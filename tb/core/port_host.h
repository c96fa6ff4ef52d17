/* port_host.h - memory, waits and rules around the ports of a core, in any simulator
 * SPDX-License-Identifier: Apache-2.0
 *
 * A simulator gives step(): inputs low, all settles, outputs are looked at, a rising edge. In every
 * clock the rules of docs/reference/core.md are held: what waits for ready stays; an idle core asks
 * for nothing, gives nothing and keeps its errors; errors stay until a start; a reset leaves
 * nothing; lines lie in memory; when busy_o falls, memory owes nothing.
 */
#ifndef TB_PORT_HOST_H
#define TB_PORT_HOST_H

#include "host.h"
#include "random.h"

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
