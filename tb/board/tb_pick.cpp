/* tb_pick.cpp - rt_pick: a press writes the list of the next machine, or of the one before, once
 * SPDX-License-Identifier: Apache-2.0
 *
 * A vector is a press, with bounces. Headers are right, or of another number, or not there; lists
 * have any length, some no end; a frame may be drawn for a while, and answers come late. Of both at
 * once the next one counts. Other buttons, or the same again, are pressed while a list is followed,
 * and do nothing. Now and then all is reset in the middle, with a button that is held down: it
 * counts when it was let go.
 */
#include <deque>
#include <vector>
#include "Vrt_pick.h"
#include "bench.h"
#include "stimulus.h"

extern "C" {
#include "tool/board.h"
}

namespace {

constexpr unsigned LOOK = 1u << STILL;

struct Rig {
    bench::Bench<Vrt_pick> &b;
    Vrt_pick &dut;
    uint64_t header = 0;
    std::vector<uint64_t> lists[BOARD_MACHINES];
    std::deque<uint64_t> wanted; /* items that are to be written */
    unsigned drawing = 0, number = 0;
    bool started = false;       /* STATUS said that no frame is drawn */
    std::deque<uint64_t> reads; /* answers of memory */
    std::deque<uint32_t> statuses;
    unsigned quiet = 0;
    bool aw = false, w = false, header_read = false;
    bool together = false; /* both buttons do the same */
    uint64_t item = 0;

    bench::Stimulus driven;
    bench::Points &presses_ = driven.values(
        "a press", {"next", "before", "next of the last", "before of the first", "of one machine",
                    "without machines", "of too many", "with another header", "of both"});
    bench::Points &lists_ = driven.values("a list", {"of nothing", "of an item", "without an end"});
    bench::Points &offsets_ = driven.alone("offset of an item", 12);
    bench::Points &numbers_ =
        driven.values("number_o", {"0", "1", "2", "4", "8", "16", "32", "63"});
    bench::Points &resets_ =
        driven.values("a reset", {"while the header is read", "while STATUS is", "while an item is",
                                  "while one is written", "with next held", "with before held"});
    bench::Points &both_ = driven.values("while a list is followed", {"next", "before"});

