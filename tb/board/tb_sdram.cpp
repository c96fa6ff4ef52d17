/* tb_sdram.cpp - rt_sdram with a part that checks its times: what was written is read
 * SPDX-License-Identifier: Apache-2.0
 *
 * From one word to the next often one bit of the address changes, so that rows differ in each
 * single bit; reads and writes come in runs, with pauses, some longer than the time between two
 * refreshes. Bytes are masked. Where a refresh becomes due, a word is written to one bank and one
 * asked for of another, closed one, in each distance. Now and then all is reset in the middle. In
 * the end nothing happens for longer than 64 ms, and each word lies in the bank, row and column
 * that the module's head says.
 */
#include <deque>
#include "Vrt_sdram.h"
#include "bench.h"
#include "board/sdram_model.h"
#include "stimulus.h"

namespace {

constexpr double NS = 16;
constexpr int64_t RCD = 2, RP = 2, RAS = 3, RFC = 5, WR = 2, REFRESH = 480; /* of the module */
enum { AUTO = 1, PRECHARGE, ACTIVATE, WRITE, READ };                        /* commands */

struct Expected {
    uint64_t data;
    uint32_t at;
};

struct Order {
    bool write;
    uint32_t at;
};

class Rig {
  public:
    explicit Rig(bench::Bench<Vrt_sdram> &bench) : b(bench), dut(bench.dut) {}
    bench::Stimulus driven;
    Sdram part{NS};

    void run() {
        dut.cmd_valid_i = 0;
        b.reset();
        for (reset_at_ = next_reset(); b.more();) {
            if (reset_at_ && b.vectors >= reset_at_ && state(reset_in_)) reset();
            clock(true);
            b.cycle = 0;
        }
        dut.cmd_valid_i = 0;
        for (int64_t n = (int64_t)(SdramTimes::T_REF / NS) + REFRESH;
             b.all_vectors && !b.failed() && n; n--)
            clock(false);
        for (int n = 20; n; n--)
            clock(false);
        if (!owed_.empty()) b.fail("reads were not answered");
        for (const auto &[at, data] : memory_)
            if (part.word(at >> 7 & 3, at >> 9, (at & 127) * 4) != data) {
                b.fail("a word lies in another place");
                break;
            }
    }

  private:
    bench::Bench<Vrt_sdram> &b;
    Vrt_sdram &dut;
    std::unordered_map<uint32_t, uint64_t> memory_;
    std::vector<uint32_t> known_; /* addresses of it */
    std::deque<Expected> owed_;
    std::deque<Order> next_;      /* on purpose */
    std::deque<uint32_t> recent_; /* addresses of the last writes */
    unsigned run_ = 0, pause_ = 0;
    bool writes_ = true;
    uint32_t at_ = 3 << 7; /* the first one waits at power-up, with a bank other than the mode's */
    int64_t clock_ = 0, began_ = 0; /* now, and the last reset */
    int64_t reset_at_ = 0;
    int reset_in_ = 0; /* the next reset: from this vector on, in this state */
    /* clocks in which commands came to the pins */
    int64_t auto_ = 0, write_ = -100, activate_ = -100, pair_ = 0, moves_ = 0;
    unsigned open_ = 0; /* banks, their rows, and the bank of the last word */
    uint32_t row_[4] = {};
    unsigned moved_bank_ = 0;
    bool moved_write_ = false;
    bool met_ = false; /* the interval since the last refresh has its meeting */

    bench::Points &address_ = driven.alone("address", 22);
    bench::Points &strobe_ = driven.alone("bytes of a write", 8);
    bench::Points &order_ = driven.values(
        "an open row",
        {"read behind a read", "write behind a read", "read behind a write", "write behind a write",
         "another row behind a read", "another row behind a write", "of another bank"});
    bench::Points &meets_ = driven.values(
        "behind a WRITE and an ACTIVATE of another bank, each in its clock, a refresh is due",
        {"1 clock later", "2 clocks later", "3 clocks later", "4 clocks later"});
    bench::Points &resets_ = driven.values("reset", {"while a read is owed", "while words go out",
                                                     "while all banks are open", "while none is",
                                                     "at power-up", "in a refresh"});

