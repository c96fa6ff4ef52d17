/* tb_arbiter.cpp - rt_mem_arbiter between clients and a memory that answers in any order of clients
 * SPDX-License-Identifier: Apache-2.0
 *
 * tb_arbiter [seed] [lines per phase]
 *
 * Each client asks for random lines and must get exactly those, in its own order, one client at a
 * time, each put together from the beats of that line, with an error if one of its beats had one.
 * Memory gives the next beat of any client's first line. At most PENDING lines are on their way,
 * and so many are if memory is late; outputs are stable while they wait; with all clients asking,
 * none waits for more than CLIENTS turns; it is busy just as long as a line is due. Throughput: a
 * line in as many cycles as it has beats. A reset of both sides in each state leaves nothing
 * behind.
 */
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <memory>
#include <string>
#include <type_traits>
#include "Vrt_mem_arbiter.h"
#include "bench.h"
#include "stimulus.h"
extern "C" {
#include "tests/number.h"
}

/* As the arbiter under test was built (-G); the defaults are those of rt_mem_arbiter. */
#ifndef CLIENTS
#define CLIENTS 2
#endif
#ifndef PENDING
#define PENDING 64
#endif
#ifndef DATA
#define DATA 64
#endif

namespace {

constexpr int BEATS = 256 / DATA;
constexpr int WORDS = DATA / 32;     /* of a beat */
constexpr uint64_t WATCHDOG = 20000; /* cycles without any transfer while one is due */

struct Phase {
    const char *name;
    int request_stall;  /* percent of cycles a client does not start to ask */
    int response_stall; /* percent of cycles a client takes nothing */
    int memory_stall;   /* percent of cycles the memory takes, and gives, nothing */
    uint32_t latency;   /* of memory, at most; each line 1 .. latency cycles */
    int errors;         /* percent of beats with an error */
    int other;          /* percent of beats that are of any client, not of the oldest line */
    bool resets = false;
};

struct Fetch {
    uint32_t line, tag;
    uint64_t due;
    int beat;
    bool error;
};

uint32_t word_of(uint32_t line, int word) {
    uint64_t z = static_cast<uint64_t>(line) * 8 + static_cast<unsigned>(word) + 1;
    z = (z ^ (z >> 17)) * 0xbf58476d1ce4e5b9ull;
    return static_cast<uint32_t>(z ^ (z >> 31));
}

class Bench {
  public:
    explicit Bench(uint64_t seed) : random_(seed << 32), top_(new Vrt_mem_arbiter) {
        top_->rst = 1;
        top_->req_valid_i = 0;
        top_->mem_rsp_valid_i = 0;
        for (int i = 0; i < 4; i++)
            clock();
        top_->rst = 0;
    }
    bool run(const Phase &phase, uint64_t lines, uint64_t seed);
    size_t most() const { return most_; }

  private:
    uint32_t below(uint32_t n) { return static_cast<uint32_t>(random_.below(n)); }
    void clock() {
        top_->clk = 0;
        top_->eval();
        top_->clk = 1;
        top_->eval();
        now_++;
    }
    void fail(const char *what, int client) {
        if (!failed_)
            printf("# cycle %llu client %d: %s\n", static_cast<unsigned long long>(now_), client,
                   what);
        failed_ = true;
    }
    void set_line(int client, uint32_t line);
    size_t choose(const Phase &phase);
    void drive(const Phase &phase, uint64_t sent, uint64_t lines);
    uint32_t watch_requests();
    uint64_t watch_answers();
    void watch_busy();
    void watch_memory(const Phase &phase);

    bench::Random random_;
    std::unique_ptr<Vrt_mem_arbiter> top_;
    uint32_t asking_[CLIENTS] = {};         /* line on the request port */
    int turns_[CLIENTS] = {};               /* of others, while this one asked */
    std::deque<uint32_t> waiting_[CLIENTS]; /* lines granted and not yet given */
    std::deque<Fetch> granted_;             /* lines granted, not yet at the memory port */
    std::deque<Fetch> memory_;              /* lines at memory */
    std::deque<bool> errors_[CLIENTS];      /* of lines that left memory, oldest first */
    bool shown_ = false;                    /* memory shows a beat not yet taken */
    size_t of_ = 0;                         /* which line it is of */
    size_t most_ = 0;                       /* lines at memory */
    bool failed_ = false;
    uint64_t now_ = 0;
    uint64_t progress_ = 0;
    bool was_due_ = true;
    bool held_mem_ = false;
    uint32_t held_line_ = 0, held_tag_ = 0;
    uint32_t held_rsp_ = 0; /* clients whose line waited in the last cycle */
    uint32_t held_word_ = 0;

