/* tb_slots.cpp - rt_slots and rt_interpenetrate against the life of a pixel as path() of the model
 * tells it SPDX-License-Identifier: Apache-2.0
 *
 * The bench stands in for all other groups: it makes up what rays hit and what is blended, for all
 * slots at once, and knows from that what must become of each pixel. A vector is a finished pixel.
 * A reset in each state of a slot forgets it.
 */
#include <cstring>

#include "Vrt_slots.h"
#include "engine/parts.h"
#include "stimulus.h"

extern "C" {
#include "machine/layout.h"
}

#ifndef SHADOW
#define SHADOW 1
#endif
#ifndef FARS
#define FARS 1
#endif
#ifndef TEXTURE
#define TEXTURE 0
#endif
#ifndef INTERPENETRATE
#define INTERPENETRATE 1
#endif

using bench::i128;
using bench::u128;

namespace {

constexpr uint32_t NO_TEXTURE = (uint32_t)SPH_LOD_NONE << 20;

struct Slot {
    enum {
        FREE,    /* no pixel */
        PRIMARY, /* its primary ray is on the way */
        SHADE,   /* a surface or a miss is at hand: shadow rays, then it is blended */
        BEHIND,  /* a ray that left a surface is on the way */
        END,     /* blended, but its pixel not yet told complete */
        LEAVES,  /* to be delivered */
        WAITS    /* its primary ray starts once more */
    } state = FREE;
    int x = 0, y = 0;
    u128 dir = 0;
    bool again = false;                       /* the primary ray is the repeated one */
    bool first = false;                       /* what is at hand is what the pixel sees itself */
    bool probe = false, last = false;         /* of the surface that was blended last */
    bool miss = false, sky = false;           /* what is at hand; nothing but background */
    uint32_t id = 0, visits = 0, texture = 0; /* of the primary hit; what others know */
    int far = 0;                              /* it was hit from inside */
    uint64_t key = 0;
    u128 colour = 0;
};

struct Hit { /* what hit_o must be two clocks after done_i */
    bool hit = false, miss = false, shadow = false, lit = false, first = false, probe = false;
    int slot = 0, far = 0;
    uint32_t id = 0;
    uint64_t key = 0;
    bool outside = false;
};

class Slots : public bench::Bench<Vrt_slots> {
  public:
    Slots(int argc, char **argv) : Bench("tb_slots", argc, argv, 30000) {
        dut.in_valid_i = dut.done_valid_i = dut.end_valid_i = 0;
        bench::put(dut.blend_i, RT_BLEND_VALID, 0);
    }

    /* No pixel is under way. */
    void phase() {
        effect = random.percent(70);
        bench::put(dut.regs_i, RT_REGS_EFFECTS, effect ? 1 << SPH_EFFECT_INTERPENETRATE : 0);
        background = (uint32_t)random.bits(24);
        prims = (uint32_t)random.below(1 << 20);
        lines = prims + 1 + (uint32_t)random.below(random.percent(50) ? 1000 : 1 << 23);
        bench::put(dut.regs_i, RT_REGS_BACKGROUND, background);
        bench::put(dut.regs_i, RT_REGS_PRIM_BASE, prims);
        bench::put(dut.regs_i, RT_REGS_MEM_LINES, lines);
        z = random.bits(WD);
        for (unsigned &p : pace)
            p = random.percent(50) ? 100 : (unsigned)random.between(3, 60);
    }

