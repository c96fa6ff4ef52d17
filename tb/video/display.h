/* display.h - a display: decodes TMDS symbols, checks syncs and blanking, gives whole pictures
 * SPDX-License-Identifier: Apache-2.0
 *
 *     Display display(mode);
 *     each pixel clock: display.take(blue, green, red);       // ten bits each, bit 0 came first
 *     if (display.error()) ...                                // what was wrong, and where
 *     while (display.has_picture()) display.picture();        // rows of 0xRRGGBB
 *
 * It knows no more of the sender than DVI 1.0 and the mode. The first leading edge of vsync that
 * comes with one of hsync is the corner of its raster; from there on every de, hsync and vsync must
 * be where the mode's formula has it: a part that is a pixel too long or too short is an error. A
 * picture is what came between two such corners.
 */
#ifndef SPH_DISPLAY_H
#define SPH_DISPLAY_H

#include <cstdint>
#include <cstdlib>
#include <deque>
#include <string>
#include <vector>
#include "driver/sphaera_modes.h"

namespace video {

/* The fields of modes.def, in their order. */
struct Mode {
    unsigned SPHAERA_MODE_FIELDS;

    unsigned h_total() const { return h_active + h_front + h_sync + h_back; }
    unsigned v_total() const { return v_active + v_front + v_sync + v_back; }
};

/* Sets the bundle mode_i of a verilated module. */
template <class Port> void set_mode(Port &port, const Mode &m) {
    const unsigned value[] = {m.h_active, m.h_front, m.h_sync, m.h_back, m.v_active,
                              m.v_front,  m.v_sync,  m.v_back, m.h_pol,  m.v_pol};
    int at = 0;
    for (int i = 0; i < 10; i++) {
        const int bits = i < 8 ? 13 : 1;
        for (int b = 0; b < bits; b++, at++) {
            const uint32_t bit = 1u << at % 32;
            port[at / 32] = value[i] >> b & 1 ? port[at / 32] | bit : port[at / 32] & ~bit;
        }
    }
}

struct Picture {
    std::vector<uint32_t> rgb; /* h_active * v_active, rows from the top */
};

class Display {
  public:
    explicit Display(const Mode &mode) : m(mode) {}

    /* Forgets the raster; no edge counts within the next `clocks`. */
    void lose(unsigned clocks) {
        locked = false;
        deaf = clocks;
        now.rgb.clear();
    }
    bool is_locked() const { return locked; }
    const std::string &error() const { return what; }
    bool has_picture() const { return !whole.empty(); }
    Picture picture() {
        Picture p = std::move(whole.front());
        whole.pop_front();
        return p;
    }

    /* The symbols of one pixel clock. */
    void take(unsigned blue, unsigned green, unsigned red) {
        const int control = control_of(blue);
        const bool de = control < 0;
        balance(0, blue, de);
        balance(1, green, de);
        balance(2, red, de);
        if ((control_of(green) < 0) != de || (control_of(red) < 0) != de)
            fail("channels do not agree on de");
        if (!de && (control_of(green) || control_of(red))) fail("CTL0..3 are not 0");
        const bool hs = de ? last_hs : ((control & 1) != 0) == (m.h_pol != 0);
        const bool vs = de ? last_vs : ((control & 2) != 0) == (m.v_pol != 0);
        const bool corner = vs && !last_vs && hs && !last_hs && !deaf;
        if (!locked && corner) {
            locked = true;
            x = y = 0;
        }
        deaf -= deaf > 0;
        last_hs = hs;
        last_vs = vs;
        if (!locked) return;
        const unsigned first_x = m.h_sync + m.h_back, first_y = m.v_sync + m.v_back;
        const bool in =
            x >= first_x && x < first_x + m.h_active && y >= first_y && y < first_y + m.v_active;
        if (de != in) fail(in ? "de is missing" : "de where blanking should be");
        if (!de && hs != (x < m.h_sync)) fail("hsync");
        if (!de && vs != (y < m.v_sync)) fail("vsync");
        if (de) now.rgb.push_back(byte_of(red) << 16 | byte_of(green) << 8 | byte_of(blue));
        if (++x < m.h_total()) return;
        x = 0;
        if (++y < m.v_total()) return;
        y = 0;
        whole.push_back(std::move(now));
        now = Picture();
    }

  private:
    Mode m;
    bool locked = false, last_hs = true, last_vs = true;
    unsigned x = 0, y = 0, deaf = 0;
    int sum[3] = {0, 0, 0}; /* ones - zeros sent of each channel since blanking */
    Picture now;
    std::deque<Picture> whole;
    std::string what;

    /* The control bits of a symbol, {vsync, hsync} of channel 0; -1: it is data. DVI 1.0, 3.2.2 */
    static int control_of(unsigned symbol) {
        switch (symbol) {
        case 0x354:
            return 0;
        case 0x0ab:
            return 1;
        case 0x154:
            return 2;
        case 0x2ab:
            return 3;
        default:
            return -1;
        }
    }
    /* The byte of a data symbol. DVI 1.0, figure 3-6 */
    static uint32_t byte_of(unsigned symbol) {
        const unsigned bits = (symbol & 0x200 ? ~symbol : symbol) & 0xff;
        const unsigned pairs = (bits ^ bits << 1) & 0xff;
        return symbol & 0x100 ? pairs : pairs ^ 0xfe;
    }
    /* A link that stays balanced never has many more ones than zeros. */
    void balance(int channel, unsigned symbol, bool de) {
        const int ones = __builtin_popcount(symbol & 0x3ff);
        sum[channel] = de ? sum[channel] + 2 * ones - 10 : 0;
        if (abs(sum[channel]) > 10) fail("the channel is not balanced");
    }
    void fail(const char *text) {
        if (!locked || !what.empty()) return;
        what = std::string(text) + " at clock " + std::to_string(x) + " of row " +
               std::to_string(y) + ", counted from the edges of the syncs";
    }
};

} // namespace video

#endif
