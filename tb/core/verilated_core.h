/* verilated_core.h - the verilated core with its memory, a clock at a time; see host.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * One clock: clk low, inputs change, outputs settle, handshakes are looked at; clk high. Included
 * by simulate_verilator.cpp alone.
 */
#ifndef TB_VERILATED_CORE_H
#define TB_VERILATED_CORE_H

#include <algorithm>
#include <array>
#include <cstring>

#include "Vrt_core.h"
#include "host.h"
#include "silence.h"
#include "stage_watch.h"
#include "texture_watch.h"
#include "verilated.h"
#include "verilated_syms.h"
#include "work_watch.h"
#if VM_TRACE_FST
#include "verilated_fst_c.h"
#endif

class VerilatedCore : public PortHost {
  public:
    VerilatedCore(const Options &o, const sph_machine &machine, Run &run);
    ~VerilatedCore() override;
    Vrt_core &ports() { return *core_; }
    TextureWatch &textures() { return *textures_; }
    WorkWatch &work() { return *work_; }
    /* What memory did up to now, by MEMORY_... */
    std::array<uint64_t, MEMORY_COUNTS> memory_work() {
        const Dram::Counts part = memory().part();
        return {memory().requests(), part.row_hits, part.row_opens, part.row_conflicts,
                part.refreshes,      owing_,        bound_};
    }

  private:
    static const int RESET = 8; /* clocks */
    static const unsigned BEAT = 8 * sizeof Vrt_core::mem_rsp_data_i;
    void step(const Inputs &in, Outputs &out) override;

    VerilatedContext context_;
    std::unique_ptr<Vrt_core> core_;
    std::unique_ptr<TextureWatch> textures_;
    std::unique_ptr<WorkWatch> work_;
    std::unique_ptr<StageWatch> stages_;
#if VM_TRACE_FST
    std::unique_ptr<VerilatedFstC> trace_;
#endif
    const uint8_t *idle_ = nullptr; /* rays wait, none is issued */
    uint64_t owing_ = 0, bound_ = 0;
    /* A named part is at work as long as its pins need for the lines that were asked for. */
    double line_clocks_ = 0, pins_ = 0;
    uint8_t memory_work_ = 0; /* as WorkWatch has it */
};

inline VerilatedCore::VerilatedCore(const Options &o, const sph_machine &machine, Run &run)
    : PortHost(o, machine, run) {
    memory().width(BEAT);
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
    if (const DramPart *part = dram_part(o.memory))
        line_clocks_ = Dram::LINE_BYTES /
                       std::min(BEAT / 8.0, Dram::peak(*part, static_cast<unsigned>(o.core_mhz)));
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
    work_ = std::make_unique<WorkWatch>(context_, "memory_" + o.memory,
                                        dram_part(o.memory) ? &memory_work_ : nullptr);
    if (run.stages) {
        stages_ =
            std::make_unique<StageWatch>(context_, machine, o.pixel[0], o.pixel[1], *run.stages);
        run.stages_shown = stages_->shown();
        if (!run.stages_shown) fail(run, "this core was built without its stages shown: STAGES=1");
    }
    pins.rst = false;
}

inline VerilatedCore::~VerilatedCore() {
    core_->final();
#if VM_TRACE_FST
    if (trace_) trace_->close();
#endif
}

inline void VerilatedCore::step(const Inputs &in, Outputs &out) {
    core_->clk = 0;
    core_->rst = in.pins.rst;
    core_->start_i = in.pins.start;
    core_->keep_cache_i = in.pins.keep_cache;
    core_->cfg_valid_i = in.pins.cfg_valid;
    core_->cfg_addr_i = static_cast<uint8_t>(in.pins.cfg_addr);
    core_->cfg_data_i = in.pins.cfg_data;
    core_->count_addr_i = static_cast<uint8_t>(in.pins.count_addr);
    core_->mem_req_ready_i = in.memory.request_ready;
    core_->mem_rsp_valid_i = in.memory.response_valid;
    core_->mem_rsp_tag_i = static_cast<uint8_t>(in.memory.tag);
    std::memcpy(&core_->mem_rsp_data_i, in.memory.data.data(), BEAT / 8);
    core_->mem_rsp_error_i = in.memory.error;
    core_->pix_ready_i = in.pix_ready;
    core_->eval();
#if VM_TRACE_FST
    if (trace_) trace_->dump(cycle() * 10);
#endif
    if (stages_ && !in.pins.rst) stages_->clock();
    if (textures_) in.pins.rst ? textures_->reset() : textures_->clock();
    if (memory().waiting()) {
        owing_++;
        bound_ += idle_ && *idle_;
    }
    const bool asked = core_->mem_req_valid_o && in.memory.request_ready;
    if (asked) pins_ += line_clocks_;
    memory_work_ =
        static_cast<uint8_t>((core_->mem_req_valid_o && !asked) << 7 | asked << 6 | (pins_ > 0));
    pins_ = std::max(0.0, pins_ - 1);
    if (work_) work_->clock();
    out.req_valid = core_->mem_req_valid_o;
    out.req_line = core_->mem_req_line_o;
    out.req_tag = core_->mem_req_tag_o;
    out.rsp_ready = core_->mem_rsp_ready_o;
    out.pix_valid = core_->pix_valid_o;
    out.x = core_->pix_x_o;
    out.y = core_->pix_y_o;
    out.pix_frame = core_->pix_frame_o;
    const uint32_t *words = core_->pix_colour_o;
    colours(words, out.pixel);
    out.pixel.texture = core_->pix_texture_o;
    out.pixel.id = core_->pix_id_o;
    out.pixel.key = core_->pix_key_o;
    out.pixel.visits = core_->pix_visits_o;
    core_->clk = !o_.gated || core_->active_o;
    core_->eval();
#if VM_TRACE_FST
    if (trace_) trace_->dump(cycle() * 10 + 5);
#endif
    if (context_.gotFinish() && !in.pins.rst && !run_.failure[0])
        fail(run_, "clock %llu: an assertion in the RTL failed",
             static_cast<unsigned long long>(cycle()));
    out.seen = {core_->busy_o != 0, core_->errors_o, core_->count_data_o, true};
}

#endif
