/* frame_store.h - frames in memory behind an AXI4 read port, and who says which one is shown
 * SPDX-License-Identifier: Apache-2.0
 *
 * A frame is filled with random pixels when it is taken and with others as soon as the next is
 * taken: what is read of it too late is seen. The port checks the rules of AXI4 that a reader must
 * keep, and that a row's bytes and no others are read.
 */
#ifndef SPH_FRAME_STORE_H
#define SPH_FRAME_STORE_H

#include <deque>
#include <string>
#include <vector>
#include "bench.h"

namespace video {

/* What a mode makes of the frame store, and how its pixels stand there. */
struct Shape {
    unsigned width, height; /* of the display */
    bool rgb565, twice;
    unsigned stride; /* bytes */

    unsigned columns() const { return twice ? (width + 1) / 2 : width; }
    unsigned rows() const { return twice ? (height + 1) / 2 : height; }
    unsigned row_bytes() const { return columns() * (rgb565 ? 2 : 4); }
};

/* 0xRRGGBB of a pixel of the store: five and six bits are repeated below themselves. */
inline uint32_t colour_of(const std::vector<uint8_t> &bytes, size_t at, bool rgb565) {
    if (!rgb565) return (uint32_t)bytes[at + 2] << 16 | (uint32_t)bytes[at + 1] << 8 | bytes[at];
    const unsigned word = bytes[at] | (unsigned)bytes[at + 1] << 8;
    const unsigned r = word >> 11, g = word >> 5 & 63, b = word & 31;
    return (r * 33 / 4) << 16 | (g * 65 / 16) << 8 | b * 33 / 4;
}

class FrameStore {
  public:
    uint32_t base[3] = {0x10000000, 0x600007c0, 0xf0000040}; /* other ones as frames are shown */
    int stalls = 0;       /* percent of the clocks in which a channel does nothing */
    unsigned latency = 5; /* clocks from an address to its first beat */
    bool dead = false;    /* gives no beat */
    int errors = 0;       /* per mille of beats that come with an error */
    uint64_t error_beats = 0, beats = 0, bursts = 0;
    bool nothing = false;                    /* no frame is complete */
    unsigned depth = 0;                      /* most bursts on their way so far */
    unsigned room = ~0u;                     /* most beats that may be on their way */
    std::deque<std::vector<uint32_t>> taken; /* pictures, as they should be shown */
    std::string what;                        /* a rule that was broken */

    FrameStore(bench::Random &r, unsigned beat_bytes) : random(r), beat(beat_bytes) {}

    void shape(const Shape &s) {
        before = form; /* of which a read may still be asked for */
        form = s;
    }
    /* The bus is reset: nothing is owed. */
    void reset() {
        owed.clear();
        waiting = next_valid = next_ready = false;
        forgotten = asked;
    }
    /* What a reset comes into: 0 nothing, 1 an address that waits, 2 beats that are owed. */
    int state() const { return waiting ? 1 : owed.empty() ? 0 : 2; }

    /* One clock, before its edge: looks at the outputs and sets the inputs of the next clock. */
    template <class Top> void clock(Top &dut) {
        address(dut);
        const bool gave = dut.m_scan_rvalid && dut.m_scan_rready && !owed.empty();
        if (gave) {
            owed.front().left--;
            if (!owed.front().left) owed.pop_front();
        }
        for (Burst &b : owed)
            b.wait -= b.wait > 0;
        if (dut.take_o) take();
        next_ready = !random.percent((unsigned)stalls);
        /* a beat that waits stays */
        if (!(next_valid && !gave))
            next_valid =
                !dead && !owed.empty() && !owed.front().wait && !random.percent((unsigned)stalls);
        if (next_valid && (gave || !dut.m_scan_rvalid)) make_beat();
    }
    /* After the edge. */
    template <class Top> void drive(Top &dut) {
        dut.m_scan_arready = next_ready;
        dut.m_scan_rvalid = next_valid;
        dut.m_scan_rlast = next_valid && owed.front().left == 1;
        dut.m_scan_rresp = response;
        for (unsigned i = 0; i < beat; i += 4) {
            uint32_t word = 0;
            for (unsigned k = 0; k < 4; k++)
                word |= (uint32_t)data[i + k] << 8 * k;
            put_word(dut.m_scan_rdata, i / 4, word);
        }
        dut.show_valid_i = show_valid;
        dut.show_base_i = base[shown];
    }

