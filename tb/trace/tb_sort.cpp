/* tb_sort.cpp - rt_sort against a stable sort
 * SPDX-License-Identifier: Apache-2.0
 */
#include <algorithm>
#include <queue>
#include <vector>

#include "Vrt_sort.h"
#include "bench.h"

namespace {

constexpr size_t LATENCY = 2;

struct Vector {
    unsigned hit;
    int near[4]; /* s16 */
};

/* Every order of four depths, ties included, from the ends and around 0, with every set of hits:
 * 4^4 * 2^4 vectors. */
constexpr long CORNERS = 4096;
constexpr int ENDS[4] = {-32768, -1, 0, 32767};

Vector make(bench::Random &random, long number) {
    Vector v{};
    v.hit = (unsigned)(number < CORNERS ? number >> 8 : random.bits(4));
    int middle = (int)random.sbits(16);
    bool close = random.percent(60); /* many ties */
    for (int i = 0; i < 4; i++)
        v.near[i] = number < CORNERS ? ENDS[number >> 2 * i & 3]
                    : close ? std::clamp(middle + (int)random.between(-1, 1), -32768, 32767)
                            : (int)random.smixed(16);
    return v;
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_sort> b("tb_sort", argc, argv);
    std::queue<Vector> sent;
    for (long number = 0; b.more(); number++) {
        const Vector v = make(b.random, number);
        bench::u128 near = 0;
        for (int i = 3; i >= 0; i--)
            near = near << 16 | (uint16_t)v.near[i];
        if (b.random.percent(10)) { /* a clock without a node */
            b.dut.in_valid_i = 0;
            b.set(b.dut.hit_i, 4, (bench::i128)b.random.next());
            b.set(b.dut.near_i, 64, (bench::i128)b.random.next());
            b.tick();
        }
        b.dut.in_valid_i = 1;
        b.set(b.dut.hit_i, 4, v.hit);
        b.set(b.dut.near_i, 64, (bench::i128)near);
        sent.push(v);
        b.tick();
        if (sent.size() < LATENCY) continue;
        const Vector e = sent.front();
        sent.pop();
        std::vector<int> list;
        for (int i = 0; i < 4; i++)
            if (e.hit >> i & 1) list.push_back(i);
        std::stable_sort(list.begin(), list.end(),
                         [&](int i, int j) { return e.near[i] < e.near[j]; });
        b.expect("count_o", b.get(b.dut.count_o), list.size(), 3);
        for (size_t i = 0; i < list.size(); i++) {
            bench::u128 entry = b.get(b.dut.list_o) >> 18 * i;
            b.expect("list_o child", entry & 3, list[i], 2);
            b.expect("list_o near", bench::sign(entry >> 2, 16), e.near[list[i]], 16);
        }
        if (b.bad()) {
            b.show("hit_i", e.hit, 4);
            for (int i = 0; i < 4; i++)
                b.show("near_i", e.near[i], 16);
        }
        b.done();
    }
    return b.finish();
}
