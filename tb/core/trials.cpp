/* trials.cpp - see trials.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "trials.h"

#include <algorithm>
#include <cstdio>
#include <string>

#include "damage.h"

namespace {

using ull = unsigned long long;

const char *const event_texts[] = {EVENTS(EVENT_TEXT)};
const int BEATS = 4, LONG = 3000, LATE = 120; /* clocks */
const uint32_t SETTLES = 40;                  /* more than counters take behind the last pixel */
const uint32_t BUS = 1u << SPH_ERROR_BUS_ERROR;

} // namespace

/* From now on memory and registers are those of the machine. */
void Trials::memory(const sph_machine &m) {
    const bool late = random_.percent(20);
    player_.take_up(m,
                    {m.regs[SPH_REG_WIN_X0], m.regs[SPH_REG_WIN_Y0], m.regs[SPH_REG_WIN_X1],
                     m.regs[SPH_REG_WIN_Y1]},
                    late);
    met(LATE_WRITE, late);
}

bool Trials::model(const sph_machine &m, Scene &s) {
    std::string error;
    return draw(m, s, error);
}

uint32_t Trials::errors_of(const sph_machine &m) {
    Scene s;
    model(m, s);
    sph_frame_free(&s.frame);
    return s.errors;
}

/* A frame of a machine of one's own, which must be the model's. */
void Trials::as_model(const sph_machine &m, const char *what) {
    Scene s;
    if (!model(m, s)) return;
    memory(m);
    player_.frame(s, what, {});
    cached_ = nullptr;
    sph_frame_free(&s.frame);
    if (s.errors >> SPH_ERROR_BAD_NODE & 1) met(BAD_NODE);
    if (s.errors >> SPH_ERROR_STACK_OVERFLOW & 1) met(STACK_OVERFLOW);
    if (s.errors >> SPH_ERROR_VISIT_LIMIT & 1) met(VISIT_LIMIT);
}

/* The clean frame behind a trial. */
void Trials::clean(const char *behind, bool may_keep) {
    const Scene &s = *now_->scene;
    Player::How how;
    how.keep = may_keep && cached_ == s.machine && random_.percent(50);
    const std::string what = std::string("a clean frame behind ") + behind;
    player_.frame(s, what.c_str(), how);
    cached_ = s.machine;
    if (!now_->length) now_->length = player_.length;
    now_->requests = how.keep ? now_->requests : player_.requests;
    if (!how.keep) return;
    met(KEEP_SAME);
    met(KEEP_SAVED, player_.counter(SPH_COUNT_NODE_MISSES) == 0);
}

void Trials::reset() {
    Host &host = player_.host();
    const int length = 1 + static_cast<int>(random_.below(5));
    const bool drain = random_.percent(30), pins = random_.percent(50), again = random_.percent(20);
    const bool idle = random_.percent(5), end = random_.percent(10);
    const uint64_t at =
        end ? player_.length - std::min<uint64_t>(random_.below(SETTLES), player_.length)
            : now_->cut % (now_->length + 1);
    const int reset_ids[] = {RESET_1, RESET_2, RESET_3, RESET_4, RESET_5};
    char what[80];
    std::snprintf(what, sizeof what, "a reset of %d in clock %llu%s", length, static_cast<ull>(at),
                  drain ? ", until memory had answered" : "");
    if (drain && random_.percent(50)) host.memory().pace(LATE, 0);
    if (!idle) {
        host.pins.keep_cache = false;
        host.pins.start = true;
        host.clock();
        host.pins.start = false;
        now_->cut += !end;
        for (uint64_t i = 0; i < at; i++)
            host.clock();
    }
    for (int round = again ? 2 : 1; round; round--) {
        met(RESET_LATE, drain && host.memory().waiting() >= 1);
        host.pins.rst = true;
        if (!drain) host.memory().reset();
        for (int i = 0; i < length || host.memory().waiting(); i++) {
            host.pins.start = host.pins.cfg_valid = pins;
            host.pins.cfg_addr = pick(SPH_N_REGS);
            host.pins.cfg_data = static_cast<uint32_t>(random_.next());
            host.clock();
        }
        host.pins.rst = host.pins.start = host.pins.cfg_valid = false;
        if (round == 2) player_.rest(static_cast<int>(random_.below(3)));
    }
    player_.clocks += at;
    if (drain) host.memory().pace(o_.latency, o_.stall);
    const bool at_once = random_.percent(70);
    if (!at_once) player_.rest(1 + pick(60));
    met(static_cast<Event>(reset_ids[length - 1]));
    met(RESET_IDLE, idle);
    met(RESET_END, !idle && end);
    met(RESET_AGAIN, again);
    met(RESET_DRAIN, drain);
    met(RESET_PINS, pins);
    met(RESET_START, at_once);
    cached_ = now_->scene->machine; /* none of another */
    const uint64_t kept = met_[KEEP_SAME];
    clean(what, true);
    met(RESET_KEEP, met_[KEEP_SAME] - kept);
}

void Trials::another_machine() {
    now_ = &subjects_[random_.below(static_cast<uint32_t>(subjects_.size()))];
    memory(*now_->scene->machine);
    met(MACHINE);
    clean("another machine", true);
}

/* The host is wrong; the core ends all the same. */
void Trials::keep_changed() {
    Copy other(*now_->scene->machine);
    spoil_words(other.machine, random_);
    memory(other.machine);
    Player::How how;
    how.keep = true;
    player_.ends(other.machine, now_->scene->window, "caches kept, memory changed", how);
    met(KEEP_CHANGED);
    cached_ = nullptr;
    memory(*now_->scene->machine);
    clean("caches kept, memory changed", false);
}

