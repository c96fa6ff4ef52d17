/* tb_texture.cpp - rt_texture against sph_path_add() and sph_lookup()
 * SPDX-License-Identifier: Apache-2.0
 *
 * Every slot follows a pixel: rays, their hits, surfaces with and without texture. Memory holds
 * sound and broken records, headers and texels; it answers late and in bursts. A vector is a
 * surface; in between the word of a pixel is read. Now and then a reset ends all that is under way.
 * The model's cache, given what the unit asks of its cache and what memory answers, says in which
 * clocks miss_o must be high.
 */
#include <deque>
#include <memory>
#include <vector>

#include "Vrt_texture.h"
#include "Vrt_texture___024root.h"
#include "bench.h"
#include "bundles.h"
#include "cache_prediction.h"
#include "texture_memory.h"

extern "C" {
#include "texture/texel.h"
#include "texture/lod.h"
#include "texture/lookup.h"
}

using bench::i128;
using bench::u128;

namespace {

struct sph_profile profile() {
    struct sph_profile p = {};
    p.w = W;
    p.wd = WD;
    p.ng = NG;
    return p;
}

struct Slot {
    enum { IDLE, TOLD, SENT, DONE } state; /* TOLD: all but the token is there */
    bool primary, again;                   /* another ray of the pixel follows */
    uint64_t path;
    int spread;
    uint32_t bend; /* of the surface before; of this one it is told */
    struct sph_textured where;
    struct sph_texture_work work;
    uint32_t map, kr, albedo, expected;
};

bool under_way(const std::vector<Slot> &slots) {
    for (const Slot &s : slots)
        if (s.state == Slot::TOLD || s.state == Slot::SENT) return true;
    return false;
}

u128 pack(const int64_t v[3], int bits) {
    u128 x = 0;
    for (int i = 2; i >= 0; i--)
        x = x << bits | bench::low((u128)v[i], bits);
    return x;
}

/* The unit, its memory, and the pixel that each slot follows. */
class Run {
  public:
    Run(int argc, char **argv)
        : b("tb_texture", argc, argv, 6000), shape(t.rootp->rt_texture__DOT__cache_shape),
          requests(t.rootp->rt_texture__DOT__cache_asked),
          seen(t.rootp->rt_texture__DOT__u_cache__DOT__seen) {
        memory.fill(b.random);
        bench::put(t.regs_i, RT_REGS_MEM_LINES, LINES_IN_MEMORY);
        reset();
    }

    /* A clock; 0 at the end. Texels were counted when their surfaces were told, so those that are
     * under way go on to their end. */
    bool clock() {
        more = b.more();
        if (more) last = b.cycle;
        if (!more && (!under_way(slots) || b.cycle > last + 20000)) return false;
        if (more && b.cycle % 256 == 200 && b.random.percent(40)) reset();
        if (b.cycle % 2048 == 0) {
            pace = b.random.percent(40) ? 100 : (unsigned)b.random.between(5, 60);
            reading = b.random.percent(40) ? 100 : (unsigned)b.random.between(5, 60);
            latency = (unsigned)b.random.below(4) * 20;
        }
        registers();
        int told = tell(), in = token(), word = ask_word();
        drive_memory();
        b.settle();
        take_requests();
        if (t.path_valid_o) check_path();
        if (t.out_valid_o) surface();
        read_material();
        if (told >= 0) slots[(size_t)told].state = Slot::TOLD;
        if (in >= 0) slots[(size_t)in].state = Slot::SENT;
        b.tick();
        if (word >= 0) read_word(word);
        word_slot = word;
        return true;
    }

    int finish() {
        if (texels != texels_asked) {
            printf("# %llu texels expected, %llu asked for\n", (unsigned long long)texels,
                   (unsigned long long)texels_asked);
            b.fail("another number of texels");
        }
        if (bad_node != (errors != 0)) b.fail("bad_node_o does not say what the model says");
        return b.finish();
    }

  private:
    /* Whatever is under way is forgotten. */
    void reset() {
        t.in_valid_i = t.word_read_i = t.mem_rsp_valid_i = t.mem_req_ready_i = t.flush_i = 0;
        b.reset();
        for (int i = 0; i < 2 * SLOTS; i++)
            b.tick();
        slots = std::vector<Slot>(SLOTS);
        asked.clear();
        texels = texels_asked;
        must_miss = false, drain = true;
        word_slot = material_slot = -1;
        prediction = std::make_unique<CachePrediction>(shape >> 16, shape >> 8 & 255, shape & 255);
    }

