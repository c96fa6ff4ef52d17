/* top_display.h - rt_top with its video: a display decodes symbols, each picture is a whole frame
 * SPDX-License-Identifier: Apache-2.0
 *
 * Two machines are drawn in turn while the display runs by its own clock. Every picture must be one
 * of both as the golden model has it, never a part of each, and the last one drawn must be seen. Of
 * frames with layers MUX chooses one while they are shown: from the next blanking on, no sooner.
 */
#ifndef TB_TOP_DISPLAY_H
#define TB_TOP_DISPLAY_H

#include "top_checks.h"
#include "video/display.h"

/* A display at the symbols of rt_top; what it saw, in order: numbers of the pictures that it knows,
 * BLACK, or TORN, none of them. */
class Screen {
  public:
    enum { BLACK = 100, TORN };
    std::vector<int> seen;
    bool torn = false;

    /* Pictures 0 and 1 are these machines'. */
    Screen(Checks &checks, const Golden &a, const Golden &b, const video::Mode &mode)
        : Screen(checks, {picture(a, Checks::depth(a)), picture(b, Checks::depth(b))}, mode) {}
    /* Pictures 0 to 2 are the layers of a machine's frame. */
    Screen(Checks &checks, const Golden &a, const video::Mode &mode)
        : Screen(checks, {picture(a, 0), picture(a, 1), picture(a, 2)}, mode) {}
    bool differ() const {
        for (size_t i = 1; i < wanted.size(); i++)
            if (wanted[i] == wanted[i - 1]) return false;
        return wanted.front() != wanted.back();
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
    using Picture = std::vector<uint32_t>;
    Checks &c;
    std::vector<Picture> wanted;
    Picture black;
    video::Display display;
    uint64_t clocks; /* that two pictures may take, at up to four a pixel */

    Screen(Checks &checks, std::vector<Picture> pictures, const video::Mode &mode)
        : c(checks), wanted(std::move(pictures)), black(wanted[0].size(), 0), display(mode),
          clocks(8ull * mode.h_total() * mode.v_total()) {
        c.top.pixel = [this](Vrt_top &top) {
            display.take(top.tmds0_o, top.tmds1_o, top.tmds2_o);
            while (display.has_picture())
                compare(display.picture().rgb);
        };
    }
    static Picture picture(const Golden &g, int depth) {
        Picture rgb;
        for (int i = 0; i < g.frame.width * g.frame.height; i++) {
            uint32_t bgr = g.frame.pixels[i].colour[depth];
            rgb.push_back((bgr & 255) << 16 | (bgr & 0xff00) | bgr >> 16);
        }
        return rgb;
    }
    void compare(const Picture &rgb) {
        int which = rgb == black ? BLACK : TORN;
        for (size_t i = wanted.size(); i-- > 0;)
            if (rgb == wanted[i]) which = (int)i;
        torn = torn || which == TORN;
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

/* The next clocks in which the display is in the midst of a picture. */
static void amidst(Checks &c) {
    for (uint32_t blank : {SPHAERA_STATUS_BLANK, 0u})
        for (int n = 0; n < 5000; n++)
            if ((c.top.read(SPHAERA_STATUS) & SPHAERA_STATUS_BLANK) == blank) break;
}

/* MUX is written while layers are shown and while the next frame is drawn. */
static void display_layers(Checks &c, const Golden &a) {
    TopHost &t = c.top;
    sphaera_reset(&t.driver, 0, POLLS);
    c.apart = 0x1000;
    c.store(128, 0);
    const struct sphaera_mode mode = {32, 2, 4, 30, 20, 2, 2, 40, 0, 1, 0};
    Screen screen(c, a, {32, 2, 4, 30, 20, 2, 2, 40, 0, 1});
    c.note("the layers differ", screen.differ());
    c.load(a, SCENE_A);
    c.choose(1);
    sphaera_video(&t.driver, &mode);
    c.equals("draw", (uint64_t)c.draw(), SPHAERA_OK);
    c.note("pictures", screen.pictures(2));
    int now = 0;
    c.equals("Rendering", (uint64_t)screen.seen.back(), (uint64_t)now);
    for (int i = 0; i < 32; i++) {
        const unsigned mux = (c.mux + 1 + (unsigned)t.random.below(3)) % 4;
        const bool draws = i & 1, anywhere = i % 4 == 3;
        t.pixel_every = 1 + (unsigned)i / 4 % 4;
        if (draws) sphaera_start(&t.driver, 0);
        if (anywhere)
            t.clocks(t.random.below(68 * 64));
        else
            amidst(c);
        t.clocks(t.random.below(15 * 68 * t.pixel_every));
        const size_t picture = screen.seen.size();
        c.choose(mux);
        const int next = c.shown_depth(a);
        const bool blank = t.read(SPHAERA_STATUS) & SPHAERA_STATUS_BLANK;
        c.note("within the picture", anywhere || !blank);
        c.note("pictures", screen.pictures(3));
        c.note("the picture that was shown stays",
               screen.seen[picture] == now || (anywhere && screen.seen[picture] == next));
        /* in a blanking whose layer is chosen already: from the one after it on */
        const size_t first = picture + 1 + (blank && screen.seen[picture + 1] == now);
        c.equals("the next one has the layer", (uint64_t)screen.seen[first], (uint64_t)next);
        c.equals("so has the next", (uint64_t)screen.seen[picture + 2], (uint64_t)next);
        now = next;
        if (draws) c.equals("draw", (uint64_t)sphaera_wait(&t.driver, POLLS), SPHAERA_OK);
    }
    c.choose(0); /* register FRAME of the frame that is shown, not of the one that is drawn */
    for (int i = 0; i < 6; i++) {
        const int next = (i + 1) % SPH_FRAMES;
        sphaera_set(&t.driver, SPH_REG_FRAME, (uint32_t)next);
        const size_t from = screen.seen.size();
        sphaera_start(&t.driver, 0);
        if (i == 0) c.equals("draw", (uint64_t)sphaera_wait(&t.driver, POLLS), SPHAERA_OK);
        c.note("a picture while it is drawn", screen.pictures(1));
        c.equals("draw", (uint64_t)sphaera_wait(&t.driver, POLLS), SPHAERA_OK);
        c.note("pictures", screen.pictures(2));
        c.equals("the layer of its FRAME", (uint64_t)screen.seen.back(), (uint64_t)next);
        for (size_t k = from; i && k < screen.seen.size(); k++)
            c.note("or that of the one before", screen.seen[k] == next || screen.seen[k] == now);
        now = next;
    }
    c.note("no picture is torn", !screen.torn);
    c.note("every sync is in its place", screen.error().empty());
    sphaera_video(&t.driver, nullptr);
    t.clocks(2000);
    c.apart = 0x40000;
    c.store(2560, 0);
    c.done("layers shown: MUX counts from the next blanking on, no picture mixes");
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
    c.equals("black before the first frame", (uint64_t)screen.seen.back(), Screen::BLACK);
    for (int i = 0; i < 12; i++) {
        Manner slow;
        slow.stall = i % 3 * 15u;
        t.frame.behave(slow);
        t.scene.behave(slow);
        t.pixel_every = 1 + (unsigned)i % 4;
        c.load(*golden[i % 2], SCENE_A);
        sphaera_start(&t.driver, 0);
        c.equals("draw", (uint64_t)sphaera_wait(&t.driver, POLLS), SPHAERA_OK);
        for (int k = 0; k < 4; k++) /* which the display does */
            t.write(SPHAERA_CONTROL, SPHAERA_CONTROL_TAKE);
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
