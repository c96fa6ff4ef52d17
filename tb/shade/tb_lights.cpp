/* tb_lights.cpp - rt_lights, and rt_light_add inside it, against light() of the model's pixel
 * SPDX-License-Identifier: Apache-2.0
 *
 * In a scene of fixed lights every slot starts surfaces over and over; each vector that comes out
 * is answered some time later by a decided light or a shadow ray. A vector is one output.
 */
#include "Vrt_lights.h"
#include "bench.h"

extern "C" {
#include "math/fx.h"
#include "shade/colour.h"
}

using bench::u128;

namespace {

constexpr int64_t MAX = ((int64_t)1 << (W - 1)) - 1, MIN = -MAX - 1; /* coordinate */
constexpr int64_t ANY = INT64_MAX;                                   /* random */
constexpr int SURFACES = 400;                                        /* of a scene */
constexpr int REGISTERS = 8;                                         /* lights the host can write */

struct Scene {
    int n_lights;
    int64_t ambient, light, intensity; /* u1.15, sW, u1.15: all the same, or ANY */
    int64_t point, cosine;             /* of every surface: sW, u1.15 */
    int lit;                           /* percent of lights that reach it */
};

const Scene corners[] = {
    {0, ANY, ANY, ANY, ANY, ANY, 50},        /* no light: ambient alone, no vector */
    {0, 65535, 0, 0, 0, 0, 0},               /* largest ambient */
    {1, 0, ANY, ANY, ANY, 32768, 100},       /* one light at cosine 1: intensity itself */
    {1, 0, ANY, 65535, ANY, 65535, 100},     /* widest operands */
    {8, 0, MIN, 0, MAX, ANY, 100},           /* longest vector, light gives nothing */
    {8, ANY, MAX, ANY, MIN, ANY, 50},        /* its opposite; every light number is used */
    {8, 65535, MIN, 65535, MIN, 32768, 100}, /* sum runs into its limit; vector 0 */
    {8, 0, ANY, 16384, ANY, 32768, 100},     /* exactly 2^17: one above the limit */
    {8, 0, ANY, 65535, ANY, 65535, 0},       /* all in shadow: nothing is added */
    {8, 7, ANY, 1, ANY, 16384, 100},         /* each share is a half: rounds up */
    {8, 7, ANY, 1, ANY, 16383, 100},         /* just below: rounds to nothing */
    {2, ANY, ANY, ANY, ANY, ANY, 50},        /* smallest loop */
};
constexpr size_t CORNERS = sizeof corners / sizeof *corners;

struct Slot {
    enum { IDLE, POINT, WAITS, ASKED, COSINE } state;
    int64_t point[3];
    int lights; /* decided */
    uint32_t cosine, sum[3];
};

/* The unit, a scene of lights, and the surfaces under way. */
class Run {
  public:
    Run(int argc, char **argv) : b("tb_lights", argc, argv) {
        b.dut.light_valid_i = b.dut.point_valid_i = b.dut.cosine_valid_i = 0;
        b.dut.start_valid_i = b.dut.decided_valid_i = b.dut.shadow_valid_i = 0;
        b.reset();
    }
    bool next() { /* a scene and its surfaces; false at the end */
        if (!b.more()) return false;
        load();
        started = inside = 0;
        for (unsigned &p : pace)
            p = 100;
        while (b.more() && (started < SURFACES || inside)) {
            if (b.random.percent(2))
                for (unsigned &p : pace)
                    p = b.random.percent(50) ? 100 : (unsigned)b.random.between(2, 50);
            give_point();
            lights_done(give_cosine());
            b.tick();
            compare();
        }
        return true;
    }
    int finish() { return b.finish(); }

  private:
    bench::Bench<Vrt_lights> b;
    Slot slots[SLOTS] = {};
    size_t scenes = 0;
    Scene scene{};
    int64_t pos[REGISTERS][3];
    int shift[REGISTERS]; /* of the position */
    uint32_t ambient[3], intensity[REGISTERS][3];
    int started = 0, inside = 0;
    unsigned pace[3] = {100, 100, 100}; /* percent of clocks with a start, light, shadow */

    static int64_t is(int64_t fixed, int64_t random) { return fixed == ANY ? random : fixed; }

    /* Lights and ambient light, while nothing is under way. */
    void load() {
        scene = {(int)b.random.below(LIGHTS + 1), ANY, ANY, ANY, ANY, ANY,
                 (int)b.random.below(101)};
        if (scenes < CORNERS) scene = corners[scenes];
        scenes++;
        if (scene.n_lights > LIGHTS) scene.n_lights = LIGHTS;
        for (int i = 0; i < 3; i++)
            ambient[i] = (uint32_t)is(scene.ambient, (int64_t)b.random.mixed(16));
        b.dut.n_lights_i = (uint8_t)scene.n_lights;
        b.set(b.dut.ambient_i, 48,
              (bench::i128)((u128)ambient[2] << 32 | (u128)ambient[1] << 16 | ambient[0]));
        for (int at = 0; at < REGISTERS * 8; at++) { /* parts 6 and 7 do not exist */
            int light = at >> 3, part = at & 7;
            int64_t data = b.random.sbits(32);
            if (!part) shift[light] = b.random.percent(50) ? 0 : (int)b.random.bits(5);
            if (part < 3)
                data = pos[light][part] = is(scene.light, b.random.smixed(shift[light] ? WD : W));
            else if (part < 6)
                data = intensity[light][part - 3] =
                    (uint32_t)is(scene.intensity, (int64_t)b.random.mixed(16));
            if (part == 3) data |= shift[light] << SPH_LIGHT_SHIFT_LSB;
            b.dut.light_valid_i = 1;
            b.dut.light_number_i = (uint8_t)light;
            b.dut.light_part_i = (uint8_t)part;
            b.set(b.dut.light_data_i, 32, data);
            b.tick();
        }
        b.dut.light_valid_i = 0;
        b.set(b.dut.light_data_i, 32, b.random.sbits(32));
    }

