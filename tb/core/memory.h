/* memory.h - the memory behind the core: late, and as unwilling as asked
 * SPDX-License-Identifier: Apache-2.0
 *
 * A request for a line is answered by beats of 64, 128 or 256 bits, low bits first, the first of
 * them `latency` clocks later or after the answers before it. With stall = P percent, each request
 * is late by a random time in P of 100 cases, ready and valid are held low in P of 100 clocks, and
 * P of 100 beats are of any client: its first line, if it is due, although others are before it.
 *
 *   request taken in clock c  ->  c + latency: beat 0, 1, 2, 3 of the line (one a clock)
 *
 * With a named part (dram.h) the beats come when its rules allow, each `latency` clocks later, and
 * at most PART_LINES lines are under way; nothing else changes.
 *
 * An answer with an error has the line's data all the same: whoever uses it is found out.
 *
 * In every clock: offer(), then the core settles, then take() with what the handshakes did.
 */
#ifndef TB_MEMORY_H
#define TB_MEMORY_H

#include <array>
#include <cstddef>
#include <deque>
#include <memory>
#include <utility>
#include <vector>

#include "dram.h"
#include "model.h"
#include "options.h"
#include "random.h"

class Memory {
  public:
    Memory(const sph_machine &machine, const Options &o, uint64_t seed);
    /* Bits of a beat, 64 unless this says 128 or 256. */
    void width(size_t bits) { words_ = static_cast<unsigned>(bits / 64); }

    /* What the core sees in this clock. */
    struct Offer {
        bool request_ready, response_valid, error;
        uint32_t tag;
        std::array<uint64_t, Dram::BEATS> data; /* beat */
    };
    const Offer &offer();

    /* What happened in this clock: a request's line and tag are looked at if it was taken. */
    void take(bool request_valid, uint32_t line, uint32_t tag, bool response_ready);

    /* A reset of memory: what was asked for is forgotten. */
    void reset();
    /* From now on lines are those of this machine. */
    void put(const sph_machine &machine) { machine_ = &machine; }
    const sph_machine &machine() const { return *machine_; }
    /* From now on the lines marked by their number answer with an error; empty: none. */
    void spoil(std::vector<bool> lines) { spoilt_ = std::move(lines); }
    /* Of the request-th line from now, from 0, the words of 64 bits of a mask (1: the first) come
     * with an error and with other data, as do those of their beats; a mask of 0: none. */
    void spoil_beats(uint64_t request, unsigned beats) {
        beats_of_ = requests_ + request;
        beats_ = beats;
    }
    /* From now on latency and stall are these. */
    void pace(int latency, int stall) {
        latency_ = latency;
        stall_ = stall;
    }
    /* While silent, no beat comes that was not offered before. */
    void silence(bool silent) { silent_ = silent; }

    uint64_t requests() const { return requests_; }
    /* Of the named part; zeros without one. */
    Dram::Counts part() const { return dram_ ? dram_->counts() : Dram::Counts{0, 0, 0, 0}; }
    size_t waiting() const { return queue_.size(); }
    /* Requests beyond the memory, as register MEM_LINES has it. */
    uint64_t out_of_range() const { return out_of_range_; }
    /* Clocks in which the core did not take a beat that was there. */
    uint64_t refused() const { return refused_; }

  private:
    struct Request {
        uint32_t line, tag;
        Dram::Beats due; /* of each word of 64 bits */
        unsigned errors; /* a bit a word */
        unsigned sent;   /* words */
    };
    static const size_t PART_LINES = 8;
    size_t choose();
    bool spoilt(uint32_t line) const { return line < spoilt_.size() && spoilt_[line]; }

    const sph_machine *machine_;
    std::vector<bool> spoilt_;
    uint64_t beats_of_ = 0;
    unsigned beats_ = 0;
    bool silent_ = false;
    int latency_, stall_;
    int64_t error_at_;
    Random random_;
    unsigned words_ = 1;         /* of a beat */
    std::unique_ptr<Dram> dram_; /* null: any number of lines, a beat a clock */
    std::deque<Request> queue_;
    Offer now_{};
    size_t shown_ = 0; /* the request in the queue whose beat is offered */
    uint64_t clock_ = 0, requests_ = 0, out_of_range_ = 0, refused_ = 0;
};

#endif
