/* life.cpp - see life.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "life.h"

#include <algorithm>
#include <cstdio>
#include <vector>

#include "host.h"
#include "outcome.h"

namespace {

using ull = unsigned long long;
const char *const counter_names[] = {SPH_COUNTER_NAMES};

/* A machine and what the model makes of it. */
struct Scene {
    const sph_machine *machine = nullptr;
    Window window = {0, 0, 0, 0};
    sph_frame frame = {0, 0, nullptr};
    sph_counters counters = {{0}};
    uint32_t errors = 0;
};

bool draw(const sph_machine &m, Scene &s, std::string &error) {
    sph_error err = {{0}};
    sph_render_options how{};
    how.traverse = SPH_TRAVERSE_TREE;
    int errors = sph_render(&m, &how, &s.frame, &s.counters, &err);
    s.machine = &m;
    s.window = {m.regs[SPH_REG_WIN_X0], m.regs[SPH_REG_WIN_Y0], m.regs[SPH_REG_WIN_X1],
                m.regs[SPH_REG_WIN_Y1]};
    s.errors = static_cast<uint32_t>(errors);
    if (errors < 0) error = err.text;
    return errors >= 0;
}

class Life {
  public:
    Life(const Options &o, Host &host, Run &run)
        : o_(o), host_(host), run_(run), random_(o.seed * 2 + 7) {}
    void take_up(const Scene &s);
    void frame(const Scene &s, const char *what);
    void resets(const Scene &s);
    bool fine() const { return !run_.failure[0]; }

    uint64_t frames = 0, clocks = 0, longest = 0;

  private:
    void compare_pixels(const Scene &s, const char *what);
    void compare_counters(const Scene &s, const char *what, uint64_t cycles, Host::Seen seen);

    const Options &o_;
    Host &host_;
    Run &run_;
    Random random_;
    std::vector<Sample> samples_;
    int first_ = 0; /* counter that is read in the clock in which busy_o falls */
};

void Life::take_up(const Scene &s) {
    host_.memory().put(*s.machine);
    configure(host_, *s.machine, s.window);
}

void Life::compare_pixels(const Scene &s, const char *what) {
    const Window &w = s.window;
    for (int y = w.y0; y < w.y1; y++)
        for (int x = w.x0; x < w.x1; x++) {
            size_t at = static_cast<size_t>(y) * static_cast<size_t>(s.frame.width) +
                        static_cast<size_t>(x);
            if (equal(s.frame.pixels[at], samples_[at]) || !fine()) continue;
            fail(run_, "%s: pixel %d %d\n%s", what, x, y,
                 difference(*s.machine, s.frame.pixels[at], samples_[at], x, y).c_str());
        }
}

void Life::compare_counters(const Scene &s, const char *what, uint64_t cycles, Host::Seen seen) {
    if (seen.errors != s.errors)
        fail(run_, "%s: errors 0x%x, wanted 0x%x", what, seen.errors, s.errors);
    for (int i = 0; i < SPH_COUNTERS; i++) {
        int number = (first_ + i) % SPH_COUNTERS;
        host_.pins.count_addr = number;
        uint64_t count = host_.clock().count, wanted = s.counters.count[number];
        if (number == SPH_COUNT_CYCLES)
            wanted = cycles;
        else if (!sph_counter_both(number))
            continue;
        if (count != wanted && fine())
            fail(run_, "%s: counter %s %llu, wanted %llu", what, counter_names[number],
                 static_cast<ull>(count), static_cast<ull>(wanted));
    }
    first_ = (first_ + 1) % SPH_COUNTERS;
}

/* One frame, from start_i on. */
void Life::frame(const Scene &s, const char *what) {
    if (!fine()) return;
    uint64_t clock = 0, last = 0; /* since start_i */
    run_.window = s.window;
    samples_.assign(static_cast<size_t>(s.frame.width) * static_cast<size_t>(s.frame.height),
                    Sample{});
    host_.pixel = [&](int x, int y, const sph_pixel &p) {
        deliver(*s.machine, run_, samples_.data(), x, y, p, clock);
        last = clock;
    };
    host_.pins.start = true;
    Host::Seen seen = host_.clock();
    host_.pins.start = false;
    while (seen.busy && fine()) {
        clock++;
        seen = host_.clock();
        if (clock - last > o_.watchdog) fail(run_, "%s: no pixel for too long", what);
    }
    host_.pixel = nullptr;
    if (fine()) compare_pixels(s, what);
    if (fine()) compare_counters(s, what, last, seen);
    frames++;
    clocks += clock;
    longest = std::max(longest, clock);
}

/* A frame is cut off in each clock that one has, or in some. */
void Life::resets(const Scene &s) {
    const uint64_t all = longest, cuts = o_.cuts ? static_cast<uint64_t>(o_.cuts) : all;
    for (uint64_t i = 0; i < cuts && fine(); i++) {
        uint64_t at = o_.cuts ? random_.below(static_cast<uint32_t>(all)) : i;
        int length = random_.percent(20) ? 2 + static_cast<int>(random_.below(4)) : 1;
        bool drain = random_.percent(20);
        char what[80];
        std::snprintf(what, sizeof what, "behind a reset of %d in clock %llu%s", length,
                      static_cast<ull>(at), drain ? ", until memory had answered" : "");
        interrupt(host_, static_cast<int64_t>(at), length, drain);
        frame(s, what);
        clocks += at;
    }
}

} // namespace

int live(const Options &o, const sph_machine &machine, Run &run, std::string &error) {
    sph_machine second{};
    sph_error err = {{0}};
    if (!o.then.empty() && sph_machine_read(o.then.c_str(), &second, &err))
        return error = err.text, 2;
    Scene a, b;
    if (!draw(machine, a, error)) return 2;
    if (!o.then.empty() && !draw(second, b, error)) return 2;
    auto host = make_host(o, machine, run);
    if (!host) return error = "--life: not in this simulator", 2;
    Life life(o, *host, run);
    life.take_up(a);
    life.frame(a, "the first frame");
    if (!o.then.empty()) {
        life.take_up(b);
        life.frame(b, "the second machine");
        life.take_up(a);
        life.frame(a, "the first machine again");
        life.frame(a, "the first machine once more");
    }
    life.resets(a);
    std::printf("core %s %s life: %llu pixels, %d mismatches, %llu cycles, %llu frames, some cut "
                "off\n",
                machine.name, sph_machine_profile(&machine)->name, static_cast<ull>(run.pixels),
                !life.fine(), static_cast<ull>(life.clocks), static_cast<ull>(life.frames));
    sph_frame_free(&a.frame);
    sph_frame_free(&b.frame);
    if (!o.then.empty()) sph_machine_free(&second);
    return life.fine() ? 0 : 1;
}
