/* memory.cpp - see memory.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "memory.h"

namespace {

const unsigned EVERY_WORD = (1u << Dram::BEATS) - 1;

} // namespace

Memory::Memory(const sph_machine &machine, const Options &o, uint64_t seed)
    : machine_(&machine), latency_(o.latency), stall_(o.stall), error_at_(o.bus_error_at),
      random_(seed) {
    if (const DramPart *part = dram_part(o.memory))
        dram_ = std::make_unique<Dram>(*part, static_cast<unsigned>(o.core_mhz));
}

/* Whose beat comes next: of the oldest request, or of the oldest of any client. */
size_t Memory::choose() {
    if (!random_.percent(stall_)) return 0;
    const uint32_t tag = queue_[random_.below(static_cast<uint32_t>(queue_.size()))].tag;
    size_t i = 0;
    while (queue_[i].tag != tag)
        i++;
    return i;
}

const Memory::Offer &Memory::offer() {
    now_.request_ready = !random_.percent(stall_) && (!dram_ || queue_.size() < PART_LINES);
    /* valid that waits for ready stays, with the same payload */
    if (now_.response_valid || silent_ || queue_.empty()) return now_;
    shown_ = choose();
    const Request &r = queue_[shown_];
    if (r.due[r.sent + words_ - 1] > clock_ || random_.percent(stall_)) return now_;
    now_.response_valid = true;
    now_.tag = r.tag;
    now_.error = (r.errors >> r.sent & ((1u << words_) - 1)) || spoilt(r.line);
    for (unsigned i = 0; i < words_; i++) {
        now_.data[i] = 0x0bad0bad0bad0badull;
        if (r.line < machine_->lines) {
            const uint32_t *word = machine_->mem + static_cast<size_t>(r.line) * SPH_LINE_WORDS +
                                   static_cast<size_t>(2) * (r.sent + i);
            now_.data[i] = word[0] | static_cast<uint64_t>(word[1]) << 32;
        }
        if (r.errors && r.errors != EVERY_WORD && now_.error) now_.data[i] = random_.next();
    }
    return now_;
}

void Memory::take(bool request_valid, uint32_t line, uint32_t tag, bool response_ready) {
    refused_ += now_.response_valid && !response_ready;
    if (now_.response_valid && response_ready) {
        now_.response_valid = false;
        Request &r = queue_[shown_];
        r.sent += words_;
        if (r.sent == Dram::BEATS) queue_.erase(queue_.begin() + static_cast<ptrdiff_t>(shown_));
    }
    if (request_valid && now_.request_ready) {
        bool beyond = line >= machine_->lines ||
                      line >= static_cast<uint32_t>(machine_->regs[SPH_REG_MEM_LINES]);
        out_of_range_ += beyond;
        uint64_t late = static_cast<uint64_t>(latency_);
        if (random_.percent(stall_))
            late += random_.below(static_cast<uint32_t>(2 * latency_ + 16));
        Dram::Beats due;
        due.fill(clock_);
        if (dram_) due = dram_->read_core(line, clock_);
        for (uint64_t &word : due)
            word += late;
        bool error = beyond || static_cast<int64_t>(requests_) == error_at_;
        unsigned errors = error ? EVERY_WORD : requests_ == beats_of_ ? beats_ : 0;
        queue_.push_back({line, tag, due, errors, 0});
        requests_++;
    }
    clock_++;
}

void Memory::reset() {
    queue_.clear();
    now_ = {};
}
