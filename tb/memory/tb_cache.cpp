/* tb_cache.cpp - rt_cache against a memory whose lines are a function of address and epoch
 * SPDX-License-Identifier: Apache-2.0
 *
 * tb_cache [seed] [requests per phase]
 *
 * Every request must be answered once, with its line as memory holds it since the last flush (the
 * epoch changes at a flush, so a stale line is a wrong line), or with an error if, and only if, a
 * bus error for that line came after the request was taken (of a group: came with the whole of
 * it) or memory ends before it. No line is fetched while it is already on its way; groups are
 * fetched in order and whole, or up to the end of memory; outputs are stable while they wait; what
 * misses is what the model's cache says. Phases: cold and warm (hits a cycle, latency), random and
 * clustered lines, one set only, one line only, with and without stalls, errors and flushes, and
 * memory that ends at each place of a group, resets of cache and memory in each state.
 */
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <vector>
#include "Vrt_cache.h"
#include "Vrt_cache___024root.h"
#include "bench.h"
#include "stimulus.h"
#include "cache_prediction.h"
extern "C" {
#include "tests/number.h"
}

/* As the cache under test was built (-G); the defaults are those of rt_cache. */
#ifndef TAG
#define TAG 8
#endif
#ifndef LINES
#define LINES 256
#endif
#ifndef WAYS
#define WAYS 4
#endif
#ifndef GROUP
#define GROUP 1
#endif
#ifndef LINE_BITS
#define LINE_BITS 26
#endif
#ifndef PENDING
#define PENDING 16
#endif

namespace {

using Tag = std::remove_reference_t<decltype(Vrt_cache::req_tag_i)>;
constexpr uint32_t SETS = LINES / GROUP / WAYS;
constexpr uint32_t LINE_MASK = (1u << LINE_BITS) - 1;
constexpr uint64_t WATCHDOG = 20000; /* cycles without any transfer while one is due */

enum Pattern { SWEEP, UNIFORM, CLUSTERED, ONE_SET, ONE_LINE };

struct Phase {
    const char *name;
    Pattern pattern;
    uint32_t lines;       /* distinct lines of the pattern */
    int request_stall;    /* percent of cycles the client offers nothing */
    int response_stall;   /* percent of cycles the client takes nothing */
    int memory_stall;     /* percent of cycles the memory takes, and gives, nothing */
    uint32_t latency;     /* of memory, at most; each line 1 .. latency cycles */
    int errors;           /* percent of lines with a bus error */
    bool flush;           /* first forget everything */
    bool flushes = false; /* now and then, whatever is under way */
    uint32_t end = 0;     /* lines of the pattern that memory has, 0: memory ends far away */
    bool resets = false;  /* of both sides now and then, whatever is under way */
};

struct Fetch {
    uint32_t line;
    uint64_t due;
};

/* What a cache with true least-recently-used replacement would fetch. */
class Lru {
  public:
    void forget() { *this = Lru(); }
    void use(uint32_t line) {
        line /= GROUP;
        std::deque<uint32_t> &set = sets_[line % SETS];
        auto at = std::find(set.begin(), set.end(), line);
        if (at != set.end())
            set.erase(at);
        else
            misses++;
        set.push_front(line);
        if (set.size() > WAYS) set.pop_back();
    }
    uint64_t misses = 0;

  private:
    std::vector<std::deque<uint32_t>> sets_ = std::vector<std::deque<uint32_t>>(SETS);
};

struct Waiting {
    bool used;
    uint32_t line;
    uint64_t taken; /* cycle */
};

class Bench {
  public:
    Bench(uint64_t seed) : random_(seed << 32), top_(new Vrt_cache), waiting_(1u << TAG) {
        top_->rst = 1;
        top_->flush_i = 0;
        top_->mem_lines_i = LINE_MASK;
        for (int i = 0; i < 4; i++)
            edge();
        top_->rst = 0;
        base_ = static_cast<uint32_t>(random_.next()) & LINE_MASK & ~(GROUP - 1u);
    }