    struct Line {
        uint32_t line;
        uint64_t when;
    };
    bench::Bench<Vrt_texture> b;
    Vrt_texture &t = b.dut;
    const struct sph_profile p = profile();
    Memory memory;
    struct sph_machine &m = memory.machine;
    std::vector<Slot> slots = std::vector<Slot>(SLOTS);
    std::deque<Line> asked;
    uint64_t texels = 0, texels_asked = 0, last = 0;
    uint32_t errors = 0, material = 0;
    bool bad_node = false, drain = true, on = true, more = true, must_miss = false;
    unsigned pace = 100, latency = 3, reading = 100;
    const uint32_t shape, &requests;
    const uint8_t &seen;
    std::unique_ptr<CachePrediction> prediction;
    int word_slot = -1, material_slot = -1;

    /* Registers change, and the cache is flushed, while nothing is inside. */
    void registers() {
        bool idle = true;
        for (const Slot &s : slots)
            idle &= s.state == Slot::IDLE;
        if (b.cycle % 4096 == 4000) drain = true;
        t.flush_i = 0;
        if (!drain || !idle) return;
        drain = false;
        on = b.random.percent(90);
        bench::put(t.regs_i, RT_REGS_EFFECTS, on ? 1 << SPH_EFFECT_TEXTURE : 0);
        m.regs[SPH_REG_TEX_FILTER] = (int32_t)b.random.below(SPH_FILTERS);
        bench::put(t.regs_i, RT_REGS_TEX_FILTER, m.regs[SPH_REG_TEX_FILTER]);
        t.flush_i = 1;
    }

    /* A slot is told of a ray, its hit and the surface; its number, or -1. */
    int tell() {
        int at = (int)b.random.below(SLOTS);
        Slot &s = slots[(size_t)at];
        bool told = more && s.state == Slot::IDLE && (!drain || s.again) &&
                    b.random.percent(pace) && !t.flush_i && at != word_slot;
        bench::put(t.ray_i, RT_RAY_VALID, told);
        bench::put(t.hit_i, RT_HIT_HIT, told);
        bench::put(t.material_i, RT_MATERIAL_VALID, told);
        bench::put(t.surface_i, RT_SURFACE_VALID, told);
        if (!told) return -1;
        struct sph_ray ray = {};
        uint64_t key = (uint64_t)b.random.mixed(W + WD + 2);
        ray.unit.y = (uint32_t)b.random.between(65535, 131071);
        ray.unit.h = (int)b.random.below(WD);
        s.primary = !s.again;
        s.again = b.random.percent(40);
        if (s.primary) {
            s.path = 0;
            s.spread = 0, s.bend = 0;
            s.work = {};
            s.work.lod = SPH_LOD_NONE;
        }
        s.spread = sph_spread(s.path, s.spread, s.bend);
        s.path = sph_path_add(&p, &ray, key, s.path, s.spread);
        uint32_t bend = (uint32_t)b.random.below(64);
        s.bend = SPREAD && b.random.percent(80) ? bend : 0;
        choose(s);
        expect(s);
        bench::put(t.ray_i, RT_RAY_SLOT, at);
        bench::put(t.ray_i, RT_RAY_PRIMARY, s.primary);
        bench::put(t.ray_i, RT_RAY_Y, ray.unit.y);
        bench::put(t.ray_i, RT_RAY_H, ray.unit.h);
        bench::put(t.hit_i, RT_HIT_SLOT, at);
        bench::put(t.hit_i, RT_HIT_KEY, (i128)key);
        bench::put(t.hit_i, RT_HIT_FAR, s.where.far);
        bench::put(t.material_i, RT_MATERIAL_SLOT, at);
        bench::put(t.material_i, RT_MATERIAL_RGB, s.albedo);
        bench::put(t.material_i, RT_MATERIAL_KR, s.kr);
        bench::put(t.material_i, RT_MATERIAL_TEX, s.map);
        bench::put(t.material_i, RT_MATERIAL_BEND, SPREAD ? s.bend : bend);
        bench::put(t.surface_i, RT_SURFACE_SLOT, at);
        bench::put(t.surface_i, RT_SURFACE_GUARDED, (i128)pack(s.where.guarded, W + NG));
        return at;
    }

    /* Where the ray hits, and what the surface is. */
    void choose(Slot &s) {
        s.where.path = s.path;
        s.where.far = b.random.percent(30);
        int64_t v[3];
        for (int i = 0; i < 3; i++) {
            s.where.guarded[i] = b.random.smixed(W + NG);
            v[i] = b.random.percent(10) ? 0 : b.random.smixed(WD);
        }
        struct sph_unit unit = sph_unit(v, (uint64_t)(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]), WD);
        for (int i = 0; i < 3; i++)
            s.where.unit[i] = unit.u[i];
        s.map = b.random.percent(20)  ? 0
                : b.random.percent(2) ? (uint32_t)b.random.bits(26)
                : b.random.percent(2) ? LINES_IN_MEMORY - 6 + (uint32_t)b.random.below(9)
                                      : 1 + (uint32_t)b.random.below(MAPS);
        s.kr = (uint32_t)b.random.below(257);
        s.albedo = (uint32_t)b.random.mixed(24);
    }

