/* tb_lite_choice.cpp - two masters at one block of registers: each access is its own, and answered
 * SPDX-License-Identifier: Apache-2.0
 *
 * Masters ask for reads and writes at random times; the block takes address and data in any order
 * and answers late. Now and then all is reset, in the middle of accesses: the block is nobody's in
 * the clock behind it, as in the one behind an answer. A vector is an access.
 */
#include "Vrt_lite_choice.h"
#include "bench.h"
#include "stimulus.h"

namespace {

struct Master {
    bool busy = false, write = false, address = false, data = false; /* what is still offered */
    uint32_t at = 0, value = 0;
};

/* Events of a clock. */
enum { READS = 1, WRITES = 2, /* of master 1: two bits up */ ANSWER = 16, RESET = 32 };

struct Rig {
    bench::Bench<Vrt_lite_choice> &b;
    Vrt_lite_choice &dut;
    bench::Stimulus driven;
    bench::Points *address[2] = {&driven.alone("address of master 0", 12),
                                 &driven.alone("address of master 1", 12)};
    bench::Points &met = driven.together(
        "a clock", {"0 reads", "0 writes", "1 reads", "1 writes", "an answer", "a reset"},
        {{0, 1}, {2, 3}});
    bench::Points &owner = driven.values("reset while the block is of", {"0", "1"});
    Master masters[2];
    bool aw = false, w = false, ar = false; /* what the block has taken */
    int at_owner = 0;                       /* whose access that is */
    bool answered = false;                  /* in the clock before */
    uint32_t at = 0, value = 0;

    explicit Rig(bench::Bench<Vrt_lite_choice> &bench) : b(bench), dut(bench.dut) {}
    void offer() {
        dut.s_awvalid = dut.s_wvalid = dut.s_arvalid = 0;
        for (int i = 0; i < 2; i++) {
            Master &m = masters[i];
            if (!m.busy && b.random.percent(20)) {
                m.busy = m.address = true;
                m.write = m.data = b.random.percent(50);
                m.at = b.random.percent(50) ? m.at ^ 1u << b.random.below(12)
                                            : (uint32_t)b.random.below(1 << 12);
                address[i]->word(m.at);
                m.value = (uint32_t)b.random.next();
            }
            dut.s_awvalid |= (m.address && m.write) << i;
            dut.s_wvalid |= m.data << i;
            dut.s_arvalid |= (m.address && !m.write) << i;
            bench::put(dut.s_awaddr, 12 * i, 12, m.at);
            bench::put(dut.s_araddr, 12 * i, 12, m.at);
            bench::put(dut.s_wdata, 32 * i, 32, m.value);
        }
        dut.m_awready = !aw && b.random.percent(50);
        dut.m_wready = !w && b.random.percent(50);
        dut.m_arready = !ar && b.random.percent(50);
        dut.m_bvalid = aw && w && b.random.percent(30);
        dut.m_rvalid = ar && b.random.percent(30);
    }
    void answer(int i, bool written) {
        Master &m = masters[i];
        if (!m.busy || m.write != written || m.address || m.data) b.fail("an answer of another");
        b.expect("address", at, m.at);
        if (written) b.expect("data", value, m.value);
        m.busy = false;
        b.done();
    }
    /* All at once, as on a board. */
    void reset() {
        b.reset(1 + b.random.below(3));
        for (Master &m : masters)
            m = Master();
        aw = w = ar = answered = false;
        dut.s_awvalid = dut.s_arvalid = dut.s_wvalid = 3;
        dut.eval();
        if (dut.m_awvalid || dut.m_wvalid || dut.m_arvalid) b.fail("an owner behind a reset");
    }
    void clock() {
        offer();
        dut.eval();
        const bool resets = b.random.below(100) == 0;
        unsigned events = resets ? RESET : 0;
        for (int i = 0; i < 2; i++)
            if (masters[i].busy) events |= (masters[i].write ? WRITES : READS) << 2 * i;
        if (dut.m_bvalid || dut.m_rvalid) events |= ANSWER;
        met.clock(events);
        if (resets && (aw || w || ar)) owner.value(at_owner);
        if (resets) return reset();
        if (answered && (dut.s_awready || dut.s_wready || dut.s_arready))
            b.fail("an owner behind an answer");
        answered = dut.m_bvalid || dut.m_rvalid;
        const unsigned bs = dut.s_bvalid, rs = dut.s_rvalid;
        if ((bs & (bs - 1)) || (rs & (rs - 1)) || !bs != !dut.m_bvalid || !rs != !dut.m_rvalid)
            b.fail("an answer to both, or to none");
        for (int i = 0; i < 2; i++) {
            Master &m = masters[i];
            if ((dut.s_awvalid & dut.s_awready | dut.s_wvalid & dut.s_wready |
                 dut.s_arvalid & dut.s_arready) >>
                    i &
                1)
                at_owner = i;
            if (dut.s_awvalid & dut.s_awready & 1 << i || dut.s_arvalid & dut.s_arready & 1 << i)
                m.address = false;
            if (dut.s_wvalid & dut.s_wready & 1 << i) m.data = false;
            if (bs >> i & 1) answer(i, true);
            if (rs >> i & 1) answer(i, false);
        }
        if ((dut.m_awvalid || dut.m_wvalid || aw || w) && (dut.m_arvalid || ar))
            b.fail("a read beside a write");
        if (dut.m_bvalid) aw = w = false;
        if (dut.m_rvalid) ar = false;
        if (dut.m_awvalid && dut.m_awready) aw = true, at = dut.m_awaddr;
        if (dut.m_wvalid && dut.m_wready) w = true, value = dut.m_wdata;
        if (dut.m_arvalid && dut.m_arready) ar = true, at = dut.m_araddr;
        b.tick();
    }
};

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_lite_choice> b("tb_lite_choice", argc, argv, 20000);
    Rig rig(b);
    b.reset();
    while (b.more())
        rig.clock();
    if (b.all_vectors && !b.mismatches && !rig.driven.whole()) b.fail("the list of stimulus");
    return b.finish();
}
