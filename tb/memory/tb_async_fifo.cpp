/* tb_async_fifo.cpp - rt_async_fifo against std::deque, at ratios of clocks from 1:5 to 5:1
 * SPDX-License-Identifier: Apache-2.0
 *
 * A vector is a word that leaves. Clocks, and odds of producer and consumer, change from time to
 * time; both sides are reset together with words inside. Checked: order and values; a word waits
 * unchanged; the producer is never told of less than is inside, nor of room that there is not; a
 * word is out within eight edges of the reader's clock.
 */
#include <deque>
#include "Vrt_async_fifo.h"
#include "bench.h"

namespace {

struct Word {
    uint64_t data;
    unsigned age; /* edges of rd_clk since it was pushed */
};

/* What Bench asks of a module with one clock. */
struct Top : Vrt_async_fifo {
    unsigned char clk = 0, rst = 0;
};

class Check {
  public:
    explicit Check(bench::Bench<Top> &bench) : b(bench) { b.dut.wr_rst = b.dut.rd_rst = 1; }

    uint64_t edges = 0, full = 0;

    /* The next edge of a clock, or of both. */
    void edge() {
        Top &dut = b.dut;
        edges++;
        /* both sides now and then, whatever is inside; each sees some edges of its clock */
        if (edges % RESETS == 0) dut.wr_rst = dut.rd_rst = 1, model.clear(), waits = false;
        if (edges % RESETS == 40) dut.wr_rst = dut.rd_rst = 0;
        if (edges % 1000 == 0)
            for (int i = 0; i < 2; i++) {
                period[i] = 1000 + b.random.below(4000);
                odds[i] = (unsigned)b.random.below(5) * 25;
            }
        const bool wr = next[0] <= next[1], rd = next[1] <= next[0];
        if (wr) {
            next[0] += period[0];
            dut.wr_valid_i = edges % RESETS > 80 && b.random.percent(odds[0]);
            dut.wr_data_i = (decltype(+dut.wr_data_i))b.random.bits(WIDTH);
        }
        if (rd) {
            next[1] += period[1];
            dut.rd_ready_i = b.random.percent(odds[1]);
        }
        dut.eval();
        if (rd && !dut.rd_rst) reads();
        if (wr && !dut.wr_rst) writes();
        dut.wr_clk = wr;
        dut.rd_clk = rd;
        dut.eval();
        dut.wr_clk = dut.rd_clk = 0;
        dut.eval();
    }

  private:
    static constexpr uint64_t RESETS = 5000; /* edges from one reset to the next */
    bench::Bench<Top> &b;
    std::deque<Word> model;
    uint64_t next[2] = {0, 500}, period[2] = {1000, 1000}, waiting = 0;
    unsigned odds[2] = {50, 50};
    bool waits = false;

    void reads() {
        const Top &dut = b.dut;
        for (Word &w : model)
            w.age++;
        if (waits) {
            b.expect("rd_valid_o of a word that waits", dut.rd_valid_o, 1);
            b.expect("a word that waits", (bench::i128)dut.rd_data_o, (bench::i128)waiting);
        }
        waits = dut.rd_valid_o && !dut.rd_ready_i;
        waiting = dut.rd_data_o;
        if (dut.rd_valid_o && model.empty()) b.fail("a word of nothing");
        if (!dut.rd_valid_o && !model.empty() && model.front().age > 8)
            b.fail("a word does not come out");
        if (!dut.rd_valid_o || !dut.rd_ready_i || model.empty()) return;
        b.expect("rd_data_o", (bench::i128)dut.rd_data_o, (bench::i128)model.front().data);
        model.pop_front();
        b.done();
    }
    void writes() {
        const Top &dut = b.dut;
        /* one may be in the output register */
        if (dut.wr_count_o + 1u < model.size()) b.fail("wr_count_o is too low");
        if (dut.wr_ready_o != (dut.wr_count_o != DEPTH)) b.fail("wr_ready_o is not room");
        full += !dut.wr_ready_o;
        if (dut.wr_valid_i && dut.wr_ready_o) model.push_back({dut.wr_data_i, 0});
    }
};

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Top> b("tb_async_fifo", argc, argv, 100000);
    Check check(b);
    for (; b.more(); b.cycle = 0)
        check.edge();
    printf("# full in %llu of %llu edges\n", (unsigned long long)check.full,
           (unsigned long long)check.edges);
    if (b.all_vectors && !check.full) b.fail("it was never full");
    return b.finish();
}
