/* tb_smooth.cpp - rt_smooth against sph_smooth_normal(), sph_surface_bend()
 * SPDX-License-Identifier: Apache-2.0
 *
 * Every slot asks for the record of its primitive, as rt_surface does, then has a surface; the
 * records come after a random time and in any order. A vector is a normal that leaves.
 */
#include "Vrt_smooth.h"
#include "bench.h"
#include "bundles.h"

extern "C" {
#include "machine/layout.h"
#include "shade/surface.h"
}

using bench::u128;

namespace {

const struct sph_profile profile = {PROFILE, W, WD, WD, NG, 12, 0};
constexpr int GW = W + NG;
constexpr uint32_t LINES = 1u << 26;

struct Slot {
    enum { IDLE, WANTS, ASKED, ARMED, BENT, FETCHED, DONE, GIVEN } state;
    uint32_t number, line, record[8];
    int64_t guarded[3], normal[3];
    int far, outside;
};

u128 pack(const int64_t v[3], int bits) {
    u128 x = 0;
    for (int i = 2; i >= 0; i--)
        x = x << bits | bench::low((u128)v[i], bits);
    return x;
}

class Run {
  public:
    Run(int argc, char **argv) : b("tb_smooth", argc, argv, 20000) {
        registers();
        bench::put(t.material_i, RT_MATERIAL_VALID, 0);
        bench::put(t.hit_i, RT_HIT_HIT, 0);
        bench::put(t.surface_i, RT_SURFACE_VALID, 0);
        bench::put(t.fetch_i, RT_FETCH_VALID, 0);
        bench::put(t.record_i, RT_RECORD_VALID, 0);
        t.fetch_ready_i = 0;
        b.reset();
    }

    bool clock() {
        if (!b.more()) return false;
        if (b.random.percent(1)) pace = b.random.percent(50) ? 100 : (unsigned)b.random.below(60);
        drain |= b.random.below(5000) == 0;
        bool idle = true;
        for (const Slot &s : slots)
            idle &= s.state == Slot::IDLE;
        if (drain && idle) {
            registers();
            drain = false;
        }
        give_fetch();
        give_surface();
        give_material();
        give_record();
        t.fetch_ready_i = b.random.percent(pace + 5);
        b.settle();
        bool asked = bench::get(t.fetch_i, RT_FETCH_VALID) && t.fetch_ready_o;
        bool given = bench::get(t.record_i, RT_RECORD_VALID);
        if (t.fetch_ready_i) take_fetch();
        check_record(given);
        check_normal();
        b.tick();
        if (asked) bench::put(t.fetch_i, RT_FETCH_VALID, 0);
        if (given) bench::put(t.record_i, RT_RECORD_VALID, 0);
        return true;
    }

    int finish() { return b.finish(); }

  private:
    bench::Bench<Vrt_smooth> b;
    Vrt_smooth &t = b.dut;
    Slot slots[SLOTS] = {};
    uint32_t base = 0, lines = 0;
    bool drain = false; /* the registers change while nothing is inside */
    unsigned pace = 100;
    int direct = -1, since = 8; /* slot of a surface of this clock; clocks since the last one */

    void registers() {
        base = (uint32_t)b.random.below(LINES / 2);
        lines = base + (uint32_t)b.random.below(1u << 24);
        bench::put(t.regs_i, RT_REGS_SMOOTH_BASE, base);
        bench::put(t.regs_i, RT_REGS_MEM_LINES, lines);
    }

    /* A slot in this state if there is one, looked for from a random one on. */
    int any(int state) {
        int from = (int)b.random.below(SLOTS), at = from;
        while (slots[at].state != state && (at + 1) % SLOTS != from)
            at = (at + 1) % SLOTS;
        return at;
    }

    /* A hit: its primitive's record is asked for, beside the side that it was hit on. */
    void give_fetch() {
        int at = (int)b.random.below(SLOTS);
        Slot &s = slots[at];
        bool now = !drain && s.state == Slot::IDLE && !bench::get(t.fetch_i, RT_FETCH_VALID);
        bench::put(t.hit_i, RT_HIT_HIT, now);
        if (!now) return;
        s.far = b.random.percent(40);
        bench::put(t.hit_i, RT_HIT_SLOT, at);
        bench::put(t.hit_i, RT_HIT_FAR, s.far);
        s.line = (uint32_t)b.random.below(LINES);
        bench::put(t.fetch_i, RT_FETCH_VALID, 1);
        bench::put(t.fetch_i, RT_FETCH_SLOT, at);
        bench::put(t.fetch_i, RT_FETCH_LINE, s.line);
        s.state = Slot::WANTS;
    }