    /* What the model makes of it. */
    void expect(Slot &s) {
        uint32_t tint = ~0u;
        if (on && s.map) tint = sph_lookup(&m, s.map, &s.where, &s.work);
        s.expected = 0;
        for (int c = 0; c < 3; c++)
            s.expected |= sph_texture_albedo(s.albedo >> 8 * c & 255, tint >> 8 * c & 255) << 8 * c;
        texels += s.work.texels;
        s.work.texels = 0;
        errors |= s.work.errors;
    }

    /* The token of a slot that was told; its number, or -1. */
    int token() {
        int in = (int)b.random.below(SLOTS);
        t.in_valid_i = slots[(size_t)in].state == Slot::TOLD;
        if (!t.in_valid_i) return -1;
        int64_t unit[3];
        for (int i = 0; i < 3; i++)
            unit[i] = slots[(size_t)in].where.unit[i];
        t.in_slot_i = (uint8_t)in;
        bench::put(t.ray_i, RT_RAY_UNIT, (i128)pack(unit, 18));
        return in;
    }

    /* The word of a pixel that ended is read; its slot, or -1. */
    int ask_word() {
        int word = (int)b.random.below(SLOTS);
        t.word_read_i = slots[(size_t)word].state == Slot::DONE && word_slot < 0;
        t.word_slot_i = (uint8_t)word;
        return t.word_read_i ? word : -1;
    }

    void drive_memory() {
        t.mem_req_ready_i = b.random.percent(reading);
        t.mem_rsp_valid_i =
            !asked.empty() && asked.front().when <= b.cycle && b.random.percent(reading);
        if (!asked.empty())
            for (int i = 0; i < 8; i++)
                t.mem_rsp_data_i[i] = memory.words[asked.front().line * SPH_LINE_WORDS + i];
    }

    void take_requests() {
        if (t.mem_req_valid_o && t.mem_req_ready_i) {
            if (t.mem_req_line_o >= LINES_IN_MEMORY)
                b.fail("a line behind the end of memory is asked for");
            else
                asked.push_back({t.mem_req_line_o, b.cycle + latency});
        }
        if (t.mem_rsp_valid_i && t.mem_rsp_ready_o) asked.pop_front();
        texels_asked += t.texel_o;
        if (t.miss_o != must_miss) b.fail("another miss than the model's");
        must_miss = prediction->texture(requests, seen);
        if (prediction->impossible()) b.fail("a lookup that the model refuses");
        bad_node |= t.bad_node_o;
        if (t.bus_error_o) b.fail("a bus error that nobody made");
    }

    void check_path() {
        const Slot &s = slots[t.path_slot_o];
        if (s.state != Slot::SENT) return b.fail("a path that nobody sent");
        b.expect("path_o", (i128)b.get(t.path_o),
                 (i128)((uint64_t)s.bend << (W + 12) | (uint64_t)s.spread << (W + 8) | s.path),
                 W + 18);
        if (b.bad()) b.show("slot", t.path_slot_o, 8);
    }

    void surface() {
        int out_slot = t.out_slot_o;
        Slot &o = slots[(size_t)out_slot];
        if (o.state != Slot::SENT) {
            b.fail("a surface that nobody sent");
        } else if (material_slot != out_slot) {
            b.fail("no material a clock before the surface");
        } else {
            b.expect("albedo_o", material, o.expected, 24);
            if (b.bad()) {
                b.show("slot", out_slot, 8);
                b.show("map", o.map, 26);
                b.show("filter", m.regs[SPH_REG_TEX_FILTER], 2);
                b.show("path", (i128)o.path, W + 8);
                b.show("lod", o.work.lod, 12);
            }
            b.done();
        }
        o.state = o.again ? Slot::IDLE : Slot::DONE;
    }

    /* The material of the surface that comes a clock later. */
    void read_material() {
        material_slot = -1;
        if (!bench::get(t.albedo_o, RT_ALBEDO_VALID)) return;
        material_slot = (int)bench::get(t.albedo_o, RT_ALBEDO_SLOT);
        material = (uint32_t)bench::get(t.albedo_o, RT_ALBEDO_RGB);
        if (bench::get(t.albedo_o, RT_ALBEDO_KR) != slots[(size_t)material_slot].kr)
            b.fail("another surface's mirror");
    }

    void read_word(int slot) {
        const Slot &o = slots[(size_t)slot];
        b.expect("word_o", (i128)b.get(t.word_o), (i128)((uint64_t)o.work.lod << 20 | o.work.words),
                 32);
        if (b.bad()) b.show("slot", slot, 8);
        slots[(size_t)slot].state = Slot::IDLE;
    }
};

} // namespace

int main(int argc, char **argv) {
    Run run(argc, argv);
    while (run.clock())
        ;
    return run.finish();
}
