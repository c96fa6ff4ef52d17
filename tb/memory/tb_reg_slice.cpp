/* tb_reg_slice.cpp - rt_reg_slice against a word that is there or not
 * SPDX-License-Identifier: Apache-2.0
 *
 * Words come and leave with other odds in each phase of some thousand clocks. Checked in every
 * clock: ready exactly if there is no word or it leaves, valid exactly if there is one, its value.
 */
#include "Vrt_reg_slice.h"
#include "bench.h"

int main(int argc, char **argv) {
    bench::Bench<Vrt_reg_slice> b("tb_reg_slice", argc, argv, 50000);
    Vrt_reg_slice &t = b.dut;
    t.in_valid_i = t.out_ready_i = 0;
    b.reset();
    bool full = false;
    uint64_t inside = 0;
    unsigned comes = 50, leaves = 50; /* percent of clocks */
    while (b.more()) {
        if (!b.random.below(1000))
            for (unsigned *odds : {&comes, &leaves})
                *odds = b.random.percent(30) ? 100 : (unsigned)b.random.below(100);
        uint64_t word = b.random.bits(WIDTH);
        t.in_valid_i = b.random.percent(comes);
        t.in_data_i = word;
        t.out_ready_i = b.random.percent(leaves);
        b.settle();
        bool room = !full || t.out_ready_i;
        b.expect("in_ready_o", t.in_ready_o, room, 1);
        b.expect("out_valid_o", t.out_valid_o, full, 1);
        if (full) b.expect("out_data_o", t.out_data_o, inside, WIDTH);
        if (room) full = t.in_valid_i;
        if (room) inside = word;
        b.tick();
        b.done();
    }
    return b.finish();
}
