/* tb_shares.cpp - rt_shares, rt_share inside, against sph_shading_light() and sph_shares_add()
 * SPDX-License-Identifier: Apache-2.0
 *
 * Every slot follows a pixel: surfaces and background one after another, each with a material,
 * light and highlights, found by a ray of some weight and depth. A vector is a surface that is
 * blended; its pixel's frames are read after it.
 */
#include "Vrt_shares.h"
#include "bench.h"
#define W 16 /* of bundles that this module has no part in */
#define WD 17
#define NG 2
#define FW 14
#include "bundles.h"

extern "C" {
#include "shade/colour.h"
#include "shade/material.h"
}

#ifndef SUM
#define SUM 1
#endif
#ifndef SPECULAR
#define SPECULAR 1
#endif
#ifndef REFRACT
#define REFRACT 1
#endif
#ifndef REFLECT
#define REFLECT 5
#endif

namespace {

using bench::i128;
using bench::u128;

constexpr int DEEPEST = REFRACT && REFLECT < SPH_REFRACT_DEPTH ? SPH_REFRACT_DEPTH : REFLECT;

struct Slot {
    enum { IDLE, TOLD, INSIDE, READ } state = IDLE; /* TOLD: all but the surface itself */
    bool fresh = true, background = false;          /* the first surface of its pixel */
    struct sph_shading shading = {};
    uint32_t lights[3] = {}, gloss[3] = {}, kr = 0, albedo = 0;
    uint32_t weight = 65536;
    int depth = 0;
    struct sph_shares shares = {};
    /* what must come out */
    uint32_t out_kr = 0, out_kt = 0, total = 0;
};

class Shares : public bench::Bench<Vrt_shares> {
  public:
    Shares(int argc, char **argv) : Bench("tb_shares", argc, argv, 20000) {}

    /* Nothing is under way. */
    void phase() {
        effects = (uint32_t)random.bits(SPH_EFFECT_BITS);
        dut.effects_i = (decltype(dut.effects_i))effects;
        max_depth = (int)random.below(DEEPEST + 1);
        dut.max_depth_i = (uint8_t)max_depth;
        least = random.percent(50) ? 0 : (uint32_t)random.below(257);
        dut.least_i = (uint16_t)least;
        for (uint32_t &a : ambient)
            a = (uint32_t)random.mixed(16);
        set(dut.ambient_i, 48,
            (i128)((u128)ambient[2] << 32 | (u128)ambient[1] << 16 | ambient[0]));
    }

    void clock(bool start) {
        tell(start);
        read();
        settle();
        bool taken = entering >= 0 && dut.in_valid_i && dut.in_ready_o;
        if (bench::get(dut.blend_o, RT_BLEND_VALID)) check_blend();
        int frames = dut.frames_read_i ? (int)dut.frames_slot_i : -1;
        int asked = dut.read_i ? (int)dut.read_slot_i : -1;
        tick();
        if (taken) {
            slots[entering].state = Slot::INSIDE;
            entering = -1;
            dut.in_valid_i = 0;
        }
        if (asked >= 0) enter(asked);
        if (frames >= 0) check_frames(frames);
    }

    bool all_idle() const {
        for (const Slot &s : slots)
            if (s.state != Slot::IDLE) return false;
        return true;
    }

  private:
    Slot slots[SLOTS];
    uint32_t effects = 0, least = 0, ambient[3] = {};
    int max_depth = 0, entering = -1;

    int on(int effect) const { return effects >> effect & 1; }

