/* bench.h - what the block benches share: random numbers, ports of any width, mismatches, TAP
 * SPDX-License-Identifier: Apache-2.0
 *
 * A bench is built by lab/benches, which passes each parameter of the module as a macro of the
 * same name (-DW=16) and the profile as PROFILE ("standard").
 *
 *     bench::Bench<Vrt_unit> b("tb_unit", argc, argv);     // [seed [vectors]]
 *     b.reset();
 *     while (b.more()) {
 *         b.set(b.dut.in_x_i, BITS, b.random.corner_signed(BITS));
 *         b.tick();
 *         b.expect("out_x_o", b.get(b.dut.out_x_o), expected);    // any number of these
 *         if (b.bad()) b.show("in_x_i", x, BITS);                 // inputs of the first mismatch
 *         b.done();                                               // one vector is checked
 *     }
 *     return b.finish();
 */
#ifndef SPH_BENCH_H
#define SPH_BENCH_H

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <queue>
#include <type_traits>
#include "verilated.h"
extern "C" {
#include "tests/number.h"
}

#ifndef PROFILE
#define PROFILE "default"
#endif

#ifdef SLOTS
constexpr int SLOTW = __builtin_ctz(SLOTS); /* bits of a slot */
#endif

/* A rule of formal/axi_rules.vh does not hold, in the instance that `what` names. */
extern "C" inline void axi_rule_broken(const char *what) {
    printf("not ok - %s\n", what);
    fflush(stdout);
    exit(1);
}

namespace bench {

typedef __int128 i128;
typedef unsigned __int128 u128;

/* The low `bits` bits of x, 0 < bits <= 128. */
inline u128 low(u128 x, int bits) {
    return bits >= 128 ? x : x & (((u128)1 << bits) - 1);
}

/* The low `bits` bits of x as two's complement. */
inline i128 sign(u128 x, int bits) {
    return (i128)(x << (128 - bits)) >> (128 - bits); /* arithmetic in gcc and clang */
}

/* splitmix64; the seed is hashed, or those of neighbouring seeds would be one shifted stream. */
class Random {
  public:
    explicit Random(uint64_t seed) : state(hash(seed * GOLDEN + 1)) {}

    uint64_t next() { return hash(state += GOLDEN); }
    /* 0 .. n-1 */
    uint64_t below(uint64_t n) { return next() % n; }
    bool percent(unsigned p) { return below(100) < p; }
    int64_t between(int64_t first, int64_t last) {
        return first + (int64_t)below((uint64_t)(last - first) + 1);
    }
    /* uniform over all words of `bits` bits */
    u128 bits(int bits) { return low((u128)next() << 64 | next(), bits); }
    int64_t sbits(int n) { return (int64_t)sign(bits(n), n); }
    /* every bit length equally likely */
    u128 log_bits(int n) {
        int length = (int)below((uint64_t)n + 1);
        return length ? (u128)1 << (length - 1) | low(bits(n), length - 1) : 0;
    }
    int64_t log_sbits(int n) {
        int64_t x = (int64_t)log_bits(n - 1);
        return next() & 1 ? ~x : x;
    }
    /* ends, zero, one, alternating bits, one bit, runs of ones (TestFloat's patterns) */
    u128 corner(int n) {
        switch (below(8)) {
        case 0:
            return 0;
        case 1:
            return low(~(u128)0, n);
        case 2:
            return 1;
        case 3:
            return (u128)1 << (n - 1);
        case 4:
            return low((u128)1 << (n - 1), n) - 1;
        case 5:
            return low((u128)0x5555555555555555u << 64 | 0x5555555555555555u, n) << below(2);
        case 6:
            return (u128)1 << below((uint64_t)n);
        default:
            return low(~(u128)0, 1 + (int)below((uint64_t)n));
        }
    }
    /* a mix of all of the above: for operands without structure */
    u128 mixed(int n) {
        uint64_t how = below(8);
        return low(how < 2 ? corner(n) : how < 4 ? log_bits(n) : bits(n), n);
    }
    int64_t smixed(int n) {
        int64_t x = (int64_t)sign(mixed(n), n);
        return next() & 1 || x == -((int64_t)1 << (n - 1)) ? x : -x;
    }

  private:
    static constexpr uint64_t GOLDEN = 0x9e3779b97f4a7c15u;
    uint64_t state;

