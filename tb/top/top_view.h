/* top_view.h - the host's view of rt_top, clock by clock: a model of all but core, pixels, builder
 * SPDX-License-Identifier: Apache-2.0
 *
 * In every edge of clk the model gets what rt_top's inputs had, and what its core did; then it says
 * what every register reads, what the register bus answers, and what irq_o and show_*_o are, which
 * are compared. Of the display it is told when a picture begins and misses a pixel, of the writer
 * of frames when it is empty; both are checked by whoever looks at the buses and at the pictures.
 * W1C: what happens in the clock of a clearing stays. Points of top_plan.txt are noted by name.
 */
#ifndef TB_TOP_VIEW_H
#define TB_TOP_VIEW_H

#include <iterator>
#include <map>
#include <string>
#include <string_view>

#include "Vrt_top.h"
#include "machine/layout.h"
extern "C" {
#include "machine/machine.h"
#include "../../driver/sphaera_regs.h"
}

/* What golden_core.svh saw in an edge of clk; none was seen in netlists and with another core. */
struct Seen {
    bool any, rst, start, keep, busy, asks; /* of the core */
    bool empty, take, underrun, blank;
    uint32_t errors;
    uint64_t count; /* of the counter that was asked for a clock before */
};
inline Seen edge_seen;

/* Points that were met, by name. */
inline std::map<std::string, long, std::less<>> met;

/* Read-write registers, in the order of their addresses: bits that they keep, reset. */
struct Setting {
    uint32_t at, kept, reset;
};
inline const Setting SETTINGS[] = {
    {SPHAERA_INTERRUPT_ENABLE, TOP_BUILD ? 0x1f : 0xf, 0},
    {SPHAERA_WATCHDOG, 0xffffffff, 0x100000},
    {SPHAERA_SCENE_BASE, 0xfffff000, 0},
    {SPHAERA_FRAME0, 0xffffffc0, 0},
    {SPHAERA_FRAME1, 0xffffffc0, 0},
    {SPHAERA_FRAME2, 0xffffffc0, 0},
    {SPHAERA_STRIDE, 0xffe0, 0xa00},
    {SPHAERA_FORMAT, 1, 0},
    {SPHAERA_MUX, 3, 0},
    {SPHAERA_FRAME_MODE, 1, 0},
    {SPHAERA_VIDEO, 0xf, 0},
    {SPHAERA_VIDEO_H_ACTIVE, 0x1fff1fff, 0x100280},
    {SPHAERA_VIDEO_H_SYNC, 0x1fff1fff, 0x300060},
    {SPHAERA_VIDEO_V_ACTIVE, 0x1fff1fff, 0x0a01e0},
    {SPHAERA_VIDEO_V_SYNC, 0x1fff1fff, 0x210002},
    {SPHAERA_LAYER_BYTES, 0xffffffc0, 0}, /* there by parameters, from here on */
    {SPHAERA_ADDRESS_HIGH, 0xffffffff, 0},
    {SPHAERA_BUILD_COUNT, SPHAERA_BUILD_COUNT_SPHERES, 0},
    {SPHAERA_BUILD_RECORDS, SPHAERA_BUILD_RECORDS_LINE, 0},
    {SPHAERA_BUILD_TREE0, SPHAERA_BUILD_TREE0_LINE, 0},
    {SPHAERA_BUILD_TREE1, SPHAERA_BUILD_TREE1_LINE, 0},
    {SPHAERA_BUILD_LINES, SPHAERA_BUILD_LINES_LINES, 0},
    {SPHAERA_BUILD_MODE,
     SPHAERA_BUILD_MODE_ORDER | SPHAERA_BUILD_MODE_ROUNDS | SPHAERA_BUILD_MODE_ROOT, 0},
};

/* The settings that a block with these parameters has. */
inline std::map<uint32_t, Setting> settings_of() {
    std::map<uint32_t, Setting> all;
    for (const Setting &s : SETTINGS)
        if ((s.at != SPHAERA_LAYER_BYTES || TOP_LAYERS) &&
            (s.at != SPHAERA_ADDRESS_HIGH || ADDR > 32) &&
            (s.at < SPHAERA_BUILD_COUNT || TOP_BUILD))
            all[s.at] = s;
    return all;
}

/* A slave of AXI4-Lite takes one write and one read; the block is busy elsewhere at times. */
class View {
  public:
    std::string broken; /* the first thing that was otherwise */
    uint64_t clocks = 0;
    enum State { IDLE, LOAD, WAIT, START, DRAW, FLUSH, END, DRAIN };

