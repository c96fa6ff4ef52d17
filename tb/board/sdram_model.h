/* sdram_model.h - an SDRAM of 4 x 8192 x 512 x 16 bits that checks the times of its datasheet
 * SPDX-License-Identifier: Apache-2.0
 *
 *     Sdram part(16.0);                    // ns a clock
 *     each rising edge of its clock: part.edge(pins); dq_i = part.out();
 *     if (!part.error().empty()) ...       // the first rule that was broken
 *
 * Words that nobody drives read as noise. Of refreshes, 8192 come in any 64 ms, and at most nine
 * are owed at the rate of one each 7.8 us, whatever came before in plenty.
 */
#ifndef TB_SDRAM_MODEL_H
#define TB_SDRAM_MODEL_H

#include <algorithm>
#include <cstdint>
#include <deque>
#include <string>
#include <unordered_map>

#include "../sdram_times.h"

struct SdramPins {
    bool cke;
    unsigned command, bank, address, mask; /* command: cs_n, ras_n, cas_n, we_n */
    bool drive;                            /* the controller drives dq */
    uint16_t dq;
};

class Sdram : SdramTimes {
  public:
    explicit Sdram(double ns) : ns_(ns) {}
    const std::string &error() const { return what_; }
    uint16_t out() const { return out_; }
    uint64_t commands(unsigned which) const { return count_[which & 7]; }
    uint64_t clocks() const { return (uint64_t)clock_; }
    uint64_t first() const { return (uint64_t)first_; }
    /* Clocks of the fewest that a rule was kept by: a bench sees whether its controller waits for
     * longer than it has to. */
    struct Shortest {
        int64_t ras = 1000, rp = 1000, rcd = 1000, rfc = 1000, wr = 1000;
    };
    const Shortest &shortest() const { return shortest_; }
    /* The controller was reset: it begins as at power-up, and its pause may be that long. */
    void restart() {
        precharged_ = ready_ = false;
        refreshes_ = 0;
        autos_.clear();
        write_.first = -1000;
        for (Bank &each : banks_)
            each.open = false;
    }
    /* The word of 64 bits at a column of a row. */
    uint64_t word(unsigned bank, unsigned row, unsigned column) const {
        uint64_t value = 0;
        for (unsigned i = 0; i < 4; i++) {
            const auto found = words_.find((bank << 22 | row << 9 | column) + i);
            value |= (uint64_t)(found == words_.end() ? 0 : found->second) << 16 * i;
        }
        return value;
    }

    void edge(const SdramPins &p) {
        clock_++;
        if (p.cke) step(p), data(p); /* else it stands still */
        if (ready_) refreshes();
    }

  private:
    enum { MODE, AUTO, PRECHARGE, ACTIVATE, WRITE, READ, STOP, NOP };
    struct Bank {
        bool open = false;
        unsigned row = 0;
        int64_t activated = -1000, precharged = -1000, written = -1000, read = -1000;
    } banks_[4];
    double ns_;
    int64_t clock_ = 0, refreshed_ = -1000, activated_ = -1000, mode_at_ = -1000;
    int64_t first_ = 0; /* clock of the first command */
    Shortest shortest_;
    int refreshes_ = 0;
    std::deque<int64_t> autos_; /* clocks of the last refreshes, ROWS of them */
    double paid_ = 0;           /* ns until which refreshes are not owed */
    bool precharged_ = false, ready_ = false;
    uint64_t count_[8] = {};
    uint16_t out_ = 0;
    std::string what_;
    std::unordered_map<uint32_t, uint16_t> words_;
    struct Burst {
        int64_t first = -1000; /* clock of its first word */
        uint32_t at = 0;       /* bank, row, column */
    } reads_[2], write_;       /* a read may begin while another ends */

