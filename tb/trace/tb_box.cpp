/* tb_box.cpp - rt_box against sph_box_meets()
 * SPDX-License-Identifier: Apache-2.0
 *
 * A vector is a ray in a frame, of frame_rays.h, and the planes of a child, of any size, some of
 * which it leaves where it enters. The limit is far away or near the depth at which the ray enters.
 */
#include <deque>
#include "Vrt_box.h"
#include "frame_rays.h"

namespace {

constexpr size_t LATENCY = 6;
constexpr int SW = SPH_BOX_CROSS + 9, CROSS = SPH_BOX_CROSS, CODE = SPH_BOX_LO_X_BITS;
constexpr int32_t FAR = 0x7fff;
const sph_profile profile = {PROFILE, W, WD, 0, 0, 0, 0};

struct Vector {
    frames::Vector frame;
    sph_box_planes planes{};
    bool in = false; /* however far away */
    int32_t near = 0, limit = 0;
};

/* Moves the axis by which the ray enters last, so that it leaves where it enters, or beside that.
 */
void touch(bench::Random &random, Vector &v) {
    int64_t first = 0, last = SPH_BOX_BEYOND;
    sph_box_axis *at = nullptr;
    for (int i = 0; i < 3; i++) {
        sph_box_axis &x = v.frame.axes[i];
        const int lo = v.planes.lo[i], hi = v.planes.hi[i], end = SPH_BOX_CODES - 1;
        const int64_t enter = x.enter + ((x.back ? end - hi : lo) * x.step >> x.fine);
        const int64_t leave = x.leave + ((x.back ? end - lo : hi) * (x.step + 2) >> x.fine);
        if (!x.flat && enter > first) first = enter, at = &x;
        if (!x.open && leave < last) last = leave;
    }
    if (at && last > 0) at->enter += (int32_t)(last - first + random.between(-1, 1));
}

Vector make(bench::Random &random) {
    Vector v;
    v.frame = frames::make(random, profile);
    const int size = (int)random.below(SPH_BOX_LO_X_BITS + 1);
    for (int i = 0; i < 3; i++) {
        const int64_t at = random.percent(5) ? random.below(SPH_BOX_CODES) : v.frame.code[i];
        v.planes.lo[i] = (uint8_t)std::max<int64_t>(at - (int64_t)random.log_bits(size), 0);
        v.planes.hi[i] =
            (uint8_t)std::min<int64_t>(at + (int64_t)random.log_bits(size), SPH_BOX_CODES - 1);
    }
    if (random.percent(20)) touch(random, v);
    v.in = sph_box_meets(v.frame.axes, &v.frame.ray, &v.planes, FAR, &v.near);
    v.limit = random.percent(40) ? FAR : (int32_t)random.log_bits(15);
    if (random.percent(40)) v.limit = std::clamp(v.near + (int32_t)random.between(-1, 1), 0, FAR);
    return v;
}

void send(bench::Bench<Vrt_box> &b, const Vector &v) {
    bench::u128 near = 0, far = 0, step = 0, more = 0;
    for (int i = 2; i >= 0; i--) {
        const sph_box_axis &x = v.frame.axes[i];
        const unsigned flip = x.back ? SPH_BOX_CODES - 1 : 0;
        near = near << CODE | ((x.back ? v.planes.hi[i] : v.planes.lo[i]) ^ flip);
        far = far << CODE | ((x.back ? v.planes.lo[i] : v.planes.hi[i]) ^ flip);
        step = step << CROSS | (unsigned)x.step;
        more = more << (CROSS + 1) | (unsigned)(x.step + 2);
    }
    b.set(b.dut.in_near_i, 3 * CODE, (bench::i128)near);
    b.set(b.dut.in_far_i, 3 * CODE, (bench::i128)far);
    b.set(b.dut.in_step_i, 3 * CROSS, (bench::i128)step);
    b.set(b.dut.in_more_i, 3 * CROSS + 3, (bench::i128)more);
}

/* A clock later. */
void send_late(bench::Bench<Vrt_box> &b, const Vector &v) {
    bench::u128 enter = 0, leave = 0;
    unsigned fine = 0, flat = 0, open = 0;
    for (int i = 2; i >= 0; i--) {
        const sph_box_axis &x = v.frame.axes[i];
        enter = enter << SW | bench::low((bench::u128)(bench::i128)x.enter, SW);
        leave = leave << SW | bench::low((bench::u128)(bench::i128)x.leave, SW);
        fine = fine << 1 | (x.fine ? 1 : 0);
        flat = flat << 1 | (x.flat ? 1 : 0);
        open = open << 1 | (x.open ? 1 : 0);
    }
    b.set(b.dut.late_enter_i, 3 * SW, (bench::i128)enter);
    b.set(b.dut.late_leave_i, 3 * SW, (bench::i128)leave);
    b.dut.late_fine_i = (uint8_t)fine;
    b.dut.late_flat_i = (uint8_t)flat;
    b.dut.late_open_i = (uint8_t)open;
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_box> b("tb_box", argc, argv, 60000);
    std::deque<Vector> sent;
    long met = 0;
    while (b.more()) {
        if (!sent.empty()) send_late(b, sent.back());
        sent.push_back(make(b.random));
        send(b, sent.back());
        b.dut.in_limit_i = (uint16_t)sent.front().limit;
        b.tick();
        if (sent.size() < LATENCY) continue;
        const Vector v = sent.front();
        sent.pop_front();
        b.expect("out_pass_o", b.dut.out_pass_o, v.in && v.near <= v.limit, 1);
        b.expect("out_near_o", b.dut.out_near_o, v.near, 15);
        met += v.in;
        if (b.bad())
            for (int i = 0; i < 3; i++) {
                b.show("enter", v.frame.axes[i].enter, SW);
                b.show("leave", v.frame.axes[i].leave, SW);
                b.show("step", v.frame.axes[i].step, CROSS);
                b.show("lo", v.planes.lo[i], CODE);
                b.show("hi", v.planes.hi[i], CODE);
            }
        b.done();
    }
    if (b.all_vectors && 8 * met < b.vectors) b.fail("too few boxes are met");
    return b.finish();
}