    void clock(bool start) {
        Hit next;
        give_pixel(start);
        for (int unit = 0; unit < SETUPS; unit++)
            bench::put(dut.primary_ready_i, unit, 1, random.percent(pace[1]));
        int told = give_done(next); /* next: what this clock's done_i makes of it */
        give_blend(told);
        dut.pix_ready_i = random.percent(pace[2]);
        dut.ray_slot_i = (uint8_t)random.below(SLOTS);
        settle();
        note();
        const Slot &r = slots[dut.ray_slot_i];
        if (r.state == Slot::PRIMARY && r.again != (dut.ray_again_o != 0))
            fail("ray_again_o is wrong");
        check_hit();
        wanted = later;
        later = next;
        told_before = told;
        bool busy = false, taken = dut.in_valid_i && dut.in_ready_o;
        for (const Slot &s : slots)
            busy |= s.state != Slot::FREE;
        if (dut.busy_o != busy) fail("busy_o is wrong");
        take_primary(taken);
        bool out = dut.pix_valid_o && dut.pix_ready_i;
        if (out) check_pixel();
        int read = dut.read_o ? (int)dut.read_slot_o : -1;
        tick();
        if (taken) dut.in_valid_i = 0;
        if (out) slots[at_port].state = Slot::FREE;
        if (read >= 0) {
            at_port = read;
            dut.visits_i = slots[read].visits;
            bench::set(dut.colour_i, 72, (i128)slots[read].colour);
            dut.texture_i = slots[read].texture;
        }
        if (start && random.below(500) == 0) restart();
    }

    bool whole() const { return driven.whole(); }

    bool all_idle() const {
        if (dut.in_valid_i) return false;
        for (const Slot &s : slots)
            if (s.state != Slot::FREE) return false;
        return true;
    }

  private:
    Slot slots[SLOTS];
    bool effect = false;
    uint32_t background = 0, prims = 0, lines = 1;
    u128 z = 0;
    unsigned pace[4] = {100, 100, 100, 100};
    int next_x = 0, next_y = 0, asked = -1, at_port = 0;
    u128 next_dir = 0;
    int told_before = -1; /* whose end done_i told in the clock before */
    Hit wanted, later;    /* in the next clock, and in the one after it */
    bench::Stimulus driven;
    bench::Points &states = driven.values(
        "handshake", some({"all slots taken, another pixel waits", "a pixel waits for a unit",
                           "all slots free", "a pixel waits at the port", "a repeated ray waits"}));
    bench::Points &resets = driven.values(
        "reset, a slot",
        some({"free", "with a primary ray", "with a surface or a miss",
              "with a ray behind a surface", "blended", "that leaves", "that waits"}));

    /* The last one is of INTERPENETRATE alone. */
    static bench::Stimulus::Names some(bench::Stimulus::Names names) {
        if (!INTERPENETRATE) names.pop_back();
        return names;
    }
    void note() {
        int taken = 0, waits = 0;
        for (const Slot &s : slots)
            taken += s.state != Slot::FREE, waits += s.state == Slot::WAITS;
        const bool stalled = dut.in_valid_i && !dut.in_ready_o;
        if (stalled) states.value(taken == SLOTS ? 0 : 1);
        if (waits && !dut.primary_ready_i) states.value(4);
        if (dut.pix_valid_o && !dut.pix_ready_i) states.value(3);
        if (!taken) states.value(2);
    }

    /* In whatever state the slots are. */
    void restart() {
        for (Slot &s : slots) {
            resets.value(s.state);
            s = Slot();
        }
        dut.in_valid_i = dut.done_valid_i = dut.end_valid_i = 0;
        bench::put(dut.blend_i, RT_BLEND_VALID, 0);
        reset();
        wanted = later = Hit();
        asked = told_before = -1;
        for (int i = 0; i < 2 * SLOTS; i++)
            clock(false);
    }

    void give_pixel(bool start) {
        if (!dut.in_valid_i && start && random.percent(pace[0])) {
            next_x = (int)random.below(1 << 14);
            next_y = (int)random.below(1 << 14);
            next_dir = z << 2 * WD | random.bits(2 * WD);
            dut.in_valid_i = 1;
            bench::put(dut.start_i, RT_START_X, next_x);
            bench::put(dut.start_i, RT_START_Y, next_y);
            bench::put(dut.start_i, RT_START_DIR, (i128)next_dir);
        }
    }

    bench::u128 of_primary(int unit, int lsb, int bits) {
        return parts::setups.get(dut.primary_o, unit, RT_VECTOR_BITS, lsb, bits);
    }

