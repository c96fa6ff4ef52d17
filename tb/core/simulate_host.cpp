/* simulate_host.cpp - simulate() by make_host(): a core that is driven a clock at a time
 * SPDX-License-Identifier: Apache-2.0
 *
 * Linked with simulate_cxxrtl.cpp or simulate_netlist.cpp, whose make_host() always gives a core.
 */
#include <chrono>

#include "host.h"
#include "progress.h"

namespace {

void pass(Host &core, const Options &o, bool keep, Sample *samples, Run &run, Pass &out) {
    uint64_t clock = 0, last = 0; /* since the start; of the last pixel */
    core.pixel = [&](int x, int y, const sph_pixel &p) {
        last = clock;
        deliver(core.memory().machine(), run, samples, x, y, p, last);
    };
    core.pins.keep_cache = keep;
    core.pins.start = true;
    Host::Seen seen = core.clock();
    core.pins.start = false;
    Progress progress;
    for (clock = 1; seen.busy && !run.failure[0] && !run.stopped; clock++) {
        progress.before(core);
        seen = core.clock();
        progress.after(core, seen, run.pixels);
        run.given_up = progress.quiet() >= o.watchdog;
        if (run.given_up)
            fail(run, "clock %llu: no progress for %llu clocks, the last pixel in clock %llu",
                 static_cast<unsigned long long>(clock),
                 static_cast<unsigned long long>(o.watchdog),
                 static_cast<unsigned long long>(last));
    }
    core.pixel = nullptr;
    out.errors = seen.errors;
    for (int i = 0; i < SPH_COUNTERS; i++) {
        core.pins.count_addr = i;
        out.count[i] = core.clock().count;
    }
}

} // namespace

void simulate(const Options &o, const sph_machine &machine, Sample *samples[PASSES], Run &run) {
    auto begin = std::chrono::steady_clock::now();
    const std::unique_ptr<Host> core = make_host(o, machine, run);
    if (run.failure[0]) return;
    configure(*core, machine, run.window);
    if (o.reset_at >= 0) interrupt(*core, o.reset_at, o.reset_for, false);
    pass(*core, o, false, samples[COLD], run, run.pass[COLD]);
    if (o.warm && !run.failure[0]) pass(*core, o, true, samples[WARM], run, run.pass[WARM]);
    run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}
