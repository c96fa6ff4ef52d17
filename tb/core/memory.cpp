/* memory.cpp - see memory.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "memory.h"

namespace {

const unsigned EVERY_BEAT = (1u << Dram::BEATS) - 1;

} // namespace

Memory::Memory(const sph_machine &machine, const Options &o, uint64_t seed)
    : machine_(&machine), latency_(o.latency), stall_(o.stall), error_at_(o.bus_error_at),
      random_(seed) {
    if (const DramPart *part = dram_part(o.memory))
        dram_ = std::make_unique<Dram>(*part, static_cast<unsigned>(o.core_mhz));
}

const Memory::Offer &Memory::offer() {
    now_.request_ready = !random_.percent(stall_) && (!dram_ || queue_.size() < PART_LINES);
    /* valid that waits for ready stays, with the same payload */
    if (now_.response_valid) return now_;
    if (silent_ || queue_.empty() || queue_.front().due[beat_] > clock_ || random_.percent(stall_))
        return now_;
    const Request &r = queue_.front();
    now_.response_valid = true;
    now_.error = (r.errors >> beat_ & 1) || spoilt(r.line);
    now_.data = 0x0bad0bad0bad0badull;
    if (r.line < machine_->lines) {
        const uint32_t *words = machine_->mem + static_cast<size_t>(r.line) * SPH_LINE_WORDS;
        now_.data = words[2 * beat_] | static_cast<uint64_t>(words[2 * beat_ + 1]) << 32;
    }
    if (r.errors && r.errors != EVERY_BEAT && now_.error) now_.data = random_.next();
    return now_;
}

void Memory::take(bool request_valid, uint32_t request_line, bool response_ready) {
    refused_ += now_.response_valid && !response_ready;
    if (now_.response_valid && response_ready) {
        now_.response_valid = false;
        beat_ = (beat_ + 1) % Dram::BEATS;
        if (beat_ == 0) queue_.pop_front();
    }
    if (request_valid && now_.request_ready) {
        bool beyond = request_line >= machine_->lines ||
                      request_line >= static_cast<uint32_t>(machine_->regs[SPH_REG_MEM_LINES]);
        out_of_range_ += beyond;
        uint64_t late = static_cast<uint64_t>(latency_);
        if (random_.percent(stall_))
            late += random_.below(static_cast<uint32_t>(2 * latency_ + 16));
        Dram::Beats due;
        due.fill(clock_);
        if (dram_) due = dram_->read_core(request_line, clock_);
        for (uint64_t &beat : due)
            beat += late;
        bool error = beyond || static_cast<int64_t>(requests_) == error_at_;
        unsigned errors = error ? EVERY_BEAT : requests_ == beats_of_ ? beats_ : 0;
        queue_.push_back({request_line, due, errors});
        requests_++;
    }
    clock_++;
}

void Memory::reset() {
    queue_.clear();
    now_ = {false, false, false, 0};
    beat_ = 0;
}
