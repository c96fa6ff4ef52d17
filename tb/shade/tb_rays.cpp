/* tb_rays.cpp - rt_rays, rt_refract inside, against the order of rays in path() of the model
 * SPDX-License-Identifier: Apache-2.0
 *
 * Every slot follows a pixel: surfaces are blended one after another, each with a mirrored ray, a
 * refracted one, both or none, until nothing waits. sph_refract() says where refracted rays go. A
 * vector is a ray that leaves, or the end of a pixel.
 */
#include "Vrt_rays.h"
#include "engine/world.h"

extern "C" {
#include "shade/refract.h"
#include "texture/lod.h"
#include "trace/setup.h"
}

#ifndef PATHS
#define PATHS (W + 8)
#endif
#ifndef DEEPEST
#define DEEPEST 5
#endif

namespace {

using bench::i128;
using bench::u128;

struct Branch { /* a refracted ray that goes, or waits */
    u128 dir, point;
    uint32_t skip; /* {inside, id} */
    uint32_t weight;
    int depth;
    uint64_t path;
};

struct Slot {
    enum { IDLE, TOLD, BLENDED } state = IDLE; /* TOLD: all but the blend is there */
    int depth = 0;
    std::vector<Branch> waiting;
    struct sph_ray ray = {};
    struct sph_surface surface = {};
    int far = 0;
    uint32_t id = 0, index = 0;
    uint64_t path = 0;
    /* what must leave it */
    enum { MIRROR, REFRACT, END } next = END;
    Branch goes = {};
    uint32_t weight = 0; /* of a mirrored ray */
};

class Rays : public bench::Bench<Vrt_rays> {
  public:
    Rays(int argc, char **argv) : Bench("tb_rays", argc, argv, 20000) {}

    void clock(bool start) {
        tell(start);
        blend();
        dut.out_ready_i = random.percent(pace);
        settle();
        bool go = dut.out_valid_o && dut.out_ready_i;
        if (dut.mirror_valid_o + dut.end_valid_o + go > 1) fail("two things leave at once");
        int at = (int)dut.slot_o;
        if (dut.mirror_valid_o) leave(at, Slot::MIRROR);
        if (dut.end_valid_o) leave(at, Slot::END);
        if (go) leave(at, Slot::REFRACT);
        if (dut.next_valid_o != (dut.mirror_valid_o || go)) fail("next_valid_o is wrong");
        if (cycle % 1000 == 0) pace = random.percent(50) ? 100 : (unsigned)random.between(3, 60);
        tick();
    }

    bool all_idle() const {
        for (const Slot &s : slots)
            if (s.state != Slot::IDLE || s.depth) return false;
        return true;
    }

  private:
    const struct sph_profile p = {PROFILE, W, WD, PQ, NG, FW, PR};
    Slot slots[SLOTS];
    unsigned pace = 100;

    /* A slot is told of a ray, its hit, material, point, normal and path. */
    void tell(bool start) {
        int at = (int)random.below(SLOTS);
        Slot &s = slots[at];
        bool now = s.state == Slot::IDLE && (start || s.depth);
        normal(); /* that of the slot told a clock ago */
        bench::put(dut.ray_i, RT_RAY_VALID, now && held < 0);
        bench::put(dut.hit_i, RT_HIT_HIT, now && held < 0);
        bench::put(dut.material_i, RT_MATERIAL_VALID, now && held < 0);
        bench::put(dut.surface_i, RT_SURFACE_VALID, now && held < 0);
        dut.path_valid_i = now && held < 0;
        if (held >= 0) {
            slots[held].state = Slot::TOLD;
            held = -1;
            return;
        }
        if (!now) return;
        s.ray = {};
        s.surface = {};
        for (int i = 0; i < 3; i++) {
            s.ray.dir[i] = random.smixed(WD);
            s.surface.point[i] = random.percent(70) ? random.sbits(W) : random.smixed(W);
            s.surface.normal[i] = random.percent(80) ? random.sbits(WD) : random.smixed(WD - 3);
            s.surface.nn += (uint64_t)(s.surface.normal[i] * s.surface.normal[i]);
        }
        s.surface.flat = random.percent(50);
        if (random.percent(10)) { /* along an axis */
            int axis = (int)random.below(3);
            int64_t n = s.surface.normal[axis] |= 1;
            s.surface.normal[(axis + 1) % 3] = s.surface.normal[(axis + 2) % 3] = 0;
            s.surface.nn = (uint64_t)(n * n);
        }
        std::copy_n(s.surface.normal, 3, s.surface.side);
        sph_ray_setup(&p, &s.ray);
        s.surface.unit = sph_unit(s.surface.normal, s.surface.nn, WD);
        s.far = random.percent(40);
        s.id = (uint32_t)random.bits(24);
        s.index = (uint32_t)random.between(SPH_INDEX_MIN, SPH_INDEX_MAX);
        s.path = (uint64_t)random.bits(W + 18); /* {bend, spread, path} */
        if (random.percent(20)) s.path &= ((uint64_t)1 << (W + 12)) - 1;
        world::put_ray(dut.ray_i, at, s.ray);
        bench::put(dut.ray_i, RT_RAY_SHADOW, 0);
        bench::put(dut.hit_i, RT_HIT_SLOT, at);
        bench::put(dut.hit_i, RT_HIT_FAR, s.far);
        bench::put(dut.hit_i, RT_HIT_ID, s.id);
        bench::put(dut.material_i, RT_MATERIAL_SLOT, at);
        bench::put(dut.material_i, RT_MATERIAL_INDEX, s.index);
        bench::put(dut.surface_i, RT_SURFACE_SLOT, at);
        bench::put(dut.surface_i, RT_SURFACE_POINT, (i128)world::pack(s.surface.point, W));
        bench::put(dut.surface_i, RT_SURFACE_NORMAL, (i128)world::pack(s.surface.normal, WD));
        bench::put(dut.surface_i, RT_SURFACE_FLAT, s.surface.flat);
        dut.path_slot_i = (uint8_t)at;
        bench::set(dut.path_i, W + 18, (i128)s.path);
        held = at;
    }
    int held = -1; /* its normal comes in this clock */