    /* What the ports have before an edge of clk. */
    void look(const Vrt_top &top, uint64_t cycle) {
        p_ = {top.rst != 0,
              top.s_axil_awvalid && top.s_axil_awready,
              top.s_axil_wvalid && top.s_axil_wready,
              top.s_axil_bvalid != 0,
              top.s_axil_bready != 0,
              top.s_axil_arvalid && top.s_axil_arready,
              top.s_axil_rvalid != 0,
              top.s_axil_rready != 0,
              top.irq_o != 0,
              top.take_i != 0,
              top.show_valid_o != 0,
              {top.s_axil_awready != 0, top.s_axil_wready != 0, top.s_axil_arready != 0},
              top.s_axil_awaddr,
              top.s_axil_wdata,
              top.s_axil_wstrb,
              top.s_axil_bresp,
              top.s_axil_araddr,
              top.s_axil_rdata,
              top.s_axil_rresp,
              (uint64_t)top.show_base_o,
              {top.m_scene_arvalid != 0, top.m_scene_arready != 0, 0},
              {top.m_scan_arvalid != 0, top.m_scan_arready != 0, top.m_scan_arlen + 1u},
              {top.m_frame_awvalid != 0, top.m_frame_awready != 0, 0},
              top.m_scene_rvalid && top.m_scene_rready,
              top.m_scene_rvalid != 0,
              top.m_scan_rvalid != 0,
              top.m_frame_wvalid && top.m_frame_wready,
              top.m_frame_bvalid != 0,
              top.m_scene_rresp,
              top.m_scan_rresp,
              top.m_frame_bresp,
              top.m_frame_wstrb};
        cycle_ = cycle;
    }
    /* Behind an edge: compares what stood before it, and goes on. */
    void edge() {
        if (!edge_seen.any || !broken.empty() || TOP_BUILD) return; /* no model of rt_builder */
        edge_seen.any = false;
        if (p_.rst && !known_) {
            known_ = true;
        }
        if (!known_) return;
        if (!first_) compare();
        clocks++;
        first_ = false;
        step();
    }
    /* What the block was built with: the parameters of make/rt_top.mk. */
    static uint32_t built(uint32_t at) {
        const uint32_t deepest =
            TOP_REFRACT && TOP_REFLECT < SPH_REFRACT_DEPTH ? SPH_REFRACT_DEPTH : TOP_REFLECT;
        switch (at) {
        case SPHAERA_ID:
            return SPHAERA_ID_RESET;
        case SPHAERA_VERSION:
            return SPHAERA_VERSION_RESET;
        case SPHAERA_CORE_PROFILE: {
            const struct sph_profile p = {"", TOP_W, TOP_WD, TOP_PQ, TOP_NG, TOP_FW, TOP_PR};
            return sph_profile_pack(&p);
        }
        case SPHAERA_CORE_EFFECTS:
            return TOP_SHADOW << SPH_EFFECT_SHADOW | (TOP_REFLECT != 0) << SPH_EFFECT_REFLECT |
                   TOP_INSIDE << SPH_EFFECT_INSIDE | TOP_FIRST << SPH_EFFECT_FIRST |
                   TOP_INTERPENETRATE << SPH_EFFECT_INTERPENETRATE |
                   TOP_FACETS << SPH_EFFECT_FACETS | TOP_TEXTURE << SPH_EFFECT_TEXTURE |
                   TOP_REFRACT << SPH_EFFECT_REFRACT | TOP_SPECULAR << SPH_EFFECT_SPECULAR |
                   TOP_SUM << SPH_EFFECT_SUM | TOP_SMOOTH << SPH_EFFECT_SMOOTH |
                   TOP_CLEAR << SPH_EFFECT_CLEAR | TOP_TURNED << SPH_EFFECT_TURNED |
                   TOP_SPREAD << SPH_EFFECT_SPREAD | TOP_CAMERA << SPH_EFFECT_CAMERA;
        case SPHAERA_CORE_PARTS:
            return 1u << SPHAERA_CORE_PARTS_ENGINES_LSB | deepest << SPHAERA_CORE_PARTS_DEPTH_LSB |
                   TOP_LIGHTS << SPHAERA_CORE_PARTS_LIGHTS_LSB |
                   TOP_CONES << SPHAERA_CORE_PARTS_CONES_LSB | TOP_RECT * SPHAERA_CORE_PARTS_RECT |
                   TOP_SPANS * SPHAERA_CORE_PARTS_SPANS | TOP_ACCEL * SPHAERA_CORE_PARTS_ACCEL |
                   TOP_COARSE << SPHAERA_CORE_PARTS_COARSE_LSB |
                   TOP_BOXES * SPHAERA_CORE_PARTS_BOXES;
        case SPHAERA_CORE_BUS:
            return DATA | TOP_VIDEO * SPHAERA_CORE_BUS_VIDEO |
                   TOP_LAYERS * SPHAERA_CORE_BUS_LAYERS |
                   (uint32_t)ADDR << SPHAERA_CORE_BUS_ADDR_LSB;
        default:
            return 0;
        }
    }
    State state() const { return state_; }
    const char *state_name() const {
        static const char *const names[] = {"idle", "load",  "wait", "start",
                                            "draw", "flush", "end",  "drain"};
        return names[state_];
    }

