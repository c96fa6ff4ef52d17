/* walk_memory.h - memory of a walk's table: lines in order, some clocks after they were asked for
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TB_WALK_MEMORY_H
#define SPH_TB_WALK_MEMORY_H

#include <deque>

#include "walk_run.h"

namespace bench {

/* Once asked for and once offered a line stays. */
struct WalkMemory {
    struct Line {
        uint32_t line;
        uint64_t due;
    };
    std::deque<Line> way;
    unsigned latency, ready; /* clocks, percent of clocks */
    long error_at, lines;    /* this line is an error; lines asked for */
    uint32_t asked;          /* offered and not taken, or NONE */
    static constexpr uint32_t NONE = UINT32_MAX;

    void begin(Random &random, bool errors) {
        way.clear();
        latency = (unsigned)(random.percent(50) ? random.below(8) : random.below(300));
        ready = random.percent(50) ? 100 : (unsigned)random.between(10, 90);
        error_at = errors ? (long)random.below(12) : -1;
        lines = 0;
        asked = NONE;
    }
    bool there(uint64_t clock) const { return !way.empty() && way.front().due <= clock; }
    bool error() const { return lines - (long)way.size() == error_at; }

    /* What is asked for in this clock, NONE: nothing; what was wrong with it, or null. */
    const char *ask(Random &random, const Run &r, uint32_t line, bool taken, uint64_t clock) {
        const char *wrong = asked != NONE && asked != line ? "a request for a line was taken back"
                            : line != NONE && !r.in_table(line) ? "a line that is not of the table"
                                                                : nullptr;
        asked = line;
        if (asked == NONE || !taken) return wrong;
        uint64_t due = clock + 1 + latency;
        way.push_back({asked, due + random.below(latency + 1)});
        lines++;
        asked = NONE;
        return wrong;
    }
};

inline uint64_t set56(const int v[4]) {
    return (uint64_t)v[3] << 42 | (uint64_t)v[2] << 28 | (uint64_t)v[1] << 14 | (uint64_t)v[0];
}

/* Registers that rt_pixel_scan and rt_pixel_scans have alike. */
template <class Top> void load(Top &dut, const Run &r) {
    dut.window_i = set56(r.win);
    dut.rect_i = set56(r.rect);
    dut.bg_mode_i = (uint8_t)r.mode;
    set(dut.bg_base_i, 26, r.base);
    dut.bg_count_i = (uint8_t)r.cones.size();
    set(dut.mem_lines_i, 26, r.lines);
    set(dut.pitch_i, WD, r.pitch);
    for (int i = 0; i < 3; i++) {
        dut.first_i[i] = (uint32_t)r.turned[i];
        dut.across_i[i] = (uint32_t)r.turned[3 + i];
        dut.down_i[i] = (uint32_t)r.turned[6 + i];
    }
}

} // namespace bench

#endif
