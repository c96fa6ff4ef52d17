/* frame_rays.h - rays, and frames of nodes mostly before them, for tb_box_axis.cpp and tb_box.cpp
 * SPDX-License-Identifier: Apache-2.0
 *
 * A ray is as sph_bih_setup() makes it. A frame has any step; its origin is mostly where the ray
 * comes by, at some distance, less than its size away.
 */
#ifndef FRAME_RAYS_H
#define FRAME_RAYS_H

#include <algorithm>
#include <cstdlib>
#include "bench.h"
extern "C" {
#include "machine/layout.h"
#include "trace/bih.h"
}

namespace frames {

constexpr int ORG_BITS = SPH_FRAME_ORG_X_BITS;
constexpr int64_t ORG_MAX = (1 << (ORG_BITS - 1)) - 1;

struct Vector {
    sph_ray ray{};
    sph_bih_ray bih{};
    int32_t org[3] = {0, 0, 0}; /* as the node has them */
    uint8_t step[3] = {0, 0, 0};
    unsigned code[3] = {0, 0, 0}; /* the cell where the ray comes by */
    sph_box_axis axes[3]{};
};

inline Vector make(bench::Random &random, const sph_profile &p) {
    Vector v;
    sph_box_frame frame{};
    v.ray.kind = SPH_PRIMARY;
    for (int i = 0; i < 3; i++) {
        v.ray.dir[i] = random.percent(10)   ? 0
                       : random.percent(50) ? random.sbits(p.wd)
                                            : random.log_sbits(p.wd);
        v.ray.org[i] = random.smixed(p.w);
        v.ray.a += (uint64_t)(v.ray.dir[i] * v.ray.dir[i]);
    }
    int64_t way = (int64_t)random.log_bits(p.w + 4); /* in 2^-8 of the direction */
    const int64_t end = (int64_t)1 << (p.w - 1);
    for (int i = 0; i < 3; i++) /* to where it is on the grid, mostly */
        while (random.percent(95) && std::abs(v.ray.org[i] + (v.ray.dir[i] * way >> 8)) > end)
            way >>= 1;
    int size = (int)random.below(16);
    for (int i = 0; i < 3; i++) {
        int step = random.percent(80) ? size : (int)random.below(16);
        int64_t at = v.ray.org[i] + (v.ray.dir[i] * way >> 8);
        v.code[i] = random.below(SPH_BOX_CODES);
        at -= (int64_t)v.code[i] << (step + sph_frame_step_shift(&p));
        at = std::clamp(at >> sph_frame_org_shift(&p), -ORG_MAX - 1, ORG_MAX);
        if (random.percent(5)) at = random.smixed(ORG_BITS);
        v.org[i] = (int32_t)at;
        v.step[i] = (uint8_t)step;
        frame.org[i] = v.org[i] * (1 << sph_frame_org_shift(&p));
        frame.step[i] = (uint8_t)(step + sph_frame_step_shift(&p));
    }
    sph_bih_setup(&p, &v.ray, &v.bih);
    sph_box_axes(&p, &v.bih, &v.ray, &frame, v.axes);
    return v;
}

} // namespace frames

#endif