    /* Material, highlights and the weight of the ray of a slot. */
    void tell(bool start) {
        int at = (int)random.below(SLOTS);
        Slot &s = slots[at];
        bool now = start && s.state == Slot::IDLE;
        bench::put(dut.material_i, RT_MATERIAL_VALID, now);
        dut.gloss_valid_i = now;
        dut.next_valid_i = now;
        if (!now) return;
        s.fresh = random.percent(40);
        if (s.fresh) s.shares = {};
        s.weight = s.fresh ? 65536 : (uint32_t)random.below(65537);
        s.depth = s.fresh ? 0 : (int)random.between(1, DEEPEST);
        s.background = !s.fresh && random.percent(20);
        auto part = [&] { return random.percent(20) ? 256u : (uint32_t)random.below(257); };
        uint32_t kt = random.percent(50) ? 0 : part(), ka = part(), kd = part();
        uint32_t ks = random.percent(30) ? 0 : (uint32_t)random.bits(8);
        bool sum = random.percent(60);
        s.kr = random.percent(50) ? 0 : part();
        s.albedo = (uint32_t)random.mixed(24);
        u128 gloss = 0;
        for (int i = 0; i < 3; i++) {
            s.lights[i] = (uint32_t)random.mixed(17);
            s.gloss[i] = (uint32_t)random.mixed(17);
            gloss |= (u128)s.gloss[i] << 17 * i;
        }
        bench::put(dut.material_i, RT_MATERIAL_SLOT, at);
        bench::put(dut.material_i, RT_MATERIAL_KT, kt);
        bench::put(dut.material_i, RT_MATERIAL_SUM, sum);
        bench::put(dut.material_i, RT_MATERIAL_KA, ka);
        bench::put(dut.material_i, RT_MATERIAL_KD, kd);
        bench::put(dut.material_i, RT_MATERIAL_KS, ks);
        dut.gloss_slot_i = dut.next_slot_i = (uint8_t)at;
        set(dut.gloss_i, 51, (i128)gloss);
        /* of no matter to the first surface of a pixel */
        dut.next_weight_i = s.fresh ? (uint32_t)random.bits(16) : s.weight;
        dut.next_depth_i = (uint8_t)(s.fresh ? (int)random.below(DEEPEST + 1) : s.depth);
        /* what the model makes of it */
        bool rays = !s.background && s.depth != max_depth;
        s.shading = {};
        s.shading.sum = SUM && on(SPH_EFFECT_SUM) && sum && !s.background;
        s.shading.ka = s.shading.sum ? ka : 256;
        s.shading.kd = s.shading.sum ? kd : 256;
        s.shading.ks = s.shading.sum && SPECULAR && on(SPH_EFFECT_SPECULAR) ? ks : 0;
        s.out_kr = rays && on(SPH_EFFECT_REFLECT) ? s.kr : 0;
        s.out_kt = rays && REFRACT && on(SPH_EFFECT_REFRACT) ? kt : 0;
        s.out_kr = sph_shading_worth(s.weight, s.out_kr, least);
        s.out_kt = sph_shading_worth(s.weight, s.out_kt, least);
        s.total = s.out_kr + s.out_kt < 256 ? s.out_kr + s.out_kt : 256;
        uint32_t colour[3];
        for (int i = 0; i < 3; i++) {
            uint32_t albedo = s.albedo >> 8 * i & 255;
            uint32_t lit =
                SUM ? sph_shading_light(&s.shading, ambient[i], s.lights[i]) : s.lights[i];
            uint32_t all =
                sph_surface_colour(albedo, lit) + sph_surface_colour(s.shading.ks, s.gloss[i]);
            colour[i] = s.background ? albedo << 8 : all < 65280 ? all : 65280;
        }
        uint32_t own = sph_share(s.weight, sph_shading_own(&s.shading, s.out_kr, s.out_kt));
        sph_shares_add(&s.shares, s.depth, s.weight, own, colour);
        s.state = Slot::TOLD;
    }

    /* Reads a slot for its surface, which enters a clock later; or the frames of one. */
    void read() {
        int at = (int)random.below(SLOTS);
        dut.read_i = entering < 0 && slots[at].state == Slot::TOLD &&
                     !(dut.gloss_valid_i && dut.gloss_slot_i == at);
        dut.read_slot_i = (uint8_t)at;
        int from = (int)random.below(SLOTS);
        dut.frames_read_i = slots[from].state == Slot::READ;
        dut.frames_slot_i = (uint8_t)from;
    }

    void enter(int at) {
        const Slot &s = slots[at];
        u128 light = 0;
        for (int i = 0; i < 3; i++)
            light |= (u128)s.lights[i] << 17 * i;
        entering = at;
        dut.in_valid_i = 1;
        dut.in_first_i = s.fresh;
        dut.in_slot_i = (uint8_t)at;
        dut.in_background_i = s.background;
        dut.in_albedo_i = s.albedo;
        dut.in_kr_i = (uint16_t)(s.background ? 0 : s.kr);
        dut.in_probe_i = 0;
        set(dut.in_light_i, 51, (i128)light);
    }

    void check_blend() {
        int at = (int)bench::get(dut.blend_o, RT_BLEND_SLOT);
        Slot &s = slots[at];
        if (s.state != Slot::INSIDE) return fail("a surface that did not enter");
        auto field = [&](const char *what, int lsb, int bits, uint32_t expected) {
            expect(what, (i128)bench::get(dut.blend_o, lsb, bits), expected, bits);
        };
        field("MIRROR", RT_BLEND_MIRROR, s.out_kr != 0);
        field("REFRACT", RT_BLEND_REFRACT, s.out_kt != 0);
        field("LAST", RT_BLEND_LAST, !s.out_kr && !s.out_kt);
        field("DEPTH", RT_BLEND_DEPTH, (uint32_t)s.depth);
        if (s.out_kr) field("W_MIRROR", RT_BLEND_W_MIRROR, sph_share(s.weight, s.out_kr));
        if (s.out_kt) field("W_REFRACT", RT_BLEND_W_REFRACT, sph_share(s.weight, s.out_kt));
        if (s.out_kt) field("W_TOTAL", RT_BLEND_W_TOTAL, sph_share(s.weight, s.total));
        s.state = Slot::READ;
        if (bad()) explain(at);
    }

    void check_frames(int at) {
        Slot &s = slots[at];
        for (int i = 0; i < SPH_FRAMES; i++)
            expect("frames_o", (i128)(get(dut.frames_o) >> 24 * i & 0xffffff),
                   sph_shares_colour(&s.shares, i), 24);
        if (bad()) explain(at);
        s.state = Slot::IDLE;
        done();
    }

    void explain(int at) {
        const Slot &s = slots[at];
        show("slot", at, SLOTW), show("weight", s.weight, 17), show("depth", s.depth, 4);
        show("effects_i", effects, SPH_EFFECT_BITS), show("background", s.background, 1);
        show("sum", s.shading.sum, 1), show("kr", s.out_kr, 9), show("kt", s.out_kt, 9);
    }
};

} // namespace

int main(int argc, char **argv) {
    Shares b(argc, argv);
    b.dut.in_valid_i = 0;
    b.phase();
    b.reset();
    bench::phases(b, 1000, 5000, 20000, "a surface got lost");
    return b.finish();
}
