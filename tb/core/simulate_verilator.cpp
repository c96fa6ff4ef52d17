/* simulate_verilator.cpp - the verilated core; see simulate.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * One clock: clk low, inputs change, outputs settle, handshakes are looked at; clk high.
 */
#include "simulate.h"

#include <time.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "Vrt_core.h"
#include "memory.h"
#include "silence.h"
#include "texture_watch.h"
#include "verilated.h"
#if VM_TRACE_FST
#include "verilated_fst_c.h"
#endif

const char *const simulator_name = "verilator";

std::string simulator_version() {
    return Verilated::productVersion();
}

double sc_time_stamp() {
    return 0;
}

/* $finish in the RTL: an assertion there failed. Verilator's own one may end the process. */
void vl_finish(const char *, int, const char *) {
    Verilated::threadContextp()->gotFinish(true);
}

namespace {

const int RESET = 8; /* clocks */
const int DRAIN = 4; /* clocks between two passes */

/* Payload of an output that waits for ready: must not change. */
struct Held {
    bool waits;
    uint64_t a, b, c;
};

class Bench {
  public:
    Bench(const Options &o, const sph_machine &machine, Run &run);
    ~Bench();
    void configure();
    void pass(Sample *samples, bool keep, Pass &out);

  private:
    void clock();
    void take_pixel();
    void check(const char *port, Held &held, bool valid, bool ready, uint64_t a, uint64_t b,
               uint64_t c);
    void hang(const char *why);
    uint64_t counter(int number);

