/* trials.h - what a host may do to a core, at random, and the clean frame behind it
 * SPDX-License-Identifier: Apache-2.0
 *
 * Each trial takes one of the machines, does something to the core, and has a clean frame of that
 * machine drawn, which must be the model's. Where the model knows what comes of a trial (random
 * words in memory and registers, limits), that frame must be the model's as well. Resets go through
 * all clocks of a machine's frame in turn, bus errors through all its requests and their beats.
 */
#ifndef TB_TRIALS_H
#define TB_TRIALS_H

#include <deque>

#include "events.h"
#include "options.h"
#include "player.h"

/* Does o.trials trials, and prints `met NUMBER EVENT` for each kind of event. */
void try_all(const Options &o, Player &player, const std::deque<Scene> &scenes);

/* ---- trials_class ---- */

class Trials {
  public:
    Trials(const Options &o, Player &player, const std::deque<Scene> &scenes)
        : o_(o), player_(player), random_(player.random()) {
        for (const Scene &s : scenes)
            subjects_.push_back({&s, 0, 0, 0, 0});
    }
    void run();
    void tell() const;

  private:
    /* A machine, and how far resets and bus errors have gone through its frame. */
    struct Subject {
        const Scene *scene;
        uint64_t length, requests, cut, spoilt; /* spoilt: requests times BEATS */
    };
    using Trial = void (Trials::*)();

    void met(Event e, uint64_t times = 1) { met_[e] += times; }
    void clean(const char *behind, bool may_keep);
    void as_model(const sph_machine &m, const char *what);
    void memory(const sph_machine &m);
    bool model(const sph_machine &m, Scene &s);
    uint32_t errors_of(const sph_machine &m);
    int pick(int n) { return static_cast<int>(random_.below(static_cast<uint32_t>(n))); }

    void reset();
    void another_machine();
    void keep_changed();
    void busy();
    void at_once();
    void bus_error();
    void silent();
    void blocked();
    void refused();
    void windows();
    void words();
    void registers();
    void register_words();
    void moved();
    void memory_ends();
    void visits_end();
    void stack_ends();

    const Options &o_;
    Player &player_;
    Random &random_;
    std::vector<Subject> subjects_;
    Subject *now_ = nullptr;
    const sph_machine *cached_ = nullptr; /* whose lines the caches may hold alone; null: unknown */
    uint64_t met_[EVENT_COUNT] = {};
};

#endif
