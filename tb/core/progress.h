/* progress.h - does a busy core go on? Slow is not hung
 * SPDX-License-Identifier: Apache-2.0
 *
 * A pixel, a line asked for, or a counter of work that the model has too: each in turn, one a
 * clock, as the core's port for them has it.
 */
#ifndef TB_PROGRESS_H
#define TB_PROGRESS_H

#include "host.h"

class Progress {
  public:
    /* What is to be set before a clock; unless somebody else chooses the counter. */
    void before(Host &core, bool choose = true) {
        if (!choose) {
            at_ = core.pins.count_addr;
            return;
        }
        do
            at_ = (at_ + 1) % SPH_COUNTERS;
        while (!sph_counter_both(at_));
        core.pins.count_addr = at_;
    }

    /* What was seen in it. */
    void after(Host &core, const Host::Seen &seen, uint64_t pixels) {
        const uint64_t lines = core.memory().requests();
        const bool counts =
            seen.known && at_ < SPH_COUNTERS && sph_counter_both(at_) && seen.count != count_[at_];
        quiet_ = counts || lines != lines_ || pixels != pixels_ ? 0 : quiet_ + 1;
        if (counts) count_[at_] = seen.count;
        lines_ = lines;
        pixels_ = pixels;
    }

    /* Clocks without any. */
    uint64_t quiet() const { return quiet_; }

  private:
    uint64_t count_[SPH_COUNTERS] = {}, lines_ = 0, pixels_ = 0, quiet_ = 0;
    int at_ = 0;
};

#endif
