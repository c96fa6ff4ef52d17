/* tb_credit_fifo.cpp - rt_credit_fifo against std::deque
 * SPDX-License-Identifier: Apache-2.0
 *
 * Words are asked for while there is credit, come late and leave late, with other odds in each
 * phase of some thousand clocks. Checked in every clock: credit exactly while fewer than DEPTH
 * words are asked for or inside, order and value of the words. A word that found no place would
 * stop the simulation. A reset in each state empties it.
 */
#include <deque>
#include "Vrt_credit_fifo.h"
#include "bench.h"
#include "stimulus.h"

int main(int argc, char **argv) {
    bench::Bench<Vrt_credit_fifo> b("tb_credit_fifo", argc, argv, 50000);
    Vrt_credit_fifo &t = b.dut;
    t.ask_i = t.in_valid_i = t.out_ready_i = 0;
    b.reset();
    bench::Stimulus driven;
    bench::Points &states = driven.values(
        "handshake", {"asked for with one credit left", "no credit", "comes into the empty queue",
                      "comes and leaves", "comes as the last one", "waits full", "taken of empty"});
    bench::Points &resets = driven.values(
        "reset", {"with nothing", "with words on their way", "with words inside", "while full"});
    std::deque<uint64_t> inside;
    unsigned asked = 0, asks = 50, comes = 50, leaves = 50; /* on their way; percent of clocks */
    while (b.more()) {
        if (!b.random.below(1000))
            for (unsigned *odds : {&asks, &comes, &leaves})
                *odds = b.random.percent(30) ? 100 : (unsigned)b.random.below(100);
        bool room = asked + inside.size() < DEPTH;
        uint64_t word = b.random.bits(WIDTH);
        t.ask_i = room && b.random.percent(asks);
        t.in_valid_i = asked && b.random.percent(comes);
        t.in_data_i = word;
        t.out_ready_i = b.random.percent(leaves);
        b.settle();
        b.expect("credit_o", t.credit_o, room, 1);
        b.expect("out_valid_o", t.out_valid_o, !inside.empty(), 1);
        if (!inside.empty()) b.expect("out_data_o", t.out_data_o, inside.front(), WIDTH);
        if (b.bad()) b.show("words inside", (bench::i128)inside.size(), 8);
        const size_t n = inside.size();
        const bool leaves_now = n && t.out_ready_i;
        if (t.ask_i && asked + n == DEPTH - 1) states.value(0);
        if (!room) states.value(1);
        if (t.in_valid_i) states.value(!n ? 2 : leaves_now ? 3 : n == DEPTH - 1 ? 4 : -1);
        if (n == DEPTH && !t.out_ready_i) states.value(5);
        if (!n && t.out_ready_i) states.value(6);
        if (!inside.empty() && t.out_ready_i) inside.pop_front();
        if (t.in_valid_i) inside.push_back(word);
        asked += t.ask_i - t.in_valid_i;
        b.tick();
        b.done();
        if (b.random.below(300)) continue;
        resets.value(inside.size() == DEPTH ? 3 : !inside.empty() ? 2 : asked ? 1 : 0);
        t.ask_i = t.in_valid_i = t.out_ready_i = 0;
        b.reset();
        inside.clear();
        asked = 0;
    }
    if (b.all_vectors && !driven.whole()) b.fail("less was driven than its list says");
    return b.finish();
}
