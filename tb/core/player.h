/* player.h - frames of one core, each compared with the model's
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef TB_PLAYER_H
#define TB_PLAYER_H

#include <string>
#include <vector>

#include "host.h"
#include "options.h"
#include "simulate.h"

/* A machine and what the model makes of it. */
struct Scene {
    const sph_machine *machine = nullptr;
    Window window = {0, 0, 0, 0};
    sph_frame frame = {0, 0, nullptr};
    sph_counters counters = {{0}};
    uint32_t errors = 0;
};

/* Draws the machine by the model, into a scene whose frame is then to be freed. */
bool draw(const sph_machine &m, Scene &s, std::string &error);

class Player {
  public:
    Player(const Options &o, Host &host, Run &run)
        : o_(o), host_(host), run_(run), random_(o.seed * 2 + 7) {}

    /* Memory and registers are those of the machine; the last one is written together with the
     * start if `late`. */
    void take_up(const sph_machine &machine, const Window &window, bool late = false);

    struct How {
        bool keep = false;    /* keep_cache_i */
        bool disturb = false; /* starts, writes, other counters while the core is busy */
        bool count = true;    /* reads the counters in the very clock in which busy_o falls */
        bool counted = true;  /* ... which are the model's */
        int64_t silent = -1;  /* memory is silent from this clock on, */
        int64_t until = -1;   /* up to this one; no pixel is taken meanwhile if `blocked` */
        bool blocked = false;
    };
    /* A frame of what is taken up, which must be the model's. */
    void frame(const Scene &s, const char *what, const How &how);
    /* A frame of it that ends, with each pixel of the window once. Its sticky errors. */
    uint32_t ends(const sph_machine &machine, const Window &w, const char *what, const How &how);
    /* The core refuses what is taken up, with these errors. */
    void refuses(uint32_t errors, const char *what);
    /* Clocks in which nothing is asked of the core, some. */
    void rest(int clocks);
    uint64_t counter(int number);
    /* Sticky errors that are not those wanted. */
    void wrong(const char *what, uint32_t errors, uint32_t wanted);

    bool fine() const { return !run_.failure[0]; }
    Host &host() { return host_; }
    Random &random() { return random_; }

    uint64_t frames = 0, clocks = 0;
    /* Of the last frame: clocks, requests for lines, writes and starts that were ignored. */
    uint64_t length = 0, requests = 0, writes = 0, starts = 0;

  private:
    void run(const sph_machine &machine, const Window &w, const char *what, const How &how);
    void compare_pixels(const Scene &s, const char *what);
    void compare_counters(const Scene &s, const char *what);
    void release();

    const Options &o_;
    Host &host_;
    Run &run_;
    Random random_;
    std::vector<Sample> samples_;
    Host::Seen seen_ = {false, 0, 0, true};
    uint64_t last_ = 0;   /* clock of the last pixel */
    uint64_t gone_ = 0;   /* pixels of this frame */
    int first_ = 0;       /* counter that is read in the clock in which busy_o falls */
    bool written_ = true; /* all registers */
};

/* ---- many frames of one core, one behind the other, each compared ---- */
/* Frames of two machines follow each other without a reset; then one frame after the other is cut
 * off by a reset, mostly of one clock, and the frame behind it must be whole. Registers are written
 * once a machine. A reset takes memory along, or lasts until memory has given all that it owes. */

/* Says in run.failure what went wrong first. 0, 1 if something did, or 2, with a reason, if it
 * cannot be done: --then cannot be read, or the simulator cannot be driven so. */
int live(const Options &o, const sph_machine &machine, Run &run, std::string &error);

#endif