    /* Runs one phase until every request is answered; prints its TAP line; true if all is well. */
    bool run(const Phase &phase, uint64_t requests, uint64_t seed);

    uint64_t lru_fetches() const { return lru_.misses; }
    uint64_t fetches() const { return fetches_; }
    uint64_t cycles() const { return cycles_; }
    uint64_t slowest() const { return slowest_; }
    uint64_t quickest() const { return quickest_; }

  private:
    uint32_t below(uint32_t n) { return static_cast<uint32_t>(random_.below(n)); }
    void edge() {
        top_->clk = 0;
        top_->eval();
        predict();
        top_->clk = 1;
        top_->eval();
        now_++;
    }

    void predict() {
        if (top_->rst) return;
        const unsigned seen = top_->rootp->rt_cache__DOT__seen;
        group_error_ |= top_->mem_rsp_valid_i && top_->mem_rsp_ready_o && top_->mem_rsp_error_i;
        if (seen >> 2 & 1) {
            if ((seen >> 1 & 1) != group_error_)
                fail("a group is void, or not, unlike what memory gave", last_fetch_);
            group_error_ = false;
        }
        if (top_->miss_o != must_miss_) fail("another miss than the model's", top_->req_line_i);
        must_miss_ =
            prediction_->clock(top_->req_valid_i, top_->req_ready_o, top_->req_line_i, true, seen);
        if (prediction_->impossible()) fail("a lookup that the model refuses", top_->req_line_i);
    }

    bool beyond(uint32_t line) const { return line >= top_->mem_lines_i; }
    uint32_t pick_line(const Phase &phase, uint64_t number);
    uint32_t word(uint32_t line, int i) const;
    void fail(const char *what, uint32_t line);
    void drive(const Phase &phase, uint64_t sent, uint64_t requests);
    bool watch_request(); /* true: the request was taken */
    void watch_response(uint64_t *answered);
    void watch_memory(const Phase &phase);

    bench::Random random_;
    std::unique_ptr<Vrt_cache> top_;
    std::vector<Waiting> waiting_;                    /* by tag */
    std::deque<Fetch> memory_;                        /* lines asked for, oldest first */
    std::vector<uint32_t> errors_;                    /* lines with one, of the group that comes */
    std::unordered_map<uint32_t, uint64_t> error_at_; /* line: cycle of its last bus error */
    uint32_t group_ = 0;                              /* lines still to be fetched of a group */
    uint32_t last_fetch_ = 0;                         /* the line before them */
    bool head_error_ = false;                         /* of the line memory shows */
    bool group_error_ = false;                        /* of a line of the group that comes */
    bool shown_ = false;                              /* memory shows a line not yet taken */
    bool failed_ = false;
    Lru lru_;
    std::optional<CachePrediction> prediction_{std::in_place, LINES, WAYS, GROUP};
    bool must_miss_ = false;
    uint32_t base_ = 0;
    uint32_t epoch_ = 0;
    uint32_t cluster_ = 0;
    uint32_t next_tag_ = 0;
    uint64_t now_ = 0;
    uint64_t fetches_ = 0;
    uint64_t groups_ = 0;
    uint64_t misses_ = 0;
    uint64_t cycles_ = 0;
    uint64_t slowest_ = 0;
    uint64_t quickest_ = 0;
    uint64_t progress_ = 0;
    bool held_rsp_ = false; /* response was waiting in the last cycle */
    uint32_t held_tag_ = 0;
    uint32_t held_word_ = 0;
    bool held_mem_ = false; /* memory request was waiting in the last cycle */
    uint32_t held_line_ = 0;

  public:
    bench::Stimulus driven;

  private:
    enum { WAITS, OWED, ANSWER, IDLE }; /* what is under way; the later one counts, IDLE: nothing */
    bench::Points &states_ = driven.values("handshake", handshakes());
    bench::Points &at_line_ = driven.values("error in line of a group", numbers(GROUP));
    bench::Points &flushed_ = driven.values("flush", under_way());
    bench::Points &resets_ = driven.values("reset", under_way());

