/* tb_slot_ram.cpp - rt_slot_ram against an array of words
 * SPDX-License-Identifier: Apache-2.0
 *
 * tb_slot_ram [seed] [cycles per phase]
 *
 * Each phase writes and reads with odds of its own, to few words or to all. Checked in every cycle:
 * the word read last, which is held while nothing is read whatever is written; with OLD 1 also when
 * the word that is read is being written, which with OLD 0 stops the simulation and is not done.
 */
#include <cstdio>
#include <cstdlib>
#include <type_traits>
#include <vector>
#include "Vrt_slot_ram.h"
#include "bench.h"
extern "C" {
#include "tests/number.h"
}

namespace {

static_assert(WIDTH <= 64, "the bench compares words of at most 64 bits");
using Word = std::remove_reference_t<decltype(Vrt_slot_ram::wr_data_i)>;
constexpr uint64_t MASK = WIDTH < 64 ? (1ull << (WIDTH % 64)) - 1 : ~0ull;

struct Phase {
    const char *name;
    int write, read; /* percent of cycles */
    int words;       /* that are used */
};

struct Bench {
    bench::Random random;
    Vrt_slot_ram top;
    std::vector<uint64_t> model = std::vector<uint64_t>(SLOTS);
    uint64_t held = 0, collisions = 0, kept = 0;

    explicit Bench(uint64_t seed) : random(seed << 32) {
        for (int i = 0; i <= SLOTS; i++) /* every word, then the first one is read */
            step(i < SLOTS, i % SLOTS, random.next() & MASK, i == SLOTS, 0);
    }

    void step(bool write, int at, uint64_t word, bool read, int from) {
        top.wr_en_i = write;
        top.wr_addr_i = static_cast<uint8_t>(at);
        top.wr_data_i = static_cast<Word>(word);
        top.rd_en_i = read;
        top.rd_addr_i = static_cast<uint8_t>(from);
        top.clk = 0;
        top.eval();
        top.clk = 1;
        top.eval();
        collisions += write && read && at == from;
        kept += !read;
        if (read) held = model[static_cast<size_t>(from)];
        if (write) model[static_cast<size_t>(at)] = word;
    }

    bool run(const Phase &phase, uint64_t cycles);
};

bool Bench::run(const Phase &phase, uint64_t cycles) {
    const auto words = static_cast<uint64_t>(phase.words);
    for (uint64_t c = 0; c < cycles; c++) {
        const bool read = random.percent(phase.read);
        const int from = static_cast<int>(random.below(words));
        int at = static_cast<int>(random.below(words));
        bool write = random.percent(phase.write);
        if (OLD && random.percent(20)) at = from;
        if (!OLD && read && at == from) write = false;
        step(write, at, random.next() & MASK, read, from);
        if (top.rd_data_o == held && !Verilated::gotFinish()) continue;
        printf("# cycle %llu of %s: word %llx, expected %llx\n", static_cast<unsigned long long>(c),
               phase.name, static_cast<unsigned long long>(top.rd_data_o),
               static_cast<unsigned long long>(held));
        return false;
    }
    return true;
}

} // namespace

int main(int argc, char **argv) {
    const uint64_t seed = test_number(argc > 1 ? argv[1] : nullptr, "argument 1", 1);
    const uint64_t n = test_number(argc > 2 ? argv[2] : nullptr, "argument 2", 20000);
    Bench bench(seed);
    const Phase phases[] = {
        {"both at times", 50, 50, SLOTS}, {"two words", 70, 70, 2},
        {"both always", 100, 100, SLOTS}, {"few reads", 90, 10, SLOTS},
        {"few writes", 5, 95, SLOTS},
    };
    bool good = true;
    for (const Phase &phase : phases)
        good = good && bench.run(phase, n);
    printf("%sok tb_slot_ram %s seed %llu: %llu cycles without a read, %llu collisions\n",
           good ? "" : "not ", PROFILE, static_cast<unsigned long long>(seed),
           static_cast<unsigned long long>(bench.kept),
           static_cast<unsigned long long>(bench.collisions));
    return good ? 0 : 1;
}