    static uint64_t hash(uint64_t z) {
        z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
        z = (z ^ z >> 27) * 0x94d049bb133111ebu;
        return z ^ z >> 31;
    }
};

/* Reads and writes ports of up to 128 bits; set masks to the port's width, get does not extend. */
template <class Port> u128 get(const Port &port) {
    if constexpr (std::is_integral<Port>::value) {
        return (u128)port;
    } else {
        u128 x = 0;
        for (int i = (int)(sizeof port / 4) - 1; i >= 0; i--)
            x = x << 32 | port[i];
        return x;
    }
}

template <class Port> void set(Port &port, int bits, i128 value) {
    u128 x = low((u128)value, bits);
    if constexpr (std::is_integral<Port>::value) {
        port = (Port)x;
    } else {
        for (int i = 0; i < (int)(sizeof port / 4); i++)
            port[i] = (uint32_t)(x >> (32 * i));
    }
}

inline void print_value(const char *name, i128 value, int bits) {
    u128 x = low((u128)value, bits);
    char digits[48];
    int at = 47;
    u128 magnitude = value < 0 ? -(u128)value : (u128)value;
    digits[at] = 0;
    do
        digits[--at] = (char)('0' + (int)(magnitude % 10)), magnitude /= 10;
    while (magnitude);
    if (value < 0) digits[--at] = '-';
    if (x >> 64)
        printf("#   %-16s 0x%llx%016llx  %s\n", name, (unsigned long long)(x >> 64),
               (unsigned long long)x, digits + at);
    else
        printf("#   %-16s 0x%llx  %s\n", name, (unsigned long long)x, digits + at);
}

/* Fields of bundles, at the low bit and bits that the names of bundles.h stand for:
 * put(dut.hit_i, RT_HIT_SLOT, 3), get(dut.ray_o, RT_RAY_A). At most 128 bits. */
template <class Port> u128 get(const Port &port, int lsb, int bits) {
    if constexpr (std::is_integral<Port>::value) {
        return low((u128)port >> lsb, bits);
    } else {
        u128 x = 0;
        for (int i = bits - 1; i >= 0; i--)
            x = x << 1 | (port[(lsb + i) / 32] >> (lsb + i) % 32 & 1);
        return x;
    }
}

template <class Port> void put(Port &port, int lsb, int bits, i128 value) {
    if constexpr (std::is_integral<Port>::value) {
        u128 mask = low(~(u128)0, bits) << lsb;
        port = (Port)(((u128)port & ~mask) | ((u128)value << lsb & mask));
    } else {
        for (int i = 0; i < bits; i++) {
            uint32_t bit = 1u << (lsb + i) % 32;
            auto &word = port[(lsb + i) / 32];
            word = (u128)value >> i & 1 ? word | bit : word & ~bit;
        }
    }
}

/* Noise in a whole bundle, before the fields that a module reads are put into it. */
template <class Port> void noise(Port &port, int bits, Random &random) {
    for (int lsb = 0; lsb < bits; lsb += 32)
        put(port, lsb, std::min(32, bits - lsb), (i128)random.next());
}

template <class Top> class Bench {
  public:
    Top dut;
    Random random;
    uint64_t seed, cycle = 0;
    long vectors, target, mismatches = 0;
    bool all_vectors; /* as many as the bench has by default */

    Bench(const char *name, int argc, char **argv, long default_vectors = 200000)
        : random(test_number(argc > 1 ? argv[1] : nullptr, "argument 1", 1)),
          seed(test_number(argc > 1 ? argv[1] : nullptr, "argument 1", 1)), vectors(0),
          target((long)test_number(argc > 2 ? argv[2] : nullptr, "vectors",
                                   (uint64_t)default_vectors)),
          all_vectors(argc <= 2), title(name) {
        dut.clk = 0;
        dut.eval();
    }

    /* One clock: inputs set before are taken, outputs read after are those of the new cycle. */
    void tick() {
        dut.clk = 1;
        dut.eval();
        dut.clk = 0;
        dut.eval();
        cycle++;
    }
    /* Lets combinational outputs follow the inputs. */
    void settle() { dut.eval(); }
    /* Holds rst, for modules that have one. */
    void reset(uint64_t clocks = 4) {
        dut.rst = 1;
        for (; clocks; clocks--)
            tick();
        dut.rst = 0;
        dut.eval();
    }
    /* Whether vectors are still to be checked; a bench that hangs ends after 1000 clocks a vector,
     * with BENCH_FIRST in the environment also after the first mismatch. */
    bool more() {
        if (cycle > 1000 * (uint64_t)(target + 100)) fail("no result: the module hangs");
        return vectors < target && !hangs && !(mismatches && first);
    }
    template <class Port> static u128 get(const Port &port) { return bench::get(port); }
    template <class Port> static i128 sget(const Port &port, int bits) {
        return sign(bench::get(port), bits);
    }
    template <class Port> static void set(Port &port, int bits, i128 value) {
        bench::set(port, bits, value);
    }
    /* Compares one output; prints only in the first vector that differs. */
    bool expect(const char *what, i128 actual, i128 expected, int bits = 128) {
        if (actual == expected) return true;
        if (!mismatches) {
            if (!vector_bad) heading();
            printf("# %s\n", what);
            print_value("expected", expected, bits);
            print_value("actual", actual, bits);
        }
        vector_bad = true;
        return false;
    }
    /* True while the first mismatch is being reported: print the inputs then. */
    bool bad() const { return vector_bad && !mismatches; }
    void show(const char *what, i128 value, int bits) const { print_value(what, value, bits); }
    /* Ends the checks of one vector. */
    void done() {
        vectors++;
        mismatches += vector_bad;
        vector_bad = false;
    }
    /* A failure that is no vector's; ends the bench. */
    void fail(const char *text) {
        if (!hangs) printf("# %s, cycle %llu\n", text, (unsigned long long)cycle);
        if (!mismatches) repeat();
        mismatches++;
        hangs = true;
    }
    bool failed() const { return hangs; }
    /* Runs a pipeline of fixed latency with in_valid_i, in_ready_o (or without), in_tag_i and
     * out_...: first the corners (an array or a vector), then what make(random) returns, with
     * random gaps, and now and then a reset, behind which nothing comes out. send(v) sets the other
     * inputs of a Vector, which has members tag and taken; check(v) compares the outputs. A vector
     * must not wait for more than `interval` clocks. */
    template <class Corners, class Make, class Send, class Check>
    void stream(const Corners &corners, Make make, int tag_bits, uint64_t latency,
                uint64_t interval, Send send, Check check) {
        using Vector = std::decay_t<decltype(corners[0])>;
        std::queue<Vector> sent;
        Vector v{};
        size_t corner = 0;
        uint64_t last = 0;
        unsigned gaps = 0; /* percent of idle clocks */
        dut.in_valid_i = 0;
        reset();
        while (more()) {
            if (random.percent(1)) gaps = (unsigned)random.below(3) * 30;
            if (random.below(5000) == 0) {
                dut.in_valid_i = 0;
                reset(1 + random.below(3));
                if (dut.out_valid_o) fail("out_valid_o behind a reset");
                sent = {};
                last = cycle;
            }
            if (!dut.in_valid_i) { /* without valid: inputs that must not matter */
                v = corner < std::size(corners) ? corners[corner] : make(random);
                v.tag = (uint64_t)random.bits(tag_bits);
                set(dut.in_tag_i, tag_bits, (i128)v.tag);
                send(v);
                dut.in_valid_i = !random.percent(gaps);
                corner += dut.in_valid_i;
            }
            settle();
            bool taken = dut.in_valid_i && ready(dut, 0);
            if (taken) {
                v.taken = cycle;
                sent.push(v);
            }
            if (!dut.in_valid_i || ready(dut, 0)) last = cycle;
            if (cycle - last >= interval) fail("in_ready_o is low for too long");
            tick();
            if (taken) dut.in_valid_i = 0;
            if (!dut.out_valid_o) continue;
            if (sent.empty()) {
                fail("a result that nothing asked for");
                continue;
            }
            const Vector e = sent.front();
            sent.pop();
            expect("latency", cycle - e.taken, latency);
            expect("out_tag_o", get(dut.out_tag_o), e.tag);
            check(e);
            done();
        }
        if (all_vectors && corner < std::size(corners)) fail("not all corners were driven");
    }
    /* What a bench need not have for phases(). */
    void phase() {}
    void compare() {}
    /* Prints the TAP line; the exit status of main. */
    int finish() {
        dut.final();
        if (mismatches)
            printf("not ok %s %s seed %llu: %ld of %ld vectors differ\n", title, PROFILE,
                   (unsigned long long)seed, mismatches, vectors);
        else
            printf("ok %s %s seed %llu: %ld vectors\n", title, PROFILE, (unsigned long long)seed,
                   vectors);
        return mismatches != 0;
    }

  private:
    /* in_ready_o; a free-running pipeline has none and takes everything. */
    template <class T> static auto ready(const T &top, int) -> decltype(top.in_ready_o, bool()) {
        return top.in_ready_o;
    }
    template <class T> static bool ready(const T &, long) { return true; }

    const char *title;
    const bool first = getenv("BENCH_FIRST") != nullptr;
    bool vector_bad = false, hangs = false;

    void repeat() const {
        const char *alone = getenv("HARD_CASE"); /* tb/hard.h */
        printf("# repeat: %s%s%spython3 -m lab benches %s/%s %llu %ld\n", alone ? "HARD_CASE=" : "",
               alone ? alone : "", alone ? " " : "", title, PROFILE, (unsigned long long)seed,
               target);
    }
    void heading() const {
        printf("# %s %s: vector %ld, cycle %llu\n", title, PROFILE, vectors,
               (unsigned long long)cycle);
        repeat();
    }
};

/* Traffic in phases, until all vectors are checked: phase() begins one; clock(true) may give new
 * work, for `least` to `most` clocks; clock(false) gives none, until all_idle(), which must be so
 * after `longest` clocks; compare() looks at what the phase added up. `lost` says what is missing
 * if it is not so. */
template <class Block>
void phases(Block &b, int64_t least, int64_t most, uint64_t longest, const char *lost) {
    while (b.more()) {
        b.phase();
        for (int64_t i = b.random.between(least, most); i && b.more(); i--)
            b.clock(true);
        uint64_t since = b.cycle;
        while (!b.all_idle() && !b.failed() && b.cycle - since < longest)
            b.clock(false);
        if (b.failed()) return; /* in a clock that did not end, perhaps: cycle stays as it is */
        if (!b.all_idle()) return b.fail(lost);
        b.compare();
    }
}

} // namespace bench

#endif