    static bench::Stimulus::Names numbers(uint32_t n) {
        bench::Stimulus::Names names;
        for (uint32_t i = 0; i < n; i++)
            names.push_back(std::to_string(i));
        return names;
    }
    /* With two requests a line never comes before its turn. */
    static bench::Stimulus::Names handshakes() {
        bench::Stimulus::Names names = {"a request waits", "a request of memory waits",
                                        "PENDING requests unanswered", "an answer waits",
                                        "a line of memory waits"};
        if (PENDING <= 2) names.pop_back();
        return names;
    }
    static bench::Stimulus::Names under_way() {
        return {"while a request waits", "while memory owes lines", "while an answer waits",
                "while idle"};
    }
    void note();
    void note_all(bench::Points &points);
    void reset();
};

/* Each that is under way. */
void Bench::note_all(bench::Points &points) {
    if (top_->req_valid_i && !top_->req_ready_o) points.value(WAITS);
    if (!memory_.empty()) points.value(OWED);
    if (top_->rsp_valid_o && !top_->rsp_ready_i) points.value(ANSWER);
    if (!top_->req_valid_i && memory_.empty() && !top_->rsp_valid_o) points.value(IDLE);
}

void Bench::note() {
    if (top_->req_valid_i && !top_->req_ready_o) states_.value(0);
    if (top_->mem_req_valid_o && !top_->mem_req_ready_i) states_.value(1);
    if (top_->mem_rsp_valid_i && !top_->mem_rsp_ready_o) states_.value(4);
    if (top_->rsp_valid_o && !top_->rsp_ready_i) states_.value(3);
    if (top_->req_valid_i && !top_->req_ready_o && !memory_.empty() &&
        std::count_if(waiting_.begin(), waiting_.end(), [](const Waiting &w) { return w.used; }) >=
            PENDING)
        states_.value(2);
    if (top_->mem_rsp_valid_i && top_->mem_rsp_ready_o && head_error_)
        at_line_.value(memory_.front().line % GROUP);
    if (top_->flush_i) note_all(flushed_);
}

/* Of cache and memory; what was asked for is not answered. */
void Bench::reset() {
    note_all(resets_);
    top_->rst = 1;
    top_->flush_i = 0;
    top_->req_valid_i = 0;
    top_->mem_rsp_valid_i = 0;
    for (int i = 0; i < 4; i++)
        edge();
    top_->rst = 0;
    for (Waiting &w : waiting_)
        w.used = false;
    memory_.clear();
    errors_.clear();
    error_at_.clear();
    group_ = 0;
    head_error_ = group_error_ = shown_ = held_rsp_ = held_mem_ = must_miss_ = false;
    misses_ = groups_;
    lru_.forget();
    prediction_.emplace(LINES, WAYS, GROUP);
    epoch_++; /* a line that was kept is a wrong one */
    progress_ = now_;
}

uint32_t Bench::word(uint32_t line, int i) const {
    uint64_t z = (static_cast<uint64_t>(epoch_) << 32 | line) * 8 + static_cast<unsigned>(i);
    z = (z ^ (z >> 31)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return static_cast<uint32_t>(z >> 32);
}

void Bench::fail(const char *what, uint32_t line) {
    if (!failed_)
        printf("# cycle %llu line %07x: %s\n", static_cast<unsigned long long>(now_), line, what);
    failed_ = true;
}

uint32_t Bench::pick_line(const Phase &phase, uint64_t number) {
    switch (phase.pattern) {
    case SWEEP:
        return static_cast<uint32_t>(base_ + number % phase.lines) & LINE_MASK;
    case UNIFORM:
        return (base_ + below(phase.lines)) & LINE_MASK;
    case CLUSTERED: /* a walk: near the last place, now and then a jump, often the first lines */
        if (random_.percent(20)) return (base_ + below(8)) & LINE_MASK;
        if (random_.percent(3)) cluster_ = below(phase.lines);
        return (base_ + (cluster_ + below(24)) % phase.lines) & LINE_MASK;
    case ONE_SET:
        return (base_ + SETS * GROUP * below(phase.lines) + below(GROUP)) & LINE_MASK;
    case ONE_LINE:
        break;
    }
    return base_;
}

/* Sets the inputs of this cycle; what waits is left as it is. */
void Bench::drive(const Phase &phase, uint64_t sent, uint64_t requests) {
    if (!top_->req_valid_i && sent < requests && !waiting_[next_tag_].used &&
        !random_.percent(phase.request_stall)) {
        top_->req_valid_i = 1;
        top_->req_line_i = pick_line(phase, sent);
        top_->req_tag_i = static_cast<Tag>(next_tag_);
    }
    top_->flush_i = phase.flushes && !below(4 * SETS + 100);
    top_->rsp_ready_i = !random_.percent(phase.response_stall);
    top_->mem_req_ready_i = !random_.percent(phase.memory_stall);
    if (!shown_ && !memory_.empty() && memory_.front().due <= now_ &&
        !random_.percent(phase.memory_stall)) {
        shown_ = true;
        head_error_ = beyond(memory_.front().line) || random_.percent(phase.errors);
        for (int i = 0; i < 8; i++) /* an error comes with rubbish */
            top_->mem_rsp_data_i[i] =
                word(memory_.front().line, i) ^
                (head_error_ ? static_cast<uint32_t>(random_.next()) | 1u : 0u);
        top_->mem_rsp_error_i = head_error_;
    }
    top_->mem_rsp_valid_i = shown_;
}

bool Bench::watch_request() {
    if (!top_->req_valid_i || !top_->req_ready_o) return false;
    waiting_[next_tag_] = {true, top_->req_line_i, now_};
    next_tag_ = (next_tag_ + 1) & ((1u << TAG) - 1);
    lru_.use(top_->req_line_i);
    progress_ = now_;
    return true;
}

void Bench::watch_response(uint64_t *answered) {
    if (held_rsp_ &&
        (!top_->rsp_valid_o || top_->rsp_tag_o != held_tag_ || (top_->rsp_data_o[0] != held_word_)))
        fail("response changed while it waited", waiting_[held_tag_].line);
    held_rsp_ = top_->rsp_valid_o && !top_->rsp_ready_i;
    held_tag_ = top_->rsp_tag_o;
    held_word_ = top_->rsp_data_o[0];
    if (!top_->rsp_valid_o || !top_->rsp_ready_i) return;
    Waiting &w = waiting_[top_->rsp_tag_o];
    if (!w.used) fail("answer nobody asked for", 0);
    if (top_->rsp_error_o) {
        auto e = error_at_.find(w.line);
        if (!beyond(w.line) && (e == error_at_.end() || e->second <= w.taken))
            fail("error that memory never gave", w.line);
    } else {
        if (beyond(w.line)) fail("no error beyond memory", w.line);
        for (int i = 0; i < 8; i++)
            if (top_->rsp_data_o[i] != word(w.line, i)) fail("wrong data", w.line);
    }
    uint64_t latency = now_ - w.taken;
    if (latency > slowest_) slowest_ = latency;
    if (latency < quickest_) quickest_ = latency;
    w.used = false;
    ++*answered;
    progress_ = now_;
}

void Bench::watch_memory(const Phase &phase) {
    misses_ += top_->miss_o;
    if (held_mem_ && (!top_->mem_req_valid_o || top_->mem_req_line_o != held_line_))
        fail("memory request changed while it waited", held_line_);
    held_mem_ = top_->mem_req_valid_o && !top_->mem_req_ready_i;
    held_line_ = top_->mem_req_line_o;
    if (top_->mem_rsp_valid_i && top_->mem_rsp_ready_o) {
        uint32_t line = memory_.front().line;
        if (head_error_) errors_.push_back(line);
        if (line % GROUP == GROUP - 1 || beyond(line + 1)) {
            for (uint32_t wrong : errors_) /* places behind the end take a clock each */
                error_at_[wrong] = now_ + (GROUP - 1 - line % GROUP);
            errors_.clear();
        }
        memory_.pop_front();
        shown_ = false;
        progress_ = now_;
    }
    if (top_->mem_req_valid_o && top_->mem_req_ready_i) {
        for (const Fetch &f : memory_)
            if (f.line == top_->mem_req_line_o) fail("line fetched while on its way", f.line);
        if (memory_.size() >= PENDING * GROUP)
            fail("more lines on their way than PENDING", top_->mem_req_line_o);
        const uint32_t line = top_->mem_req_line_o;
        if (group_ ? line != last_fetch_ + 1 : line % GROUP != 0)
            fail("a group not fetched in order", line);
        if (group_ == 0) { /* of a group that has no line in memory all are asked for */
            group_ = GROUP;
            if (!beyond(line) && beyond(line + GROUP - 1)) group_ = top_->mem_lines_i - line;
            groups_++;
        }
        group_--;
        last_fetch_ = line;
        memory_.push_back({top_->mem_req_line_o, now_ + 1 + below(phase.latency)});
        fetches_++;
        progress_ = now_;
    }
}

bool Bench::run(const Phase &phase, uint64_t requests, uint64_t seed) {
    top_->flush_i = phase.flush;
    top_->req_valid_i = 0;
    top_->mem_rsp_valid_i = 0;
    if (phase.flush) note_all(flushed_);
    edge();
    top_->flush_i = 0;
    if (phase.flush) { /* other lines: each bit of their addresses is the other one */
        epoch_++, lru_.forget();
        base_ ^= LINE_MASK & ~(GROUP - 1u);
    }
    /* another end of memory makes the cache forget, as a flush does */
    const uint32_t lines = phase.end ? (base_ + phase.end) & LINE_MASK : LINE_MASK;
    if (lines != top_->mem_lines_i) lru_.forget();
    top_->mem_lines_i = lines;
    lru_.misses = 0;
    uint64_t sent = 0;
    uint64_t answered = 0;
    uint64_t start = now_;
    progress_ = now_;
    fetches_ = groups_ = misses_ = slowest_ = 0;
    quickest_ = ~0ull;
    failed_ = false;
    while (answered < requests && !failed_) {
        top_->clk = 0;
        drive(phase, sent, requests);
        top_->eval();
        predict();
        note();
        watch_response(&answered); /* before the request: its tag may be reused at once */
        bool taken = watch_request();
        sent += taken;
        watch_memory(phase);
        top_->clk = 1;
        top_->eval();
        if (Verilated::gotFinish()) fail("the RTL stopped the simulation", 0);
        now_++;
        if (taken) top_->req_valid_i = 0;
        if (now_ - progress_ > WATCHDOG) fail("deadlock", top_->req_line_i);
        if (phase.resets && !failed_ && !below(2 * SETS + 150)) {
            reset();
            answered = sent;
        }
    }
    top_->flush_i = 0;
    cycles_ = now_ - start;
    for (int i = 0; i < 4 && !failed_; i++) { /* nothing may follow */
        edge();
        if (top_->rsp_valid_o && i > 0) fail("answer after the last", 0);
        misses_ += top_->miss_o;
    }
    if (misses_ != groups_ || group_) fail("miss_o does not count the groups fetched", 0);
    printf("%sok tb_cache %s seed %llu: %s, %llu requests\n", failed_ ? "not " : "", PROFILE,
           static_cast<unsigned long long>(seed), phase.name,
           static_cast<unsigned long long>(answered));
    printf("# %.4f requests a cycle, %.2f %% misses, latency %llu to %llu\n",
           static_cast<double>(answered) / static_cast<double>(cycles_),
           100.0 * static_cast<double>(misses_) / static_cast<double>(answered),
           static_cast<unsigned long long>(quickest_), static_cast<unsigned long long>(slowest_));
    return !failed_;
}

bool check(bool good, uint64_t seed, const char *what) {
    printf("%sok tb_cache %s seed %llu: %s\n", good ? "" : "not ", PROFILE,
           static_cast<unsigned long long>(seed), what);
    return good;
}

} // namespace

int main(int argc, char **argv) {
    const uint64_t seed = test_number(argc > 1 ? argv[1] : nullptr, "argument 1", 1);
    const uint64_t n = test_number(argc > 2 ? argv[2] : nullptr, "argument 2", 20000);
    Bench bench(seed);
    bool good = true;

    /* name, pattern, lines, stalls of request, response, memory, latency, errors, flush */
    good = good && bench.run({"cold sweep", SWEEP, LINES, 0, 0, 0, 20, 0, true}, LINES, seed);
    good = good && check(bench.fetches() == LINES, seed, "cold: every line fetched once");
    good = good && bench.run({"warm", UNIFORM, LINES, 0, 0, 0, 20, 0, false}, n, seed);
    good = good && check(bench.fetches() == 0, seed, "warm: no line fetched");
    good = good && check(static_cast<double>(n) >= 0.99 * static_cast<double>(bench.cycles()), seed,
                         "warm: 0.99 hits a cycle");
    good = good && check(bench.quickest() == 3 && bench.slowest() == 3, seed, "warm: latency 3");

    good = good && bench.run({"clustered", CLUSTERED, 4 * LINES, 0, 0, 0, 20, 0, false}, n, seed);
    printf("# %llu groups fetched, %llu by a cache with LRU replacement\n",
           static_cast<unsigned long long>(bench.fetches() / GROUP),
           static_cast<unsigned long long>(bench.lru_fetches()));
    good = good && check(10 * bench.fetches() <= 11 * GROUP * bench.lru_fetches(), seed,
                         "clustered: at most 1.1 times the misses of LRU");

    const Phase phases[] = {
        {"uniform over all lines", UNIFORM, LINE_MASK, 0, 0, 0, 400, 0, true},
        {"stalls everywhere", CLUSTERED, 2 * LINES, 30, 30, 50, 200, 0, true},
        {"slow client", CLUSTERED, 2 * LINES, 0, 90, 0, 8, 0, false},
        {"slow memory", CLUSTERED, 2 * LINES, 0, 0, 90, 200, 0, false},
        {"one set, just fitting", ONE_SET, WAYS, 0, 10, 10, 30, 0, true},
        {"one set, thrashing", ONE_SET, 2 * WAYS + 1, 0, 0, 0, 200, 0, false},
        {"one set, one too many, stalls", ONE_SET, WAYS + 1, 20, 60, 30, 10, 0, true},
        {"one set, errors", ONE_SET, WAYS + 2, 10, 30, 30, 30, 40, false},
        {"one line, errors", ONE_LINE, 1, 10, 10, 10, 50, 99, true},
        {"errors", CLUSTERED, 2 * LINES, 10, 20, 20, 60, 10, true},
        {"every line an error", UNIFORM, 2 * LINES, 0, 10, 10, 60, 100, true},
        {"flushes", CLUSTERED, 2 * LINES, 30, 10, 30, 60, 0, false, true},
        {"flushes, one set", ONE_SET, 2 * WAYS + 1, 10, 10, 30, 60, 10, true, true},
        {"resets", CLUSTERED, 2 * LINES, 30, 30, 30, 60, 10, true, false, 0, true},
        {"after the errors", CLUSTERED, LINES, 10, 10, 10, 60, 0, false},
    };
    for (const Phase &phase : phases)
        good = good && bench.run(phase, n, seed);
    for (uint32_t end = 4 * GROUP; end <= 5 * GROUP; end++) {
        const std::string name = "memory of " + std::to_string(end) +
                                 " lines, the last group has " + std::to_string(end % GROUP) +
                                 " of " + std::to_string(GROUP);
        const bool flush = GROUP == 1 || end % 2;
        const Phase ends[] = {
            {name.c_str(), UNIFORM, 6 * GROUP, 10, 10, 10, 60, flush ? 10 : 0, flush, false, end},
            {name.c_str(), CLUSTERED, 2 * LINES, 20, 20, 30, 60, 10, false, true, end},
        };
        for (const Phase &phase : ends)
            good = good && bench.run(phase, n, seed);
    }
    good = good && (argc > 2 || bench.driven.whole());
    return good ? 0 : 1;
}
