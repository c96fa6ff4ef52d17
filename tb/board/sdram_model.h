/* sdram_model.h - an SDRAM of 4 x 8192 x 512 x 16 bits that checks the times of its datasheet
 * SPDX-License-Identifier: Apache-2.0
 *
 *     Sdram part(16.0);                    // ns a clock
 *     each rising edge of its clock: part.edge(pins); dq_i = part.out();
 *     if (!part.error().empty()) ...       // the first rule that was broken
 *
 * Words that nobody drives read as noise.
 */
#ifndef TB_SDRAM_MODEL_H
#define TB_SDRAM_MODEL_H

#include <cstdint>
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
    uint64_t shortest() const { return (uint64_t)shortest_; } /* clocks that a row was open */
    /* The controller was reset: it begins as at power-up, and its pause may be that long. */
    void restart() {
        precharged_ = ready_ = false;
        refreshes_ = 0;
        write_.first = -1000;
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
        if (p.cke) step(p);
        data(p);
        /* a word is refreshed in time, if 8192 refreshes come in any 64 ms */
        if (ready_ && since(refreshed_) > 9 * T_REFI) fail("more than 9 refreshes are owed");
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
    int64_t shortest_ = 1000;
    int refreshes_ = 0;
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
    void step(const SdramPins &p) {
        if (p.command & 8 || p.command == NOP) return;
        Bank &b = banks_[p.bank];
        count_[p.command]++;
        if (!first_) first_ = clock_;
        if (clock_ * ns_ < T_POWER) fail("a command before power is stable");
        if (clock_ - mode_at_ < 2) fail("tMRD");
        if (p.command != NOP) least(since(refreshed_), T_RFC, "tRFC");
        switch (p.command) {
        case MODE:
            if (!precharged_ || refreshes_ < 2) fail("mode before precharge and two refreshes");
            if (p.bank || (p.address & 0x7f) != 0x22) fail("another mode than CL 2, 4 words");
            for (const Bank &each : banks_)
                if (each.open) fail("mode while a bank is open");
            mode_at_ = clock_;
            ready_ = true;
            break;
        case AUTO:
            for (const Bank &each : banks_) {
                if (each.open) fail("refresh while a bank is open");
                least(since(each.precharged), T_RP, "tRP");
            }
            refreshed_ = clock_;
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
        if (clock_ - b.read < 4) fail("a read is cut off");
        b.open = false;
        b.precharged = clock_;
        if (clock_ - b.activated < shortest_) shortest_ = clock_ - b.activated;
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
