/* simulate_verilator.cpp - the verilated core; see simulate.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "simulate.h"

#include <time.h>

#include <algorithm>
#include <chrono>

#include "progress.h"
#include "verilated_core.h"

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

#ifdef NETLIST /* of lab/faults/drawn: signals of inner modules have no names in it */
constexpr bool SHOWN = false;
#else
constexpr bool SHOWN = true;
#endif

using ull = unsigned long long;

class Bench {
  public:
    Bench(const Options &o, const sph_machine &machine, Run &run)
        : o_(o), run_(run), core_(o, machine, run), random_(o.seed * 2 + 3) {}
    void pass(Sample *samples, bool keep, Pass &out);
    VerilatedCore &core() { return core_; }

  private:
    void disturb();
    void hang(const char *why, uint64_t last_pixel);
    uint64_t counter(int number) {
        core_.pins.count_addr = number;
        return core_.clock().count;
    }

    const Options &o_;
    Run &run_;
    VerilatedCore core_;
    Random random_;
};

/* What a busy core must ignore: starts, writes of registers. */
void Bench::disturb() {
    core_.pins.start = random_.percent(5);
    core_.pins.cfg_valid = random_.percent(20);
    core_.pins.cfg_addr = static_cast<int>(random_.below(128));
    core_.pins.cfg_data = static_cast<uint32_t>(random_.next());
}

void Bench::hang(const char *why, uint64_t last_pixel) {
    run_.given_up = true;
    const Vrt_core &p = core_.ports();
    fail(run_, "clock %llu: %s, %llu of %llu pixels delivered, the last in clock %llu",
         static_cast<ull>(core_.cycle()), why, static_cast<ull>(run_.pixels),
         static_cast<ull>(run_.window.x1 - run_.window.x0) *
             static_cast<ull>(run_.window.y1 - run_.window.y0),
         static_cast<ull>(last_pixel));
    fail(run_,
         "  busy %d, errors 0x%02x, mem_req valid %d line %u tag %u, mem_rsp valid %d ready %d",
         p.busy_o, p.errors_o, p.mem_req_valid_o, p.mem_req_line_o, p.mem_req_tag_o,
         p.mem_rsp_valid_i, p.mem_rsp_ready_o);
    fail(run_, "  pix valid %d (%d %d), memory owes %zu of %llu lines", p.pix_valid_o, p.pix_x_o,
         p.pix_y_o, core_.memory().waiting(), static_cast<ull>(core_.memory().requests()));
    static const char *const names[] = {SPH_COUNTER_NAMES};
    for (int i = 0; i < SPH_COUNTERS; i++)
        fail(run_, "  counter %-15s %llu", names[i], static_cast<ull>(counter(i)));
}

void Bench::pass(Sample *samples, bool keep, Pass &out) {
    const uint64_t begin = core_.cycle(), missed = core_.textures().missed();
    const auto work = core_.memory_work();
    uint64_t last_pixel = begin;
    core_.work().reset();
    core_.pixel = [&](int x, int y, const sph_pixel &p) {
        last_pixel = core_.cycle();
        deliver(core_.memory().machine(), run_, samples, x, y, p, last_pixel - begin);
    };
    core_.pins.keep_cache = keep;
    core_.pins.start = true;
    Host::Seen seen = core_.clock();
    core_.pins.start = false;
    Progress progress;
    while (seen.busy && !run_.failure[0] && !run_.stopped) {
        if (o_.stall) disturb();
        progress.before(core_);
        seen = core_.clock();
        progress.after(core_, seen, run_.pixels);
        if (progress.quiet() >= o_.watchdog) hang("no progress for too long", last_pixel);
        if (o_.max_cycles && core_.cycle() - begin > o_.max_cycles)
            hang("more clocks than --max-cycles", last_pixel);
    }
    core_.pins.start = core_.pins.cfg_valid = false;
    core_.pixel = nullptr;
    if (run_.stopped) return;
    out.errors = seen.errors;
    out.works = core_.work().rows(out.work);
    const auto worked = core_.memory_work();
    for (size_t i = 0; i < MEMORY_COUNTS; i++)
        out.memory[i] = worked[i] - work[i];
    uint64_t cycles = counter(SPH_COUNT_CYCLES); /* at once: the last one to be complete */
    if (cycles != last_pixel - begin && !run_.failure[0])
        fail(run_, "counter cycles %llu, %llu clocks from start to the last pixel",
             static_cast<ull>(cycles), static_cast<ull>(last_pixel - begin));
    for (int i = 0; i < SPH_COUNTERS; i++)
        out.count[i] = counter(i);
    uint64_t misses = out.count[SPH_COUNT_TEXEL_MISSES],
             predicted = core_.textures().missed() - missed;
    if (SHOWN && (misses != predicted || core_.textures().impossible()) && !run_.failure[0])
        fail(run_, "counter texel_misses %llu, by the model's cache %llu%s",
             static_cast<ull>(misses), static_cast<ull>(predicted),
             core_.textures().impossible() ? " up to a lookup that it refuses" : "");
    if (core_.memory().out_of_range())
        fail(run_, "the core asked for %llu lines beyond its memory",
             static_cast<ull>(core_.memory().out_of_range()));
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
    configure(bench.core(), machine, run.window);
    if (o.reset_at >= 0) interrupt(bench.core(), o.reset_at, o.reset_for, false);
    auto spoil = [&] {
        std::vector<bool> lines(machine.lines);
        std::fill(lines.begin() + std::min<int64_t>(o.spoil, machine.lines), lines.end(), true);
        bench.core().memory().spoil(lines);
    };
    if (o.spoil >= 0 && !o.warm) spoil();
    bench.pass(samples[COLD], false, run.pass[COLD]);
    if (o.spoil >= 0 && o.warm) spoil();
    if (o.warm && !run.failure[0] && !run.stopped) bench.pass(samples[WARM], true, run.pass[WARM]);
    run.cpu = cpu_seconds() - cpu;
    run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

std::unique_ptr<Host> make_host(const Options &o, const sph_machine &machine, Run &run) {
    return std::make_unique<VerilatedCore>(o, machine, run);
}
