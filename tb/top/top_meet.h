/* top_meet.h - orders of the host that meet what a frame does, in every clock; a host at random
 * SPDX-License-Identifier: Apache-2.0
 *
 * top_view.h judges every clock of it. What meets in one clock is not drawn: each order is given at
 * each clock of frames of a few pixels, of every kind that a frame can end in.
 */
#ifndef TB_TOP_MEET_H
#define TB_TOP_MEET_H

#include <fstream>
#include <sstream>

#include "golden_core.h"
#include "top_display.h"

namespace {

/* What a frame meets besides. */
enum Kind {
    PLAIN,
    FRESH, /* with one before that is not shown yet */
    WAITS,
    CORE_ERROR,
    READ_SLVERR,
    READ_DECERR,
    WRITE_SLVERR,
    WRITE_DECERR,
    READ_SILENT,
    WRITE_SILENT,
    DRAINS,
    KINDS
};
const uint32_t MEET_WATCHDOG = 40;

/* The orders; behind those of CONTROL the port, and writes that clear. */
enum Order : uint32_t { PORT_TAKE = 0x80, CLEAR_ERRORS, CLEAR_INTERRUPTS, SET_FRAME, SET_MUX };
const uint32_t ORDERS[] = {SPHAERA_CONTROL_START,
                           SPHAERA_CONTROL_START | SPHAERA_CONTROL_KEEP_CACHE,
                           SPHAERA_CONTROL_STOP,
                           SPHAERA_CONTROL_STOP | SPHAERA_CONTROL_START,
                           SPHAERA_CONTROL_SOFT_RESET,
                           SPHAERA_CONTROL_SOFT_RESET | SPHAERA_CONTROL_FORGET,
                           SPHAERA_CONTROL_FORGET,
                           SPHAERA_CONTROL_SNAPSHOT,
                           SPHAERA_CONTROL_TAKE,
                           PORT_TAKE,
                           CLEAR_ERRORS,
                           CLEAR_INTERRUPTS,
                           SET_FRAME,
                           SET_MUX};

/* A few pixels of one row, in two groups. */
std::vector<Pixel> few(bench::Random &r) {
    std::vector<Pixel> made;
    for (int x = 5; x < 9; x++) {
        Pixel p = {x, 3, {}};
        for (int &colour : p.colour)
            colour = (int)r.below(1 << 24);
        made.push_back(p);
    }
    return made;
}

void buses_alive(TopHost &t) {
    t.scene.revive();
    t.scan.revive();
    t.frame.revive();
}

/* FORGET: the buses are reset with it. */
void forget(TopHost &t, uint32_t control) {
    for (bool on : {true, false}) {
        t.scene.reset();
        t.scan.reset();
        t.frame.reset();
        t.scene.in_reset = t.scan.in_reset = t.frame.in_reset = on;
        if (on) t.write(SPHAERA_CONTROL, control);
    }
}

void give(TopHost &t, uint32_t order) {
    switch (order) {
    case PORT_TAKE:
        t.take_in = 1;
        t.clock();
        break;
    case CLEAR_ERRORS:
        t.write(SPHAERA_ERRORS, 0xffff);
        break;
    case CLEAR_INTERRUPTS:
        t.write(SPHAERA_INTERRUPTS, 0xf);
        break;
    case SET_FRAME:
        t.write(SPHAERA_FRAME0 + 4 * (uint32_t)t.random.below(3), (uint32_t)t.random.next());
        break;
    case SET_MUX:
        t.write(SPHAERA_MUX, (uint32_t)t.random.below(4));
        break;
    default:
        if (order & SPHAERA_CONTROL_SOFT_RESET && order & SPHAERA_CONTROL_FORGET)
            forget(t, order);
        else
            t.write(SPHAERA_CONTROL, order);
    }
}

/* Until no frame is drawn or drained; the bus that was silent answers, if that is waited for. */
void calm(Checks &c) {
    TopHost &t = c.top;
    buses_alive(t);
    t.write(SPHAERA_CONTROL, SPHAERA_CONTROL_TAKE); /* who waits for it goes on */
    for (int n = 0; n < 2000 && t.view.state() != View::IDLE; n++)
        t.clock();
    c.equals("idle", t.view.state(), View::IDLE);
}

/* One frame of that kind, and the order so many clocks behind its START, or behind a STOP in the
 * midst of its reads and writes. */
void meet(Checks &c, Kind kind, uint32_t order, unsigned after) {
    TopHost &t = c.top;
    Manner manner;
    manner.latency = 3;
    t.scene.behave(manner);
    t.frame.behave(manner);
    core.errors = kind == CORE_ERROR ? (1 << SPH_ERRORS) - 1 : 0;
    t.write(SPHAERA_FRAME_MODE, kind == WAITS);
    if (kind >= READ_SLVERR && kind <= WRITE_DECERR) {
        manner.error_at = kind <= READ_DECERR ? 2 : 0;
        manner.error = kind == READ_SLVERR || kind == WRITE_SLVERR ? SLVERR : DECERR;
    }
    if (kind == READ_SILENT || kind == WRITE_SILENT) manner.deaf_after = 1;
    if (kind == DRAINS) manner.latency = 60;
    if (kind == READ_SLVERR || kind == READ_DECERR || kind == READ_SILENT) t.scene.behave(manner);
    if (kind == WRITE_SLVERR || kind == WRITE_DECERR || kind == WRITE_SILENT || kind == DRAINS)
        t.frame.behave(manner);
    for (int n = 0; n < 1 + (kind == FRESH); n++) {
        if (n) t.clocks(250);
        t.write(SPHAERA_CONTROL, SPHAERA_CONTROL_START);
    }
    for (int n = 0; kind == DRAINS && n < 400 && !t.dut.m_frame_bready; n++)
        t.clock();
    if (kind == DRAINS) t.write(SPHAERA_CONTROL, SPHAERA_CONTROL_STOP);
    t.clocks(after);
    give(t, order);
    for (int n = 0; n < 400 && t.view.state() != View::IDLE; n++)
        t.clock();
    t.read(SPHAERA_STATUS);
    t.read(SPHAERA_INTERRUPTS);
    t.read(SPHAERA_ERRORS);
    if (t.random.percent(10)) { /* they are compared as they are read */
        uint64_t counters[SPHAERA_COUNTS];
        sphaera_counters(&t.driver, counters);
    }
    calm(c);
    if (kind == READ_SILENT || kind == WRITE_SILENT || t.random.percent(3))
        t.write(SPHAERA_CONTROL, SPHAERA_CONTROL_SOFT_RESET);
    t.clocks(60);
}

/* A frame behind all that, read back with its counts. */
void right_again(Checks &c, const Golden &golden) {
    core.scripted = false;
    buses_alive(c.top);
    c.store(2560, 0);
    c.choose(0);
    c.top.write(SPHAERA_FRAME_MODE, 0);
    c.top.write(SPHAERA_WATCHDOG, SPHAERA_WATCHDOG_RESET);
    c.equals("reset", (uint64_t)sphaera_reset(&c.top.driver, 0, POLLS), SPHAERA_OK);
    c.whole(golden, SCENE_A);
    c.equals("no error", sphaera_errors(&c.top.driver), 0);
}

void scripted_frames(Checks &c, const Golden &any) {
    TopHost &t = c.top;
    t.stall = 0; /* so that the order comes in the clock that is meant */
    sphaera_reset(&t.driver, 0, POLLS);
    c.load(any, SCENE_A);
    sphaera_set(&t.driver, SPH_REG_MEM_LINES, 1);
    core.scripted = true;
    core.script = few(t.random);
    core.errors = 0;
    t.write(SPHAERA_WATCHDOG, MEET_WATCHDOG);
    t.write(SPHAERA_INTERRUPT_ENABLE, 0xf);
}

/* Every order in every clock of every kind of frame, but few of those in which registers go to the
 * core. */
void meetings(Checks &c, const Golden &a) {
    scripted_frames(c, a);
    const unsigned loads = SPHAERA_MACHINE_REGISTERS;
    for (unsigned kind = 0; kind < KINDS; kind++)
        for (uint32_t order : ORDERS) {
            unsigned after = 0;
            while (after < (kind == DRAINS ? 70 : loads + 110) && c.top.view.broken.empty()) {
                meet(c, (Kind)kind, order, after);
                after += kind != DRAINS && after >= 4 && after < loads - 20 ? 24 : 1;
            }
        }
    right_again(c, a);
    c.done("every order in every clock of every kind of frame");
}

/* take_i in each clock of each write, with a frame that was not shown. */
void takes(Checks &c, const Golden &a) {
    TopHost &t = c.top;
    scripted_frames(c, a);
    t.scene.behave({});
    t.frame.behave({});
    for (uint32_t order : ORDERS)
        for (unsigned clock = 1; clock < 9; clock++) {
            t.write(SPHAERA_CONTROL, SPHAERA_CONTROL_START);
            t.clocks(400);
            t.take_in = clock;
            give(t, order);
            t.read(SPHAERA_INTERRUPTS);
            calm(c);
        }
    uint64_t counters[SPHAERA_COUNTS];
    sphaera_counters(&t.driver, counters);
    right_again(c, a);
    c.done("take_i in every clock of every write");
}

/* A host that clears all the time, while the display misses pixels, gets errors, is silent. */
void clears(Checks &c, const Golden &a) {
    TopHost &t = c.top;
    scripted_frames(c, a);
    c.store(128, 0);
    const struct sphaera_mode mode = {16, 2, 3, 2, 5, 2, 2, 6, 0, 1, 0};
    t.pixel = [](Vrt_top &) {};
    t.pixel_every = 1;
    sphaera_video(&t.driver, &mode);
    for (int i = 0; i < 160; i++) {
        t.write(SPHAERA_CONTROL, SPHAERA_CONTROL_START);
        t.clocks(300 + (unsigned)i);
        Manner m;
        m.error_at = i % 3 ? -1 : 3;
        m.error = SLVERR;
        m.deaf_after = i % 3 ? 2 : -1;
        t.scan.behave(m);
        for (int n = 0; n < 80; n++)
            give(t, i & 1 ? CLEAR_ERRORS : CLEAR_INTERRUPTS);
        t.scan.revive();
    }
    sphaera_video(&t.driver, nullptr);
    t.clocks(500);
    t.pixel = nullptr;
    right_again(c, a);
    c.done("errors and interrupts of the display, cleared in any clock");
}

/* A display in pix_clk: what stands on its wires beside the picture, and when BLANK does. */
struct Glance {
    unsigned rows = 0, syncs = 0, off = 0; /* pixel clocks since de, vsync, ENABLE changed */
    bool on = false, h_pol = false, v_pol = false;
    std::string broken;