void Trials::busy() {
    Player::How how;
    how.disturb = true;
    player_.frame(*now_->scene, "disturbed while busy", how);
    met(BUSY_START, player_.starts);
    met(BUSY_WRITE, player_.writes);
    clean("one that was disturbed", true);
}

void Trials::at_once() {
    Player::How how;
    how.count = false;
    player_.frame(*now_->scene, "the first of two without a pause", how);
    met(AT_ONCE);
    clean("another without a pause", true);
}

void Trials::bus_error() {
    const uint64_t asked = std::max<uint64_t>(now_->requests, 1), turn = now_->spoilt++;
    const uint64_t request = turn / (BEATS + 1) % asked;
    const auto beat = static_cast<unsigned>(turn % (BEATS + 1));
    const bool one = beat < BEATS;
    const unsigned beats = one ? 1u << beat : 1 + random_.below((1u << BEATS) - 1);
    char what[80];
    std::snprintf(what, sizeof what, "a bus error in request %llu, beats 0x%x",
                  static_cast<ull>(request), beats);
    player_.host().memory().spoil_beats(request, beats);
    Player::How how;
    const uint32_t errors = player_.ends(*now_->scene->machine, now_->scene->window, what, how);
    /* what came without data may lead to fewer requests, never to this one being left out */
    if (player_.fine() && errors != (now_->scene->errors | BUS) && player_.requests > request)
        player_.wrong(what, errors, now_->scene->errors | BUS);
    met(one ? static_cast<Event>(BEAT_0 + static_cast<int>(beat)) : BEATS_MORE);
    met(BUS_ERROR, (errors & BUS) != 0);
    player_.host().memory().spoil_beats(0, 0);
    cached_ = now_->scene->machine;
    const uint64_t kept = met_[KEEP_SAME];
    clean(what, true);
    met(BUS_KEEP, met_[KEEP_SAME] - kept);
}

void Trials::silent() {
    const auto from = static_cast<int64_t>(random_.below(static_cast<uint32_t>(now_->length + 1)));
    if (random_.percent(50)) {
        Player::How how;
        how.silent = from;
        how.until = from + LONG;
        player_.frame(*now_->scene, "memory silent for long", how);
        met(SILENT);
        return clean("memory silent for long", true);
    }
    Host &host = player_.host();
    host.pins.keep_cache = false;
    host.pins.start = true;
    host.clock();
    host.pins.start = false;
    host.memory().silence(true);
    player_.rest(LONG);
    host.pins.rst = true;
    host.memory().reset();
    host.memory().silence(false);
    player_.rest(1 + pick(5));
    host.pins.rst = false;
    met(DEAD);
    cached_ = nullptr;
    clean("memory that never answered", false);
}

void Trials::blocked() {
    Player::How how;
    how.blocked = true;
    how.silent = static_cast<int64_t>(random_.below(static_cast<uint32_t>(now_->length + 1)));
    how.until = how.silent + LONG;
    player_.frame(*now_->scene, "no pixel taken for long", how);
    met(BLOCKED);
    clean("no pixel taken for long", true);
}

void Trials::run() {
    static const Trial trials[] = {&Trials::reset,           &Trials::reset,
                                   &Trials::reset,           &Trials::reset,
                                   &Trials::reset,           &Trials::bus_error,
                                   &Trials::bus_error,       &Trials::bus_error,
                                   &Trials::bus_error,       &Trials::words,
                                   &Trials::words,           &Trials::words,
                                   &Trials::words,           &Trials::registers,
                                   &Trials::registers,       &Trials::register_words,
                                   &Trials::moved,           &Trials::moved,
                                   &Trials::keep_changed,    &Trials::busy,
                                   &Trials::at_once,         &Trials::silent,
                                   &Trials::blocked,         &Trials::refused,
                                   &Trials::windows,         &Trials::memory_ends,
                                   &Trials::visits_end,      &Trials::stack_ends,
                                   &Trials::another_machine, &Trials::another_machine};
    const int kinds = static_cast<int>(sizeof trials / sizeof *trials);
    now_ = &subjects_.front();
    for (int64_t i = 0; i < o_.trials && player_.fine(); i++) {
        if (random_.percent(20)) {
            const int latency = 1 + pick(random_.percent(10) ? 400 : 2 * o_.latency);
            player_.host().memory().pace(latency, random_.percent(50) ? 0 : pick(60));
        }
        (this->*trials[pick(kinds)])();
    }
}

void Trials::tell() const {
    for (int i = 0; i < EVENT_COUNT; i++)
        std::printf("met %llu %s\n", static_cast<ull>(met_[i]), event_texts[i]);
    for (const Subject &s : subjects_)
        std::printf("swept %s: resets in %llu of %llu clocks, bus errors in %llu of %llu beats\n",
                    s.scene->machine->name, static_cast<ull>(std::min(s.cut, s.length)),
                    static_cast<ull>(s.length),
                    static_cast<ull>(std::min(s.spoilt * BEATS / (BEATS + 1), s.requests * BEATS)),
                    static_cast<ull>(s.requests * BEATS));
}

void try_all(const Options &o, Player &player, const std::deque<Scene> &scenes) {
    Trials trials(o, player, scenes);
    trials.run();
    trials.tell();
}
