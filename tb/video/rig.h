/* rig.h - rt_video between a frame store and a display, in two clocks of any ratio
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_RIG_H
#define SPH_RIG_H

#include <cstring>
#include "Vrt_video.h"
#include "video/display.h"
#include "video/frame_store.h"

namespace video {

class Rig {
  public:
    Vrt_video &dut;
    bench::Random &random;
    FrameStore store;
    Display display;
    Mode mode{};
    Shape shape{};
    uint64_t clk_period = 1000, pix_period = 1000; /* any unit */
    static constexpr unsigned DEAF = 9; /* pixel clocks until the end is heard of and shown */
    int waits = 0; /* percent of pixels that the taker of the stream lets wait */
    uint64_t clocks = 0, pictures = 0, right = 0, underruns = 0, errors = 0, takes = 0;
    uint64_t must_be_right = 0; /* pictures from this take on */
    uint64_t first_take = 0;    /* of the picture that comes next */
    bool wrong = false;
    std::string what;

    Rig(Vrt_video &d, bench::Random &r, unsigned beat_bytes)
        : dut(d), random(r), store(r, beat_bytes), display(Mode{}) {}

    /* Another mode; enable_i must be low. */
    void set(const Mode &m, const Shape &s) {
        mode = m;
        shape = s;
        display = Display(m);
        display.lose(DEAF);
        store.shape(s);
        set_mode(dut.mode_i, m);
        dut.format_i = s.rgb565;
        dut.double_i = s.twice;
        dut.stride_i = (uint16_t)s.stride;
    }
    /* What was on its way to the display is lost; a frame begins after a while. */
    void lose() {
        display.lose(DEAF);
        store.taken.clear();
        stream.clear();
        row = 0;
        first_take = takes;
    }
    void enable(bool on, unsigned clocks_off = 3) {
        dut.enable_i = on;
        if (on) return;
        display.lose(~0u);
        run_clocks(clocks_off);
        lose();
    }
    /* Resets for some clocks of each side, none or more; with clk's the bus is reset. */
    void reset(unsigned clk_edges, unsigned pix_edges) {
        display.lose(~0u); /* while the reset lasts */
        dut.rst = clk_edges > 0;
        dut.pix_rst = pix_edges > 0;
        const uint64_t until_clk = clocks + clk_edges, until_pix = pixels + pix_edges;
        while (dut.rst || dut.pix_rst) {
            const uint64_t before = clocks;
            step();
            if (dut.rst && clocks != before) store.reset();
            dut.rst = dut.rst && clocks < until_clk;
            dut.pix_rst = dut.pix_rst && pixels < until_pix;
            dut.eval();
        }
        run_clocks(4); /* a frame that began before the other side heard of it; none begins yet */
        lose();
    }
    /* The bus is reset while the display runs on. */
    void reset_bus() {
        dut.forget_i = 1;
        dut.m_scan_arready = dut.m_scan_rvalid = 0;
        run_clocks(1);
        store.reset();
        store.drive(dut);
        dut.forget_i = 0;
        dut.eval();
    }
    void run_clocks(unsigned n) {
        for (const uint64_t until = clocks + n; clocks < until;)
            step();
    }
    void run_pictures(uint64_t n) {
        const uint64_t most =
            4 * (n + 2) * mode.h_total() * mode.v_total() * 200 / (unsigned)(100 - waits) + 10000;
        for (const uint64_t until = pictures + n, end = pixels + most;
             pictures < until && !wrong;) {
            step();
            if (pixels > end) fail("the display gets no picture");
        }
    }
    void fail(const std::string &text) {
        if (!wrong) what = text;
        wrong = true;
    }

    /* The next edge of a clock, or of both. */
    void step() {
        const bool c = next_clk <= next_pix, p = next_pix <= next_clk;
        if (c) {
            underruns += dut.underrun_o;
            errors += dut.error_o;
            takes += dut.take_o;
            store.clock(dut);
            next_clk += clk_period;
            clocks++;
        }
        if (p) {
            look();
            next_pix += pix_period;
            pixels++;
        }
        dut.clk = c;
        dut.pix_clk = p;
        dut.eval();
        if (c) store.drive(dut);
        if (p) dut.m_video_tready = !waits || !random.percent((unsigned)waits);
        dut.clk = 0;
        dut.pix_clk = 0;
        dut.eval();
        if (!store.what.empty()) fail(store.what);
        if (!display.error().empty()) fail("display: " + display.error());
        while (display.has_picture())
            check(display.picture());
    }

  private:
    uint64_t next_clk = 0, next_pix = 300, pixels = 0;
    std::vector<uint32_t> stream; /* pixels of the stream since tuser */
    unsigned row = 0;             /* pixels of this row */
    uint32_t waiting = 0;         /* the pixel that waits; its top bit: there is one */

    /* What leaves with this edge of the pixel clock. */
    void look() {
        const bool valid = dut.m_video_tvalid, taken = valid && dut.m_video_tready;
        const uint32_t pixel =
            1u << 31 | dut.m_video_tuser << 30 | dut.m_video_tlast << 29 | dut.m_video_tdata;
        if (waiting && (!valid || waiting != pixel) && display.is_locked())
            fail("a pixel of the stream did not wait for ready");
        waiting = valid && !taken ? pixel : 0;
        if (dut.de_o != dut.m_video_tvalid) fail("de_o is not tvalid");
        if (taken) {
            if (dut.m_video_tuser) stream.clear(), row = 0;
            stream.push_back(dut.m_video_tdata);
            if (dut.m_video_tlast != (++row == mode.h_active) && display.is_locked())
                fail("tlast is not the last pixel of a row");
            if (row == mode.h_active) row = 0;
        }
        if (!valid || taken) display.take(dut.tmds0_o, dut.tmds1_o, dut.tmds2_o);
    }
    void check(const Picture &picture) {
        pictures++;
        if (store.taken.empty()) return fail("a picture before take_o");
        const std::vector<uint32_t> &sent = store.taken.front();
        if (picture.rgb != stream) fail("stream and symbols are not the same picture");
        size_t good = 0;
        while (good < sent.size() && picture.rgb[good] == sent[good])
            good++;
        right += good == sent.size();
        if (good != sent.size() && first_take >= must_be_right)
            fail("a wrong picture from pixel " + std::to_string(good) + " of " +
                 std::to_string(sent.size()));
        for (size_t i = good; i < sent.size(); i++)
            if (picture.rgb[i]) {
                fail("a picture is neither a frame nor black from pixel " + std::to_string(good));
                break;
            }
        store.taken.pop_front();
        first_take++;
    }
};

} // namespace video

#endif