    const Options &o_;
    const sph_machine &machine_;
    Run &run_;
    Memory memory_;
    Random random_;
    VerilatedContext context_;
    std::unique_ptr<Vrt_core> core_;
    std::unique_ptr<TextureWatch> textures_;
#if VM_TRACE_FST
    std::unique_ptr<VerilatedFstC> trace_;
#endif
    Sample *samples_ = nullptr;
    Held request_ = {false, 0, 0, 0}, pixel_ = {false, 0, 0, 0};
    uint64_t cycle_ = 0, last_pixel_ = 0;
};

Bench::Bench(const Options &o, const sph_machine &machine, Run &run)
    : o_(o), machine_(machine), run_(run),
      memory_(machine, o.latency, o.stall, o.seed * 2, o.bus_error_at), random_(o.seed * 2 + 1) {
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
    core_->cfg_valid_i = 0;
    core_->start_i = 0;
    core_->keep_cache_i = 0;
    core_->count_addr_i = 0;
    core_->rst = 1;
    {
        Silence silence;
        for (int i = 0; i < RESET; i++)
            clock();
    }
    context_.gotFinish(false);
    textures_ = std::make_unique<TextureWatch>(context_);
    core_->rst = 0;
    request_.waits = pixel_.waits = false;
}

Bench::~Bench() {
    core_->final();
#if VM_TRACE_FST
    if (trace_) trace_->close();
#endif
}

void Bench::configure() {
    for (int i = 0; i < SPH_N_REGS; i++) {
        const Window &w = run_.window;
        int32_t value = i == SPH_REG_WIN_X0   ? w.x0
                        : i == SPH_REG_WIN_Y0 ? w.y0
                        : i == SPH_REG_WIN_X1 ? w.x1
                        : i == SPH_REG_WIN_Y1 ? w.y1
                                              : machine_.regs[i];
        core_->cfg_valid_i = 1;
        core_->cfg_addr_i = static_cast<uint8_t>(i);
        core_->cfg_data_i = static_cast<uint32_t>(value);
        clock();
    }
    core_->cfg_valid_i = 0;
}

void Bench::check(const char *port, Held &held, bool valid, bool ready, uint64_t a, uint64_t b,
                  uint64_t c) {
    if (held.waits && (!valid || a != held.a || b != held.b || c != held.c) && !run_.failure[0])
        fail(run_, "clock %llu: %s_valid_o or its payload changed before ready",
             static_cast<unsigned long long>(cycle_), port);
    held = {valid && !ready, a, b, c};
}

void Bench::take_pixel() {
    const uint32_t *c = core_->pix_colour_o;
    sph_pixel p{};
    p.texture = core_->pix_texture_o;
    p.colour[0] = c[0] & 0xffffff;
    p.colour[1] = (c[0] >> 24 | c[1] << 8) & 0xffffff;
    p.colour[2] = (c[1] >> 16 | c[2] << 16) & 0xffffff;
    p.id = core_->pix_id_o;
    p.key = core_->pix_key_o;
    p.visits = core_->pix_visits_o;
    auto frame = static_cast<unsigned>(machine_.regs[SPH_REG_FRAME]);
    if (core_->pix_frame_o != p.colour[frame < SPH_FRAMES ? frame : SPH_FRAMES - 1])
        fail(run_, "clock %llu: the frame mux shows another frame than FRAME = %u",
             static_cast<unsigned long long>(cycle_), frame);
    deliver(machine_, run_, samples_, core_->pix_x_o, core_->pix_y_o, p);
    last_pixel_ = cycle_;
}

void Bench::clock() {
    const Memory::Offer &m = memory_.offer();
    core_->clk = 0;
    core_->mem_req_ready_i = m.request_ready;
    core_->mem_rsp_valid_i = m.response_valid;
    core_->mem_rsp_data_i = m.data;
    core_->mem_rsp_error_i = m.error;
    core_->pix_ready_i = !random_.percent(o_.stall);
    core_->eval();
#if VM_TRACE_FST
    if (trace_) trace_->dump(cycle_ * 10);
#endif
    bool request = core_->mem_req_valid_o && !core_->rst, pixel = core_->pix_valid_o && !core_->rst;
    if (o_.stall) {
        check("mem_req", request_, request, m.request_ready, core_->mem_req_line_o, 0, 0);
        check("pix", pixel_, pixel, core_->pix_ready_i,
              static_cast<uint64_t>(core_->pix_x_o) << 32 | core_->pix_y_o, core_->pix_key_o,
              core_->pix_colour_o[0] | static_cast<uint64_t>(core_->pix_texture_o) << 32);
    }
    if (pixel && core_->pix_ready_i && samples_) take_pixel();
    if (!core_->rst) textures_->clock();
    memory_.take(request, core_->mem_req_line_o, core_->mem_rsp_ready_o);
    core_->clk = 1;
    core_->eval();
#if VM_TRACE_FST
    if (trace_) trace_->dump(cycle_ * 10 + 5);
#endif
    if (context_.gotFinish() && !core_->rst && !run_.failure[0])
        fail(run_, "clock %llu: an assertion in the RTL failed",
             static_cast<unsigned long long>(cycle_));
    cycle_++;
}

uint64_t Bench::counter(int number) {
    core_->count_addr_i = static_cast<uint8_t>(number);
    clock();
    core_->eval();
    return core_->count_data_o;
}

void Bench::hang(const char *why) {
    using ull = unsigned long long;
    fail(run_, "clock %llu: %s, %llu of %llu pixels delivered, the last in clock %llu",
         static_cast<ull>(cycle_), why, static_cast<ull>(run_.pixels),
         static_cast<ull>(run_.window.x1 - run_.window.x0) *
             static_cast<ull>(run_.window.y1 - run_.window.y0),
         static_cast<ull>(last_pixel_));
    fail(run_, "  busy %d, errors 0x%02x, mem_req valid %d line %u, mem_rsp valid %d ready %d",
         core_->busy_o, core_->errors_o, core_->mem_req_valid_o, core_->mem_req_line_o,
         core_->mem_rsp_valid_i, core_->mem_rsp_ready_o);
    fail(run_, "  pix valid %d (%d %d), memory owes %zu of %llu lines", core_->pix_valid_o,
         core_->pix_x_o, core_->pix_y_o, memory_.waiting(), static_cast<ull>(memory_.requests()));
    static const char *const names[] = {SPH_COUNTER_NAMES};
    for (int i = 0; i < SPH_COUNTERS; i++)
        fail(run_, "  counter %-15s %llu", names[i], static_cast<ull>(counter(i)));
}

void Bench::pass(Sample *samples, bool keep, Pass &out) {
    samples_ = samples;
    core_->keep_cache_i = keep;
    core_->start_i = 1;
    last_pixel_ = cycle_;
    const uint64_t begin = cycle_, missed = textures_->missed();
    clock();
    core_->start_i = 0;
    while (core_->busy_o && !run_.failure[0] && !run_.stopped) {
        clock();
        if (cycle_ - last_pixel_ > o_.watchdog) hang("no pixel for too long");
        if (o_.max_cycles && cycle_ - begin > o_.max_cycles) hang("more clocks than --max-cycles");
    }
    samples_ = nullptr;
    if (run_.stopped) return;
    for (int i = 0; i < DRAIN; i++)
        clock();
    out.errors = core_->errors_o;
    for (int i = 0; i < SPH_COUNTERS; i++)
        out.count[i] = counter(i);
    uint64_t misses = out.count[SPH_COUNT_TEXEL_MISSES], predicted = textures_->missed() - missed;
    if ((misses != predicted || textures_->impossible()) && !run_.failure[0])
        fail(run_, "counter texel_misses %llu, by the model's cache %llu%s",
             static_cast<unsigned long long>(misses), static_cast<unsigned long long>(predicted),
             textures_->impossible() ? " up to a lookup that it refuses" : "");
    if (memory_.out_of_range())
        fail(run_, "the core asked for %llu lines beyond its memory",
             static_cast<unsigned long long>(memory_.out_of_range()));
}

/* Of this process and its threads. */
double cpu_seconds() {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec) * 1e-9;
}

} // namespace

void simulate(const Options &o, const sph_machine &machine, Sample *samples[PASSES], Run &run) {
    auto begin = std::chrono::steady_clock::now();
    double cpu = cpu_seconds();
    Bench bench(o, machine, run);
    bench.configure();
    bench.pass(samples[COLD], false, run.pass[COLD]);
    if (o.warm && !run.failure[0] && !run.stopped) bench.pass(samples[WARM], true, run.pass[WARM]);
    run.cpu = cpu_seconds() - cpu;
    run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}