    void take_primary(bool taken) {
        int unit = -1; /* that takes a ray */
        for (int i = 0; i < SETUPS; i++) {
            if (!of_primary(i, RT_VECTOR_VALID) || !(dut.primary_ready_i >> i & 1)) continue;
            if (unit >= 0) return fail("two set-up units take a ray");
            unit = i;
        }
        if (unit < 0) {
            if (taken) fail("a pixel that was taken without its ray");
            return;
        }
        int at = parts::setups.slot(dut.primary_o, unit, RT_VECTOR_BITS, RT_VECTOR_SLOT);
        Slot &s = slots[at];
        if (taken) {
            if (s.state != Slot::FREE) return fail("a slot that is not free");
            s = Slot();
            s.x = next_x, s.y = next_y, s.dir = next_dir;
        } else if (s.state == Slot::WAITS) {
            s.again = true;
        } else {
            return fail("a primary ray that nobody wants");
        }
        s.state = Slot::PRIMARY;
        expect("VEC", (i128)of_primary(unit, RT_VECTOR_VEC), (i128)s.dir, 3 * WD);
        if (bad()) done();
    }

    /* How the ray of last clock's done_slot_i ended; then another that is done. */
    int give_done(Hit &next) {
        int told = asked;
        if (asked >= 0) {
            tell(asked, next);
            asked = -1;
        }
        dut.done_valid_i = 0;
        int at = (int)random.below(SLOTS);
        Slot &s = slots[at];
        bool way = s.state == Slot::PRIMARY || s.state == Slot::BEHIND ||
                   (SHADOW && s.state == Slot::SHADE && !s.miss && random.percent(50));
        if (at != told && way && random.percent(pace[3])) {
            dut.done_valid_i = 1;
            dut.done_slot_i = (uint8_t)at;
            asked = at;
        }
        return asked >= 0 ? asked : told;
    }

    void tell(int at, Hit &h) {
        Slot &s = slots[at];
        bool shadow = s.state == Slot::SHADE, primary = s.state == Slot::PRIMARY;
        bool found = random.percent(60), out = random.percent(5);
        uint32_t room = lines - prims;
        bool first = primary && !s.again && INTERPENETRATE && effect && random.percent(70);
        h.id = out ? room + (uint32_t)random.below(100) : (uint32_t)random.below(room);
        h.far = FARS && random.percent(50);
        const int fars = (int)random.below(3); /* that hold the origin, whichever is hit first */
        h.key = (uint64_t)random.bits(W + WD + 2);
        h.slot = at;
        bench::put(dut.done_i, RT_DONE_FOUND, found);
        bench::put(dut.done_i, RT_DONE_SHADOW, shadow);
        bench::put(dut.done_i, RT_DONE_PRIMARY, primary);
        bench::put(dut.done_i, RT_DONE_FIRST, first);
        bench::put(dut.done_i, RT_DONE_FAR, h.far);
        bench::put(dut.done_i, RT_DONE_FARS, fars);
        bench::put(dut.done_i, RT_DONE_ID, h.id);
        bench::put(dut.done_i, RT_DONE_KEY, (i128)h.key);
        if (shadow) {
            h.shadow = true;
            h.lit = !found;
            return;
        }
        h.outside = found && out;
        found &= !out;
        h.first = primary;
        h.probe = first;
        if (primary) {
            s.id = found ? h.id : SPH_ID_NONE;
            s.far = h.far;
            s.key = found ? h.key : 0;
            s.sky = !found;
            s.state = found ? Slot::SHADE : Slot::LEAVES;
            h.hit = found;
        } else if (s.probe && found && fars > s.far) {
            s.state = Slot::WAITS;
        } else if (s.probe && s.last) {
            s.state = Slot::LEAVES;
        } else {
            s.state = Slot::SHADE;
            (found ? h.hit : h.miss) = true;
        }
        s.first = first;
        s.miss = h.miss;
        if (s.state == Slot::LEAVES || s.state == Slot::SHADE) {
            s.colour = random.bits(72);
            s.visits = (uint32_t)random.bits(24);
            s.texture = (uint32_t)random.bits(32);
        }
    }

