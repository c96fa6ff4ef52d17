/* tb_sdram.cpp - rt_sdram with a part that checks its times: what was written is read
 * SPDX-License-Identifier: Apache-2.0
 *
 * Words lie in few rows of each bank, so that rows are met, missed and changed; reads and writes
 * come in runs, with pauses, some longer than the time between two refreshes. Bytes are masked. In
 * the end each word lies in the bank, row and column that the module's head says.
 */
#include <deque>
#include "Vrt_sdram.h"
#include "bench.h"
#include "board/sdram_model.h"

namespace {

struct Expected {
    uint64_t data, at;
};

/* A word whose row is one of three, in any bank, at one of eight columns. */
uint32_t place(bench::Random &r) {
    static const uint32_t rows[3] = {0, 0x1fff, 0x0a51};
    return rows[r.below(3)] << 9 | (uint32_t)r.below(4) << 7 | (uint32_t)r.below(8) * 16;
}

/* Runs of reads or of writes, with pauses; a word that was never written is not read. */
struct Orders {
    std::unordered_map<uint32_t, uint64_t> memory;
    unsigned run = 0, pause = 0;
    bool writes = true;

    void offer(Vrt_sdram &dut, bench::Random &random) {
        pause -= pause > 0;
        if (dut.cmd_valid_i || pause) return;
        if (!run) {
            run = 1 + (unsigned)random.below(12);
            writes = random.percent(50);
            pause = (unsigned)random.below(random.percent(3) ? 1500 : 4);
        }
        run--;
        /* the first one waits at power-up, with a bank other than the mode's */
        const uint32_t at = place(random) | (memory.empty() ? 3 << 7 : 0);
        const bool known = memory.count(at) != 0;
        if (!writes && !known) return;
        dut.cmd_valid_i = 1;
        dut.cmd_write_i = writes;
        dut.cmd_addr_i = at;
        dut.cmd_data_i = random.next();
        dut.cmd_strb_i = known && random.percent(50) ? (uint8_t)random.next() : 255;
    }
    void write(uint32_t at, uint64_t data, unsigned strobe) {
        for (int i = 0; i < 8; i++) {
            const uint64_t byte = strobe >> i & 1 ? 0xffull << 8 * i : 0;
            memory[at] = (memory[at] & ~byte) | (data & byte);
        }
    }
};

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_sdram> b("tb_sdram", argc, argv, 30000);
    Vrt_sdram &dut = b.dut;
    Sdram part(16.0);
    Orders orders;
    std::deque<Expected> owed;
    dut.cmd_valid_i = 0;
    b.reset();
    unsigned rest = 8; /* clocks until the last word is written */
    for (uint64_t clock = 0; (b.more() || rest--) && clock < 4000000; clock++) {
        if (b.more()) orders.offer(dut, b.random);
        dut.eval();
        const bool taken = dut.cmd_valid_i && dut.cmd_ready_o;
        const SdramPins pins = {dut.cke_o != 0, dut.command_o,    dut.ba_o, dut.a_o,
                                dut.dqm_o,      dut.dq_oe_o != 0, dut.dq_o};
        if (taken && dut.cmd_write_i) orders.write(dut.cmd_addr_i, dut.cmd_data_i, dut.cmd_strb_i);
        if (taken && !dut.cmd_write_i)
            owed.push_back({orders.memory[dut.cmd_addr_i], dut.cmd_addr_i});
        if (taken) b.done();
        b.tick(); /* dq_i is what the part gave after the edge before */
        part.edge(pins);
        dut.dq_i = part.out();
        if (taken) dut.cmd_valid_i = 0;
        if (!part.error().empty()) {
            b.fail(part.error().c_str());
            break;
        }
        if (!dut.rsp_valid_o) continue;
        if (owed.empty()) {
            b.fail("an answer to nothing");
            break;
        }
        b.expect("rsp_data_o", dut.rsp_data_o, owed.front().data);
        if (b.bad()) b.show("address", (bench::i128)owed.front().at, 22);
        owed.pop_front();
    }
    if (owed.size() > 3) b.fail("reads were not answered");
    for (const auto &[at, data] : orders.memory)
        if (part.word(at >> 7 & 3, at >> 9, (at & 127) * 4) != data) {
            b.fail("a word lies in another place");
            break;
        }
    if (b.all_vectors && part.shortest() != 3) b.fail("no row is closed as soon as RAS allows");
    if (part.first() < POWER || part.first() > POWER + 8) b.fail("power-up of another length");
    printf("# %llu activations, %llu reads, %llu writes, %llu refreshes\n",
           (unsigned long long)part.commands(3), (unsigned long long)part.commands(5),
           (unsigned long long)part.commands(4), (unsigned long long)part.commands(1));
    return b.finish();
}
