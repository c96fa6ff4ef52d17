/* tb_table.cpp - rt_table: every line of a table, in order, passes times
 * SPDX-License-Identifier: Apache-2.0
 */
#include <vector>

#include "Vrt_table.h"
#include "bench.h"

int main(int argc, char **argv) {
    bench::Bench<Vrt_table> b("tb_table", argc, argv);
    b.dut.start_i = b.dut.room_i = b.dut.req_ready_i = 0;
    b.reset();
    while (b.more()) {
        uint64_t lines = b.random.percent(3)   ? 0
                         : b.random.percent(2) ? 2048
                         : b.random.percent(2) ? b.random.below(2048)
                                               : b.random.log_bits(5);
        uint64_t passes = b.random.percent(3)   ? 0
                          : b.random.percent(1) ? 2048
                          : b.random.percent(1) ? b.random.below(2048)
                                                : b.random.log_bits(4);
        if (lines * passes > 100000) passes = 2;
        uint64_t first = (uint64_t)b.random.mixed(26) % ((1u << 26) - 2048), asked = 0;
        uint64_t stop = b.random.percent(2) ? b.random.below(lines * passes + 1) : lines * passes;
        unsigned room = b.random.percent(50) ? 100 : 30, ready = b.random.percent(50) ? 100 : 30;
        bench::set(b.dut.first_i, 26, (bench::i128)first);
        bench::set(b.dut.lines_i, 12, (bench::i128)lines);
        bench::set(b.dut.passes_i, 12, (bench::i128)passes);
        b.dut.start_i = 1;
        b.dut.room_i = 0;
        b.tick();
        b.dut.start_i = 0;
        while (asked < stop) {
            b.dut.room_i = b.dut.room_i || b.random.percent(room);
            b.dut.req_ready_i = b.random.percent(ready);
            b.settle();
            b.expect("req_valid_o", b.dut.req_valid_o, b.dut.room_i);
            b.expect("asked_o", b.dut.asked_o, b.dut.room_i && b.dut.req_ready_i);
            if (b.dut.room_i)
                b.expect("req_line_o", b.get(b.dut.req_line_o),
                         (bench::i128)(first + asked % lines), 26);
            bool taken = b.dut.room_i && b.dut.req_ready_i;
            asked += taken;
            b.tick();
            if (taken) b.dut.room_i = 0; /* room falls only with a line */
            if (b.bad()) {
                b.show("first_i", (bench::i128)first, 26);
                b.show("lines_i", (bench::i128)lines, 12);
                b.show("passes_i", (bench::i128)passes, 12);
                b.show("asked", (bench::i128)asked, 32);
            }
            b.done();
        }
        if (stop < lines * passes) b.reset(); /* in the middle: the rest is forgotten */
        for (int i = 0; i < 3; i++) {
            b.dut.room_i = b.dut.req_ready_i = 1;
            b.settle();
            b.expect("req_valid_o", b.dut.req_valid_o, 0);
            b.expect("asked_o", b.dut.asked_o, 0);
            b.tick();
        }
        b.done();
    }
    return b.finish();
}
