/* tb_spans.cpp - rt_spans: the spans of the window's rows, over and over
 * SPDX-License-Identifier: Apache-2.0
 *
 * The bench asks for a line whenever there is room, as rt_table does, and answers in order, some
 * time later. Spans come out for rows WIN_Y0 .. WIN_Y1-1, once a pass; none is lost or said twice.
 */
#include <deque>

#include "Vrt_spans.h"
#include "bench.h"

namespace {

struct Window {
    int y0, y1;
};

const Window corners[] = {
    {0, 1},         /* one row */
    {7, 8},         /* the last of its line */
    {8, 9},         /* the first */
    {0, 8},         /* a whole line */
    {7, 9},         /* one row of each of two */
    {1, 32},        /* four lines: all places, less than all rows */
    {0, 33},        /* a line more than there are places */
    {16382, 16383}, /* the last row of all */
    {16376, 16383}, /* all but one of the last line */
    {0, 16383},     /* every row of the largest window */
};

/* Span of a row, different for each. */
uint32_t span(int y) {
    return (uint32_t)y * 2654435761u ^ (uint32_t)y << 3;
}

using Bench = bench::Bench<Vrt_spans>;

void compare(Bench &b, const Window &w, int y) {
    b.expect("span_x0_o", b.dut.span_x0_o, span(y) & 0xffff, 16);
    b.expect("span_x1_o", b.dut.span_x1_o, span(y) >> 16, 16);
    if (b.bad()) {
        b.show("win_y0_i", w.y0, 14);
        b.show("win_y1_i", w.y1, 14);
        b.show("row", y, 14);
    }
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_spans> b("tb_spans", argc, argv);
    size_t corner = 0;
    b.dut.start_i = b.dut.asked_i = b.dut.rsp_valid_i = b.dut.span_next_i = 0;
    b.reset();
    while (b.more()) {
        long wrong = b.mismatches;
        Window w = {(int)b.random.below(b.random.percent(90) ? 100 : 16000), 0};
        w.y1 = w.y0 + 1 + (int)b.random.below(80);
        if (corner < sizeof corners / sizeof *corners) w = corners[corner++];
        int first = w.y0 / 8, lines = (w.y1 + 7) / 8 - first;
        long passes = b.random.between(1, 4), rows = passes * (w.y1 - w.y0);
        long stop = b.random.percent(3) ? (long)b.random.below((uint64_t)rows) : rows;
        uint64_t latency = b.random.below(b.random.percent(50) ? 6 : 200);
        unsigned next = b.random.percent(50) ? 100 : (unsigned)b.random.between(5, 60);
        std::deque<std::pair<int, uint64_t>> way; /* line, when it is there */
        long asked = 0, row = 0;
        uint64_t taken = b.cycle;
        b.dut.win_y0_i = (uint16_t)w.y0;
        b.dut.win_y1_i = (uint16_t)w.y1;
        b.dut.start_i = 1;
        b.tick();
        b.dut.start_i = 0;
        for (; row < stop && b.mismatches == wrong && b.cycle - taken < 3000; b.done()) {
            bool there = !way.empty() && way.front().second <= b.cycle;
            b.dut.asked_i = b.dut.room_o && asked < passes * lines && b.random.percent(80);
            b.dut.span_next_i = b.random.percent(next);
            b.dut.rsp_valid_i = there;
            for (int i = 0; i < 8; i++)
                b.dut.rsp_data_i[i] =
                    there ? span(8 * way.front().first + i) : (uint32_t)b.random.next();
            b.settle();
            int y = w.y0 + (int)(row % (w.y1 - w.y0));
            if (b.dut.span_valid_o) {
                compare(b, w, y);
                if (b.dut.span_next_i) row++, taken = b.cycle;
            }
            if (there && b.dut.rsp_ready_o) way.pop_front();
            if (b.dut.asked_i) {
                uint64_t due = b.cycle + 1 + latency + b.random.below(latency + 1);
                way.push_back({first + (int)(asked++ % lines), due});
                b.expect("lines on their way at most", way.size() <= 4, 1);
            }
            b.tick();
        }
        b.expect("rows", row >= stop, 1);
        b.dut.asked_i = b.dut.rsp_valid_i = b.dut.span_next_i = 0;
        if (stop < rows || b.mismatches != wrong) b.reset(); /* in the middle */
        b.settle();
        b.expect("span_valid_o", b.dut.span_valid_o, 0);
        b.expect("room_o", b.dut.room_o, 1);
        b.done();
    }
    return b.finish();
}
