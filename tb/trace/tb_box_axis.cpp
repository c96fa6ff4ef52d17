/* tb_box_axis.cpp - rt_box_axis against sph_box_axes()
 * SPDX-License-Identifier: Apache-2.0
 *
 * A vector is one axis of a ray and of a frame, of frame_rays.h.
 */
#include <deque>
#include "Vrt_box_axis.h"
#include "frame_rays.h"

namespace {

constexpr size_t BACK = 6, STEP = 7, LATENCY = 8;
constexpr int SW = SPH_BOX_CROSS + 9;
const sph_profile profile = {PROFILE, W, WD, 0, 0, 0, 0};

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_box_axis> b("tb_box_axis", argc, argv, 60000);
    std::deque<frames::Vector> sent; /* axis x of each */
    long open = 0;
    while (b.more()) {
        sent.push_back(frames::make(b.random, profile));
        const frames::Vector &v = sent.back();
        const sph_bih_axis &x = v.bih.axis[0];
        const unsigned shift = x.shift < 0 ? 64 : (unsigned)x.shift;
        b.set(b.dut.in_org_i, frames::ORG_BITS, v.org[0]);
        b.dut.in_step_i = v.step[0];
        b.set(b.dut.in_place_i, W + 2, v.ray.org[0] * 4 + (x.negative ? 2 : 0) + (x.zero ? 1 : 0));
        b.dut.in_pace_i = shift << SPH_BIH_G | x.mant;
        b.tick();
        const size_t n = sent.size();
        if (n >= BACK) b.expect("back_o", b.dut.back_o, sent[n - BACK].axes[0].back, 1);
        if (n >= STEP) {
            b.expect("step_o", b.dut.step_o, sent[n - STEP].axes[0].step, SPH_BOX_CROSS);
            b.expect("more_o", b.dut.more_o, sent[n - STEP].axes[0].step + 2, SPH_BOX_CROSS + 1);
        }
        if (n < LATENCY) continue;
        const frames::Vector w = sent.front();
        const sph_box_axis &a = w.axes[0];
        sent.pop_front();
        b.expect("out_enter_o", b.get(b.dut.out_enter_o), bench::low((bench::u128)a.enter, SW), SW);
        b.expect("out_leave_o", b.get(b.dut.out_leave_o), bench::low((bench::u128)a.leave, SW), SW);
        b.expect("out_fine_o", b.dut.out_fine_o, a.fine != 0, 1);
        b.expect("out_flat_o", b.dut.out_flat_o, a.flat, 1);
        b.expect("out_open_o", b.dut.out_open_o, a.open, 1);
        open += a.open;
        if (b.bad()) {
            b.show("org", w.ray.org[0], W);
            b.show("dir", w.ray.dir[0], WD);
            b.show("frame", w.org[0], frames::ORG_BITS);
            b.show("step", w.step[0], 4);
            b.show("shift", w.bih.axis[0].shift, 8);
            b.show("mant", w.bih.axis[0].mant, SPH_BIH_G);
        }
        b.done();
    }
    if (b.all_vectors && (10 * open < b.vectors || 10 * open > 9 * b.vectors))
        b.fail("too few or too many axes are open");
    return b.finish();
}