    /* The number of a record: none, one in memory, or the first numbers behind its end. */
    void give_material() {
        int at = any(Slot::GIVEN);
        Slot &s = slots[at];
        bool now = s.state == Slot::GIVEN;
        bench::put(t.material_i, RT_MATERIAL_VALID, now);
        if (!now) return;
        uint32_t most = lines - base;
        s.number = b.random.percent(30)  ? 0
                   : b.random.percent(5) ? most + (uint32_t)b.random.below(3)
                                         : 1 + (uint32_t)b.random.below(most + 1);
        s.number &= 0xffffff;
        s.outside = s.number > most;
        bench::put(t.material_i, RT_MATERIAL_SLOT, at);
        bench::put(t.material_i, RT_MATERIAL_SMOOTH, s.number);
        s.state = Slot::ARMED;
    }

    void give_surface() {
        int at = any(Slot::ARMED);
        Slot &s = slots[at];
        bool now = ++since >= 8 && s.state == Slot::ARMED && b.random.percent(60);
        direct = -1;
        bench::put(t.surface_i, RT_SURFACE_VALID, now);
        if (!now) return;
        since = 0;
        make(s);
        bench::put(t.surface_i, RT_SURFACE_SLOT, at);
        bench::put(t.surface_i, RT_SURFACE_GUARDED, (bench::i128)pack(s.guarded, GW));
        bench::put(t.surface_i, RT_SURFACE_NORMAL, (bench::i128)pack(s.normal, WD));
        bool flat = b.random.percent(90); /* a number of what is no facet means nothing */
        bench::put(t.surface_i, RT_SURFACE_FLAT, flat);
        if (!flat) s.number = 0;
        s.state = s.number && !s.outside ? Slot::BENT : Slot::IDLE;
        if (s.state == Slot::IDLE) direct = at;
    }

    /* A hit of a triangle, mostly near where the record starts; its normal is as rt_hit gives it.
     */
    void make(Slot &s) {
        int64_t vector[3];
        struct sph_surface own = {};
        struct sph_ray ray = {};
        int kind = (int)b.random.below(16), room = (int)b.random.below(W);
        bool far = b.random.percent(10); /* so far that the difference is limited */
        for (int i = 0; i < 3; i++)
            vector[i] = b.random.smixed(24) | (i == 0);
        sph_surface_turn(&profile, &ray, 0, vector, &own);
        for (int i = 0; i < 3; i++)
            s.normal[i] = own.normal[i];
        for (uint32_t &word : s.record)
            word = (uint32_t)b.random.next();
        for (int i = 0; i < 3; i++) {
            int64_t from = b.random.smixed(W), limit = ((int64_t)1 << (GW - 1)) - 1;
            s.guarded[i] = from * (1 << NG) + b.random.between(-1, 1) * b.random.bits(room + NG);
            if (!kind || far) s.guarded[i] = b.random.smixed(GW);
            if (s.guarded[i] > limit) s.guarded[i] = limit;
            if (s.guarded[i] < -limit - 1) s.guarded[i] = -limit - 1;
            sph_field_set(s.record, SPH_SMOOTH_B_X_LSB + 24 * i, 24, (uint32_t)from);
            if (kind < 2) /* no normal, or one that is turned at its edge */
                sph_field_set(s.record, SPH_SMOOTH_N_X_LSB + 17 * i, 17, kind ? 0x10000 : 0);
            if (kind > 3) continue;
            for (int k = 0; k < 3; k++) /* nothing else, or all that there may be */
                sph_field_set(s.record, SPH_SMOOTH_M_XX_LSB + 14 * (3 * i + k), 14,
                              kind == 3 ? 0x2000 : 0);
        }
        if (kind > 4) sph_field_set(s.record, SPH_SMOOTH_E_LSB, 6, (uint32_t)b.random.below(24));
    }