  public:
    bench::Stimulus driven;

  private:
    bench::Points &states_ = driven.values(
        "handshake", {"a request waits", "a request of memory waits", "a beat of memory waits",
                      "a line waits for its client", "PENDING lines on their way"});
    bench::Points &at_beat_ = driven.values("error in beat", numbers(BEATS));
    bench::Points &resets_ =
        driven.values("reset", {"while idle", "while a client asks", "while memory owes lines",
                                "within a line", "while a line waits for its client"});

    static bench::Stimulus::Names numbers(int n) {
        bench::Stimulus::Names names;
        for (int i = 0; i < n; i++)
            names.push_back(std::to_string(i));
        return names;
    }
    void note();
    bool reset();
};

/* Ports wider than 64 bits are arrays of words, narrower ones are not. */
template <class T> uint32_t get_word(const T &port, int i) {
    if constexpr (std::is_integral_v<T>)
        return static_cast<uint32_t>(static_cast<uint64_t>(port) >> (32 * i));
    else
        return port[static_cast<size_t>(i)];
}

template <class T> void put_word(T &port, int i, uint32_t word) {
    if constexpr (std::is_integral_v<T>) {
        uint64_t mask = 0xffffffffull << (32 * i);
        port = static_cast<T>((static_cast<uint64_t>(port) & ~mask) | static_cast<uint64_t>(word)
                                                                          << (32 * i));
    } else {
        port[static_cast<size_t>(i)] = word;
    }
}

void Bench::set_line(int client, uint32_t line) {
    for (int bit = 0; bit < 26; bit++) {
        int at = 26 * client + bit;
        uint32_t word = get_word(top_->req_line_i, at / 32) & ~(1u << at % 32);
        put_word(top_->req_line_i, at / 32, word | (line >> bit & 1) << at % 32);
    }
    asking_[client] = line;
}

/* The oldest line, or the oldest of any client. */
size_t Bench::choose(const Phase &phase) {
    size_t i = 0;
    if (!random_.percent(phase.other)) return i;
    const uint32_t tag = memory_[below(static_cast<uint32_t>(memory_.size()))].tag;
    while (memory_[i].tag != tag)
        i++;
    return i;
}

/* Sets the inputs of this cycle; what waits is left as it is. */
void Bench::drive(const Phase &phase, uint64_t sent, uint64_t lines) {
    uint32_t ready = 0;
    for (int c = 0; c < CLIENTS; c++) {
        bool asks = top_->req_valid_i >> c & 1;
        if (!asks && sent < lines && !random_.percent(phase.request_stall)) {
            set_line(c, below(1u << 26));
            top_->req_valid_i |= static_cast<uint8_t>(1u << c);
            turns_[c] = 0;
        }
        ready |= static_cast<uint32_t>(!random_.percent(phase.response_stall)) << c;
    }
    top_->rsp_ready_i = static_cast<uint8_t>(ready);
    top_->mem_req_ready_i = !random_.percent(phase.memory_stall);
    if (!shown_ && !memory_.empty() && !random_.percent(phase.memory_stall)) {
        of_ = choose(phase);
        const Fetch &f = memory_[of_];
        shown_ = f.due <= now_;
        top_->mem_rsp_tag_i = static_cast<uint8_t>(f.tag);
        top_->mem_rsp_error_i = random_.percent(phase.errors);
        for (int i = 0; i < WORDS; i++)
            put_word(top_->mem_rsp_data_i, i, word_of(f.line, WORDS * f.beat + i));
    }
    top_->mem_rsp_valid_i = shown_;
}

/* Returns the clients whose request was taken. */
uint32_t Bench::watch_requests() {
    uint32_t taken = top_->req_valid_i & top_->req_ready_o;
    if (taken & (taken - 1)) fail("two clients served at once", 0);
    for (int c = 0; c < CLIENTS && taken; c++) {
        if (taken >> c & 1) {
            waiting_[c].push_back(asking_[c]);
            granted_.push_back({asking_[c], static_cast<uint32_t>(c), 0, 0, false});
            progress_ = now_;
        } else if (++turns_[c] >= CLIENTS && (top_->req_valid_i >> c & 1)) {
            fail("waited for more than CLIENTS turns", c);
        }
    }
    return taken;
}

/* Returns the number of lines taken by clients, 0 or 1. */
uint64_t Bench::watch_answers() {
    uint32_t valid = top_->rsp_valid_o;
    if (valid & (valid - 1)) fail("a line for two clients", 0);
    if (held_rsp_ && (valid != held_rsp_ || top_->rsp_data_o[0] != held_word_))
        fail("line changed while it waited", 0);
    held_rsp_ = valid & ~static_cast<uint32_t>(top_->rsp_ready_i);
    held_word_ = top_->rsp_data_o[0];
    if (!(valid & top_->rsp_ready_i)) return 0;
    int c = 0;
    while (!(valid >> c & 1))
        c++;
    if (waiting_[c].empty() || errors_[c].empty()) {
        fail("line nobody asked for", c);
        return 0;
    }
    if (top_->rsp_error_o != errors_[c].front()) fail("wrong error", c);
    for (int i = 0; i < 8; i++)
        if (top_->rsp_data_o[i] != word_of(waiting_[c].front(), i)) fail("wrong data", c);
    waiting_[c].pop_front();
    errors_[c].pop_front();
    progress_ = now_;
    return 1;
}

/* Busy while a line is asked for, on its way or not taken, and until a clock behind that. */
void Bench::watch_busy() {
    bool due = top_->req_valid_i != 0;
    for (const std::deque<uint32_t> &lines : waiting_)
        due |= !lines.empty();
    if (top_->busy_o < due) fail("not busy, though a line is due", 0);
    if (top_->busy_o > (due || was_due_)) fail("busy with nothing", 0);
    was_due_ = due;
}

void Bench::watch_memory(const Phase &phase) {
    if (held_mem_ && (!top_->mem_req_valid_o || top_->mem_req_line_o != held_line_ ||
                      top_->mem_req_tag_o != held_tag_))
        fail("memory request changed while it waited", 0);
    held_mem_ = top_->mem_req_valid_o && !top_->mem_req_ready_i;
    held_line_ = top_->mem_req_line_o;
    held_tag_ = top_->mem_req_tag_o;
    if (top_->mem_rsp_valid_i && top_->mem_rsp_ready_o) {
        Fetch &f = memory_[of_];
        f.error |= top_->mem_rsp_error_i != 0;
        shown_ = false;
        progress_ = now_;
        if (++f.beat == BEATS) {
            errors_[f.tag].push_back(f.error);
            memory_.erase(memory_.begin() + static_cast<ptrdiff_t>(of_));
        }
    }
    if (top_->mem_req_valid_o && top_->mem_req_ready_i) {
        if (granted_.empty() || granted_.front().line != top_->mem_req_line_o ||
            granted_.front().tag != top_->mem_req_tag_o)
            return fail("line asked of memory that no client wants next", 0);
        memory_.push_back(granted_.front());
        granted_.pop_front();
        memory_.back().due = now_ + 1 + below(phase.latency);
        if (memory_.size() > PENDING) fail("more lines on their way than PENDING", 0);
        most_ = std::max(most_, memory_.size());
        progress_ = now_;
    }
}

void Bench::note() {
    if (top_->req_valid_i & ~top_->req_ready_o) states_.value(0);
    if (top_->mem_req_valid_o && !top_->mem_req_ready_i) states_.value(1);
    if (top_->mem_rsp_valid_i && !top_->mem_rsp_ready_o) states_.value(2);
    if (top_->rsp_valid_o & ~top_->rsp_ready_i) states_.value(3);
    if (memory_.size() == PENDING) states_.value(4);
    if (top_->mem_rsp_valid_i && top_->mem_rsp_ready_o && top_->mem_rsp_error_i)
        at_beat_.value(memory_[of_].beat);
}

/* Of both sides, in whatever state they are. */
bool Bench::reset() {
    const bool within =
        std::any_of(memory_.begin(), memory_.end(), [](const Fetch &f) { return f.beat > 0; });
    resets_.value(top_->rsp_valid_o   ? 4
                  : within            ? 3
                  : !memory_.empty()  ? 2
                  : top_->req_valid_i ? 1
                                      : 0);
    if (BEATS == 1 && !memory_.empty()) resets_.value(3); /* nothing is within a line of one */
    top_->rst = 1;
    top_->req_valid_i = 0;
    top_->mem_rsp_valid_i = 0;
    for (int i = 0; i < 4; i++) {
        top_->clk = 0;
        top_->eval();
        top_->clk = 1;
        top_->eval();
        now_++;
    }
    top_->rst = 0;
    for (int c = 0; c < CLIENTS; c++) {
        waiting_[c].clear();
        errors_[c].clear();
    }
    granted_.clear();
    memory_.clear();
    shown_ = held_mem_ = false;
    held_rsp_ = 0;
    was_due_ = true;
    progress_ = now_;
    return true;
}

bool Bench::run(const Phase &phase, uint64_t lines, uint64_t seed) {
    uint64_t sent = 0;
    uint64_t answered = 0;
    uint64_t start = now_;
    progress_ = now_;
    while (!failed_ && (answered < sent || sent < lines || top_->req_valid_i)) {
        top_->clk = 0;
        drive(phase, sent, lines);
        top_->eval();
        note();
        watch_busy();
        answered += watch_answers();
        uint32_t taken = watch_requests();
        sent += taken != 0;
        watch_memory(phase);
        top_->clk = 1;
        top_->eval();
        now_++;
        top_->req_valid_i = static_cast<uint8_t>(top_->req_valid_i & ~taken);
        if (Verilated::gotFinish()) fail("the RTL stopped the simulation", 0);
        if (now_ - progress_ > WATCHDOG) fail("deadlock", 0);
        if (phase.resets && !failed_ && !below(60) && reset()) answered = sent;
    }
    double cycles = static_cast<double>(now_ - start) / static_cast<double>(answered);
    bool free = phase.request_stall + phase.response_stall + phase.memory_stall == 0;
    if (free && phase.latency <= PENDING && cycles > BEATS + 0.1)
        fail("slower than a beat every cycle", 0);
    printf("%sok tb_arbiter %s seed %llu: %s, %llu lines\n", failed_ ? "not " : "", PROFILE,
           static_cast<unsigned long long>(seed), phase.name,
           static_cast<unsigned long long>(answered));
    printf("# %.3f cycles a line\n", cycles);
    return !failed_;
}

} // namespace

