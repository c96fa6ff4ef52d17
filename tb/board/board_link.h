/* board_link.h - the four GPDI pins of a board as a display sees them, and the picture it must see
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef TB_BOARD_LINK_H
#define TB_BOARD_LINK_H

#include "video/display.h"

extern "C" {
#include "render/render.h"
#include "machine/machine.h"
#include "validate/validate.h"
}
#ifdef GOLDEN_CORE /* lab/faults/drawn/boards.py */
#include "top/golden_core.h"
#endif

/* Finds symbols by the edges of the clock's pin, as a receiver does, and gives them to a display.
 */
class Link {
  public:
    video::Display display;
    bool broken = false; /* a symbol had not ten bits */

    explicit Link(const video::Mode &mode) : display(mode) {}
    /* One bit of each pin: blue, green, red, clock. */
    void bit(unsigned pins) {
        const bool clock = pins >> 3 & 1;
        if (clock && !clock_) {
            broken = broken || (symbols_ > 8 && bits_ != 10); /* the first ones end a reset */
            if (bits_ == 10) display.take(lane_[0], lane_[1], lane_[2]);
            bits_ = 0;
            symbols_++;
            lane_[0] = lane_[1] = lane_[2] = 0;
        }
        clock_ = clock;
        for (int i = 0; i < 3 && bits_ < 10; i++)
            lane_[i] |= (pins >> i & 1) << bits_;
        bits_++;
    }

  private:
    bool clock_ = false;
    unsigned bits_ = 0, lane_[3] = {0, 0, 0};
    uint64_t symbols_ = 0;
};

/* What a display of this mode shows of a machine: the golden model's colours as RGB565 keeps them,
 * doubled if the frame is half as wide. */
inline std::vector<uint32_t> golden_picture(const char *path, const video::Mode &mode) {
    struct sph_error err = {{0}};
    struct sph_render_options options = {};
    sph_machine machine{};
    sph_frame frame{};
    sph_counters counters{};
    if (sph_machine_read(path, &machine, &err) ||
        sph_render(&machine, &options, &frame, &counters, &err) < 0) {
        fprintf(stderr, "%s\n", err.text);
        exit(2);
    }
    const int which = machine.regs[SPH_REG_FRAME];
    const int depth = which < SPH_FRAMES ? which : SPH_FRAMES - 1;
    const unsigned factor = mode.h_active / (unsigned)frame.width;
    std::vector<uint32_t> rgb;
    for (unsigned y = 0; y < mode.v_active; y++)
        for (unsigned x = 0; x < mode.h_active; x++) {
            const size_t at = y / factor * (size_t)frame.width + x / factor;
            const uint32_t c = frame.pixels[at].colour[depth];
            const uint32_t red = c >> 3 & 31, green = c >> 10 & 63, blue = c >> 19 & 31;
            rgb.push_back((red << 3 | red >> 2) << 16 | (green << 2 | green >> 4) << 8 |
                          (blue << 3 | blue >> 2));
        }
    sph_frame_free(&frame);
    sph_machine_free(&machine);
    return rgb;
}

#endif
