/* life.cpp - see life.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "life.h"

#include <algorithm>
#include <cstdio>
#include <deque>

#include "host.h"
#include "outcome.h"
#include "player.h"
#include "trials.h"

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