    void give_record() {
        if (bench::get(t.record_i, RT_RECORD_VALID)) return;
        int at = any(b.random.percent(50) ? Slot::ASKED : Slot::FETCHED);
        Slot &s = slots[at];
        if ((s.state != Slot::ASKED && s.state != Slot::FETCHED) || !b.random.percent(pace + 5))
            return;
        bench::put(t.record_i, RT_RECORD_VALID, 1);
        bench::put(t.record_i, RT_RECORD_SLOT, at);
        for (int i = 0; i < 8; i++)
            bench::put(t.record_i, lsb(RT_RECORD_DATA) + 32 * i, 32, s.record[i]);
    }

    static int lsb(int first, int) { return first; }

    /* Somebody's fetch goes to the cache. */
    void take_fetch() {
        if (!bench::get(t.fetch_o, RT_FETCH_VALID)) return;
        Slot &s = slots[bench::get(t.fetch_o, RT_FETCH_SLOT)];
        uint32_t line = s.state == Slot::BENT ? base + s.number - 1 : s.line;
        if (s.state != Slot::BENT && s.state != Slot::WANTS) b.fail("a record that none asked for");
        b.expect("LINE", bench::get(t.fetch_o, RT_FETCH_LINE), line % LINES, 26);
        s.state = s.state == Slot::BENT ? Slot::FETCHED : Slot::ASKED;
    }

    /* A record is taken, of a primitive by rt_surface. */
    void check_record(bool given) {
        int at = (int)bench::get(t.record_i, RT_RECORD_SLOT);
        bool valid = bench::get(t.record_i, RT_RECORD_VALID), own = slots[at].state == Slot::ASKED;
        b.expect("VALID of record_o", bench::get(t.record_o, RT_RECORD_VALID), valid && own, 1);
        if (valid && own)
            b.expect("SLOT of record_o", bench::get(t.record_o, RT_RECORD_SLOT), at, SLOTW);
        if (given) slots[at].state = own ? Slot::GIVEN : Slot::DONE;
    }

    void check_normal() {
        int at = (int)bench::get(t.normal_o, RT_VECTOR_SLOT);
        bool valid = bench::get(t.normal_o, RT_VECTOR_VALID);
        b.expect("bad_node_o", t.bad_node_o, direct >= 0 && slots[direct].number, 1);
        b.expect("VALID of side_o", bench::get(t.side_o, RT_SIDE_VALID), valid, 1);
        if (direct >= 0) b.expect("SLOT", valid ? at : SLOTS, direct, SLOTW + 1);
        if (!valid) {
            if (b.bad()) b.done();
            return;
        }
        Slot &s = slots[at];
        struct sph_surface surface = {};
        for (int i = 0; i < 3; i++)
            surface.normal[i] = s.normal[i];
        if (direct < 0) {
            int64_t normal[3];
            if (s.state != Slot::DONE) b.fail("a normal before its record");
            sph_smooth_normal(&profile, s.record, s.guarded, normal);
            sph_surface_bend(&profile, s.far, normal, &surface);
            b.expect("VEC of side_o", bench::get(t.side_o, RT_SIDE_VEC),
                     (bench::i128)pack(s.normal, WD), 3 * WD);
            uint64_t nn = 0;
            for (int64_t n : s.normal)
                nn += (uint64_t)(n * n);
            b.expect("NN", bench::get(t.side_o, RT_SIDE_NN), (bench::i128)nn, 2 * WD);
        }
        b.expect("BENT", bench::get(t.side_o, RT_SIDE_BENT), surface.bent, 1);
        b.expect("VEC", bench::get(t.normal_o, RT_VECTOR_VEC),
                 (bench::i128)pack(surface.normal, WD), 3 * WD);
        if (b.bad()) {
            b.show("slot", at, SLOTW);
            b.show("far", s.far, 1);
            b.show("e", sph_field(s.record, SPH_SMOOTH_E_LSB, 6), 6);
        }
        s.state = Slot::IDLE;
        b.done();
    }
};

} // namespace

int main(int argc, char **argv) {
    Run run(argc, argv);
    while (run.clock())
        ;
    return run.finish();
}
