/* host.cpp - see host.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "host.h"

int32_t register_of(const sph_machine &machine, const Window &w, int number) {
    switch (number) {
    case SPH_REG_WIN_X0:
        return w.x0;
    case SPH_REG_WIN_Y0:
        return w.y0;
    case SPH_REG_WIN_X1:
        return w.x1;
    case SPH_REG_WIN_Y1:
        return w.y1;
    default:
        return machine.regs[number];
    }
}

void configure(Host &host, const sph_machine &machine, const Window &w) {
    host.pins.cfg_valid = true;
    for (int i = 0; i < SPH_N_REGS; i++) {
        host.pins.cfg_addr = i;
        host.pins.cfg_data = static_cast<uint32_t>(register_of(machine, w, i));
        host.clock();
    }
    host.pins.cfg_valid = false;
}

void interrupt(Host &host, int64_t clocks, int length, bool drain) {
    auto pixel = std::move(host.pixel);
    host.pixel = nullptr;
    host.pins.start = true;
    host.clock();
    host.pins.start = false;
    for (int64_t i = 0; i < clocks; i++)
        host.clock();
    host.pins.rst = true;
    if (!drain) host.memory().reset();
    for (int i = 0; i < length || host.memory().waiting(); i++)
        host.clock();
    host.pins.rst = false;
    host.pixel = std::move(pixel);
}

/* ---- port_host ---- */

namespace {

/* Clocks from start_i to the clearing of errors_o. */
const int CLEARS = 3;

bool same(const sph_pixel &a, const sph_pixel &b) {
    return a.id == b.id && a.key == b.key && a.visits == b.visits && a.texture == b.texture &&
           a.colour[0] == b.colour[0] && a.colour[1] == b.colour[1] && a.colour[2] == b.colour[2];
}

} // namespace

PortHost::PortHost(const Options &o, const sph_machine &machine, Run &run)
    : o_(o), run_(run), memory_(machine, o, o.seed * 2), random_(o.seed * 2 + 1) {
    pix_stall = o.stall;
}

void PortHost::colours(const uint32_t *c, sph_pixel &p) {
    p.colour[0] = c[0] & 0xffffff;
    p.colour[1] = (c[0] >> 24 | c[1] << 8) & 0xffffff;
    p.colour[2] = (c[1] >> 16 | c[2] << 16) & 0xffffff;
}

void PortHost::wrong(const char *what) {
    if (!run_.failure[0])
        fail(run_, "clock %llu: %s", static_cast<unsigned long long>(cycle_), what);
}

void PortHost::hold(const char *port, Held &held, bool valid, bool ready, const Held &now) {
    if (held.waits &&
        (!valid || now.x != held.x || now.y != held.y || !same(now.pixel, held.pixel)) &&
        !run_.failure[0])
        fail(run_, "clock %llu: %s_valid_o or its payload changed before ready",
             static_cast<unsigned long long>(cycle_), port);
    held = now;
    held.waits = valid && !ready;
}

/* Of a core that has been reset. */
void PortHost::hold_rules(const Inputs &in, const Outputs &out) {
    const bool rst = in.pins.rst, idle = !before_.busy, taken = idle && in.pins.start && !rst;
    const Seen &now = out.seen;
    if (!rst) {
        hold("mem_req", request_, out.req_valid, in.memory.request_ready,
             {false, static_cast<int>(out.req_line), static_cast<int>(out.req_tag), {}});
        hold("pix", pixel_, out.pix_valid, in.pix_ready, {false, out.x, out.y, out.pixel});
        if (idle && out.req_valid) wrong("an idle core asks for a line");
        if (idle && out.pix_valid) wrong("an idle core gives a pixel");
    } else { /* takes back what was offered */
        request_.waits = pixel_.waits = false;
    }
    if (rst ? now.busy : idle && now.busy != taken)
        wrong(rst     ? "busy_o behind a reset"
              : taken ? "busy_o is low behind start_i"
                      : "busy_o rises without start_i");
    if (taken) clearing_ = CLEARS;
    if (rst ? now.errors : clearing_ ? 0 : before_.errors & ~now.errors)
        wrong(rst ? "errors_o behind a reset" : "an error is forgotten without start_i");
    if (!rst && idle && !taken && now.errors != before_.errors)
        wrong("errors_o of an idle core change");
    if (clearing_) clearing_--;
}

Host::Seen PortHost::clock() {
    const Inputs in = {pins, memory_.offer(), !random_.percent(pix_stall)};
    Outputs out{};
    step(in, out);
    reset_ = reset_ || pins.rst;
    if (reset_ && cycle_) hold_rules(in, out);
    if (out.pix_valid && !pins.rst && in.pix_ready && pixel) {
        auto frame = static_cast<unsigned>(memory_.machine().regs[SPH_REG_FRAME] & 3);
        if (out.pix_frame != out.pixel.colour[frame < SPH_FRAMES ? frame : SPH_FRAMES - 1])
            wrong("the frame mux shows another frame than FRAME says");
        pixel(out.x, out.y, out.pixel);
    }
    memory_.take(out.req_valid && !pins.rst, out.req_line, out.req_tag, out.rsp_ready);
    if (before_.busy && !out.seen.busy && !pins.rst && memory_.waiting())
        wrong("busy_o falls, and memory owes lines");
    before_ = out.seen;
    cycle_++;
    return out.seen;
}
