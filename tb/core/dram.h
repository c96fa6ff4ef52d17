/* dram.h - when a named memory part gives the lines that it is asked for
 * SPDX-License-Identifier: Apache-2.0
 *
 * A controller serves lines of 32 bytes in the order in which they come. Rows stay open. A bank is
 * precharged and its row opened as soon as the times of the part allow, while other banks still
 * give data; rows open in the order of the lines, and each clock of the part has one command. A
 * line is two bursts of eight words of 16 bits. A refresh goes before the first line that comes
 * when it is due, and closes all rows.
 *
 *   line   row % rows | bank | column           address of a line, high bits first
 *
 *   PRE --RP--> ACT --RCD--> RD --CCD--> RD     RD + CL: the first word; a beat of 64 bits is
 *                                               there when its last word has passed
 *
 * Nothing is written: frames leave by another port. Times are whole clocks of the part.
 */
#ifndef TB_DRAM_H
#define TB_DRAM_H

#include <array>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

struct DramPart {
    const char *name, *chip; /* name: an option's; chip: what the times are of */
    uint64_t ps;             /* of a clock */
    unsigned banks, rows, row_bytes;
    /* in clocks */
    unsigned cl, burst;    /* to the first word; of a burst on the pins, and from RD to RD */
    unsigned rcd, rp, ras; /* ACT to RD, PRE to ACT, ACT to PRE */
    unsigned rc, rrd, faw; /* ACT to ACT: of a bank, of two banks; of five in a row */
    unsigned rtp;          /* RD to PRE */
    unsigned rfc, refi;    /* REF to ACT, REF to REF on the mean */
};

/* All that have a name; nullptr if there is none of this one. */
const std::vector<DramPart> &dram_parts();
const DramPart *dram_part(const std::string &name);

struct DramCommand {
    enum Kind { ACTIVATE, READ, PRECHARGE, PRECHARGE_ALL, REFRESH } kind;
    uint64_t clock; /* of the part */
    unsigned bank, row;
};

class Dram {
  public:
    static const unsigned BEATS = 4, LINE_BYTES = 32;
    using Beats = std::array<uint64_t, BEATS>;

    Dram(const DramPart &part, unsigned core_mhz) : part_(part), mhz_(core_mhz) {
        banks_.resize(part.banks);
        next_refresh_ = part.refi;
    }

    /* Clocks of the part from which on each beat is there; `clock`, of the part, never less than
     * that of the line before: when the line is asked for. */
    Beats read(uint32_t line, uint64_t clock);

    /* The same in clocks of the core. */
    Beats read_core(uint32_t line, uint64_t clock);

    /* Bytes that the pins carry in a clock of the core, at most. */
    static double peak(const DramPart &part, unsigned core_mhz) {
        return 1e6 / core_mhz / static_cast<double>(part.ps) * 16 / part.burst;
    }
    static uint64_t bytes(const DramPart &part) {
        return static_cast<uint64_t>(part.banks) * part.rows * part.row_bytes;
    }

    struct Counts {
        uint64_t row_hits, row_opens, row_conflicts, refreshes;
    };
    const Counts &counts() const { return counts_; }
    /* Is told each command, not always in order of clocks; may be empty. */
    std::function<void(const DramCommand &)> watch;

  private:
    static const uint64_t NEVER = 0;
    struct Bank {
        bool open = false;
        unsigned row = 0;
        /* earliest clocks of what may follow */
        uint64_t activate = NEVER, read = NEVER, precharge = NEVER;
    };
    uint64_t command(DramCommand::Kind kind, uint64_t earliest, unsigned bank, unsigned row);
    void refresh();
    void close(Bank &bank, uint64_t clock);
    void open(unsigned bank, unsigned row, uint64_t clock);

    const DramPart part_;
    unsigned mhz_;
    std::vector<Bank> banks_;
    std::set<uint64_t> taken_;         /* clocks that have a command, those to come */
    std::array<uint64_t, 4> opened_{}; /* earliest ACT because of the four before, oldest first */
    uint64_t next_open_ = NEVER, next_read_ = NEVER, next_refresh_;
    Counts counts_ = {0, 0, 0, 0};
};

#endif