    void look(const Vrt_top &t) {
        rows = t.de_o ? rows + 1 : 0;
        syncs = t.vsync_o == v_pol && !t.de_o ? syncs + 1 : 0;
        off = on ? 0 : off + 1;
        if (t.de_o && (t.hsync_o == h_pol || t.vsync_o == v_pol)) fault("a sync in a picture");
        if (rows > LATE && edge_seen.blank) fault("BLANK in a row");
        if (on && syncs > LATE && !edge_seen.blank) fault("no BLANK in vsync");
        if (off > AFTER && !edge_seen.blank) fault("no BLANK while off");
        if (off > AFTER && t.de_o) fault("a pixel while off");
    }

  private:
    static constexpr unsigned LATE = 8, AFTER = 40; /* clocks of crossings, of a row at most */
    void fault(const char *what) {
        if (broken.empty()) broken = what;
    }
};

/* A processor with no manners but those of AXI4-Lite: any register, both directions at once. */
class Rude {
  public:
    Rude(TopHost &host) : t(host) {}
    void clock(unsigned pace) {
        Vrt_top &d = t.dut;
        if (!writing_ && t.random.percent(pace)) write();
        if (!reading_ && t.random.percent(pace)) read();
        d.s_axil_awvalid = d.s_axil_awvalid || (aw_ && t.random.percent(60));
        d.s_axil_wvalid = d.s_axil_wvalid || (w_ && t.random.percent(60));
        d.s_axil_arvalid = d.s_axil_arvalid || (ar_ && t.random.percent(60));
        d.s_axil_bready = t.random.percent(60);
        d.s_axil_rready = t.random.percent(60);
        const bool aw = d.s_axil_awvalid && d.s_axil_awready,
                   w = d.s_axil_wvalid && d.s_axil_wready,
                   ar = d.s_axil_arvalid && d.s_axil_arready,
                   b = d.s_axil_bvalid && d.s_axil_bready, r = d.s_axil_rvalid && d.s_axil_rready;
        t.clock();
        if (aw) aw_ = d.s_axil_awvalid = false;
        if (w) w_ = d.s_axil_wvalid = false;
        if (ar) ar_ = d.s_axil_arvalid = false;
        if (b) writing_ = false;
        if (r) reading_ = false;
    }
    /* Until all is answered. */
    bool finish() {
        for (int n = 0; n < 2000 && (writing_ || reading_); n++)
            clock(0);
        t.dut.s_axil_bready = t.dut.s_axil_rready = 0;
        return !writing_ && !reading_;
    }
    void lose() { aw_ = w_ = ar_ = writing_ = reading_ = false; }

