/* work_watch.h - how busy each unit of a verilated core is
 * SPDX-License-Identifier: Apache-2.0
 *
 * A unit shows a wire work_NAME = {turned away, taken, clocks u6}: an operand waits at its port and
 * is not taken; one is taken; clocks of its own work that fall into this one, or that the operand
 * just taken needs. A unit that holds a result which nobody takes does not work. Units are found by
 * name, wherever they stand; those of one name make a row. A frame has parts that ask for different
 * units, so every SPAN clocks are looked at alone: they are bound by the row that is busiest there,
 * if it is busy in at least BINDS of them.
 */
#ifndef TB_WORK_WATCH_H
#define TB_WORK_WATCH_H

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "simulate.h"
#include "verilated.h"
#include "verilated_syms.h"

class WorkWatch {
  public:
    static constexpr uint64_t SPAN = 256;
    /* After the first clock of the core that was made in this context. more: what the bench itself
     * counts as such a wire would, or null, by the name of its row. */
    WorkWatch(VerilatedContext &context, const std::string &name, const uint8_t *more) {
        const std::string prefix = "work_";
        std::vector<Unit> units;
        if (more) units.push_back({name, more});
        for (const auto &scope : *context.scopeNameMap())
            if (scope.second->varsp())
                for (const auto &var : *scope.second->varsp())
                    if (prefix == std::string(var.first).substr(0, prefix.size()))
                        units.push_back({var.first + prefix.size(),
                                         static_cast<const uint8_t *>(var.second.datap())});
        std::stable_sort(units.begin(), units.end(),
                         [](const Unit &a, const Unit &b) { return a.name < b.name; });
        for (const Unit &unit : units) {
            if (rows_.empty() || rows_.back().name != unit.name)
                rows_.push_back({unit.name, {}, {}, 0, 0});
            rows_.back().units.push_back(unit.work);
        }
        reset();
    }
    void reset() {
        for (Row &row : rows_) {
            row.total = Work{};
            row.total.units = static_cast<uint32_t>(row.units.size());
            std::strncpy(row.total.name, row.name.c_str(), sizeof row.total.name - 1);
            row.span = 0;
        }
        at_ = 0;
    }
    /* Before every clock edge, when all has settled. */
    void clock() {
        for (Row &row : rows_)
            for (const uint8_t *work : row.units) {
                const unsigned now = *work;
                if (!now) continue; /* most of them, in most clocks */
                row.total.away += now >> 7;
                row.total.taken += now >> 6 & 1;
                row.span += now & 63;
            }
        if (++at_ == SPAN) end_span();
    }
    /* What was counted since the last reset; of more than WORKS rows the first ones. */
    int rows(Work *rows) {
        end_span();
        const size_t n = std::min(rows_.size(), static_cast<size_t>(WORKS));
        for (size_t i = 0; i < n; i++)
            rows[i] = rows_[i].total;
        return static_cast<int>(n);
    }

  private:
    struct Unit {
        std::string name;
        const uint8_t *work;
    };
    struct Row {
        std::string name;
        std::vector<const uint8_t *> units;
        Work total;
        uint64_t span; /* clocks of work in the span at hand */
        double busy;   /* its share */
    };
    void end_span() {
        Row *most = nullptr;
        for (Row &row : rows_) {
            row.busy = static_cast<double>(row.span) /
                       static_cast<double>(std::max(at_, uint64_t{1}) * row.units.size());
            row.total.clocks += row.span;
            row.span = 0;
            if (!most || row.busy > most->busy) most = &row;
        }
        if (most && most->busy >= BINDS) most->total.binds += at_;
        at_ = 0;
    }

    std::vector<Row> rows_;
    uint64_t at_ = 0; /* clocks of the span at hand */
};

#endif