  private:
    struct Request {
        bool valid, ready;
        unsigned beats;
    };
    struct Ports {
        bool rst, aw, w, bvalid, bready, ar, rvalid, rready, irq, take, show_valid;
        bool readies[3];
        uint32_t awaddr, wdata, wstrb, bresp, araddr, rdata, rresp;
        uint64_t show_base;
        Request scene, scan, frame;
        bool scene_beat, scene_rvalid, scan_rvalid, w_beat, frame_bvalid;
        uint32_t scene_resp, scan_resp, frame_resp, strobe;
    } p_ = {};
    bool known_ = false, first_ = true;
    uint64_t cycle_ = 0;
    std::map<uint32_t, Setting> settings_; /* reset: what they have now */

    // ---- the register bus ----
    bool aw_full_ = false, w_full_ = false, aw_seen_ = false, bvalid_ = false;
    bool ar_full_ = false, ar_seen_ = false, ar_free_ = false, rvalid_ = false;
    uint32_t aw_ = 0, w_ = 0, keep_ = 0, bresp_ = 0, ar_ = 0, elsewhere_ = 0, rdata_ = 0,
             rresp_ = 0, order_ = 0;
    uint32_t errors_ = 0, happened_ = 0, frames_ = 0;

    // ---- registers of the machine ----
    uint32_t machine_[128] = {};
    unsigned clearing_ = 0, loading_ = 0; /* clocks that are left */

    // ---- a frame ----
    State state_ = IDLE;
    bool keep_cache_ = false, bad_ = false, empty_ = false, halt_ = false, silent_ = false;
    bool dead_read_ = false, dead_write_ = false;
    uint32_t seen_errors_ = 0;
    uint64_t still_read_ = 0, still_write_ = 0, still_scan_ = 0;
    unsigned read_told_ = 0, write_told_ = 0; /* answers with an error, a clock later */

    // ---- what the buses owe ----
    unsigned owed_read_ = 0, owed_write_ = 0, owed_scan_ = 0;
    bool scan_waits_ = false, frame_waits_ = false; /* an address did, a clock before */

    // ---- the frame store ----
    bool fresh_ = false, gone_ = false, show_valid_ = false;
    unsigned drawn_ = 0, newest_ = 0, shown_ = 0;
    uint64_t bases_[3] = {}, draw_base_ = 0, newest_base_ = 0, shown_base_ = 0, show_base_ = 0;
    unsigned layer_ = 0, newest_layer_ = 0, shown_layer_ = 0;

    // ---- counters ----
    struct Events {
        unsigned bursts, beats, writes, write_beats;
        bool frame, clear, swap, again, lost, underrun;
    } event_ = {};
    uint32_t total_[SPHAERA_COUNTS] = {};
    uint64_t counter_[64] = {};
    bool run_ = false, wait_ = false, put_ = false;
    unsigned at_ = 0, put_at_ = 0;

    void differ(const char *what, uint64_t is, uint64_t wanted) {
        if (is == wanted || !broken.empty()) return;
        char text[200];
        snprintf(text, sizeof text, "%s: 0x%llx, not 0x%llx, clock %llu, state %s", what,
                 (unsigned long long)is, (unsigned long long)wanted, (unsigned long long)cycle_,
                 state_name());
        broken = text;
    }
    uint32_t set(uint32_t at) const {
        const auto found = settings_.find(at);
        return found == settings_.end() ? 0 : found->second.reset;
    }
    uint64_t address(uint32_t at, unsigned high) const {
        return (uint64_t)(set(SPHAERA_ADDRESS_HIGH) >> 8 * high & 255) << 32 | set(at);
    }
    static bool of_machine(uint32_t at) { return at >= SPHAERA_MACHINE && at < SPHAERA_COUNTERS; }
    static bool of_counters(uint32_t at) {
        return at >= SPHAERA_COUNTERS && at < SPHAERA_COUNTERS + 8 * SPHAERA_COUNTS;
    }
    bool there(uint32_t at) const {
        return settings_.count(at) || of_counters(at) ||
               (of_machine(at) && at < SPHAERA_MACHINE + 4 * SPHAERA_MACHINE_REGISTERS) ||
               at <= SPHAERA_CORE_BUS || (at >= SPHAERA_CONTROL && at <= SPHAERA_INTERRUPTS);
    }
    bool machine_busy() const { return clearing_ || loading_; }
    bool count_busy() const { return run_ || wait_ || put_; }
    bool busy() const { return state_ != IDLE && state_ != DRAIN; }
    uint32_t status() const {
        return busy() * SPHAERA_STATUS_BUSY | (state_ == DRAIN) * SPHAERA_STATUS_DRAINING |
               (state_ == WAIT) * SPHAERA_STATUS_WAITING | edge_seen.blank * SPHAERA_STATUS_BLANK |
               show_valid_ * SPHAERA_STATUS_VALID | drawn_ << SPHAERA_STATUS_DRAWN_LSB |
               newest_ << SPHAERA_STATUS_NEWEST_LSB | shown_ << SPHAERA_STATUS_SHOWN_LSB;
    }
    uint32_t value(uint32_t at) const {
        if (settings_.count(at)) return set(at);
        switch (at) {
        case SPHAERA_STATUS:
            return status();
        case SPHAERA_FRAME_COUNT:
            return frames_;
        case SPHAERA_ERRORS:
            return errors_;
        case SPHAERA_INTERRUPTS:
            return happened_;
        default:
            return there(at) && (of_machine(at) || of_counters(at)) ? elsewhere_ : built(at);
        }
    }

