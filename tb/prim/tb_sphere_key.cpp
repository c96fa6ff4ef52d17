/* tb_sphere_key.cpp - rt_sphere_key, and rt_isqrt inside it, against sph_leaf_key_bits()
 * SPDX-License-Identifier: Apache-2.0
 *
 * The hits of tests/hard come first. Keys come in the order of their hits, each in the clock that
 * rt_isqrt names, and hits are taken as often as it says. Without INSIDE in_far_i must not matter.
 */
#include <deque>
#include <vector>

#include "Vrt_sphere_key.h"
#include "bench.h"
#include "hard.h"

extern "C" {
#include "math/arith.h"
#include "prim/sphere.h"
}

using bench::i128;

namespace {

constexpr int XW = 2 * W + 2 * WD, KW = W + WD + 2;
constexpr i128 RMAX = ((i128)1 << (XW / 2)) - 1; /* largest root */
constexpr i128 XMAX = ((i128)1 << XW) - 1;
constexpr int64_t BMAX = ((int64_t)1 << (KW - 1)) - 1;

struct Vector {
    i128 disc;
    int64_t b;
    int far;
    hard::Case hard{};
};

const Vector corners[] = {
    {1, 2, 0},                               /* smallest root, smallest key */
    {1, 0, 1},                               /* the same from inside: no inexact */
    {2, 2, 0},                               /* root 1, inexact: near does not mind */
    {2, -1, 1},                              /* far rounds up: key 1 */
    {3, -1, 1},                              /* just below a square: key 1 */
    {4, -1, 1},                              /* a square: key 1 by the root alone */
    {XMAX, BMAX, 0},                         /* every bit set */
    {XMAX, BMAX, 1},                         /* longest sum */
    {RMAX * RMAX, BMAX, 1},                  /* largest square: exact */
    {RMAX * RMAX - 1, BMAX, 1},              /* one less: root and inexact change */
    {RMAX * RMAX + 1, BMAX, 1},              /* one more: only inexact does */
    {RMAX * RMAX, (int64_t)RMAX + 1, 0},     /* long subtraction, key 1 */
    {RMAX * RMAX, 1 - (int64_t)RMAX, 1},     /* long negative b, key 1 */
    {XMAX, -(int64_t)RMAX, 1},               /* key 1 by inexact alone */
    {(i128)1 << (XW - 1), BMAX, 0},          /* only the top bit, half a square */
    {(i128)1 << (XW - 2), BMAX, 1},          /* only one bit: a square */
    {((i128)1 << (XW - 2)) - 1, BMAX, 1},    /* runs of ones below it */
    {(RMAX / 2) * (RMAX / 2 + 1), BMAX, 1},  /* between two squares */
    {(RMAX / 3) * (RMAX / 3), BMAX, 0},      /* alternating bits in the root */
    {(RMAX / 3 * 2) * (RMAX / 3 * 2), 2, 1}, /* the other ones */
};

Vector make(bench::Random &random) {
    Vector v{};
    i128 root = (i128)random.mixed(XW / 2);
    v.far = random.percent(50);
    switch (random.below(4)) {
    case 0: /* a square and what is beside it */
        v.disc = root * root + random.between(-1, 1);
        break;
    case 1: /* the last of a root, and the next */
        v.disc = root * root + 2 * root + random.between(-1, 2);
        break;
    default:
        v.disc = (i128)random.mixed(XW);
        break;
    }
    if (v.disc < 1 || v.disc > XMAX) v.disc = 1;
    int inexact;
    int64_t exact = (int64_t)sph_isqrt((bench::u128)v.disc, &inexact); /* PR: keys below 1 too */
    int64_t key = (int64_t)random.log_bits(KW - 2) + 1;
    v.b = v.far ? key - exact - inexact : key + exact;
    if (v.far && random.percent(20)) { /* a key of 0, of the root as it is cut, and beside it */
        struct sph_leaf_result r = {};
        uint64_t roots = 0;
        r.hit = r.far = 1;
        r.disc = v.disc;
        v.b = random.between(-1, 1) - (int64_t)sph_leaf_key_bits(&r, PR, &roots);
    }
    if (v.b > BMAX) v.b = BMAX;
    return v;
}

using Bench = bench::Bench<Vrt_sphere_key>;

/* What is tried first: the corners, then the hits of tests/hard. */
std::vector<Vector> vectors(Bench &b) {
    std::vector<Vector> directed;
    if (!hard::alone()) directed.assign(std::begin(corners), std::end(corners));
    hard::Source source(
        b.seed, [](const sph_profile &p) { return p.w == W && p.wd == WD; },
        [](const hard::Case &c) { return c.is_ray && c.disc && c.key; });
    source.limit(b);
    for (Vector d{}; source.next(d.hard);) {
        d.disc = (i128)d.hard.disc;
        d.b = d.hard.result.b;
        d.far = d.hard.result.far;
        directed.push_back(d);
    }
    source.report(b);
    return directed;
}

/* A hit that was taken: its tag, and the clock of its key. */
struct Sent {
    Vector v;
    int tag;
    uint64_t due;
};

void compare(Bench &b, const Sent &sent) {
    const Vector &e = sent.v;
    struct sph_leaf_result r = {};
    uint64_t roots = 0;
    r.hit = 1;
    r.far = INSIDE && e.far;
    r.disc = e.disc;
    r.b = e.b;
    b.expect("out_tag_o", b.get(b.dut.out_tag_o), sent.tag, TAG);
    b.expect("out_key_o", b.get(b.dut.out_key_o),
             (i128)bench::low(sph_leaf_key_bits(&r, PR, &roots), KW), KW);
    b.expect("out_far_o", b.dut.out_far_o, r.far, 1);
    if (b.bad()) {
        e.hard.show();
        b.show("in_disc_i", e.disc, XW);
        b.show("in_b_i", e.b, KW);
        b.show("in_far_i", e.far, 1);
    }
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_sphere_key> b("tb_sphere_key", argc, argv, 100000);
    std::vector<Vector> directed = vectors(b);
    constexpr int ROUNDS = (XW / 2 + STEP - 1) / STEP, INTERVAL = ROUNDS / STAGES + 1;
    std::deque<Sent> under_way;
    Vector v{};
    int tag = 0;
    uint64_t free = 0; /* the clock from which a hit is taken */
    size_t corner = 0;
    unsigned gaps = 0; /* percent of clocks without input */
    b.dut.in_valid_i = 0;
    b.reset();
    while (b.more()) {
        if (b.random.percent(1)) gaps = (unsigned)b.random.below(3) * 48;
        if (!b.dut.in_valid_i) { /* without valid: inputs that must not matter */
            if (hard::alone())   /* keys come late: the first hits once more behind the last */
                v = directed[corner % directed.size()];
            else
                v = corner < directed.size() ? directed[corner] : make(b.random);
            tag = (int)b.random.below(1 << TAG);
            b.set(b.dut.in_tag_i, TAG, tag);
            b.set(b.dut.in_disc_i, XW, v.disc);
            b.set(b.dut.in_b_i, KW, v.b);
            b.dut.in_far_i = (uint8_t)v.far;
            b.dut.in_valid_i = !b.random.percent(gaps);
            corner += b.dut.in_valid_i;
        }
        b.settle();
        if (b.dut.in_ready_o != (b.cycle >= free)) b.fail("in_ready_o: not each INTERVAL clocks");
        bool due = !under_way.empty() && b.cycle == under_way.front().due;
        if (b.dut.out_valid_o != due) b.fail("out_valid_o: not ROUNDS + 1 clocks behind its hit");
        if (due) {
            compare(b, under_way.front());
            under_way.pop_front();
            b.done();
        }
        if (b.dut.in_valid_i && b.dut.in_ready_o) {
            under_way.push_back({v, tag, b.cycle + ROUNDS + 1});
            free = b.cycle + INTERVAL;
            b.tick();
            b.dut.in_valid_i = 0;
        } else {
            b.tick();
        }
    }
    return b.finish();
}