    int64_t next_reset() { return b.all_vectors ? b.vectors + b.random.between(1, 1500) : 0; }
    bool known(uint32_t at) const { return memory_.count(at) != 0; }
    uint32_t place() {
        bench::Random &r = b.random;
        if (r.percent(40)) return at_ ^ 1u << r.below(22);
        if (r.percent(80) && !known_.empty()) return known_[r.below(known_.size())];
        return (uint32_t)r.below(1 << 22);
    }
    /* A write to an open row of one bank, or none, and a word of a closed bank behind it. */
    void meet() {
        const unsigned bank = (unsigned)b.random.below(4);
        if (open_ == 15 || met_ || !(open_ >> bank & 1)) return;
        met_ = true;
        unsigned other = bank;
        while (open_ >> other & 1)
            other = (unsigned)b.random.below(4);
        if (b.random.percent(70))
            next_.push_back({true, row_[bank] << 9 | bank << 7 | (uint32_t)b.random.below(128)});
        next_.push_back({true, (uint32_t)b.random.below(1 << 13) << 9 | other << 7});
    }

    void offer() {
        bench::Random &r = b.random;
        pause_ -= pause_ > 0;
        /* due_q of the module is 0 so many clocks behind the AUTO of the pins */
        const int64_t left = auto_ + REFRESH - 1 - clock_;
        if (left >= 0 && left < 8 && next_.empty() && !dut.cmd_valid_i && r.percent(30)) meet();
        if (dut.cmd_valid_i) return;
        Order order;
        if (!next_.empty()) {
            order = next_.front();
            next_.pop_front();
        } else {
            if (pause_ || (left >= -1 && left < 20)) return;
            if (!run_) {
                run_ = 1 + (unsigned)r.below(12);
                writes_ = r.percent(50);
                pause_ = (unsigned)r.below(r.percent(3) ? 1500 : 4);
            }
            run_--;
            order = {writes_, memory_.empty() ? at_ : place()};
            if (!order.write && !known(order.at)) order.write = r.percent(20);
            if (!order.write && !known(order.at)) return;
        }
        address_.word(at_ = order.at);
        dut.cmd_valid_i = 1;
        dut.cmd_write_i = order.write;
        dut.cmd_addr_i = order.at;
        dut.cmd_data_i = r.next();
        dut.cmd_strb_i = !order.write || !known(order.at) ? 255
                         : r.percent(50) ? (uint8_t)(dut.cmd_strb_i ^ 1u << r.below(8))
                                         : (uint8_t)r.next();
        if (order.write) strobe_.word(dut.cmd_strb_i);
    }
    void write(uint32_t at, uint64_t data, unsigned strobe) {
        if (!known(at)) known_.push_back(at);
        for (int i = 0; i < 8; i++) {
            const uint64_t byte = strobe >> i & 1 ? 0xffull << 8 * i : 0;
            memory_[at] = (memory_[at] & ~byte) | (data & byte);
        }
    }
    /* What the command at the pins does, for the lists alone. */
    void watch(const SdramPins &p) {
        if (!p.cke || p.command > READ || !p.command) return;
        const bool lasts = moves_ && clock_ - moves_ < 12;
        const unsigned bank = 1u << p.bank;
        switch (p.command) {
        case AUTO:
            if (pair_ > auto_) meets_.value(auto_ + REFRESH - pair_ - 1);
            auto_ = clock_;
            met_ = false;
            break;
        case PRECHARGE:
            if (lasts && !(p.address >> 10 & 1)) order_.value(moved_write_ ? 5 : 4);
            open_ &= p.address >> 10 & 1 ? 0 : ~bank;
            break;
        case ACTIVATE:
            activate_ = clock_;
            if (clock_ - write_ == 1) pair_ = clock_;
            open_ |= bank;
            row_[p.bank] = p.address;
            break;
        default:
            if (lasts && activate_ < moves_) {
                order_.value(2 * moved_write_ + (p.command == WRITE));
                if (p.bank != moved_bank_) order_.value(6);
            }
            moves_ = clock_;
            moved_write_ = p.command == WRITE;
            moved_bank_ = p.bank;
            if (moved_write_) write_ = clock_;
        }
    }