    explicit Rig(bench::Bench<Vrt_pick> &bench) : b(bench), dut(bench.dut) {}
    uint64_t memory(uint32_t address) {
        const uint32_t at = (address - BOARD_LISTS) / 8;
        if (address < BOARD_LISTS || at >= 256 * (BOARD_MACHINES + 1)) return b.fail("address"), 0;
        header_read = at == 0;
        if (at == 0) return header;
        if (at < 256) return b.fail("behind the header"), 0;
        const std::vector<uint64_t> &list = lists[at / 256 - 1];
        return at % 256 < list.size() ? list[at % 256] : b.random.next() | 0xfffull << 32;
    }
    void clock() {
        dut.m_rvalid = !reads.empty() && b.random.percent(50);
        dut.m_rdata = dut.m_rvalid ? reads.front() : b.random.next();
        dut.r_rvalid = !statuses.empty() && b.random.percent(50);
        dut.r_rdata = dut.r_rvalid ? statuses.front() : (uint32_t)b.random.next();
        dut.r_bvalid = aw && w && b.random.percent(50);
        dut.m_arready = b.random.percent(50);
        dut.r_arready = b.random.percent(50);
        dut.r_awready = b.random.percent(50);
        dut.r_wready = b.random.percent(50);
        dut.eval();
        if (dut.m_rvalid) reads.pop_front(), header_read = false;
        if (dut.r_rvalid) statuses.pop_front();
        if (dut.r_bvalid) aw = w = false, write();
        if (dut.m_arvalid && dut.m_arready) reads.push_back(memory(dut.m_araddr));
        if (dut.r_arvalid && dut.r_arready) {
            b.expect("r_araddr", dut.r_araddr, SPHAERA_STATUS);
            const uint32_t status = drawing ? 1u + (uint32_t)b.random.below(3) : 0u;
            started = !status;
            drawing -= drawing > 0;
            statuses.push_back(status | ((uint32_t)b.random.next() & ~3u));
        }
        if (dut.r_awvalid && dut.r_awready)
            aw = true, item = (uint64_t)dut.r_awaddr << 32 | (item & ~0u);
        if (dut.r_wvalid && dut.r_wready) w = true, item = (item >> 32 << 32) | dut.r_wdata;
        quiet = dut.m_arvalid || dut.r_arvalid || dut.r_awvalid || aw || w || !reads.empty() ||
                        !statuses.empty()
                    ? 0
                    : quiet + 1;
        b.tick();
    }
    void write() {
        if (!started) b.fail("a write while a frame is drawn");
        if (wanted.empty()) return b.fail("a write that no list has");
        b.expect("item", item, wanted.front());
        wanted.pop_front();
    }
    void bounce(unsigned button, bool down) {
        for (unsigned n = (unsigned)b.random.below(LOOK); n; n--) {
            set(button, b.random.percent(50));
            clock();
        }
        set(button, down);
    }
    void set(unsigned button, bool down) {
        if (!button || together) dut.next_i = down;
        if (button || together) dut.before_i = down;
    }
    /* What a press is, for the lists. */
    void told(unsigned kind, unsigned button, unsigned n, size_t items) {
        presses_.value(kind < 3 ? 5 + (int)kind : (int)button);
        if (kind >= 3) {
            presses_.value(n == 1 ? 4 : -1);
            presses_.value(!button && n > 1 && !number          ? 2
                           : button && n > 1 && number == n - 1 ? 3
                                                                : -1);
            presses_.value(together && n > 2 ? 8 : -1);
            lists_.value(items == 0 ? 0 : items == 1 ? 1 : items == 255 ? 2 : -1);
            for (uint64_t each : wanted)
                offsets_.word(each >> 32);
        }
        numbers_.value(number == 63            ? 7
                       : number & (number - 1) ? -1
                       : number                ? 1 + __builtin_ctz(number)
                                               : 0);
    }
    /* In the middle of what a press does, with the button held: nothing happens until it is let go
     * and pressed again. */
    void reset(unsigned button) {
        const unsigned wait = (unsigned)b.random.below(4);
        for (unsigned i = 0; i < 40 * LOOK && !during(wait); i++)
            clock();
        resets_.value(during(wait) ? (int)wait : -1);
        resets_.value(4 + (int)button);
        b.reset(1 + b.random.below(3));
        reads.clear();
        statuses.clear();
        wanted.clear();
        aw = w = false;
        for (unsigned i = 0; i < 5 * LOOK; i++)
            clock();
        if (quiet < 4 * LOOK) b.fail("a button that was held through a reset counts");
        b.expect("number_o behind a reset", dut.number_o, 0);
        bounce(button, false);
        for (unsigned i = 0; i < 3 * LOOK; i++)
            clock();
        number = 0;
        b.done();
        b.cycle = 0;
    }
    bool during(unsigned what) const {
        return what == 0   ? header_read
               : what == 1 ? !statuses.empty()
               : what == 2 ? !reads.empty() && !header_read
                           : aw || w;
    }
    void vector() {
        bench::Random &r = b.random;
        const unsigned n = 1 + (unsigned)r.below(r.percent(50) ? 4 : BOARD_MACHINES);
        const unsigned kind = (unsigned)r.below(8), button = (unsigned)r.below(2);
        const bool known = kind > 2;
        together = !button && r.percent(20);
        header = (uint64_t)BOARD_MAGIC << 32 | (kind == 0   ? 0
                                                : kind == 1 ? 65 + r.below(1u << 30)
                                                            : n);
        if (kind == 2) header ^= 1ull << (32 + r.below(32));
        number = !known                      ? 0
                 : !button                   ? number + 1 >= n ? 0 : number + 1
                 : !number || number > n - 1 ? n - 1
                                             : number - 1;
        std::vector<uint64_t> &list = lists[number];
        list.resize(r.percent(5) ? 255 : r.below(12));
        for (uint64_t &each : list)
            each = (r.next() & ~(0xfffull << 32)) | r.below(0xfff) << 32;
        for (size_t i = 1; i < list.size(); i += 2) /* one bit of the offset is another */
            if (const uint64_t other = list[i - 1] >> 32 & 0xfff ^ 1u << r.below(12);
                other != 0xfff)
                list[i] = (list[i] & ~(0xfffull << 32)) | other << 32;
        wanted.clear();
        for (uint64_t each : list)
            if (known) wanted.push_back(each & 0xfffffffffff);
        drawing = (unsigned)r.below(5);
        started = false;
        told(kind, button, n, list.size());
        bounce(button, true);
        if (r.percent(15)) return reset(button);
        for (unsigned i = 0; i < 3 * LOOK; i++)
            clock();
        if (list.size() > 60 && !wanted.empty() &&
            !together) { /* it is followed for longer than a press */
            both_.value(!button);
            set(!button, true);
            for (unsigned i = 0; i < 3 * LOOK; i++)
                clock();
            set(!button, false);
        }
        for (quiet = 0; quiet < 3 * LOOK;)
            clock();
        bounce(button, false);
        for (unsigned i = 0; i < 3 * LOOK; i++)
            clock();
        b.expect("items that were not written", wanted.size(), 0);
        b.expect("number_o", dut.number_o, number);
        b.done();
        b.cycle = 0;
    }
};

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_pick> b("tb_pick", argc, argv, 2000);
    Rig rig(b);
    b.reset();
    for (unsigned i = 0; i < 3 * LOOK; i++)
        rig.clock();
    while (b.more())
        rig.vector();
    if (b.all_vectors && !b.mismatches && !rig.driven.whole()) b.fail("the list of stimulus");
    return b.finish();
}
