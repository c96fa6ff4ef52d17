/* tb_bih_ray.cpp - rt_bih_ray against sph_bih_setup()
 * SPDX-License-Identifier: Apache-2.0
 *
 * Slots live at random: a ray is written, its token comes some clocks later (or, of a light that
 * needs no shadow ray, never: the next ray overwrites it), six words and a start must follow. A
 * vector is a start. First come the ends of directions; a direction of no length comes again and
 * again, since each divider has to take it.
 */
#include <vector>
#include "Vrt_bih_ray.h"
#include "bench.h"
extern "C" {
#include "machine/layout.h"
#include "trace/bih.h"
}

namespace {

constexpr int64_t D_MAX = ((int64_t)1 << (WD - 1)) - 1;
constexpr uint64_t PATIENCE = 4000; /* clocks until a ray has started */
const sph_profile profile = {PROFILE, W, WD, 0, 0, 0, 0};

struct Slot {
    enum { FREE, WRITTEN, STARTED } state = FREE;
    sph_ray ray{};
    bool pixel = false, shadow = false;
    uint64_t since = 0; /* clock in which it started */
    int words = 0;      /* of this ray, bit i: place on axis i, bit 3 + i: pace */
    bench::u128 place[3] = {0, 0, 0}, pace[3] = {0, 0, 0};
};

const int64_t ends[] = {0, 1, -1, 2, -2, D_MAX, -D_MAX, -D_MAX - 1, D_MAX / 2, 3};

sph_ray make(bench::Random &random, unsigned n) {
    sph_ray ray{};
    do
        for (int i = 0; i < 3; i++) {
            ray.dir[i] = n < 1000             ? ends[n % 10]
                         : random.percent(50) ? random.smixed(WD)
                                              : random.log_sbits(WD);
            ray.org[i] = random.smixed(W);
            n = n < 1000 ? n / 10 : n;
        }
    while (n >= 1000 && n % 64 && !ray.dir[0] && !ray.dir[1] && !ray.dir[2]);
    if (n >= 1000 && n % 64 == 0) ray.dir[0] = ray.dir[1] = ray.dir[2] = 0;
    for (int64_t d : ray.dir)
        ray.a += (uint64_t)(d * d);
    return ray;
}

bench::u128 place(const sph_ray &ray, const sph_bih_axis &x, int i) {
    bench::u128 w = bench::low((bench::u128)(bench::i128)ray.org[i], W);
    return w << 2 | (unsigned)x.negative << 1 | (unsigned)x.zero;
}
bench::u128 pace(const sph_bih_axis &x) {
    unsigned shift = x.shift < 0 ? 64 : (unsigned)x.shift;
    return (bench::u128)shift << SPH_BIH_G | x.mant;
}

using Bench = bench::Bench<Vrt_bih_ray>;

void give(Bench &b, const sph_ray &ray, size_t at) {
    b.dut.new_valid_i = 1;
    b.set(b.dut.new_slot_i, SLOTW, (bench::i128)at);
    bench::u128 org = 0, dir = 0;
    for (int i = 2; i >= 0; i--) {
        org = org << W | bench::low((bench::u128)(bench::i128)ray.org[i], W);
        dir = dir << WD | bench::low((bench::u128)(bench::i128)ray.dir[i], WD);
    }
    b.set(b.dut.new_org_i, 3 * W, (bench::i128)org);
    b.set(b.dut.new_dir_i, 3 * WD, (bench::i128)dir);
    b.set(b.dut.new_a_i, 2 * WD, (bench::i128)ray.a);
}

void compare(Bench &b, const Slot &t) {
    b.expect("a ray that waits", t.state, Slot::STARTED);
    b.expect("words written", t.words, 63);
    b.expect("start_pixel_o", b.dut.start_pixel_o, t.pixel);
    sph_bih_ray bih;
    sph_bih_setup(&profile, &t.ray, &bih);
    for (int i = 0; i < 3; i++) {
        const sph_bih_axis &x = bih.axis[i];
        b.expect("place_o", (bench::i128)t.place[i], (bench::i128)place(t.ray, x, i));
        if (!x.zero) b.expect("pace_o", (bench::i128)t.pace[i], (bench::i128)pace(x));
    }
    if (b.bad())
        for (int i = 0; i < 3; i++)
            b.show("dir", t.ray.dir[i], WD);
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_bih_ray> b("tb_bih_ray", argc, argv, 20000);
    std::vector<Slot> slots(SLOTS);
    unsigned made = 0;
    unsigned load = 30; /* percent of clocks with a new ray */
    b.reset();
    while (b.more()) {
        if (b.random.percent(1)) load = (unsigned)b.random.below(4) * 20;
        b.dut.new_valid_i = b.dut.go_valid_i = b.dut.shadow_go_i = 0;
        b.dut.start_ready_i = !b.random.percent(20);
        size_t at = b.random.below(SLOTS);
        Slot &s = slots[at];
        if (s.state == Slot::WRITTEN && b.random.percent(50)) {
            s.state = Slot::STARTED;
            s.words = 0;
            s.since = b.cycle;
            if (s.shadow) {
                b.dut.shadow_go_i = 1;
                b.set(b.dut.shadow_slot_i, SLOTW, (bench::i128)at);
            } else {
                b.dut.go_valid_i = 1;
                b.set(b.dut.go_slot_i, SLOTW, (bench::i128)at);
                b.dut.go_pixel_i = s.pixel;
            }
        } else if (s.state == Slot::FREE && b.random.percent(load)) {
            s.state = Slot::WRITTEN;
            s.ray = make(b.random, made++);
            s.shadow = SHADOW && b.random.percent(40);
            s.pixel = !s.shadow && b.random.percent(50);
            if (s.shadow && b.random.percent(20)) s.state = Slot::FREE; /* a light without */
            give(b, s.ray, at);
        }
        if (s.state == Slot::STARTED && b.cycle - s.since > PATIENCE) b.fail("a ray is lost");
        b.settle();
        bool start = b.dut.start_valid_o && b.dut.start_ready_i;
        if (start) {
            size_t n = (size_t)b.get(b.dut.start_slot_o);
            Slot &t = slots[n];
            compare(b, t);
            t.state = Slot::FREE;
            b.done();
        }
        if (b.dut.place_valid_o) {
            Slot &t = slots[(size_t)b.get(b.dut.place_slot_o)];
            t.words |= 1 << b.dut.place_axis_o;
            t.place[b.dut.place_axis_o] = b.get(b.dut.place_o);
        }
        if (b.dut.pace_valid_o) {
            Slot &t = slots[(size_t)b.get(b.dut.pace_slot_o)];
            t.words |= 8 << b.dut.pace_axis_o;
            t.pace[b.dut.pace_axis_o] = b.get(b.dut.pace_o);
        }
        b.tick();
    }
    printf("# %.1f clocks a ray\n", (double)b.cycle / (double)b.vectors);
    return b.finish();
}
