/* dram_check.cpp - tb/core/dram.h against sequences worked by hand, and against the rules of parts
 * SPDX-License-Identifier: Apache-2.0
 *
 * Prints TAP lines; test_dram.sh compiles and runs it. The table has what a reader of the datasheet
 * gets with pencil and paper; rules() looks at commands of random lines pair by pair and shares
 * nothing with the model. Of each rule a part with one clock more must be told from the one that
 * the model was given.
 */
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

#include "core/dram.h"
extern "C" {
#include "tests/number.h"
}

namespace {

int checks = 0, failed = 0;

void check(bool good, const std::string &name, const std::string &why = "") {
    std::printf("%sok %d - %s\n", good ? "" : "not ", ++checks, name.c_str());
    if (!good && !why.empty()) std::printf("# %s\n", why.c_str());
    failed += !good;
}

/* A line asked for in a clock of the part, and when its first and last beat are there. */
struct Row {
    const char *what;
    uint32_t line;
    uint64_t clock, first, last;
};

void table(const char *name, const std::vector<Row> &rows) {
    Dram dram(*dram_part(name), 84);
    for (const Row &row : rows) {
        const Dram::Beats there = dram.read(row.line, row.clock);
        check(there[0] == row.first && there[3] == row.last, std::string(name) + ": " + row.what,
              "beats from " + std::to_string(there[0]) + " to " + std::to_string(there[3]));
    }
}

std::string at(const DramCommand &c) {
    static const char *const names[] = {"ACT", "RD", "PRE", "PREA", "REF"};
    return std::string(" at ") + names[c.kind] + " of clock " + std::to_string(c.clock);
}

bool closes(const DramCommand &c, unsigned bank) {
    return c.kind == DramCommand::PRECHARGE_ALL ||
           (c.kind == DramCommand::PRECHARGE && c.bank == bank);
}

/* The first rule of part p that commands break, in order of clocks; empty: none. */
std::string rules(const DramPart &p, const std::vector<DramCommand> &all) {
    for (size_t i = 0; i < all.size(); i++) {
        const DramCommand &c = all[i];
        const bool act = c.kind == DramCommand::ACTIVATE, rd = c.kind == DramCommand::READ;
        const bool pre = c.kind == DramCommand::PRECHARGE || c.kind == DramCommand::PRECHARGE_ALL;
        const bool ref = c.kind == DramCommand::REFRESH;
        bool seen = false; /* a command that opened or closed c's bank */
        unsigned acts = 0;
        for (size_t j = i; j-- > 0 && i - j < 200;) {
            const DramCommand &b = all[j];
            const uint64_t d = c.clock - b.clock;
            const bool same = b.bank == c.bank, b_act = b.kind == DramCommand::ACTIVATE;
            const bool shut = closes(b, c.bank) || b.kind == DramCommand::REFRESH;
            if (d == 0) return "two commands" + at(c);
            if (act && b_act && same && d < p.rc) return "rc" + at(c);
            if (act && b_act && d < p.rrd) return "rrd" + at(c);
            if (act && b_act && ++acts == 4 && d < p.faw) return "faw" + at(c);
            if (act && closes(b, c.bank) && d < p.rp) return "rp" + at(c);
            if (ref && (b.kind == DramCommand::PRECHARGE || b.kind == DramCommand::PRECHARGE_ALL) &&
                d < p.rp)
                return "rp" + at(c);
            if ((act || ref) && b.kind == DramCommand::REFRESH && d < p.rfc) return "rfc" + at(c);
            if (rd && b.kind == DramCommand::READ && d < p.burst) return "burst" + at(c);
            if (rd && b_act && same && d < p.rcd) return "rcd" + at(c);
            const bool cut = c.kind == DramCommand::PRECHARGE_ALL || same;
            if (pre && b_act && cut && d < p.ras) return "ras" + at(c);
            if (pre && b.kind == DramCommand::READ && cut && d < p.rtp) return "rtp" + at(c);
            if (seen || !((b_act && same) || shut)) continue;
            seen = true;
            if (act && b_act) return "a bank is opened twice" + at(c);
            if (rd && shut) return "a column of a closed bank" + at(c);
            if (rd && b_act && b.row != c.row) return "a column of another row" + at(c);
        }
        if (!ref) continue;
        std::vector<bool> open(p.banks);
        for (size_t j = 0; j < i; j++)
            for (unsigned bank = 0; bank < p.banks; bank++) {
                if (all[j].kind == DramCommand::ACTIVATE && all[j].bank == bank) open[bank] = true;
                if (closes(all[j], bank)) open[bank] = false;
            }
        if (std::count(open.begin(), open.end(), true)) return "refresh of open banks" + at(c);
    }
    return "";
}

/* Commands of random lines: rows in use again and again, rests, and hurry. */
std::vector<DramCommand> commands(const DramPart &part, unsigned seed, std::string &why) {
    std::mt19937 random(seed);
    std::vector<DramCommand> all;
    Dram dram(part, 84);
    dram.watch = [&](const DramCommand &c) { all.push_back(c); };
    uint64_t clock = 0, last = 0;
    uint32_t line = 0;
    uint64_t lines = 0;
    for (int i = 0; i < 1500; i++) {
        clock += random() % 4 ? random() % 12 : random() % (random() % 40 ? 100 : 3 * part.refi);
        line = random() % 3 ? line + static_cast<uint32_t>(random() % 3)
                            : static_cast<uint32_t>(random() % 100000);
        const Dram::Beats there = dram.read(line, clock);
        lines++;
        const size_t from = all.size();
        std::vector<DramCommand> reads;
        for (size_t j = from; j-- > 0 && reads.size() < 2;)
            if (all[j].kind == DramCommand::READ) reads.push_back(all[j]);
        const uint64_t page = static_cast<uint64_t>(line) * 32 / part.row_bytes;
        if (reads[0].bank != page % part.banks || reads[0].row != page / part.banks % part.rows)
            why = "a line of another row";
        if (there[3] != reads[0].clock + part.cl + part.burst ||
            there[0] != reads[1].clock + part.cl + part.burst / 2)
            why = "a beat at another time than its words";
        if (there[0] <= last || reads[1].clock < clock) why = "a beat before its time";
        last = there[3];
        clock = std::max(clock, last > 400 ? last - 400 : 0); /* few are under way */
    }
    const auto &n = dram.counts();
    if (n.row_hits + n.row_opens + n.row_conflicts != lines || !n.row_hits || !n.row_opens ||
        !n.row_conflicts)
        why = "rows are counted wrong";
    if (n.refreshes != clock / part.refi && n.refreshes + 1 != clock / part.refi)
        why = "refreshes are counted wrong";
    std::sort(all.begin(), all.end(),
              [](const DramCommand &a, const DramCommand &b) { return a.clock < b.clock; });
    return all;
}

struct Rule {
    const char *name;
    unsigned DramPart::*clocks;
};
const Rule each[] = {{"burst", &DramPart::burst}, {"rcd", &DramPart::rcd}, {"rp", &DramPart::rp},
                     {"ras", &DramPart::ras},     {"rc", &DramPart::rc},   {"rrd", &DramPart::rrd},
                     {"faw", &DramPart::faw},     {"rtp", &DramPart::rtp}, {"rfc", &DramPart::rfc}};

/* A part that nobody sells, in which each rule is the latest one now and then. */
const DramPart strict = {"strict", "", 1000, 8, 1024, 1024, 4, 4, 3, 2, 20, 30, 5, 33, 9, 40, 900};

void keeps(const DramPart &part, unsigned seed) {
    std::string why;
    const auto all = commands(part, seed, why);
    if (why.empty()) why = rules(part, all);
    check(why.empty(), std::string(part.name) + " keeps its rules, seed " + std::to_string(seed),
          why);
}

} // namespace