    /* A point, and a surface that starts. */
    void give_point() {
        int at = (int)b.random.below(SLOTS);
        Slot *s = &slots[at];
        b.dut.point_valid_i = s->state == Slot::IDLE && started < SURFACES;
        b.dut.point_slot_i = (uint8_t)at;
        u128 packed = 0;
        int64_t point[3];
        for (int i = 2; i >= 0; i--) {
            point[i] = is(scene.point, b.random.smixed(W));
            packed = packed << W | bench::low((u128)point[i], W);
        }
        b.set(b.dut.point_i, 3 * W, (bench::i128)packed);
        if (b.dut.point_valid_i) {
            started++;
            inside++;
            s->state = Slot::POINT;
            for (int i = 0; i < 3; i++)
                s->point[i] = point[i], s->sum[i] = ambient[i];
            s->lights = 0;
        }
        if (b.random.percent(50)) at = (int)b.random.below(SLOTS);
        s = &slots[at];
        b.dut.start_valid_i = s->state == Slot::POINT && b.random.percent(pace[0]);
        b.dut.start_slot_i = (uint8_t)at;
        if (b.dut.start_valid_i) s->state = Slot::WAITS;
    }

    /* A cosine; not all that is answered has a new one. */
    int give_cosine() {
        int at = (int)b.random.below(SLOTS);
        Slot *s = &slots[at];
        uint32_t cosine = (uint32_t)is(scene.cosine, (int64_t)b.random.below(32769));
        b.dut.cosine_valid_i = s->state == Slot::ASKED;
        b.dut.cosine_slot_i = (uint8_t)at;
        b.dut.cosine_i = (uint16_t)cosine;
        if (b.dut.cosine_valid_i) {
            s->state = Slot::COSINE;
            s->cosine = cosine;
        }
        return at;
    }

    /* A decided light and a shadow ray that is done. */
    void lights_done(int at) {
        for (int shadow = 0; shadow < 2; shadow++) {
            if (b.random.percent(50)) at = (int)b.random.below(SLOTS);
            Slot *s = &slots[at];
            bool valid = (SHADOW || !shadow) && s->state == Slot::COSINE &&
                         b.random.percent(pace[1 + shadow]);
            bool lit = b.random.percent((unsigned)scene.lit);
            (shadow ? b.dut.shadow_valid_i : b.dut.decided_valid_i) = valid;
            (shadow ? b.dut.shadow_slot_i : b.dut.decided_slot_i) = (uint8_t)at;
            (shadow ? b.dut.shadow_lit_i : b.dut.decided_lit_i) = lit;
            if (!valid) continue;
            for (int i = 0; i < 3 && lit; i++)
                s->sum[i] = sph_light_add(s->sum[i], s->cosine, intensity[s->lights][i]);
            s->lights++;
            s->state = Slot::WAITS;
        }
    }

    void compare() {
        if (b.dut.vec_valid_o) compare(b.dut.vec_slot_o, false);
        if (b.dut.sum_valid_o) compare(b.dut.sum_slot_o, true);
    }

    /* A vector, or the sum of a slot whose lights are all decided. */
    void compare(int at, bool sum) {
        Slot &e = slots[at];
        if (e.state != Slot::WAITS) {
            b.fail("a slot without an event");
            return;
        }
        bool last = e.lights == scene.n_lights;
        b.expect("sum_valid_o", sum, last, 1);
        for (int i = 0; i < 3; i++)
            if (last)
                b.expect("sum_o", bench::low(b.get(b.dut.sum_o) >> (17 * i), 17), e.sum[i], 17);
            else
                b.expect("vec_o", bench::sign(b.get(b.dut.vec_o) >> (WD * i), WD),
                         bench::sign(
                             (u128)(pos[e.lights][i] - sph_round(e.point[i], shift[e.lights])), WD),
                         WD);
        if (b.bad()) {
            b.show("slot", at, SLOTW);
            b.show("scene", (bench::i128)scenes - 1, 32);
            b.show("n_lights_i", scene.n_lights, 4);
            b.show("lights decided", e.lights, 4);
            b.show("ambient_i", (bench::i128)b.get(b.dut.ambient_i), 48);
            b.show("last cosine", e.cosine, 16);
        }
        for (int i = 0; i < 3 && b.bad(); i++)
            b.show("point", e.point[i], W);
        e.state = last ? Slot::IDLE : Slot::ASKED;
        inside -= last;
        b.done();
    }
};

} // namespace

int main(int argc, char **argv) {
    Run run(argc, argv);
    while (run.next())
        ;
    return run.finish();
}
