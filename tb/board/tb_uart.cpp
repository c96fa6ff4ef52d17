/* tb_uart.cpp - rt_uart at a line with jitter, glitches and breaks; each bit out lasts DIV clocks
 * SPDX-License-Identifier: Apache-2.0
 *
 * A vector is a piece of the line that comes in: a byte of a sender whose clock is up to 3 % off
 * and whose edges come up to an eighth of a bit early or late, with pulses of the other level away
 * from the middles of its bits; or what is no byte: a stop bit that is low, a pulse of less than
 * half a bit, a break. Meanwhile bytes go out, and the line is looked at in every clock. Now and
 * then all is reset in the middle.
 */
#include <deque>
#include "Vrt_uart.h"
#include "bench.h"
#include "stimulus.h"

namespace {

enum { BYTE, PULSED, CUT, PULSE, BREAK, KINDS };
constexpr bool SLOW = DIV > 1000; /* a few bytes, for the counters' upper bits */
constexpr int64_t BIT = DIV;

struct Rig {
    bench::Bench<Vrt_uart> &b;
    Vrt_uart &dut;
    bench::Stimulus driven;
    bench::Points &kind = driven.values(
        "the line", {"a byte", "a byte with pulses", "a low stop bit", "a pulse", "a break"});
    bench::Points &rate = driven.values("a sender's clock", {"3 % slow", "right", "3 % fast"});
    bench::Points &wide = driven.values("a pulse that is no start bit", {"a clock", "the longest"});
    bench::Points &in = driven.alone("byte in", 8), &out = driven.alone("byte out", 8);
    bench::Points &met = driven.together("a clock", {"in comes", "out goes", "a reset"});
    std::deque<bool> line;    /* levels of the clocks that come */
    std::deque<unsigned> due; /* bytes that are in it */
    unsigned before = 0, next = 0, sent = 0;
    uint64_t out_at = 0; /* clocks of the byte that goes out; 0: none */

    explicit Rig(bench::Bench<Vrt_uart> &bench) : b(bench), dut(bench.dut) {}
    void level(bool high, int64_t clocks) { line.insert(line.end(), (size_t)clocks, high); }
    unsigned another(unsigned byte) {
        return b.random.percent(50) ? byte ^ 1u << b.random.below(8)
                                    : (unsigned)b.random.below(256);
    }
    void byte(unsigned how) {
        static const int64_t percents[] = {103, 100, 97};
        const unsigned speed = (unsigned)b.random.below(3);
        const size_t start = line.size();
        before = another(before);
        in.word(before);
        rate.value(speed);
        const unsigned bits = (before | (how == CUT ? 0 : 256)) << 1;
        for (int64_t i = 0; i < 10; i++) {
            const int64_t late = i < 9 ? b.random.between(-BIT / 8, BIT / 8) : 0;
            const int64_t ends = (i + 1) * BIT * percents[speed] / 100 + late;
            level(bits >> i & 1, (int64_t)start + ends - (int64_t)line.size());
        }
        if (how ==
            PULSED) /* around edges, where nobody may look; not where a start is waited for */
            for (int64_t i = 1; i < 9; i++) {
                const int64_t edge = (int64_t)start + i * BIT * percents[speed] / 100;
                for (int64_t n = b.random.below(2) ? BIT / 8 : 0; n; n--) {
                    bool &at = line[(size_t)(edge + b.random.between(-BIT / 8, BIT / 8))];
                    at = !at;
                }
            }
        if (how == CUT)
            level(true, b.random.between(2, BIT));
        else
            due.push_back(before);
        level(true, b.random.between(0, b.random.percent(50) ? 2 : 3 * BIT));
    }
    void piece() {
        const unsigned how = (unsigned)b.random.below(KINDS);
        kind.value(how);
        if (how <= CUT) return byte(how);
        if (how == PULSE) {
            level(true, BIT);
            const int64_t longest = BIT / 2 - 1;
            const int64_t n = b.random.percent(50)   ? b.random.between(1, longest)
                              : b.random.percent(50) ? 1
                                                     : longest;
            wide.value(n == 1 ? 0 : n == longest ? 1 : -1);
            level(false, n);
        } else {
            level(false, b.random.between(10 * BIT, 40 * BIT));
        }
        level(true, b.random.between(BIT, 2 * BIT));
    }
    void reset() {
        line.clear();
        due.clear();
        dut.rx_i = 1;
        out_at = 0;
        b.reset(1 + b.random.below(3));
        b.expect("tx_o behind a reset", dut.tx_o, 1);
        b.expect("put_ready_o behind a reset", dut.put_ready_o, 1);
        level(true, 4); /* it saw the line high */
    }
    void clock() {
        const bool goes = out_at, comes = !line.empty() && !due.empty();
        const bool resets = !SLOW && b.random.below(4000) == 0;
        met.clock(comes | goes << 1 | resets << 2);
        if (resets) return reset();
        dut.put_valid_i = dut.put_valid_i || b.random.percent(1);
        if (!dut.put_valid_i) next = another(next);
        dut.put_data_i = (uint8_t)next;
        dut.rx_i = line.empty() || line.front();
        if (!line.empty()) line.pop_front();
        b.expect("put_ready_o", dut.put_ready_o, !out_at);
        const bool put = dut.put_valid_i && dut.put_ready_o;
        b.tick();
        if (out_at) out_at = (out_at + 1) % (10 * DIV + 1);
        if (put) {
            out_at = 1;
            sent = (next | 256) << 1;
            dut.put_valid_i = 0;
            out.word(next);
        }
        b.expect("tx_o", dut.tx_o, out_at ? sent >> (out_at - 1) / DIV & 1 : 1);
        if (!dut.get_valid_o) return;
        if (due.empty()) return b.fail("a byte that nobody sent");
        b.expect("get_data_o", dut.get_data_o, due.front());
        due.pop_front();
    }
};

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_uart> b("tb_uart", argc, argv, SLOW ? 8 : 4000);
    if (SLOW && b.target > 8) b.target = 8; /* of 200 000 clocks each */
    Rig rig(b);
    rig.dut.put_valid_i = 0;
    rig.reset();
    while (b.more()) {
        rig.piece();
        while (!rig.line.empty() && !b.failed())
            rig.clock();
        if (!rig.due.empty() && b.random.percent(20)) /* the next one may come at once */
            for (unsigned n = DIV; n-- && !b.failed();)
                rig.clock();
        b.expect("bytes that did not come", rig.due.size() > 1, 0);
        b.cycle = 0;
        b.done();
    }
    if (!SLOW && b.all_vectors && !b.mismatches && !rig.driven.whole())
        b.fail("the list of stimulus");
    return b.finish();
}