    void compare() {
        differ("AWREADY", p_.readies[0], !aw_full_);
        differ("WREADY", p_.readies[1], !w_full_);
        differ("ARREADY", p_.readies[2], !ar_full_);
        differ("BVALID", p_.bvalid, bvalid_);
        differ("RVALID", p_.rvalid, rvalid_);
        if (bvalid_) differ("BRESP", p_.bresp, bresp_);
        /* pixels are counted as their burst begins, before they are seen */
        if (rvalid_ && ar_ != SPHAERA_COUNTERS + 8 * SPHAERA_COUNT_WRITE_PIXELS) {
            char what[32];
            snprintf(what, sizeof what, "read of 0x%03x", ar_);
            differ(what, p_.rdata, rdata_);
        }
        if (rvalid_) differ("RRESP", p_.rresp, rresp_);
        differ("irq_o", p_.irq, (happened_ & set(SPHAERA_INTERRUPT_ENABLE)) != 0);
        differ("show_valid_o", p_.show_valid, show_valid_);
        if (show_valid_) differ("show_base_o", p_.show_base, show_base_);
        differ("reset of the core", edge_seen.rst, p_.rst || halt_);
        differ("start of the core", edge_seen.start, state_ == START);
        if (state_ == START) differ("caches kept", edge_seen.keep, keep_cache_);
        if (edge_seen.asks) differ("a request of a core in reset", edge_seen.rst, 0);
        if (state_ == FLUSH && edge_seen.empty) differ("writes owed at the end", owed_write_, 0);
    }

