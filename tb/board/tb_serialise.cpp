/* tb_serialise.cpp - rt_serialise: a deserialiser finds every symbol of every lane, in order
 * SPDX-License-Identifier: Apache-2.0
 *
 * Pins are sampled in the middle of each half of clk5, ten samples a pixel clock. Symbols are
 * random, or differ in one bit; the bits that leave must be those of the symbols one after another,
 * at each phase at which the first pixel clock may come.
 */
#include <deque>
#include <memory>
#include "Vrt_serialise.h"
#include "bench.h"
#include "stimulus.h"

namespace {

constexpr int LATE = 6; /* half clocks */

struct Top : Vrt_serialise {
    unsigned char clk = 0, rst = 0;
};

/* Symbols of a lane, and the lists of what their bits did. */
struct Lane {
    std::deque<bool> sent, got;
    uint64_t symbol = 0;
    bench::Points *bits = nullptr;
};

/* From power-up on, with the pixel clock's first edge at one of five edges of clk5. */
void run(bench::Bench<Top> &b, Lane (&lanes)[LANES], unsigned phase, long vectors) {
    const std::unique_ptr<Top> dut(new Top);
    int late = -1; /* half clocks of clk5 from a symbol's edge to its first bit */
    for (Lane &lane : lanes)
        lane.sent.clear(), lane.got.clear();
    for (uint64_t half = 0; b.vectors < vectors && b.more(); half++, b.cycle = 0) {
        const bool pix = half % 10 == 2 * phase;
        dut->clk5 = half % 2 == 0;
        if (half % 10 == (2 * phase + 5) % 10) dut->pix_clk = 0;
        if (pix) dut->pix_clk = 1;
        dut->eval();
        for (int i = 0; pix && i < LANES; i++) {
            Lane &lane = lanes[i];
            lane.symbol = b.random.percent(50) ? lane.symbol ^ 1u << b.random.below(10)
                                               : b.random.below(1 << 10);
            lane.bits->word(lane.symbol);
            for (int k = 0; k < 10; k++)
                lane.sent.push_back(lane.symbol >> k & 1);
            bench::put(dut->symbol_i, 10 * i, 10, (bench::i128)lane.symbol);
        }
        dut->eval();
        for (int i = 0; i < LANES; i++)
            lanes[i].got.push_back(dut->pin_o >> i & 1);
        if (half < 400) continue;
        if (late < 0) { /* the delay at which lane 0 has all bits */
            for (int d = 0; d < 40 && late < 0; d++) {
                bool same = true;
                for (size_t k = 100; k < 300; k++)
                    same = same && lanes[0].got[k + d] == lanes[0].sent[k];
                if (same) late = d;
            }
            if (late < 0) return b.fail("no delay fits lane 0");
            b.expect("half clocks from the edge of a symbol to its first bit",
                     late - (int)(2 * phase), LATE);
            for (Lane &lane : lanes) {
                lane.got.erase(lane.got.begin(), lane.got.begin() + late + 100);
                lane.sent.erase(lane.sent.begin(), lane.sent.begin() + 100);
            }
        }
        while (lanes[0].got.size() >= 10 && lanes[0].sent.size() >= 10) {
            for (Lane &lane : lanes)
                for (int k = 0; k < 10; k++) {
                    b.expect("a bit of a lane", lane.got.front(), lane.sent.front());
                    lane.got.pop_front();
                    lane.sent.pop_front();
                }
            b.done();
        }
    }
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Top> b("tb_serialise", argc, argv, 20000);
    bench::Stimulus driven;
    Lane lanes[LANES];
    for (int i = 0; i < LANES; i++)
        lanes[i].bits = &driven.alone(("symbol of lane " + std::to_string(i)).c_str(), 10);
    for (unsigned phase = 0; phase < 5; phase++)
        run(b, lanes, phase, b.target * (phase + 1) / 5);
    if (b.all_vectors && !b.mismatches && !driven.whole()) b.fail("the list of stimulus");
    return b.finish();
}
