/* stimulus.h - what a bench has to have driven: bits that toggle alone, events that meet, values
 * SPDX-License-Identifier: Apache-2.0
 *
 *     bench::Stimulus driven;
 *     auto &row = driven.alone("row", 13);              // each bit changes while no other does
 *     auto &met = driven.together("a clock", {"write", "refresh", "reset"}, {{1, 2}});
 *     auto &length = driven.values("words of a burst", {"1", "2", "256"});
 *     row.word(cmd_addr >> 9);                          // again and again
 *     met.clock(write | due << 1 | rst << 2);           // events, by their bits
 *     length.value(n == 1 ? 0 : n == 2 ? 1 : n == 256 ? 2 : -1);
 *     if (!driven.whole()) ...                          // says what is missing, a line each
 *
 * A list is part of its bench: a bench that was changed and drives less than its list fails.
 */
#ifndef SPH_STIMULUS_H
#define SPH_STIMULUS_H

#include <cstdint>
#include <cstdio>
#include <deque>
#include <string>
#include <utility>
#include <vector>

namespace bench {

/* One list: its points, and how often each was driven. */
class Points {
  public:
    /* A word of those whose bits have to toggle alone: its bit that alone differs from the word
     * before, if there is such a bit, is met. */
    void word(uint64_t now) {
        const uint64_t other = first_ ? 0 : now ^ before_;
        first_ = false;
        before_ = now;
        if (other && !(other & (other - 1))) value(__builtin_ctzll(other));
    }
    /* Events of one clock, by their bits: each pair of them is met. */
    void clock(uint64_t events) {
        for (size_t i = 0; i < pairs_.size(); i++)
            if (events >> pairs_[i].first & events >> pairs_[i].second & 1) seen_[i]++;
    }
    /* A value, by its place in the list; none of the list is a place outside. */
    void value(int64_t at) {
        if (at >= 0 && at < (int64_t)seen_.size()) seen_[(size_t)at]++;
    }
    /* Forgets the word before: the next one is not compared. */
    void anew() { first_ = true; }

  private:
    friend class Stimulus;
    std::string what_;
    std::vector<std::string> names_;
    std::vector<uint64_t> seen_;
    std::vector<std::pair<unsigned, unsigned>> pairs_;
    uint64_t before_ = 0;
    bool first_ = true;
};

class Stimulus {
  public:
    typedef std::vector<std::string> Names;

    /* `bits` points, at most 64. */
    Points &alone(const char *what, unsigned bits) {
        Names names;
        for (unsigned i = 0; i < bits; i++)
            names.push_back("bit " + std::to_string(i) + " alone");
        return add(what, names);
    }
    /* A point for each pair of events, but for those that cannot meet. */
    Points &together(const char *what, const Names &events,
                     const std::vector<std::pair<unsigned, unsigned>> &never = {}) {
        Names names;
        std::vector<std::pair<unsigned, unsigned>> pairs;
        for (unsigned i = 0; i < events.size(); i++)
            for (unsigned k = i + 1; k < events.size(); k++) {
                bool can = true;
                for (const auto &[a, b] : never)
                    can = can && !(a == i && b == k) && !(a == k && b == i);
                if (!can) continue;
                names.push_back(events[i] + " with " + events[k]);
                pairs.push_back({i, k});
            }
        Points &points = add(what, names);
        points.pairs_ = pairs;
        return points;
    }
    /* A point for each of these. */
    Points &values(const char *what, const Names &names) { return add(what, names); }

    /* Whether all was driven; prints how much, and each point that was not. */
    bool whole() const {
        size_t all = 0, missing = 0;
        for (const Points &each : lists_)
            for (size_t i = 0; i < each.names_.size(); i++) {
                all++;
                if (each.seen_[i]) continue;
                missing++;
                printf("# never driven: %s: %s\n", each.what_.c_str(), each.names_[i].c_str());
            }
        printf("# stimulus: %zu of %zu points\n", all - missing, all);
        return !missing;
    }

  private:
    std::deque<Points> lists_; /* references to them stay */

    Points &add(const char *what, const Names &names) {
        lists_.emplace_back();
        lists_.back().what_ = what;
        lists_.back().names_ = names;
        lists_.back().seen_.resize(names.size());
        return lists_.back();
    }
};

} // namespace bench

#endif
