/* player.cpp - see player.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <algorithm>
#include <cstdio>
#include <deque>

#include "host.h"
#include "player.h"
#include "outcome.h"
#include "progress.h"
#include "trials.h"

namespace {

using ull = unsigned long long;
const char *const counter_names[] = {SPH_COUNTER_NAMES};

uint64_t area(const Window &w) {
    return w.x0 < w.x1 && w.y0 < w.y1
               ? static_cast<uint64_t>(w.x1 - w.x0) * static_cast<uint64_t>(w.y1 - w.y0)
               : 0;
}

} // namespace

bool draw(const sph_machine &m, Scene &s, std::string &error) {
    sph_error err = {{0}};
    sph_render_options how{};
    how.traverse = SPH_TRAVERSE_TREE;
    how.threads = 1;
    int errors = sph_render(&m, &how, &s.frame, &s.counters, &err);
    s.machine = &m;
    s.window = {m.regs[SPH_REG_WIN_X0], m.regs[SPH_REG_WIN_Y0], m.regs[SPH_REG_WIN_X1],
                m.regs[SPH_REG_WIN_Y1]};
    s.errors = static_cast<uint32_t>(errors);
    if (errors < 0) error = err.text;
    return errors >= 0;
}

void Player::take_up(const sph_machine &machine, const Window &window, bool late) {
    host_.memory().put(machine);
    configure(host_, machine, window);
    if (!late) return;
    /* the last one again: first something else, and the right value with the start */
    host_.pins.cfg_valid = true;
    host_.pins.cfg_addr = SPH_REG_BG_COLOUR;
    host_.pins.cfg_data = ~static_cast<uint32_t>(machine.regs[SPH_REG_BG_COLOUR]);
    host_.clock();
    host_.pins.cfg_data = static_cast<uint32_t>(machine.regs[SPH_REG_BG_COLOUR]);
}

void Player::release() {
    host_.pins.start = host_.pins.cfg_valid = false;
    host_.pixel = nullptr;
    host_.pix_stall = o_.stall;
    host_.memory().silence(false);
}

void Player::run(const sph_machine &machine, const Window &w, const char *what, const How &how) {
    const uint64_t asked = host_.memory().requests();
    uint64_t clock = 0;
    Progress progress;
    last_ = gone_ = starts = writes = 0;
    run_.window = w;
    samples_.assign(static_cast<size_t>(machine.regs[SPH_REG_FRAME_W]) *
                        static_cast<size_t>(machine.regs[SPH_REG_FRAME_H]),
                    Sample{});
    host_.pixel = [&](int x, int y, const sph_pixel &p) {
        deliver(machine, run_, samples_.data(), x, y, p, clock);
        last_ = clock;
        gone_++;
    };
    host_.pins.keep_cache = how.keep;
    host_.pins.start = true;
    seen_ = host_.clock();
    host_.pins.start = host_.pins.cfg_valid = false;
    host_.pins.keep_cache = !how.keep; /* it counts with start alone */
    while (seen_.busy && fine()) {
        clock++;
        if (how.disturb) {
            host_.pins.start = random_.percent(10);
            host_.pins.keep_cache = random_.percent(50);
            host_.pins.cfg_valid = random_.percent(30);
            host_.pins.cfg_addr = static_cast<int>(random_.below(128));
            host_.pins.cfg_data = static_cast<uint32_t>(random_.next());
            host_.pins.count_addr = static_cast<int>(random_.below(32));
            starts += host_.pins.start;
            writes += host_.pins.cfg_valid;
        }
        if (how.silent >= 0) {
            auto now = static_cast<int64_t>(clock);
            const bool on = now >= how.silent && now < how.until;
            if (how.blocked)
                host_.pix_stall = on ? 100 : o_.stall;
            else
                host_.memory().silence(on);
        }
        progress.before(host_, !how.disturb);
        seen_ = host_.clock();
        progress.after(host_, seen_, run_.pixels);
        if (progress.quiet() >= o_.watchdog) fail(run_, "%s: no progress for too long", what);
    }
    release();
    length = clock;
    requests = host_.memory().requests() - asked;
    if (host_.memory().out_of_range()) fail(run_, "%s: a request beyond memory", what);
    frames++;
    clocks += clock;
}

