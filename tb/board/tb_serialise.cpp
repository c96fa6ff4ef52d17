/* tb_serialise.cpp - rt_serialise: a deserialiser finds every symbol of every lane, in order
 * SPDX-License-Identifier: Apache-2.0
 *
 * Pins are sampled in the middle of each half of clk5, ten samples a pixel clock. Symbols are
 * random; the bits that leave must be those of the symbols one after another, whatever the phase
 * at which the first pixel clock comes.
 */
#include <deque>
#include "Vrt_serialise.h"
#include "bench.h"

namespace {

struct Top : Vrt_serialise {
    unsigned char clk = 0, rst = 0;
};

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Top> b("tb_serialise", argc, argv, 20000);
    Top &dut = b.dut;
    std::deque<bool> sent[LANES];
    int late = -1; /* half clocks of clk5 from a symbol's edge to its first bit */
    std::deque<bool> got[LANES];
    const unsigned phase = (unsigned)b.random.below(5);
    for (uint64_t half = 0; b.more(); half++, b.cycle = 0) {
        const bool pix = half % 10 == 2 * phase;
        dut.clk5 = half % 2 == 0;
        if (half % 10 == (2 * phase + 5) % 10) dut.pix_clk = 0;
        if (pix) dut.pix_clk = 1;
        dut.eval();
        if (pix) {
            uint64_t symbols = 0;
            for (int i = 0; i < LANES; i++)
                for (int k = 0; k < 10; k++) {
                    const bool bit = b.random.next() & 1;
                    sent[i].push_back(bit);
                    symbols |= (uint64_t)bit << (10 * i + k);
                }
            dut.symbol_i = symbols;
            dut.eval();
        }
        for (int i = 0; i < LANES; i++)
            got[i].push_back(dut.pin_o >> i & 1);
        if (half < 400) continue;
        if (late < 0) { /* the delay at which lane 0 has all bits */
            for (int d = 0; d < 40 && late < 0; d++) {
                bool same = true;
                for (size_t k = 100; k < 300; k++)
                    same = same && got[0][k + d] == sent[0][k];
                if (same) late = d;
            }
            if (late < 0) b.fail("no delay fits lane 0");
            for (int i = 0; i < LANES; i++) {
                got[i].erase(got[i].begin(), got[i].begin() + late + 100);
                sent[i].erase(sent[i].begin(), sent[i].begin() + 100);
            }
        }
        while (got[0].size() >= 10 && sent[0].size() >= 10) {
            for (int i = 0; i < LANES; i++)
                for (int k = 0; k < 10; k++) {
                    b.expect("a bit of a lane", got[i].front(), sent[i].front());
                    got[i].pop_front();
                    sent[i].pop_front();
                }
            b.done();
        }
    }
    printf("# %d half clocks of clk5 from the edge of a symbol to its first bit\n",
           late - (int)(2 * phase));
    return b.finish();
}