    void step() {
        // ---- buses, by their ports ----
        const bool ar_new = p_.scan.valid && !scan_waits_, aw_new = p_.frame.valid && !frame_waits_;
        if (ar_new) owed_scan_ += p_.scan.beats;
        if (aw_new) owed_write_++;
        scan_waits_ = p_.scan.valid && !p_.scan.ready;
        frame_waits_ = p_.frame.valid && !p_.frame.ready;
        const bool answer = p_.frame_bvalid && owed_write_;
        const bool read_idle = !owed_read_, write_idle = !owed_write_;
        const bool read_stall =
            owed_read_ && !p_.scene_rvalid && !(p_.scene.valid && p_.scene.ready);
        const bool write_stall =
            owed_write_ && !p_.frame_bvalid && !p_.w_beat && !(p_.frame.valid && p_.frame.ready);
        const bool scan_beat = p_.scan_rvalid && owed_scan_;
        const bool scan_stall = owed_scan_ && !p_.scan_rvalid && !(p_.scan.valid && p_.scan.ready);
        const bool scan_error = scan_beat && p_.scan_resp & 2;

        // ---- orders ----
        const bool stops = order_ & SPHAERA_CONTROL_STOP, starts = order_ & SPHAERA_CONTROL_START;
        const bool anew = order_ & SPHAERA_CONTROL_SOFT_RESET;
        const bool forget = anew && order_ & SPHAERA_CONTROL_FORGET;
        const bool stop = anew || (stops && state_ != IDLE);
        const bool accept = starts && !stop && state_ == IDLE && !dead_read_ && !dead_write_;
        const bool quiet = read_idle && write_idle;
        const bool room = !(set(SPHAERA_FRAME_MODE) & SPHAERA_FRAME_MODE_WAIT) || !fresh_;
        const bool begin = state_ == WAIT && room && !stop, end = state_ == END && !stop;
        const bool good = end && !bad_ && !edge_seen.errors;
        const bool done = end || (stop && busy());

        // ---- silences ----
        const uint32_t limit = set(SPHAERA_WATCHDOG);
        const bool read_late = limit && still_read_ >= limit && !dead_read_ && busy();
        const bool write_late = limit && still_write_ >= limit && !dead_write_ && busy();
        const bool scan_late = limit && still_scan_ >= limit && !silent_;

        // ---- what happens ----
        const bool video = set(SPHAERA_VIDEO) & SPHAERA_VIDEO_ENABLE;
        const bool take = video ? edge_seen.take : p_.take || order_ & SPHAERA_CONTROL_TAKE;
        const bool swap = take && fresh_, again = take && !fresh_ && show_valid_ && !gone_;
        const bool lost = good && fresh_ && !take;
        const uint32_t new_errors =
            (edge_seen.errors & ~seen_errors_) | (read_told_ == 2) * SPHAERA_ERRORS_SCENE_SLVERR |
            (read_told_ == 3) * SPHAERA_ERRORS_SCENE_DECERR |
            (write_told_ == 2) * SPHAERA_ERRORS_FRAME_SLVERR |
            (write_told_ == 3) * SPHAERA_ERRORS_FRAME_DECERR |
            scan_error * SPHAERA_ERRORS_SCAN_ERROR |
            (read_late || write_late) * SPHAERA_ERRORS_WATCHDOG |
            (starts && !accept) * SPHAERA_ERRORS_REFUSED | scan_late * SPHAERA_ERRORS_SCAN_WATCHDOG;
        const uint32_t happens = done * SPHAERA_INTERRUPTS_FRAME_DONE |
                                 swap * SPHAERA_INTERRUPTS_SWAP |
                                 edge_seen.underrun * SPHAERA_INTERRUPTS_UNDERRUN |
                                 (new_errors != 0) * SPHAERA_INTERRUPTS_ERROR;

        // ---- register bus ----
        const bool write = aw_seen_ && w_full_ && !bvalid_ && !(of_machine(aw_) && machine_busy());
        const bool free =
            !(of_machine(ar_) && machine_busy()) && !(of_counters(ar_) && count_busy());
        const bool read = ar_free_ && !rvalid_ && free;
        const uint32_t ones = w_ & keep_;
        points({write, take, swap, again, lost, good, begin, stop, accept, forget, video, ones,
                new_errors, happens});
        uint32_t clear_errors = write && aw_ == SPHAERA_ERRORS ? ones : 0;
        uint32_t clear_happened = write && aw_ == SPHAERA_INTERRUPTS ? ones : 0;
        if (read) {
            rdata_ = there(ar_) ? value(ar_) : 0;
            rresp_ = there(ar_) ? 0 : 2;
        }
        elsewhere_ = of_counters(ar_) ? word_of_counter(ar_) : machine_[ar_ / 4 % 128];
        const uint32_t order = write && aw_ == SPHAERA_CONTROL ? ones & 0x7f : 0;
        const uint32_t frame_before = machine_[SPH_REG_FRAME];
        if (write && there(aw_) && of_machine(aw_))
            machine_[aw_ / 4 % 128] = (machine_[aw_ / 4 % 128] & ~keep_) | ones;
        const uint64_t next_bases[3] = {address(SPHAERA_FRAME0, 0), address(SPHAERA_FRAME1, 1),
                                        address(SPHAERA_FRAME2, 2)};
        const uint64_t apart = set(SPHAERA_LAYER_BYTES);
        const unsigned mux = set(SPHAERA_MUX);

        // ---- counters: a clock behind what happens ----
        const bool snap = order_ & SPHAERA_CONTROL_SNAPSHOT && !count_busy();
        if (put_) counter_[put_at_] = put_at_ >= 32 ? total_[put_at_] : edge_seen.count;
        put_ = run_;
        put_at_ = at_;
        if (run_ || wait_)
            at_++;
        else
            at_ = 0;
        if (run_ && at_ == SPHAERA_COUNTS) run_ = false, at_ = 0;
        if (wait_ && at_ == 64) run_ = true, wait_ = false, at_ = 0;
        if (snap) run_ = true;
        event_.writes = aw_new; /* it is seen a clock later than what counts it */
        count(event_);
        event_ = {
            edge_seen.asks && !forget, p_.scene_beat, 0, p_.w_beat, begin, anew, swap, again, lost,
            edge_seen.underrun};

        // ---- the frame store ----
        if (accept)
            for (int i = 0; i < 3; i++)
                bases_[i] = next_bases[i];
        if (loading_ == SPHAERA_MACHINE_REGISTERS - SPH_REG_FRAME && !clearing_)
            layer_ = (frame_before & 3) > 2 ? 2 : frame_before & 3;
        const bool fresh = fresh_, valid = show_valid_;
        const unsigned shown = shown_;
        if (take) {
            const unsigned own = fresh ? newest_layer_ : shown_layer_;
            show_base_ = (fresh ? newest_base_ : shown_base_) +
                         (TOP_LAYERS ? (mux ? mux - 1 : own) * apart : 0);
            show_base_ &= (1ull << ADDR) - 1;
            show_valid_ = fresh || (valid && !gone_);
            fresh_ = gone_ = false;
            if (fresh) shown_ = newest_, shown_base_ = newest_base_, shown_layer_ = newest_layer_;
        }
        if (begin) {
            drawn_ = 0;
            while ((valid && drawn_ == shown) || (fresh && drawn_ == newest_))
                drawn_++;
            draw_base_ = bases_[drawn_];
        }
        if (good)
            fresh_ = true, newest_ = drawn_, newest_base_ = draw_base_, newest_layer_ = layer_;
        if (anew) fresh_ = false, gone_ = true;

        // ---- settings and W1C: what happens in the same clock stays ----
        if (write && settings_.count(aw_)) {
            Setting &s = settings_[aw_];
            s.reset = ((s.reset & ~keep_) | ones) & s.kept;
        }
        errors_ = (errors_ & ~clear_errors) | new_errors;
        happened_ = (happened_ & ~clear_happened) | happens;
        frames_ += good;
        if (anew) errors_ = happened_ = frames_ = 0;

        // ---- the frame ----
        const State was = state_;
        const bool drained = was == DRAIN && quiet;
        switch (was) {
        case IDLE:
            if (accept) state_ = LOAD;
            break;
        case LOAD:
            if (!loading_) state_ = WAIT;
            break;
        case WAIT:
            if (room) state_ = START;
            break;
        case START:
            state_ = DRAW;
            break;
        case DRAW:
            if (!edge_seen.busy) state_ = FLUSH;
            break;
        case FLUSH:
            if (empty_ || dead_write_) state_ = END;
            break;
        case END:
            state_ = IDLE;
            break;
        case DRAIN:
            if (quiet) state_ = IDLE;
        }
        if (stop) state_ = DRAIN;
        empty_ = edge_seen.empty;
        if (accept) keep_cache_ = order_ & SPHAERA_CONTROL_KEEP_CACHE;
        if (begin)
            bad_ = false;
        else if (read_told_ >= 2 || write_told_ >= 2 || read_late || write_late)
            bad_ = true;
        dead_read_ = !forget && !drained && (dead_read_ || read_late);
        dead_write_ = !forget && !drained && (dead_write_ || write_late);
        halt_ = stop || (was == DRAIN && !quiet) || dead_read_;
        const auto still = [&](uint64_t &so_far, bool stall) {
            so_far = stall && !forget ? so_far + (so_far < 0xffffffff) : 0;
        };
        still(still_read_, read_stall);
        still(still_write_, write_stall);
        still(still_scan_, scan_stall);
        silent_ = scan_stall && (silent_ || scan_late) && !forget;
        seen_errors_ = edge_seen.errors;
        read_told_ = p_.scene_beat ? p_.scene_resp : 0;
        write_told_ = answer ? p_.frame_resp : 0;

        // ---- what is owed; the machine ----
        owed_read_ += (edge_seen.asks ? 256 / TOP_MEM_DATA : 0) - p_.scene_beat;
        owed_write_ -= answer;
        owed_scan_ -= scan_beat;
        if (forget) owed_read_ = owed_write_ = owed_scan_ = 0, scan_waits_ = frame_waits_ = false;
        if (clearing_)
            clearing_--;
        else if (loading_)
            loading_--;
        if (accept) loading_ = SPHAERA_MACHINE_REGISTERS;

        // ---- the register bus ----
        order_ = order;
        const bool aw_taken = p_.aw, w_taken = p_.w, ar_taken = p_.ar;
        const bool aw_was = aw_full_, ar_was = ar_full_, ar_seen = ar_seen_;
        if (bvalid_ && p_.bready) bvalid_ = false;
        if (rvalid_ && p_.rready) rvalid_ = false;
        if (write) {
            aw_full_ = w_full_ = false;
            bvalid_ = true;
            bresp_ = there(aw_) ? 0 : 2;
        }
        if (read) ar_full_ = false, rvalid_ = true;
        aw_seen_ = aw_was && !write;
        ar_seen_ = ar_was && !read;
        ar_free_ = ar_seen && free && !read;
        if (aw_taken) aw_full_ = true, aw_ = p_.awaddr & ~3u;
        if (w_taken) {
            w_full_ = true;
            w_ = p_.wdata;
            keep_ = 0;
            for (int b = 0; b < 4; b++)
                if (p_.wstrb >> b & 1) keep_ |= 255u << 8 * b;
        }
        if (ar_taken) ar_full_ = true, ar_ = p_.araddr & ~3u;
        if (p_.rst) reset();
    }
    uint32_t word_of_counter(uint32_t at) const {
        const uint64_t c = counter_[(at - SPHAERA_COUNTERS) / 8 % 64];
        return at & 4 ? (uint32_t)(c >> 32) : (uint32_t)c;
    }
    void count(const Events &e) {
        const uint32_t add[] = {e.bursts, e.beats, e.writes, e.write_beats, 0,
                                e.swap,   e.again, e.lost,   e.underrun};
        for (unsigned i = 32; i < SPHAERA_COUNTS; i++) {
            total_[i] += add[i - 32];
            if (i < SPHAERA_COUNT_FRAMES_SHOWN ? e.frame : e.clear) total_[i] = 0;
        }
    }
    void reset() {
        for (auto &[at, s] : settings_of())
            settings_[at] = s;
        aw_full_ = w_full_ = aw_seen_ = bvalid_ = ar_full_ = ar_seen_ = ar_free_ = rvalid_ = false;
        order_ = errors_ = happened_ = frames_ = 0;
        for (uint32_t &word : machine_)
            word = 0;
        clearing_ = 128;
        loading_ = 0;
        state_ = IDLE;
        halt_ = dead_read_ = dead_write_ = silent_ = false;
        still_read_ = still_write_ = still_scan_ = 0;
        seen_errors_ = read_told_ = write_told_ = 0;
        owed_read_ = owed_write_ = owed_scan_ = 0;
        scan_waits_ = frame_waits_ = false;
        fresh_ = gone_ = show_valid_ = false;
        drawn_ = newest_ = shown_ = 0;
        event_ = {};
        for (uint32_t &t : total_)
            t = 0;
        run_ = put_ = false;
        wait_ = true;
        at_ = 0;
    }

