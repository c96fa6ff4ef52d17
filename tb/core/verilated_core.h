/* verilated_core.h - the verilated core with its memory, a clock at a time; see host.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * One clock: clk low, inputs change, outputs settle, handshakes are looked at; clk high. Included
 * by simulate_verilator.cpp alone.
 */
#ifndef TB_VERILATED_CORE_H
#define TB_VERILATED_CORE_H

#include <array>

#include "Vrt_core.h"
#include "host.h"
#include "silence.h"
#include "texture_watch.h"
#include "verilated.h"
#include "verilated_syms.h"
#if VM_TRACE_FST
#include "verilated_fst_c.h"
#endif

class VerilatedCore : public Host {
  public:
    VerilatedCore(const Options &o, const sph_machine &machine, Run &run);
    ~VerilatedCore() override;
    Seen clock() override;
    Memory &memory() override { return memory_; }
    Vrt_core &ports() { return *core_; }
    TextureWatch &textures() { return *textures_; }
    uint64_t cycle() const { return cycle_; }
    /* What memory did up to now, by MEMORY_... */
    std::array<uint64_t, MEMORY_COUNTS> memory_work() const {
        const Dram::Counts part = memory_.part();
        return {memory_.requests(), part.row_hits, part.row_opens, part.row_conflicts,
                part.refreshes,     owing_,        bound_};
    }

  private:
    static const int RESET = 8; /* clocks */
    /* Payload of an output that waits for ready: must not change. */
    struct Held {
        bool waits;
        uint64_t a, b, c;
    };
    void take_pixel();
    void check(const char *port, Held &held, bool valid, bool ready, uint64_t a, uint64_t b,
               uint64_t c);

    const Options &o_;
    Run &run_;
    Memory memory_;
    Random random_;
    VerilatedContext context_;
    std::unique_ptr<Vrt_core> core_;
    std::unique_ptr<TextureWatch> textures_;
#if VM_TRACE_FST
    std::unique_ptr<VerilatedFstC> trace_;
#endif
    Held request_ = {false, 0, 0, 0}, pixel_ = {false, 0, 0, 0};
    const uint8_t *idle_ = nullptr; /* rays wait, none is issued */
    uint64_t cycle_ = 0, owing_ = 0, bound_ = 0;
};

inline VerilatedCore::VerilatedCore(const Options &o, const sph_machine &machine, Run &run)
    : o_(o), run_(run), memory_(machine, o, o.seed * 2), random_(o.seed * 2 + 1) {
    context_.randReset(2); /* registers without reset start with noise */
    context_.randSeed(static_cast<int>(o.seed % 2147483647 + 1));
    context_.traceEverOn(!o.trace.empty());
    core_ = std::make_unique<Vrt_core>(&context_, "rt_core");
    if (!o.trace.empty()) {
#if VM_TRACE_FST
        trace_ = std::make_unique<VerilatedFstC>();
        core_->trace(trace_.get(), 99);
        trace_->open(o.trace.c_str());
#else
        fail(run, "this core was built without tracing: WAVES=1 builds one with it");
#endif
    }
    pins.rst = true;
    {
        Silence silence;
        for (int i = 0; i < RESET; i++)
            clock();
    }
    context_.gotFinish(false);
    for (const auto &scope : *context_.scopeNameMap())
        if (const VerilatedVar *idle = scope.second->varFind("issue_idle"))
            idle_ = static_cast<const uint8_t *>(idle->datap());
    textures_ = std::make_unique<TextureWatch>(context_);
    pins.rst = false;
}

inline VerilatedCore::~VerilatedCore() {
    core_->final();
#if VM_TRACE_FST
    if (trace_) trace_->close();
#endif
}

inline void VerilatedCore::check(const char *port, Held &held, bool valid, bool ready, uint64_t a,
                                 uint64_t b, uint64_t c) {
    if (held.waits && (!valid || a != held.a || b != held.b || c != held.c) && !run_.failure[0])
        fail(run_, "clock %llu: %s_valid_o or its payload changed before ready",
             static_cast<unsigned long long>(cycle_), port);
    held = {valid && !ready, a, b, c};
}

inline void VerilatedCore::take_pixel() {
    const uint32_t *c = core_->pix_colour_o;
    sph_pixel p{};
    p.texture = core_->pix_texture_o;
    p.colour[0] = c[0] & 0xffffff;
    p.colour[1] = (c[0] >> 24 | c[1] << 8) & 0xffffff;
    p.colour[2] = (c[1] >> 16 | c[2] << 16) & 0xffffff;
    p.id = core_->pix_id_o;
    p.key = core_->pix_key_o;
    p.visits = core_->pix_visits_o;
    auto frame = static_cast<unsigned>(memory_.machine().regs[SPH_REG_FRAME]);
    if (core_->pix_frame_o != p.colour[frame < SPH_FRAMES ? frame : SPH_FRAMES - 1])
        fail(run_, "clock %llu: the frame mux shows another frame than FRAME = %u",
             static_cast<unsigned long long>(cycle_), frame);
    pixel(core_->pix_x_o, core_->pix_y_o, p);
}

inline Host::Seen VerilatedCore::clock() {
    const Memory::Offer &m = memory_.offer();
    core_->clk = 0;
    core_->rst = pins.rst;
    core_->start_i = pins.start;
    core_->keep_cache_i = pins.keep_cache;
    core_->cfg_valid_i = pins.cfg_valid;
    core_->cfg_addr_i = static_cast<uint8_t>(pins.cfg_addr);
    core_->cfg_data_i = pins.cfg_data;
    core_->count_addr_i = static_cast<uint8_t>(pins.count_addr);
    core_->mem_req_ready_i = m.request_ready;
    core_->mem_rsp_valid_i = m.response_valid;
    core_->mem_rsp_data_i = m.data;
    core_->mem_rsp_error_i = m.error;
    core_->pix_ready_i = !random_.percent(o_.stall);
    core_->eval();
#if VM_TRACE_FST
    if (trace_) trace_->dump(cycle_ * 10);
#endif
    bool request = core_->mem_req_valid_o && !pins.rst, given = core_->pix_valid_o && !pins.rst;
    if (o_.stall) {
        request_.waits = request_.waits && !pins.rst; /* a reset takes back what was offered */
        pixel_.waits = pixel_.waits && !pins.rst;
        check("mem_req", request_, request, m.request_ready, core_->mem_req_line_o, 0, 0);
        check("pix", pixel_, given, core_->pix_ready_i,
              static_cast<uint64_t>(core_->pix_x_o) << 32 | core_->pix_y_o, core_->pix_key_o,
              core_->pix_colour_o[0] | static_cast<uint64_t>(core_->pix_texture_o) << 32);
    }
    if (given && core_->pix_ready_i && pixel) take_pixel();
    if (textures_) pins.rst ? textures_->reset() : textures_->clock();
    if (memory_.waiting()) {
        owing_++;
        bound_ += idle_ && *idle_;
    }
    memory_.take(request, core_->mem_req_line_o, core_->mem_rsp_ready_o);
    core_->clk = 1;
    core_->eval();
#if VM_TRACE_FST
    if (trace_) trace_->dump(cycle_ * 10 + 5);
#endif
    if (context_.gotFinish() && !pins.rst && !run_.failure[0])
        fail(run_, "clock %llu: an assertion in the RTL failed",
             static_cast<unsigned long long>(cycle_));
    cycle_++;
    return {core_->busy_o != 0, core_->errors_o, core_->count_data_o};
}

#endif
