/* top_display.h - rt_top with its video: a display decodes symbols, each picture is a whole frame
 * SPDX-License-Identifier: Apache-2.0
 *
 * Two machines are drawn in turn while the display runs by its own clock. Every picture must be one
 * of both as the golden model has it, never a part of each, and the last one drawn must be seen.
 */
#ifndef TB_TOP_DISPLAY_H
#define TB_TOP_DISPLAY_H

#include "top_checks.h"
#include "video/display.h"

/* A display at the symbols of rt_top; what it saw, in order: 0, 1: these machines, 2: black. */
class Screen {
  public:
    std::vector<int> seen;
    bool torn = false;

    Screen(Checks &checks, const Golden &a, const Golden &b, const video::Mode &mode)
        : c(checks), wanted{picture(a), picture(b)}, black(wanted[0].size(), 0), display(mode),
          clocks(8ull * mode.h_total() * mode.v_total()) {
        c.top.pixel = [this](Vrt_top &top) {
            display.take(top.tmds0_o, top.tmds1_o, top.tmds2_o);
            while (display.has_picture())
                compare(display.picture().rgb);
        };
    }
    ~Screen() { c.top.pixel = nullptr; }
    Screen(const Screen &) = delete;

    const std::string &error() const { return display.error(); }
    /* Until so many pictures more were seen. */
    bool pictures(size_t more) {
        size_t wanted_size = seen.size() + more;
        uint64_t end = c.top.cycle + (more + 1) * clocks;
        while (seen.size() < wanted_size && c.top.cycle < end)
            c.top.clock();
        return seen.size() >= wanted_size;
    }

  private:
    Checks &c;
    std::vector<uint32_t> wanted[2], black;
    video::Display display;
    uint64_t clocks; /* that two pictures may take, at up to four a pixel */

    static std::vector<uint32_t> picture(const Golden &g) {
        std::vector<uint32_t> rgb;
        for (int i = 0; i < g.frame.width * g.frame.height; i++) {
            uint32_t bgr = g.frame.pixels[i].colour[Checks::depth(g)];
            rgb.push_back((bgr & 255) << 16 | (bgr & 0xff00) | bgr >> 16);
        }
        return rgb;
    }
    void compare(const std::vector<uint32_t> &rgb) {
        int which = rgb == wanted[0] ? 0 : rgb == wanted[1] ? 1 : rgb == black ? 2 : 3;
        torn = torn || which == 3;
        seen.push_back(which);
    }
};

/* The display's bus falls silent: told once, frames are drawn all the same; right again when it
 * answers, or when it was reset and FORGET says so. */
static void silent_display(Checks &c, Screen &screen, const Golden &a) {
    TopHost &t = c.top;
    sphaera_interrupts(&t.driver, SPHAERA_INTERRUPTS_ERROR);
    c.load(a, SCENE_A);
    for (int i = 0; i < 6; i++) {
        Manner deaf;
        deaf.deaf_after = (int64_t)t.random.below(20);
        deaf.refuses = i & 1;
        const uint32_t limit = 600 + (uint32_t)t.random.below(200);
        t.write(SPHAERA_WATCHDOG, limit);
        c.equals("draw", (uint64_t)c.draw(), SPHAERA_OK);
        c.note("pictures", screen.pictures(2));
        c.equals("the frame is seen", (uint64_t)screen.seen.back(), 0);
        sphaera_handle(&t.driver);
        t.irq_at = 0;
        t.scan.behave(deaf);
        c.note("pictures", screen.pictures(3));
        c.equals("by its watchdog", t.read(SPHAERA_ERRORS), SPHAERA_ERRORS_SCAN_WATCHDOG);
        c.equals("in time", t.scan_silent, limit + 1);
        sphaera_errors(&t.driver);
        unsigned frames = t.read(SPHAERA_FRAME_COUNT);
        c.equals("draw", (uint64_t)c.draw(), SPHAERA_OK);
        c.equals("a frame is complete", t.read(SPHAERA_FRAME_COUNT), frames + 1);
        c.note("pictures", screen.pictures(2));
        c.equals("told once", t.read(SPHAERA_ERRORS), 0);
        if (i & 2) { /* the interconnect is reset */
            t.scan.reset();
            t.scan.in_reset = true;
            c.equals("reset", (uint64_t)sphaera_reset(&t.driver, 1, 2), SPHAERA_OK);
            t.scan.in_reset = false;
        }
        t.scan.revive();
        if (i & 4) c.equals("reset", (uint64_t)sphaera_reset(&t.driver, 0, POLLS), SPHAERA_OK);
        c.note("pictures", screen.pictures(2));
    }
    t.write(SPHAERA_WATCHDOG, SPHAERA_WATCHDOG_RESET);
    c.equals("draw", (uint64_t)c.draw(), SPHAERA_OK);
    c.note("pictures", screen.pictures(2));
    c.equals("the frame is seen", (uint64_t)screen.seen.back(), 0);
    c.done("a display whose bus is silent: watchdog, recovery");
}