int main(int argc, char **argv) {
    const unsigned seed =
        static_cast<unsigned>(test_number(argc > 1 ? argv[1] : nullptr, "seed", 1));
    /* 32 lines a row, 4 banks: line 32 is bank 1, line 128 bank 0 again */
    table("sdram16",
          {{"ACT 10, RD 13 and 21", 0, 10, 20, 32},
           {"row open, behind it: RD 29, 37", 1, 10, 36, 48},
           {"another bank: ACT 12, RD 45, 53, no gap", 32, 10, 52, 64},
           {"bank 0, another row: PRE 46 (RD has 45), ACT 49, RD 61, 69", 128, 10, 68, 80},
           {"back again, alone: PRE 100, ACT 103, RD 106, 114", 0, 100, 113, 125},
           {"a refresh is due: PREA 1041, REF 1044, ACT 1053, RD 1056", 0, 1041, 1063, 1075},
           {"two in a rest, rows closed: ACT 3200, RD 3203", 0, 3200, 3210, 3222}});
    /* 64 lines a row, 8 banks: line 512 is bank 0 again */
    table("ddr3x16",
          {{"ACT 7, RD 13 and 17", 0, 7, 21, 27},
           {"row open, behind it: RD 21, 25", 63, 7, 29, 35},
           {"bank 1: ACT 11, RD 29, 33", 64, 7, 37, 43},
           {"bank 2: ACT 15, RD 37, 41", 128, 7, 45, 51},
           {"bank 0, another row: PRE 30 (RD has 29), ACT 36, RD 45, 49", 512, 7, 53, 59},
           {"bank 0 again, RD to PRE: PRE 53, ACT 59, RD 65", 0, 7, 73, 79},
           {"a refresh is due: PREA 3120, REF 3126, ACT 3190, RD 3196", 0, 3121, 3204, 3210}});
    Dram slow(*dram_part("sdram16"), 84);
    /* 11.9 ns a clock: asked for at 119.05 ns = clock 16 of the part, there at 26 = 195 ns = 17 */
    const Dram::Beats there = slow.read_core(0, 10);
    check(there[0] == 17 && there[3] == 24, "clocks of the core, rounded up",
          std::to_string(there[0]) + " to " + std::to_string(there[3]));

    std::vector<DramPart> parts = dram_parts();
    parts.push_back(strict);
    for (const DramPart &part : parts)
        keeps(part, seed);
    std::string why;
    const auto all = commands(strict, seed, why);
    for (const Rule &rule : each) {
        DramPart harder = strict;
        harder.*rule.clocks += 1;
        const std::string said = rules(harder, all);
        check(said.rfind(rule.name, 0) == 0, std::string("a clock less is noticed: ") + rule.name,
              said);
    }
    std::printf("1..%d\n", checks);
    return failed != 0;
}