    void give_blend(int not_this) {
        int at = (int)random.below(SLOTS);
        Slot &s = slots[at];
        bool go = at != not_this && at != told_before && s.state == Slot::SHADE &&
                  random.percent(30) && !(wanted.slot == at && (wanted.hit || wanted.miss)) &&
                  !(later.slot == at && (later.hit || later.miss));
        bench::put(dut.blend_i, RT_BLEND_VALID, go);
        dut.end_valid_i = 0;
        if (go) {
            s.last = s.miss || random.percent(40);
            s.probe = s.first && !s.miss;
            bench::put(dut.blend_i, RT_BLEND_SLOT, at);
            bench::put(dut.blend_i, RT_BLEND_LAST, s.last);
            bench::put(dut.blend_i, RT_BLEND_PROBE, s.probe);
            s.state = s.last && !s.probe ? Slot::END : Slot::BEHIND;
        }
        int end = (int)random.below(SLOTS); /* with REFRACT clocks after the blend */
        if (slots[end].state == Slot::END && random.percent(60)) {
            dut.end_valid_i = 1;
            dut.end_slot_i = (uint8_t)end;
            slots[end].state = Slot::LEAVES;
        }
    }

    void check_hit() {
        auto field = [&](const char *what, int lsb, int bits, uint64_t expected) {
            expect(what, (i128)bench::get(dut.hit_o, lsb, bits), (i128)expected, bits);
        };
        field("HIT", RT_HIT_HIT, wanted.hit);
        field("MISS", RT_HIT_MISS, wanted.miss);
        field("SHADOW", RT_HIT_SHADOW, wanted.shadow);
        expect("BAD_NODE", dut.fault_o, wanted.outside ? 1 << SPH_ERROR_BAD_NODE : 0, 4);
        if (wanted.hit || wanted.miss || wanted.shadow)
            field("SLOT", RT_HIT_SLOT, (uint64_t)wanted.slot);
        if (wanted.shadow) field("LIT", RT_HIT_LIT, wanted.lit);
        if (wanted.hit || wanted.miss) {
            field("FIRST", RT_HIT_FIRST, wanted.first);
            field("PROBE", RT_HIT_PROBE, wanted.probe);
        }
        if (wanted.hit) {
            field("FAR", RT_HIT_FAR, (uint64_t)wanted.far);
            field("ID", RT_HIT_ID, wanted.id);
            field("KEY", RT_HIT_KEY, wanted.key);
        }
        if (bad()) done();
    }

    void check_pixel() {
        const Slot &s = slots[at_port];
        if (s.state != Slot::LEAVES) return fail("a pixel that is not complete");
        auto field = [&](const char *what, int lsb, int bits, u128 expected) {
            expect(what, (i128)bench::get(dut.pix_o, lsb, bits), (i128)expected, bits);
        };
        u128 sky = background;
        field("X", RT_PIXEL_X, (u128)s.x);
        field("Y", RT_PIXEL_Y, (u128)s.y);
        field("COLOUR", RT_PIXEL_COLOUR, s.sky ? sky << 48 | sky << 24 | sky : s.colour);
        field("ID", RT_PIXEL_ID, s.id);
        field("KEY", RT_PIXEL_KEY, s.key);
        field("VISITS", RT_PIXEL_VISITS, s.visits);
        field("TEXTURE", RT_PIXEL_TEXTURE, TEXTURE && !s.sky ? s.texture : NO_TEXTURE);
        if (bad()) show("slot", at_port, SLOTW), show("again", s.again, 1);
        done();
    }
};

} // namespace

int main(int argc, char **argv) {
    Slots b(argc, argv);
    b.phase();
    b.reset();
    for (int i = 0; i < 2 * SLOTS; i++)
        b.clock(false);
    bench::phases(b, 100, 3000, 100000, "a pixel got lost");
    if (b.all_vectors && !b.whole()) b.fail("less was driven than its list says");
    return b.finish();
}
