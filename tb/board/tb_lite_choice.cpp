/* tb_lite_choice.cpp - two masters at one block of registers: each access is its own, and answered
 * SPDX-License-Identifier: Apache-2.0
 *
 * Masters ask for reads and writes at random times; the block takes address and data in any order
 * and answers late. A vector is an access.
 */
#include "Vrt_lite_choice.h"
#include "bench.h"

namespace {

struct Master {
    bool busy = false, write = false, address = false, data = false; /* what is still offered */
    uint32_t at = 0, value = 0;
};

struct Rig {
    bench::Bench<Vrt_lite_choice> &b;
    Vrt_lite_choice &dut;
    Master masters[2];
    bool aw = false, w = false, ar = false; /* what the block has taken */
    uint32_t at = 0, value = 0;

    explicit Rig(bench::Bench<Vrt_lite_choice> &bench) : b(bench), dut(bench.dut) {}
    void offer() {
        dut.s_awvalid = dut.s_wvalid = dut.s_arvalid = 0;
        for (int i = 0; i < 2; i++) {
            Master &m = masters[i];
            if (!m.busy && b.random.percent(20)) {
                m.busy = m.address = true;
                m.write = m.data = b.random.percent(50);
                m.at = (uint32_t)b.random.below(1 << 12);
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
    void clock() {
        offer();
        dut.eval();
        const unsigned bs = dut.s_bvalid, rs = dut.s_rvalid;
        if ((bs & (bs - 1)) || (rs & (rs - 1)) || !bs != !dut.m_bvalid || !rs != !dut.m_rvalid)
            b.fail("an answer to both, or to none");
        for (int i = 0; i < 2; i++) {
            Master &m = masters[i];
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
    return b.finish();
}