    void normal() {
        bench::put(dut.ray_i, RT_RAY_NORMAL, held >= 0);
        if (held < 0) return;
        const Slot &s = slots[held];
        bench::put(dut.ray_i, RT_RAY_SLOT, held);
        bench::put(dut.ray_i, RT_RAY_DIR, (i128)world::pack(s.surface.normal, WD));
        bench::put(dut.ray_i, RT_RAY_A, (i128)s.surface.nn);
    }

    void blend() {
        int at = (int)random.below(SLOTS);
        Slot &s = slots[at];
        bool now = s.state == Slot::TOLD && at != held && random.percent(60);
        bench::put(dut.blend_i, RT_BLEND_VALID, now);
        if (!now) return;
        bool deep = s.depth == DEEPEST;
        bool mirror = !deep && random.percent(40), refract = !deep && random.percent(50);
        bool probe = !deep && !s.depth && random.percent(10);
        uint32_t weight[3]; /* mirrored, refracted, mirrored if all is reflected */
        for (uint32_t &w : weight)
            w = (uint32_t)random.below(65537);
        bench::put(dut.blend_i, RT_BLEND_SLOT, at);
        bench::put(dut.blend_i, RT_BLEND_LAST, !mirror && !refract);
        bench::put(dut.blend_i, RT_BLEND_PROBE, probe);
        bench::put(dut.blend_i, RT_BLEND_MIRROR, mirror);
        bench::put(dut.blend_i, RT_BLEND_REFRACT, refract);
        bench::put(dut.blend_i, RT_BLEND_DEPTH, s.depth);
        bench::put(dut.blend_i, RT_BLEND_W_MIRROR, weight[0]);
        bench::put(dut.blend_i, RT_BLEND_W_REFRACT, weight[1]);
        bench::put(dut.blend_i, RT_BLEND_W_TOTAL, weight[2]);
        s.state = Slot::BLENDED;
        if (!s.depth) s.waiting.clear();
        int64_t start[3];
        sph_surface_behind(&p, &s.surface, start);
        Branch bent = {0,         world::pack(start, W), (uint32_t)!s.far << 24 | s.id,
                       weight[1], s.depth + 1,           path_of(s)};
        int64_t dir[3] = {};
        uint32_t from = s.far ? s.index : SPH_INDEX_ONE, to = s.far ? SPH_INDEX_ONE : s.index;
        bool total = refract && !sph_refract(&p, &s.ray, &s.surface, from, to, dir);
        bent.dir = world::pack(dir, WD);
        s.weight = total ? weight[2] : weight[0];
        mirror |= total || probe;
        refract &= !total;
        if (mirror) {
            if (refract) s.waiting.push_back(bent);
            s.next = Slot::MIRROR;
        } else if (refract) {
            s.next = Slot::REFRACT;
            s.goes = bent;
        } else if (!s.waiting.empty()) {
            s.next = Slot::REFRACT;
            s.goes = s.waiting.back();
            s.waiting.pop_back();
        } else {
            s.next = Slot::END;
        }
    }

    /* What a refracted ray keeps of it. */
    static uint64_t path_of(const Slot &s) {
        if (PATHS <= W + 8) return s.path & (((uint64_t)1 << PATHS) - 1);
        uint64_t bend = sph_bend_through((uint32_t)(s.path >> (W + 12)), s.far);
        return bend << (W + 12) | (s.path & (((uint64_t)1 << (W + 12)) - 1));
    }

    void leave(int at, int what) {
        Slot &s = slots[at];
        if (s.state != Slot::BLENDED) return fail("a surface that was not blended");
        expect("what leaves: mirrored, refracted, none", what, s.next, 2);
        if (what == Slot::MIRROR) {
            expect("next_weight_o", dut.next_weight_o, s.weight, 17);
            expect("next_depth_o", dut.next_depth_o, s.depth + 1, 4);
        } else if (what == Slot::REFRACT) {
            expect("out_vec_o", (i128)get(dut.out_vec_o), (i128)s.goes.dir, 3 * WD);
            expect("out_point_o", (i128)get(dut.out_point_o), (i128)s.goes.point, 3 * W);
            expect("out_skip_o", dut.out_skip_o, s.goes.skip, 25);
            expect("out_path_o", (i128)get(dut.out_path_o), (i128)s.goes.path, W + 18);
            expect("next_weight_o", dut.next_weight_o, s.goes.weight, 17);
            expect("next_depth_o", dut.next_depth_o, s.goes.depth, 4);
        }
        if (bad()) show("slot", at, SLOTW), show("depth", s.depth, 4), show("far", s.far, 1);
        s.depth = what == Slot::END ? 0 : what == Slot::MIRROR ? s.depth + 1 : s.goes.depth;
        s.state = Slot::IDLE;
        done();
    }
};

} // namespace

int main(int argc, char **argv) {
    Rays b(argc, argv);
    b.reset();
    bench::phases(b, 1000, 5000, 100000, "a pixel got lost");
    return b.finish();
}
