/* simulate_cxxrtl.cpp - the core as Yosys writes it in C++; see simulate_host.cpp
 * SPDX-License-Identifier: Apache-2.0
 *
 * Compiled with what `write_cxxrtl` made of rt_core. Registers start with what they are initialised
 * to, memories with zeros.
 */
#include <cstring>
#include <vector>

#include "core.cpp"
#include "host.h"

const char *const simulator_name = "cxxrtl";

std::string simulator_version() {
    return "CXXRTL of " YOSYS_VERSION;
}

namespace {

template <size_t N> const cxxrtl::value<N> &bits(const cxxrtl::value<N> &v) {
    return v;
}
template <size_t N> const cxxrtl::value<N> &bits(const cxxrtl::wire<N> &w) {
    return w.curr;
}
/* Up to 64 bits of an output. */
template <class T> uint64_t word(const T &port) {
    const auto &v = bits(port);
    return v.chunks > 1 ? v.data[0] | static_cast<uint64_t>(v.data[v.chunks - 1]) << 32 : v.data[0];
}

class CxxrtlCore : public PortHost {
  public:
    CxxrtlCore(const Options &o, const sph_machine &machine, Run &run) : PortHost(o, machine, run) {
        memory().width(BEAT);
        pins.rst = true;
        for (int i = 0; i < RESET; i++)
            clock();
        pins.rst = false;
    }

  private:
    static const int RESET = 4; /* clocks */
    static const unsigned BEAT =
        8 * sizeof std::declval<cxxrtl_design::p_rt__core>().p_mem__rsp__data__i.data;
    void step(const Inputs &in, Outputs &out) override {
        core_.p_clk.set(false);
        core_.p_rst.set(in.pins.rst);
        core_.p_start__i.set(in.pins.start);
        core_.p_keep__cache__i.set(in.pins.keep_cache);
        core_.p_cfg__valid__i.set(in.pins.cfg_valid);
        core_.p_cfg__addr__i.set(static_cast<uint8_t>(in.pins.cfg_addr & 127));
        core_.p_cfg__data__i.set(in.pins.cfg_data);
        core_.p_count__addr__i.set(static_cast<uint8_t>(in.pins.count_addr & 31));
        core_.p_mem__req__ready__i.set(in.memory.request_ready);
        core_.p_mem__rsp__valid__i.set(in.memory.response_valid);
        core_.p_mem__rsp__tag__i.set(static_cast<uint8_t>(in.memory.tag));
        std::memcpy(core_.p_mem__rsp__data__i.data, in.memory.data.data(), BEAT / 8);
        core_.p_mem__rsp__error__i.set(in.memory.error);
        core_.p_pix__ready__i.set(in.pix_ready);
        core_.step();
        out.req_valid = word(core_.p_mem__req__valid__o) != 0;
        out.req_line = static_cast<uint32_t>(word(core_.p_mem__req__line__o));
        out.req_tag = static_cast<uint32_t>(word(core_.p_mem__req__tag__o));
        out.rsp_ready = word(core_.p_mem__rsp__ready__o) != 0;
        out.pix_valid = word(core_.p_pix__valid__o) != 0;
        out.x = static_cast<int>(word(core_.p_pix__x__o));
        out.y = static_cast<int>(word(core_.p_pix__y__o));
        out.pix_frame = static_cast<uint32_t>(word(core_.p_pix__frame__o));
        colours(bits(core_.p_pix__colour__o).data, out.pixel);
        out.pixel.id = static_cast<uint32_t>(word(core_.p_pix__id__o));
        out.pixel.key = word(core_.p_pix__key__o);
        out.pixel.visits = static_cast<uint32_t>(word(core_.p_pix__visits__o));
        out.pixel.texture = static_cast<uint32_t>(word(core_.p_pix__texture__o));
        core_.p_clk.set(true);
        core_.step();
        core_.step(); /* what follows from registers: a step ends with their new values */
        out.seen = {word(core_.p_busy__o) != 0, static_cast<uint32_t>(word(core_.p_errors__o)),
                    word(core_.p_count__data__o), true};
    }

    cxxrtl_design::p_rt__core core_;
};

} // namespace

std::unique_ptr<Host> make_host(const Options &o, const sph_machine &machine, Run &run) {
    return std::make_unique<CxxrtlCore>(o, machine, run);
}