    // ---- points ----
    struct Now {
        bool write, take, swap, again, lost, good, begin, stop, accept, forget, video;
        uint32_t ones, errors, happens;
    };
    static void met_if(bool holds, const char *name) {
        if (!holds) return;
        const auto found = met.find(std::string_view(name));
        if (found == met.end())
            met[name] = 1;
        else
            found->second++;
    }
    /* Each order in each state; each event in the clock of its clearing. */
    void points(const Now &n) {
        for (unsigned bit = 0; bit < std::size(ORDERS); bit++)
            if (order_ >> bit & 1) met[std::string(ORDERS[bit]) + " in " + state_name()]++;
        if (n.take) met[std::string("a frame taken in ") + state_name()]++;
        const uint32_t ones = n.write ? n.ones : 0;
        for (uint32_t bit = 1; ones & n.errors && aw_ == SPHAERA_ERRORS && bit; bit <<= 1)
            if (ones & n.errors & bit) met[name_of(ERRORS, bit) + " cleared as it is set"]++;
        for (uint32_t bit = 1; ones & n.happens && aw_ == SPHAERA_INTERRUPTS && bit; bit <<= 1)
            if (ones & n.happens & bit) met[name_of(INTERRUPTS, bit) + " cleared as it is set"]++;
        if (n.errors)
            for (uint32_t bit = 1; bit; bit <<= 1)
                if (n.errors & bit) met[name_of(ERRORS, bit)]++;
        if (n.happens)
            for (uint32_t bit = 1; bit; bit <<= 1)
                if (n.happens & bit) met[name_of(INTERRUPTS, bit)]++;
        met_if(n.write && there(aw_) && !settings_.count(aw_) && aw_ < SPHAERA_CONTROL,
               "a write to a read-only register");
        met_if(n.write && !there(aw_), "a write without a register");
        met_if(n.write && keep_ && ~keep_, "a write of some bytes");
        met_if(aw_seen_ && w_full_ && !bvalid_ && of_machine(aw_) && loading_,
               "a write waits while registers go to the core");
        met_if(ar_seen_ && of_machine(ar_) && loading_,
               "a read waits while registers go to the core");
        met_if(ar_seen_ && of_counters(ar_) && count_busy(), "a read waits for a snapshot");
        met_if(ar_free_ && !there(ar_), "a read without a register");
        met_if(bvalid_ && !p_.bready, "BVALID waits");
        met_if(rvalid_ && !p_.rready, "RVALID waits");
        met_if(aw_full_ && !w_full_, "an address before its data");
        met_if(w_full_ && !aw_full_, "data before their address");
        met_if(aw_full_ && ar_full_, "a read beside a write");
        met_if(n.take && n.good && fresh_, "a frame taken as the next one ends");
        met_if(n.take && n.begin, "a frame taken as the next one begins");
        met_if(n.lost, "a complete frame lost");
        met_if(n.again, "a frame shown again");
        met_if(n.swap, "another frame shown");
        met_if(n.take && gone_ && !fresh_, "nothing shown behind a SOFT_RESET");
        met_if(n.video && fresh_ && order_ & SPHAERA_CONTROL_TAKE, "TAKE with video on");
        met_if(n.video && fresh_ && p_.take, "take_i with video on");
        met_if(n.forget && owed_read_, "FORGET of lines");
        met_if(n.forget && owed_write_, "FORGET of writes");
        met_if(n.forget && owed_scan_, "FORGET of the display's beats");
        met_if(n.forget && state_ == DRAIN, "FORGET of what is drained");
        met_if(state_ == DRAIN && owed_read_ && owed_write_, "both buses drained");
        met_if(state_ == DRAIN && p_.scene_beat, "an answer dropped");
        met_if(state_ == FLUSH && dead_write_, "pixels dropped behind a silent bus");
        met_if(halt_ && dead_read_, "the core in reset behind a silent bus");
        met_if(state_ == IDLE && (dead_read_ || dead_write_) && order_ & SPHAERA_CONTROL_START,
               "START with a bus given up");
        met_if(n.accept && order_ & SPHAERA_CONTROL_KEEP_CACHE, "caches kept");
        met_if(n.accept && loading_, "START while registers of a stopped one go to the core");
        met_if(state_ == END && bad_, "a frame that ends with an error of a bus");
        met_if(state_ == END && edge_seen.errors, "a frame that ends with an error of the core");
        met_if(p_.rst && state_ != IDLE, "rst in a frame");
        met_if(p_.scene.valid && !p_.scene.ready, "ARVALID of the scene waits");
        met_if(p_.scan.valid && !p_.scan.ready, "ARVALID of the display waits");
        met_if(p_.frame.valid && !p_.frame.ready, "AWVALID waits");
        met_if(p_.scene_rvalid && !p_.scene_beat, "RVALID of the scene waits");
        met_if(state_ == WAIT && fresh_, "a frame waits until the newest is shown");
        met_if(p_.irq, "irq_o");
        met_if(happened_ && !p_.irq, "an interrupt that is not enabled");
    }
    static constexpr const char *ORDERS[] = {"START",  "KEEP_CACHE", "STOP", "SOFT_RESET",
                                             "FORGET", "SNAPSHOT",   "TAKE"};
    struct Named {
        uint32_t bit;
        const char *name;
    };
    static constexpr Named ERRORS[] = {{SPHAERA_ERRORS_BAD_NODE, "BAD_NODE"},
                                       {SPHAERA_ERRORS_STACK_OVERFLOW, "STACK_OVERFLOW"},
                                       {SPHAERA_ERRORS_VISIT_LIMIT, "VISIT_LIMIT"},
                                       {SPHAERA_ERRORS_BUS_ERROR, "BUS_ERROR"},
                                       {SPHAERA_ERRORS_MISSING_EFFECT, "MISSING_EFFECT"},
                                       {SPHAERA_ERRORS_WRONG_PROFILE, "WRONG_PROFILE"},
                                       {SPHAERA_ERRORS_LEFT_OUT, "LEFT_OUT"},
                                       {SPHAERA_ERRORS_SCENE_SLVERR, "SCENE_SLVERR"},
                                       {SPHAERA_ERRORS_SCENE_DECERR, "SCENE_DECERR"},
                                       {SPHAERA_ERRORS_FRAME_SLVERR, "FRAME_SLVERR"},
                                       {SPHAERA_ERRORS_FRAME_DECERR, "FRAME_DECERR"},
                                       {SPHAERA_ERRORS_SCAN_ERROR, "SCAN_ERROR"},
                                       {SPHAERA_ERRORS_WATCHDOG, "WATCHDOG"},
                                       {SPHAERA_ERRORS_REFUSED, "REFUSED"},
                                       {SPHAERA_ERRORS_SCAN_WATCHDOG, "SCAN_WATCHDOG"}};
    static constexpr Named INTERRUPTS[] = {{SPHAERA_INTERRUPTS_FRAME_DONE, "FRAME_DONE"},
                                           {SPHAERA_INTERRUPTS_SWAP, "SWAP"},
                                           {SPHAERA_INTERRUPTS_UNDERRUN, "UNDERRUN"},
                                           {SPHAERA_INTERRUPTS_ERROR, "ERROR"}};
    template <size_t N> static std::string name_of(const Named (&list)[N], uint32_t bit) {
        for (const Named &n : list)
            if (n.bit == bit) return n.name;
        return "a bit without a name";
    }
};

#endif