int main(int argc, char **argv) {
    const uint64_t seed = test_number(argc > 1 ? argv[1] : nullptr, "argument 1", 1);
    const uint64_t n = test_number(argc > 2 ? argv[2] : nullptr, "argument 2", 5000);
    Bench bench(seed);
    /* name, stalls of request, response, memory, latency, errors, beats of any client */
    const Phase phases[] = {
        {"everyone ready", 0, 0, 0, 2, 0, 0},
        {"few requests", 95, 0, 0, 20, 0, 50},
        {"stalls everywhere", 30, 50, 50, 200, 0, 50},
        {"slow clients", 0, 95, 0, 10, 0, 50},
        {"slow memory", 0, 0, 90, 4 * PENDING, 0, 50},
        {"any order", 0, 0, 0, 50, 0, 100},
        {"errors", 20, 20, 20, 20, 20, 50},
        {"resets", 60, 50, 50, 20, 20, 50, true},
    };
    bool good = true;
    for (const Phase &phase : phases)
        good = good && bench.run(phase, n, seed);
    if (good && bench.most() != PENDING) {
        printf("not ok tb_arbiter: %zu lines on their way at most, not PENDING\n", bench.most());
        good = false;
    }
    return good && (argc > 2 || bench.driven.whole()) ? 0 : 1;
}