    /* Whether it is so that a reset waits for. */
    bool state(int which) const {
        switch (which) {
        case 0:
            return !owed_.empty();
        case 1:
            return clock_ - write_ < 4;
        case 2:
            return open_ == 15;
        case 3:
            return !open_;
        case 4:
            return auto_ < began_;
        default:
            return clock_ - auto_ < RFC;
        }
    }
    void reset() {
        resets_.value(reset_in_);
        /* words that may be on their way out */
        dut.cmd_valid_i = 0;
        for (uint32_t at : recent_)
            memory_.erase(at);
        for (size_t i = 0; i < known_.size();)
            if (known(known_[i]))
                i++;
            else
                known_[i] = known_.back(), known_.pop_back();
        owed_.clear();
        next_.clear();
        run_ = pause_ = open_ = 0;
        b.reset(1 + b.random.below(3));
        part.restart();
        began_ = clock_;
        if (dut.cke_o || dut.dq_oe_o || dut.rsp_valid_o) b.fail("pins or an answer behind a reset");
        reset_in_ = (reset_in_ + 1) % 6;
        reset_at_ = next_reset();
        if (reset_in_ == 4) { /* at power-up */
            for (uint64_t n = b.random.below(POWER); n; n--)
                clock(false);
            reset_at_ = b.vectors;
        }
    }

    void clock(bool more) {
        if (more) offer();
        dut.eval();
        const bool taken = dut.cmd_valid_i && dut.cmd_ready_o;
        const SdramPins pins = {dut.cke_o != 0, dut.command_o,    dut.ba_o, dut.a_o,
                                dut.dqm_o,      dut.dq_oe_o != 0, dut.dq_o};
        if (taken && dut.cmd_write_i) {
            write(dut.cmd_addr_i, dut.cmd_data_i, dut.cmd_strb_i);
            recent_.push_back(dut.cmd_addr_i);
            if (recent_.size() > 2) recent_.pop_front();
        }
        if (taken && !dut.cmd_write_i) owed_.push_back({memory_[dut.cmd_addr_i], dut.cmd_addr_i});
        if (taken) b.done();
        b.tick(); /* dq_i is what the part gave after the edge before */
        clock_++;
        watch(pins);
        part.edge(pins);
        dut.dq_i = part.out();
        if (taken) dut.cmd_valid_i = 0;
        if (!part.error().empty()) return b.fail(part.error().c_str());
        if (!dut.rsp_valid_o) return;
        if (owed_.empty()) return b.fail("an answer to nothing");
        b.expect("rsp_data_o", dut.rsp_data_o, owed_.front().data);
        if (b.bad()) b.show("address", (bench::i128)owed_.front().at, 22);
        owed_.pop_front();
        if (owed_.size() > 3) b.fail("reads were not answered");
    }
};

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_sdram> b("tb_sdram", argc, argv, 30000);
    Rig rig(b);
    rig.run();
    const Sdram::Shortest &s = rig.part.shortest();
    printf("# shortest: RAS %d, RP %d, RCD %d, RFC %d, WR %d clocks\n", (int)s.ras, (int)s.rp,
           (int)s.rcd, (int)s.rfc, (int)s.wr);
    if (b.all_vectors && (s.ras != RAS || s.rp != RP || s.rcd != RCD || s.rfc != RFC || s.wr != WR))
        b.fail("something waits for longer than its parameter says, or for less");
    if (rig.part.first() < POWER || rig.part.first() > POWER + 8)
        b.fail("power-up of another length");
    if (b.all_vectors && !b.mismatches && !rig.driven.whole()) b.fail("the list of stimulus");
    printf("# %llu activations, %llu reads, %llu writes, %llu refreshes\n",
           (unsigned long long)rig.part.commands(ACTIVATE),
           (unsigned long long)rig.part.commands(READ),
           (unsigned long long)rig.part.commands(WRITE),
           (unsigned long long)rig.part.commands(AUTO));
    return b.finish();
}
