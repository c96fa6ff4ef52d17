/* tb_tmds.cpp - rt_tmds against the flow chart of DVI 1.0, figure 3-5: all bytes at all balances
 * SPDX-License-Identifier: Apache-2.0
 *
 * The encoder below is written from the chart, step by step, and shares no formula with the RTL.
 * Its balances that can be reached are found first; then bytes are sent until each was sent at each
 * of them, between blankings with each control symbol. Clocks without advance_i change nothing.
 */
#include <set>
#include <utility>
#include "Vrt_tmds.h"
#include "bench.h"

namespace {

struct Sent {
    unsigned symbol;
    int cnt; /* Cnt(t): ones - zeros sent so far */
};

Sent encode(unsigned d, int cnt) {
    int q_m[9], n1 = 0;
    for (int i = 0; i < 8; i++)
        n1 += d >> i & 1;
    q_m[0] = d & 1;
    if (n1 > 4 || (n1 == 4 && !(d & 1))) {
        for (int i = 1; i < 8; i++)
            q_m[i] = q_m[i - 1] == (int)(d >> i & 1);
        q_m[8] = 0;
    } else {
        for (int i = 1; i < 8; i++)
            q_m[i] = q_m[i - 1] != (int)(d >> i & 1);
        q_m[8] = 1;
    }
    int ones = 0, zeros = 0;
    for (int i = 0; i < 8; i++)
        q_m[i] ? ones++ : zeros++;
    int q_out[10];
    if (cnt == 0 || ones == zeros) {
        q_out[9] = !q_m[8];
        q_out[8] = q_m[8];
        for (int i = 0; i < 8; i++)
            q_out[i] = q_m[8] ? q_m[i] : !q_m[i];
        if (q_m[8] == 0)
            cnt = cnt + (zeros - ones);
        else
            cnt = cnt + (ones - zeros);
    } else if ((cnt > 0 && ones > zeros) || (cnt < 0 && zeros > ones)) {
        q_out[9] = 1;
        q_out[8] = q_m[8];
        for (int i = 0; i < 8; i++)
            q_out[i] = !q_m[i];
        cnt = cnt + 2 * q_m[8] + (zeros - ones);
    } else {
        q_out[9] = 0;
        q_out[8] = q_m[8];
        for (int i = 0; i < 8; i++)
            q_out[i] = q_m[i];
        cnt = cnt - 2 * !q_m[8] + (ones - zeros);
    }
    Sent s = {0, cnt};
    for (int i = 0; i < 10; i++)
        s.symbol |= (unsigned)q_out[i] << i;
    return s;
}

/* The four control symbols as table of DVI 1.0, section 3.2.2, has them: q_out[0:9], first bit
 * left. */
unsigned control(unsigned c) {
    static const char *const BITS[] = {"0010101011", "1101010100", "0010101010", "1101010101"};
    unsigned symbol = 0;
    for (int i = 0; i < 10; i++)
        symbol |= (unsigned)(BITS[c][i] == '1') << i;
    return symbol;
}

std::set<int> reachable() {
    std::set<int> seen = {0}, now = {0};
    while (!now.empty()) {
        std::set<int> next;
        for (int cnt : now)
            for (unsigned d = 0; d < 256; d++)
                if (seen.insert(encode(d, cnt).cnt).second) next.insert(encode(d, cnt).cnt);
        now = next;
    }
    return seen;
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_tmds> b("tb_tmds", argc, argv, 100000);
    const std::set<int> balances = reachable();
    std::set<std::pair<int, unsigned>> tried;
    int cnt = 0;
    std::queue<unsigned> expected;
    for (long i = 0; b.more(); i++, b.cycle = 0) {
        const bool de = i > 4 && !b.random.percent(2);
        unsigned d = (unsigned)b.random.below(256);
        /* a byte that was not sent at this balance yet, if there is one */
        for (unsigned k = 0; k < 256 && tried.count({cnt, d}); k++)
            d = (d + 1) & 255;
        const unsigned c = (unsigned)b.random.below(4);
        if (de) tried.insert({cnt, d});
        const Sent sent = de ? encode(d, cnt) : Sent{control(c), 0};
        cnt = sent.cnt;
        expected.push(sent.symbol);
        while (b.random.percent(10)) { /* inputs that do not count */
            b.dut.advance_i = 0;
            b.dut.de_i = !de;
            b.dut.data_i = (uint8_t)~d;
            const unsigned was = b.dut.symbol_o;
            b.tick();
            b.expect("symbol_o without advance_i", b.dut.symbol_o, was, 10);
        }
        b.dut.advance_i = 1;
        b.dut.de_i = de;
        b.dut.data_i = (uint8_t)d;
        b.dut.control_i = (uint8_t)c;
        b.tick();
        if (i < 2) continue; /* latency 2 */
        while (expected.size() > 2)
            expected.pop();
        b.expect("symbol_o", b.dut.symbol_o, expected.front(), 10);
        b.done();
    }
    const size_t all = balances.size() * 256;
    printf("# ones - zeros from %d to %d; %zu of %zu bytes at balances tried\n", *balances.begin(),
           *balances.rbegin(), tried.size(), all);
    if (b.all_vectors && tried.size() != all) b.fail("a byte was not tried at some balance");
    return b.finish();
}