  private:
    struct Burst {
        uint32_t at;
        unsigned left, wait;
    };
    bench::Random &random;
    unsigned beat;
    Shape form{}, before{};
    std::vector<uint8_t> frame[3];
    unsigned shown = 0;
    bool show_valid = false, next_ready = false, next_valid = false, waiting = false;
    /* since the last take: of its frame something was asked for; an address of the one before
     * waits; the bus was reset behind that */
    bool asked = false, late = false, forgotten = false;
    uint32_t wait_addr = 0, wait_len = 0;
    std::deque<Burst> owed;
    uint8_t data[16] = {0};
    unsigned response = 0;

    static void put_word(uint64_t &port, unsigned i, uint32_t word) {
        port = (port & ~(0xffffffffull << 32 * i)) | (uint64_t)word << 32 * i;
    }
    template <class Port> static void put_word(Port &port, unsigned i, uint32_t word) {
        port[i] = word;
    }

    template <class Top> void address(Top &dut) {
        if (waiting &&
            (!dut.m_scan_arvalid || dut.m_scan_araddr != wait_addr || dut.m_scan_arlen != wait_len))
            fail("an address did not wait for ready");
        waiting = dut.m_scan_arvalid && !dut.m_scan_arready;
        wait_addr = dut.m_scan_araddr;
        wait_len = dut.m_scan_arlen;
        if (!dut.m_scan_arvalid || !dut.m_scan_arready) return;
        const unsigned n = dut.m_scan_arlen + 1u;
        const uint32_t at = dut.m_scan_araddr;
        if (dut.m_scan_arburst != 1 || 1u << dut.m_scan_arsize != beat) fail("arburst or arsize");
        if (at % beat) fail("an address that is not aligned");
        if (at / 4096 != (at + n * beat - 1) / 4096) fail("a burst across 4 KiB");
        if (!show_valid) fail("a read while no frame is complete");
        const uint32_t offset = at - base[frame_at(at)];
        if (!inside(form, offset, n) && !inside(before, offset, n))
            fail("a read beside the rows of a frame");
        if (forgotten) fail("the rest of a frame is asked for behind a reset of the bus");
        if (!late) asked = true;
        late = false;
        owed.push_back({at, n, 1 + latency});
        unsigned left = 0;
        for (const Burst &b : owed)
            left += b.left;
        if (left > room) fail("more beats on their way than the queue has words");
        bursts++;
        if (owed.size() > depth) depth = (unsigned)owed.size();
    }
    unsigned frame_at(uint32_t at) const {
        unsigned f = 0;
        while (f < 2 && at - base[f] >= 0x08000000)
            f++;
        return f;
    }
    /* Whether all beats of a read have bytes of one row. */
    bool inside(const Shape &s, uint32_t offset, unsigned n) const {
        return s.stride && offset % s.stride + (n - 1) * beat < s.row_bytes() &&
               offset / s.stride < s.rows();
    }
    /* What rt_frames does, but any frame at any time. */
    void take() {
        std::vector<uint32_t> picture((size_t)form.width * form.height, 0);
        asked = forgotten = false;
        late = waiting;
        for (uint8_t &b : frame[shown])
            b = (uint8_t)random.next();
        show_valid = !nothing;
        if (show_valid) {
            if (!random.percent(30)) {
                shown = (shown + 1) % 3;
                base[shown] = (shown * 0x55000000 + (uint32_t)random.below(0x4d000000)) & ~63u;
            }
            frame[shown].resize((size_t)form.stride * form.rows());
            for (uint8_t &b : frame[shown])
                b = (uint8_t)random.next();
            for (unsigned y = 0; y < form.height; y++)
                for (unsigned x = 0; x < form.width; x++)
                    picture[(size_t)y * form.width + x] =
                        colour_of(frame[shown],
                                  (size_t)(y >> form.twice) * form.stride +
                                      (x >> form.twice) * (form.rgb565 ? 2 : 4),
                                  form.rgb565);
        }
        taken.push_back(std::move(picture));
    }
    void make_beat() {
        const uint32_t at = owed.front().at;
        owed.front().at += beat;
        const unsigned f = frame_at(at);
        const uint32_t offset = at - base[f];
        beats++;
        for (unsigned k = 0; k < beat; k++)
            data[k] = offset + k < frame[f].size() ? frame[f][offset + k] : 0xa5;
        const bool bad = random.below(1000) < (unsigned)errors;
        response = bad ? 2 + (unsigned)random.below(2) : (unsigned)random.below(2);
        error_beats += bad;
    }
    void fail(const char *text) {
        if (what.empty()) what = text;
    }
};

} // namespace video

#endif