void Player::compare_pixels(const Scene &s, const char *what) {
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

uint64_t Player::counter(int number) {
    host_.pins.count_addr = number;
    Host::Seen seen = host_.clock();
    if (!seen.known) fail(run_, "counter %s has unknown bits", counter_names[number]);
    return seen.count;
}

/* The first of them in the very clock in which busy_o falls, another one each time. */
void Player::compare_counters(const Scene &s, const char *what) {
    for (int i = 0; i < SPH_COUNTERS; i++) {
        int number = (first_ + i) % SPH_COUNTERS;
        uint64_t count = counter(number), wanted = s.counters.count[number];
        if (number == SPH_COUNT_CYCLES) wanted = gone_ ? last_ : count;
        if ((sph_counter_both(number) || number == SPH_COUNT_CYCLES) && count != wanted)
            fail(run_, "%s: counter %s %llu, wanted %llu", what, counter_names[number],
                 static_cast<ull>(count), static_cast<ull>(wanted));
    }
    first_ = (first_ + 1) % SPH_COUNTERS;
}

void Player::frame(const Scene &s, const char *what, const How &how) {
    if (!fine()) return;
    run(*s.machine, s.window, what, how);
    if (fine()) compare_pixels(s, what);
    if (fine() && how.count) compare_counters(s, what);
    if (seen_.errors != s.errors) wrong(what, seen_.errors, s.errors);
}

void Player::wrong(const char *what, uint32_t errors, uint32_t wanted) {
    if (fine()) fail(run_, "%s: errors 0x%x, wanted 0x%x", what, errors, wanted);
}

uint32_t Player::ends(const sph_machine &machine, const Window &w, const char *what,
                      const How &how) {
    if (!fine()) return 0;
    run(machine, w, what, how);
    for (const Sample &sample : samples_)
        if (sample.times > 1 && fine()) fail(run_, "%s: a pixel came twice", what);
    if (gone_ != area(w) && fine())
        fail(run_, "%s: %llu pixels of %llu", what, static_cast<ull>(gone_),
             static_cast<ull>(area(w)));
    return seen_.errors;
}

void Player::refuses(uint32_t errors, const char *what) {
    if (!fine()) return;
    const uint64_t asked = host_.memory().requests();
    uint64_t clock = 0;
    gone_ = 0;
    host_.pixel = [&](int, int, const sph_pixel &) { gone_++; };
    host_.pins.start = true;
    seen_ = host_.clock();
    host_.pins.start = host_.pins.cfg_valid = false;
    while (seen_.busy && clock++ < 2)
        seen_ = host_.clock();
    if (seen_.busy) fail(run_, "%s: busy_o stays", what);
    const uint32_t at_once = seen_.errors;
    rest(30);
    release();
    if (gone_ || host_.memory().requests() != asked) fail(run_, "%s: something is drawn", what);
    if ((at_once != errors || seen_.errors != errors) && fine())
        fail(run_, "%s: errors 0x%x, 0x%x later, wanted 0x%x", what, at_once, seen_.errors, errors);
}

void Player::rest(int n) {
    for (int i = 0; i < n && fine(); i++)
        seen_ = host_.clock();
    clocks += static_cast<uint64_t>(n);
}

/* ---- life ---- */

namespace {

using ull = unsigned long long;

/* A frame is cut off in each clock that one has, or in some. */
void resets(const Options &o, Player &player, const Scene &s, uint64_t longest) {
    const uint64_t cuts = o.cuts ? static_cast<uint64_t>(o.cuts) : longest;
    Random &random = player.random();
    for (uint64_t i = 0; i < cuts && player.fine(); i++) {
        uint64_t at = o.cuts ? random.below(static_cast<uint32_t>(longest)) : i;
        int length = random.percent(20) ? 2 + static_cast<int>(random.below(4)) : 1;
        bool drain = random.percent(20);
        char what[80];
        std::snprintf(what, sizeof what, "behind a reset of %d in clock %llu%s", length,
                      static_cast<ull>(at), drain ? ", until memory had answered" : "");
        interrupt(player.host(), static_cast<int64_t>(at), length, drain);
        player.frame(s, what, {});
        player.clocks += at;
    }
}

/* Frames of all machines without a reset, and of the first again. The longest one of the first. */
uint64_t in_turn(Player &player, const std::deque<Scene> &scenes) {
    uint64_t longest = 0;
    auto next = [&](const Scene &s, const char *what) {
        if (player.fine()) player.take_up(*s.machine, s.window);
        player.frame(s, what, {});
    };
    for (const Scene &s : scenes) {
        next(s, "a machine for the first time");
        if (&s == &scenes.front()) longest = player.length;
    }
    if (scenes.size() == 1) return longest;
    next(scenes.front(), "the first machine again");
    longest = std::max(longest, player.length);
    player.frame(scenes.front(), "the first machine once more", {});
    return std::max(longest, player.length);
}

} // namespace

int live(const Options &o, const sph_machine &machine, Run &run, std::string &error) {
    sph_error err = {{0}};
    std::deque<sph_machine> machines;
    std::deque<Scene> scenes;
    auto add = [&](const sph_machine &m) {
        scenes.emplace_back();
        return draw(m, scenes.back(), error);
    };
    bool ready = add(machine);
    for (const std::string &file : o.then) {
        machines.emplace_back();
        if (!sph_machine_read(file.c_str(), &machines.back(), &err)) {
            ready = ready && add(machines.back());
            continue;
        }
        error = err.text;
        machines.pop_back();
        ready = false;
    }
    if (ready) {
        auto host = make_host(o, machine, run);
        Player player(o, *host, run);
        uint64_t longest = in_turn(player, scenes);
        if (o.trials) {
            try_all(o, player, scenes);
        } else {
            resets(o, player, scenes.front(), longest);
        }
        std::printf("core %s %s life: %llu pixels, %d mismatches, %llu cycles, %llu frames, "
                    "some cut off\n",
                    machine.name, sph_machine_profile(&machine)->name, static_cast<ull>(run.pixels),
                    !player.fine(), static_cast<ull>(player.clocks),
                    static_cast<ull>(player.frames));
    }
    for (Scene &s : scenes)
        sph_frame_free(&s.frame);
    for (sph_machine &m : machines)
        sph_machine_free(&m);
    return !ready ? 2 : run.failure[0] ? 1 : 0;
}
