/* dram.cpp - see dram.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "dram.h"

#include <algorithm>
#include <cmath>

#include "../sdram_times.h"

namespace {

/* Clocks of `ps` picoseconds that last `ns` nanoseconds or more, at least `least`. */
unsigned clocks(double ns, uint64_t ps, unsigned least = 0) {
    auto whole = static_cast<uint64_t>(std::llround(ns * 1000));
    return std::max(least, static_cast<unsigned>((whole + ps - 1) / ps));
}

/* At its full speed, CL 3. A burst ends before its bank is precharged. */
DramPart sdram16() {
    const uint64_t ps = 7500;
    const unsigned burst = 8, rrd = clocks(SdramTimes::T_RRD, ps);
    return {"sdram16",
            "MT48LC16M16A2-75, 133 MHz",
            ps,
            4,
            8192,
            1024,
            3,
            burst,
            clocks(SdramTimes::T_RCD, ps),
            clocks(SdramTimes::T_RP, ps),
            clocks(SdramTimes::T_RAS, ps),
            clocks(SdramTimes::T_RC, ps),
            rrd,
            4 * rrd, /* it has no rule for five */
            burst,
            clocks(SdramTimes::T_RFC, ps),
            static_cast<unsigned>(SdramTimes::T_REFI * 1000 / static_cast<double>(ps))};
}

/* Grade 125 at the 400 MHz that FPGAs of this size drive, CL 6. Micron's datasheet, x16: pages of
 * 2 KB; the least of rrd and rtp are four clocks. */
DramPart ddr3x16() {
    const uint64_t ps = 2500;
    return {"ddr3x16",
            "MT41K128M16-125, 400 MHz",
            ps,
            8,
            16384,
            2048,
            6,
            4,
            clocks(13.75, ps),
            clocks(13.75, ps),
            clocks(35, ps),
            clocks(48.75, ps),
            clocks(7.5, ps, 4),
            clocks(40, ps),
            clocks(7.5, ps, 4),
            clocks(160, ps),
            static_cast<unsigned>(7800 * 1000 / ps)};
}

} // namespace

const std::vector<DramPart> &dram_parts() {
    static const std::vector<DramPart> parts = {sdram16(), ddr3x16()};
    return parts;
}

const DramPart *dram_part(const std::string &name) {
    for (const DramPart &part : dram_parts())
        if (name == part.name) return &part;
    return nullptr;
}

uint64_t Dram::command(DramCommand::Kind kind, uint64_t earliest, unsigned bank, unsigned row) {
    while (!taken_.insert(earliest).second)
        earliest++;
    if (watch) watch({kind, earliest, bank, row});
    return earliest;
}

void Dram::close(Bank &bank, uint64_t clock) {
    bank.open = false;
    bank.activate = std::max(bank.activate, clock + part_.rp);
}

void Dram::refresh() {
    uint64_t at = next_refresh_;
    bool any = false;
    for (const Bank &bank : banks_)
        if (bank.open) {
            any = true;
            at = std::max(at, bank.precharge);
        }
    if (any) {
        at = command(DramCommand::PRECHARGE_ALL, at, 0, 0);
        for (Bank &bank : banks_)
            if (bank.open) close(bank, at);
    }
    for (const Bank &bank : banks_)
        at = std::max(at, bank.activate);
    at = command(DramCommand::REFRESH, at, 0, 0);
    for (Bank &bank : banks_)
        bank.activate = at + part_.rfc;
    next_refresh_ += part_.refi;
    counts_.refreshes++;
}

void Dram::open(unsigned number, unsigned row, uint64_t clock) {
    Bank &bank = banks_[number];
    if (bank.open) {
        close(bank, command(DramCommand::PRECHARGE, std::max(clock, bank.precharge), number, 0));
        counts_.row_conflicts++;
    } else {
        counts_.row_opens++;
    }
    uint64_t at = command(DramCommand::ACTIVATE,
                          std::max({clock, bank.activate, next_open_, opened_[0]}), number, row);
    bank.open = true;
    bank.row = row;
    bank.activate = at + part_.rc;
    bank.read = at + part_.rcd;
    bank.precharge = at + part_.ras;
    next_open_ = at + part_.rrd;
    std::rotate(opened_.begin(), opened_.begin() + 1, opened_.end());
    opened_[3] = at + part_.faw;
}

Dram::Beats Dram::read(uint32_t line, uint64_t clock) {
    taken_.erase(taken_.begin(), taken_.lower_bound(clock));
    while (next_refresh_ <= clock)
        refresh();
    const uint64_t page = static_cast<uint64_t>(line) * LINE_BYTES / part_.row_bytes;
    const auto number = static_cast<unsigned>(page % part_.banks);
    const auto row = static_cast<unsigned>(page / part_.banks % part_.rows);
    Bank &bank = banks_[number];
    if (bank.open && bank.row == row)
        counts_.row_hits++;
    else
        open(number, row, clock);
    Beats there{};
    for (unsigned burst = 0; burst < 2; burst++) {
        uint64_t at =
            command(DramCommand::READ, std::max({clock, bank.read, next_read_}), number, row);
        next_read_ = at + part_.burst;
        bank.precharge = std::max(bank.precharge, at + part_.rtp);
        for (unsigned half = 0; half < 2; half++)
            there[2 * burst + half] = at + part_.cl + part_.burst / 2 * (half + 1);
    }
    return there;
}

Dram::Beats Dram::read_core(uint32_t line, uint64_t clock) {
    const uint64_t second = 1000000; /* MHz of the core times picoseconds */
    const uint64_t step = part_.ps * mhz_;
    Beats there = read(line, (clock * second + step - 1) / step);
    for (uint64_t &at : there)
        at = (at * step + second - 1) / second;
    return there;
}