    double since(int64_t then) const { return (double)(clock_ - then) * ns_; }
    void fail(const std::string &text) {
        if (what_.empty()) what_ = text + ", clock " + std::to_string(clock_);
    }
    void least(double is, double wanted, const char *name) {
        if (is < wanted)
            fail(std::string(name) + ": " + std::to_string((int)is) + " ns, not " +
                 std::to_string((int)wanted));
    }
    void refreshes() {
        const double now = (double)clock_ * ns_;
        if (now - paid_ > 9 * T_REFI) fail("more than 9 refreshes are owed");
        const int64_t then = (int)autos_.size() == ROWS ? autos_.front() : mode_at_;
        if (since(then) > T_REF) fail("8192 refreshes last for longer than 64 ms");
    }
    /* Clocks since then, and the least that there were. */
    void seen(int64_t &least, int64_t then) const { least = std::min(least, clock_ - then); }
    void step(const SdramPins &p) {
        if (p.command & 8 || p.command == NOP) return;
        Bank &b = banks_[p.bank];
        count_[p.command]++;
        if (!first_) first_ = clock_;
        if (clock_ * ns_ < T_POWER) fail("a command before power is stable");
        if (clock_ - mode_at_ < 2) fail("tMRD");
        least(since(refreshed_), T_RFC, "tRFC");
        seen(shortest_.rfc, refreshed_);
        switch (p.command) {
        case MODE:
            if (!precharged_ || refreshes_ < 2) fail("mode before precharge and two refreshes");
            if (p.bank || (p.address & 0x7f) != 0x22) fail("another mode than CL 2, 4 words");
            for (const Bank &each : banks_)
                if (each.open) fail("mode while a bank is open");
            mode_at_ = clock_;
            paid_ = (double)clock_ * ns_;
            ready_ = true;
            break;
        case AUTO:
            for (const Bank &each : banks_) {
                if (each.open) fail("refresh while a bank is open");
                least(since(each.precharged), T_RP, "tRP");
                least(since(each.activated), T_RC, "tRC");
                seen(shortest_.rp, each.precharged);
            }
            refreshed_ = clock_;
            paid_ = std::min(paid_, (double)clock_ * ns_ + 8 * T_REFI) + T_REFI;
            autos_.push_back(clock_);
            if ((int)autos_.size() > ROWS) autos_.pop_front();
            refreshes_++;
            break;
        case PRECHARGE:
            for (unsigned i = 0; i < 4; i++)
                if (p.address >> 10 & 1 || i == p.bank) precharge(banks_[i]);
            precharged_ = true;
            break;
        case ACTIVATE:
            if (!ready_) fail("used before its mode is set");
            if (b.open) fail("a bank is opened twice");
            least(since(b.precharged), T_RP, "tRP");
            seen(shortest_.rp, b.precharged);
            least(since(b.activated), T_RC, "tRC");
            least(since(activated_), T_RRD, "tRRD");
            b.open = true;
            b.row = p.address;
            b.activated = activated_ = clock_;
            break;
        case READ:
        case WRITE:
            if (!b.open) fail("a column of a closed bank");
            if (p.address >> 10 & 1) fail("auto precharge, which nothing here asks for");
            least(since(b.activated), T_RCD, "tRCD");
            seen(shortest_.rcd, b.activated);
            if (p.address & 3) fail("a burst that wraps");
            burst(p, b);
            break;
        default:
            fail("burst stop");
        }
    }
    void precharge(Bank &b) {
        if (!b.open) return;
        least(since(b.activated), T_RAS, "tRAS");
        least(since(b.written), T_WR, "tWR");
        if (since(b.activated) > T_RAS_MOST) fail("a row is open for too long");
        if (clock_ - b.read < 4) fail("a read is cut off");
        b.open = false;
        b.precharged = clock_;
        seen(shortest_.ras, b.activated);
        seen(shortest_.wr, b.written);
    }
    void burst(const SdramPins &p, Bank &b) {
        const uint32_t at = p.bank << 22 | b.row << 9 | (p.address & 0x1ff);
        if (clock_ - write_.first < 4) fail("a write is cut off");
        if (p.command == READ) {
            if (clock_ + 2 - reads_[0].first < 4) fail("a read is cut off");
            reads_[1] = reads_[0];
            reads_[0] = {clock_ + 2, at};
            b.read = clock_;
        } else {
            if (clock_ <= reads_[0].first + 4) fail("a write before the pins are free of a read");
            write_ = {clock_, at};
            b.written = clock_ + 3; /* its last word */
        }
    }
    void data(const SdramPins &p) {
        const int64_t w = clock_ - write_.first;
        if (w >= 0 && w < 4) {
            if (!p.drive) fail("a word to be written is not there");
            uint16_t &word = words_[write_.at + (uint32_t)w];
            if (!(p.mask & 1)) word = (uint16_t)((word & 0xff00) | (p.dq & 0xff));
            if (!(p.mask & 2)) word = (uint16_t)((word & 0xff) | (p.dq & 0xff00));
        } else if (p.drive) {
            fail("dq is driven outside of a write");
        }
        out_ = (uint16_t)(clock_ * 0x9e37);
        for (const Burst &r : reads_) {
            const int64_t n = clock_ + 1 - r.first; /* the controller takes it at the next edge */
            if (n < 0 || n >= 4) continue;
            if (p.drive) fail("two drive dq");
            if (p.mask) fail("a mask of words that are read");
            out_ = words_[r.at + (uint32_t)n];
        }
    }
};

#endif