  private:
    TopHost &t;
    bool aw_ = false, w_ = false, ar_ = false, writing_ = false, reading_ = false;

    static constexpr uint32_t OFTEN[] = {
        SPHAERA_CONTROL,          SPHAERA_CONTROL, SPHAERA_ERRORS,     SPHAERA_INTERRUPTS,
        SPHAERA_INTERRUPT_ENABLE, SPHAERA_MUX,     SPHAERA_FRAME_MODE, SPHAERA_FRAME1};
    void write() {
        Vrt_top &d = t.dut;
        uint32_t at = OFTEN[t.random.below(std::size(OFTEN))], data = (uint32_t)t.random.next();
        if (at == SPHAERA_CONTROL) { /* FORGET is for buses that are reset, others are rare */
            data = 1u << t.random.below(7);
            if (t.random.percent(20)) data |= 1u << t.random.below(7);
            if (t.random.percent(70)) data &= ~(SPHAERA_CONTROL_STOP | SPHAERA_CONTROL_SOFT_RESET);
            if (data & SPHAERA_CONTROL_SOFT_RESET) data &= ~SPHAERA_CONTROL_FORGET;
        }
        if (t.random.percent(10)) at = SPHAERA_MACHINE + 4 * SPH_REG_LIGHT0_X;
        if (t.random.percent(5)) at = SPHAERA_ID + 4 * (uint32_t)t.random.below(7);
        d.s_axil_awaddr = (uint16_t)at;
        d.s_axil_wdata = data;
        d.s_axil_wstrb = (uint8_t)(t.random.percent(80) ? 15 : t.random.below(16));
        aw_ = w_ = writing_ = true;
    }
    void read() {
        const uint32_t any = (uint32_t)t.random.below(0x560) & ~3u;
        const uint32_t often[] = {SPHAERA_STATUS,
                                  SPHAERA_ERRORS,
                                  SPHAERA_INTERRUPTS,
                                  SPHAERA_FRAME_COUNT,
                                  any,
                                  SPHAERA_COUNTERS + 8 * (uint32_t)t.random.below(SPHAERA_COUNTS)};
        t.dut.s_axil_araddr = (uint16_t)often[t.random.below(std::size(often))];
        ar_ = reading_ = true;
    }
};

Manner any_manner(bench::Random &r) {
    Manner m;
    m.stall = (unsigned)r.below(3) * 30;
    m.latency = 1 + (unsigned)r.below(20);
    if (r.percent(30)) {
        m.error_at = (int64_t)r.below(30);
        m.error = r.percent(50) ? SLVERR : DECERR;
    }
    if (r.percent(20)) {
        m.deaf_after = (int64_t)r.below(8);
        m.refuses = r.percent(50);
    }
    return m;
}

/* Trials of that host, display on or off, buses of any manner; then a frame must be right. */
void life(Checks &c, const Golden &a, const Golden &b) {
    TopHost &t = c.top;
    Glance glance;
    Rude host(t);
    t.pixel = [&](Vrt_top &top) { glance.look(top); };
    for (int i = 0; i < 90; i++) {
        scripted_frames(c, i & 1 ? a : b);
        t.pixel_every = 1 + (unsigned)i % 4;
        const bool video = i % 3 == 0;
        if (video) {
            const uint8_t h_pol = i & 1, v_pol = i & 2 ? 1 : 0;
            const struct sphaera_mode mode = {16, 2, 3, 2, 5, 2, 2, 6, h_pol, v_pol, 0};
            c.store(128, 0);
            sphaera_video(&t.driver, &mode);
            glance.h_pol = h_pol;
            glance.v_pol = v_pol;
            glance.on = true;
        }
        core.script.resize(t.random.below(5));
        core.errors = i % 4 ? 0 : (int)t.random.below(1 << SPH_ERRORS);
        t.scene.behave(any_manner(t.random));
        t.frame.behave(any_manner(t.random));
        t.scan.behave(any_manner(t.random));
        t.write(SPHAERA_WATCHDOG, i % 5 ? 30 + (uint32_t)t.random.below(60) : 0);
        const unsigned pace = 10 + (unsigned)t.random.below(3) * 40;
        for (int n = 0; n < 2000; n++) {
            if (t.random.percent(2)) t.take_in = 1;
            host.clock(pace);
            if (n % 400 == 399) { /* buses come to life, and behave otherwise */
                t.scene.revive();
                t.frame.revive();
                t.scan.revive();
                if (n & 1) t.scan.behave(any_manner(t.random));
            }
        }
        c.note("every access is answered", host.finish());
        if (i % 10 == 9) {
            t.reset();
            struct sphaera_bus bus = t.bus();
            c.equals("open", (uint64_t)sphaera_open(&t.driver, &bus), SPHAERA_OK);
            glance.on = false;
            glance.off = 0;
        } else if (i % 10 == 5) {
            forget(t, SPHAERA_CONTROL_SOFT_RESET | SPHAERA_CONTROL_FORGET);
        }
        if (video) { /* off, and at once another mode */
            const uint32_t now = t.read(SPHAERA_VIDEO);
            t.write(SPHAERA_VIDEO, ~now & (SPHAERA_VIDEO_H_POL | SPHAERA_VIDEO_V_POL));
            glance.on = false;
            t.clocks(500);
        }
        calm(c);
        right_again(c, i & 1 ? a : b);
        c.note(glance.broken.c_str(), glance.broken.empty());
    }
    t.pixel = nullptr;
    c.done("a host without manners, then a frame that is right");
}

/* Whether what a line of top_plan.txt names was met, or is a check that came to its end. */
bool judged(const Checks &c, const std::string &kind, const std::string &name) {
    if (kind == "met") return met.count(name) != 0;
    const auto found = c.names.lower_bound(name);
    return found != c.names.end() && found->compare(0, name.size(), name) == 0;
}

/* All points and checks of this bench that the plan has. */
void plan(Checks &c) {
    std::ifstream from("tb/top/top_plan.txt");
    std::string line, more;
    long points = 0;
    while (std::getline(from, line)) {
        for (; !line.empty() && line.back() == '\\' && std::getline(from, more); line += more)
            line.pop_back();
        const size_t by = line.rfind("| ");
        if (line[0] == '#' || line[0] == '-' || line[0] == '=' || by == std::string::npos) continue;
        std::istringstream words(line.substr(by + 2));
        std::string kind, name;
        words >> kind;
        if (kind != "met" && kind != "check") continue;
        while (std::getline(words >> std::ws, name, ';')) {
            points++;
            if (judged(c, kind, name)) continue;
            c.note(("not met: " + name).c_str(), false);
        }
    }
    c.note("the plan was read", points > 0);
    if (getenv("TOP_POINTS"))
        for (const auto &[name, times] : met)
            printf("# %8ld %s\n", times, name.c_str());
    printf("# %ld points met; the host's view was right in %llu clocks of %llu\n", points,
           (unsigned long long)c.top.view.clocks, (unsigned long long)c.top.cycle);
    c.done("every point of the plan is met");
}

void environment(Checks &c, const Golden &a, const Golden &b) {
    if (c.top.view.clocks == 0) return; /* a netlist, whose core nobody looks into */
    meetings(c, a);
    takes(c, a);
    clears(c, a);
    life(c, a, b);
    if (!c.layers) plan(c);
}

} // namespace

#endif