/* Pictures of two machines; underruns and errors of the scan-out. */
static void display(Checks &c, const Golden &a, const Golden &b) {
    TopHost &t = c.top;
    const Golden *const golden[2] = {&a, &b};
    sphaera_reset(&t.driver, 0, POLLS);
    c.store(128, 0);
    const struct sphaera_mode mode = {32, 2, 4, 30, 20, 2, 2, 40, 0, 1, 0};
    Screen screen(c, a, b, {32, 2, 4, 30, 20, 2, 2, 40, 0, 1});
    sphaera_video(&t.driver, &mode);
    sphaera_interrupts(&t.driver, SPHAERA_INTERRUPTS_UNDERRUN);
    c.note("a picture", screen.pictures(2));
    c.equals("black before the first frame", (uint64_t)screen.seen.back(), 2);
    for (int i = 0; i < 12; i++) {
        Manner slow;
        slow.stall = i % 3 * 15u;
        t.frame.behave(slow);
        t.scene.behave(slow);
        t.pixel_every = 1 + (unsigned)i % 4;
        c.load(*golden[i % 2], SCENE_A);
        sphaera_start(&t.driver, 0);
        c.equals("draw", (uint64_t)sphaera_wait(&t.driver, POLLS), SPHAERA_OK);
        if (i % 3) continue; /* the next is drawn at once: frames are lost or shown */
        c.note("pictures", screen.pictures(2));
        c.equals("the last frame is seen", (uint64_t)screen.seen.back(), (uint64_t)i % 2);
    }
    c.note("no picture is torn", !screen.torn);
    c.note("no underrun", !t.dut.irq_o);
    Manner deaf;
    deaf.deaf_after = 3;
    t.scan.behave(deaf);
    c.note("pictures", screen.pictures(3));
    c.equals("underrun", t.dut.irq_o, 1);
    t.scan.revive();
    c.note("pictures", screen.pictures(3));
    c.note("right again", screen.seen.back() < 2);
    sphaera_handle(&t.driver);
    Manner bad;
    bad.error_at = 7;
    bad.error = SLVERR;
    t.scan.behave(bad);
    c.note("pictures", screen.pictures(2));
    c.equals("SCAN_ERROR", t.read(SPHAERA_ERRORS), SPHAERA_ERRORS_SCAN_ERROR);
    sphaera_errors(&t.driver);
    t.scan.behave({});
    uint64_t n[SPHAERA_COUNTS];
    sphaera_counters(&t.driver, n);
    c.note("UNDERRUNS", n[SPHAERA_COUNT_UNDERRUNS] >= 1 && n[SPHAERA_COUNT_UNDERRUNS] < 8);
    c.note("one frame is taken for each picture",
           n[SPHAERA_COUNT_FRAMES_AGAIN] + n[SPHAERA_COUNT_FRAMES_SHOWN] <= screen.seen.size() + 3);
    c.note("frames were shown again", n[SPHAERA_COUNT_FRAMES_AGAIN] > 0);
    c.note("more than one was shown", n[SPHAERA_COUNT_FRAMES_SHOWN] > 3);
    if (!screen.error().empty()) printf("# %s\n", screen.error().c_str());
    c.note("every sync is in its place", screen.error().empty());
    printf("# %zu pictures; frames shown %llu, again %llu, lost %llu\n", screen.seen.size(),
           (unsigned long long)n[SPHAERA_COUNT_FRAMES_SHOWN],
           (unsigned long long)n[SPHAERA_COUNT_FRAMES_AGAIN],
           (unsigned long long)n[SPHAERA_COUNT_FRAMES_LOST]);
    c.done("a display beside: whole pictures, underrun, error of its reads");
    silent_display(c, screen, a);
    sphaera_video(&t.driver, nullptr);
    t.clocks(2000);
    c.store(2560, 0);
}

#endif
