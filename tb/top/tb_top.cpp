/* tb_top.cpp - rt_top under its driver: registers, frames, errors, resets, a silent bus
 * SPDX-License-Identifier: Apache-2.0
 *
 * usage: tb_top A.sph B.sph [seed]        two machines of the core's profile, not of one picture
 */
#include "top_builds.h"
#include "top_display.h"
#include "top_faults.h"
extern "C" {
#include "tests/number.h"
}

#ifdef SCRIPTED
static void scripted(Checks &c, const Golden &any);
namespace {
void environment(Checks &c, const Golden &a, const Golden &b);
}
#endif

/* Every bit of every setting, each by itself; a reset gives all what they had. */
static void settings(Checks &c) {
    TopHost &t = c.top;
    std::vector<Setting> all;
    for (const auto &[at, setting] : settings_of())
        all.push_back(setting);
    const size_t count = all.size();
    std::vector<uint32_t> copy(count);
    t.stall = 40;
    t.reset();
    for (size_t i = 0; i < count; i++)
        c.equals("setting behind a reset", t.read(all[i].at), copy[i] = all[i].reset);
    for (int n = 0; n < 200; n++) {
        const size_t at = (size_t)t.random.below((uint32_t)count);
        const uint32_t value = (uint32_t)t.random.next();
        const unsigned strobe = (unsigned)t.random.below(16);
        t.write(all[at].at, value, strobe);
        for (int b = 0; b < 4; b++)
            if (strobe >> b & 1) copy[at] = (copy[at] & ~(255u << 8 * b)) | (value & 255u << 8 * b);
        copy[at] &= all[at].kept;
        c.equals("setting", t.read(all[at].at), copy[at]);
        const size_t other = (size_t)t.random.below((uint32_t)count);
        c.equals("another setting", t.read(all[other].at), copy[other]);
    }
    t.reset();
    for (size_t i = 0; i < count; i++)
        c.equals("setting after a reset", t.read(all[i].at), all[i].reset);
    t.stall = 0;
    c.done("settings: each bit, strobes, reset");
}

/* Registers that are only read, as they stand before the first frame. */
static void fixed(Checks &c, const Golden &a) {
    TopHost &t = c.top;
    const uint32_t known[][2] = {
        {SPHAERA_ID, SPHAERA_ID_RESET},
        {SPHAERA_VERSION, SPHAERA_VERSION_RESET},
        {SPHAERA_CORE_PROFILE, (uint32_t)a.machine.regs[SPH_REG_PROFILE]},
        {SPHAERA_CORE_EFFECTS, t.driver.effects},
        {SPHAERA_CORE_PARTS, View::built(SPHAERA_CORE_PARTS)},
        {SPHAERA_CORE_BUS, DATA | SPHAERA_CORE_BUS_VIDEO |
                               (c.layers ? SPHAERA_CORE_BUS_LAYERS : 0) |
                               (uint32_t)ADDR << SPHAERA_CORE_BUS_ADDR_LSB |
                               (t.driver.built & SPHAERA_CORE_BUS_BUILD)},
        {SPHAERA_CONTROL, 0},
        {SPHAERA_STATUS, SPHAERA_STATUS_BLANK},
        {SPHAERA_FRAME_COUNT, 0},
        {SPHAERA_ERRORS, 0},
        {SPHAERA_INTERRUPTS, 0},
    };
    for (const auto &[at, value] : known) {
        t.write(at, 0);
        c.equals("a register that is only read takes a write", (uint64_t)t.response, OKAY);
        c.equals("and is what it was", t.read(at), value);
        c.equals("it answers", (uint64_t)t.response, OKAY);
    }
    for (uint32_t i : {0u, 31u, SPHAERA_COUNTS - 1u}) {
        t.write(SPHAERA_COUNTERS + 8 * i, 0);
        c.equals("so does a counter", (uint64_t)t.response, OKAY);
    }
}

static void registers(Checks &c, const Golden &a) {
    TopHost &t = c.top;
    fixed(c, a);
    for (uint32_t i = 0; i < SPHAERA_MACHINE_REGISTERS; i++)
        c.equals("0 after a reset", t.read(SPHAERA_MACHINE + 4 * i), 0);
    c.equals("ID", t.read(SPHAERA_ID), SPHAERA_ID_RESET);
    c.equals("CORE_BUS", t.read(SPHAERA_CORE_BUS) & SPHAERA_CORE_BUS_DATA, DATA);
    t.write(SPHAERA_ID, 0);
    c.equals("ID is read-only", t.read(SPHAERA_ID), SPHAERA_ID_RESET);
    c.equals("and says OKAY", (uint64_t)t.response, OKAY);
    t.stall = 40;
    uint32_t copy[SPHAERA_MACHINE_REGISTERS];
    for (uint32_t i = 0; i < SPHAERA_MACHINE_REGISTERS; i++)
        sphaera_set(&t.driver, i, copy[i] = (uint32_t)t.random.next());
    for (int i = 0; i < 300; i++) { /* strobes */
        uint32_t at = (uint32_t)t.random.below(SPHAERA_MACHINE_REGISTERS);
        uint32_t value = (uint32_t)t.random.next();
        unsigned strobe = (unsigned)t.random.below(16);
        t.write(SPHAERA_MACHINE + 4 * at, value, strobe);
        for (int b = 0; b < 4; b++)
            if (strobe >> b & 1) copy[at] = (copy[at] & ~(255u << 8 * b)) | (value & 255u << 8 * b);
        at = (uint32_t)t.random.below(SPHAERA_MACHINE_REGISTERS);
        c.equals("machine register", t.read(SPHAERA_MACHINE + 4 * at), copy[at]);
    }
    t.write(SPHAERA_WATCHDOG, 0x12345678);
    t.write(SPHAERA_WATCHDOG, 0xffffffff, 5);
    c.equals("strobes of a setting", t.read(SPHAERA_WATCHDOG), 0x12ff56ff);
    t.write(SPHAERA_WATCHDOG, SPHAERA_WATCHDOG_RESET);
    t.write(SPHAERA_FRAME1, 0xffffffff);
    c.equals("low bits of an address", t.read(SPHAERA_FRAME1), SPHAERA_FRAME1_PLACE);
    c.store(c.stride, c.rgb565);
    const uint32_t behind = SPHAERA_MACHINE + 4 * SPHAERA_MACHINE_REGISTERS;
    for (uint32_t offset : {0x18u, 0x1cu, 0x3cu, 0x74u, 0x78u, 0x7cu, 0x80u, 0x94u, 0x98u, 0x9cu,
                            0xa0u, behind, 0x3fcu, 0x548u, 0xffcu}) {
        if (offset == SPHAERA_LAYER_BYTES && c.layers) continue;
        if (offset == SPHAERA_ADDRESS_HIGH && ADDR > 32) continue;
        if (offset >= SPHAERA_BUILD_COUNT && offset <= SPHAERA_BUILD_WRITTEN && c.builds())
            continue;
        c.equals("no register reads 0", t.read(offset), 0);
        c.equals("and answers SLVERR", (uint64_t)t.response, SLVERR);
        t.write(offset, 0xffffffff);
        c.equals("a write too", (uint64_t)t.response, SLVERR);
    }
    c.done("registers: read back, strobes, offsets without one");
}

static void frames(Checks &c, const Golden &a, const Golden &b) {
    for (unsigned stall : {0u, 30u, 70u}) {
        Manner slow;
        slow.stall = stall;
        slow.latency = 1 + stall;
        c.top.scene.behave(slow);
        c.top.frame.behave(slow);
        c.whole(a, SCENE_A);
        c.whole(b, SCENE_B); /* no reset between two machines */
    }
    c.done("two machines one after another, buses that stall");
    c.load(a, SCENE_A);
    for (int half = 0; half < 2; half++) {
        c.store(half ? 1024 : 1280, half);
        for (unsigned mux = 1; mux < 4; mux++) {
            c.choose(mux);
            c.equals("draw", (uint64_t)c.draw(), SPHAERA_OK);
            c.same(a, c.newest(), (int)mux - 1);
        }
    }
    c.choose(0);
    c.store(2560, 0);
    c.done("frame mux, both formats");
}

/* MUX is written again and again while a frame is drawn: at once, while registers go to the core,
 * among its pixels and behind its last one. It counts from the next START on, or if a frame has
 * layers for none of them. */
static void mux(Checks &c, const Golden &a) {
    TopHost &t = c.top;
    c.load(a, SCENE_A);
    uint64_t length = t.cycle;
    c.equals("draw", (uint64_t)c.draw(), SPHAERA_OK);
    length = t.cycle - length;
    const auto depth = [&](unsigned frame) { return frame ? (int)frame - 1 : c.depth(a); };
    unsigned from = 0;
    for (int i = 0; i < 32; i++) {
        const unsigned to = (from + 1 + (unsigned)t.random.below(3)) % 4;
        sphaera_mux(&t.driver, from);
        c.spoil();
        c.equals("start", (uint64_t)sphaera_start(&t.driver, 0), SPHAERA_OK);
        t.clocks(i < 12 ? (uint64_t)i : t.random.below((uint32_t)length));
        sphaera_mux(&t.driver, to);
        for (int n = 0; i & 1 && n < 40; n++) {
            t.clocks(t.random.below(20));
            sphaera_mux(&t.driver, (unsigned)t.random.below(4));
        }
        sphaera_mux(&t.driver, to);
        c.equals("draw", (uint64_t)sphaera_wait(&t.driver, POLLS), SPHAERA_OK);
        c.same(a, c.newest(), depth(from));
        from = to;
    }
    c.choose(0);
    c.done("MUX written in mid-frame counts from the next START on");
}

static void counters(Checks &c, const Golden &a) {
    uint64_t n[SPHAERA_COUNTS];
    c.top.frame.behave({});
    c.top.scene.behave({});
    c.whole(a, SCENE_A);
    sphaera_counters(&c.top.driver, n);
    for (int i = 0; i < SPH_COUNTERS; i++)
        if (sph_counter_both(i)) c.equals("counter of the core", n[i], a.counters.count[i]);
    c.equals("WRITE_PIXELS", n[SPHAERA_COUNT_WRITE_PIXELS],
             (uint64_t)(a.frame.width * a.frame.height * (c.layers ? SPH_FRAMES : 1)));
    c.equals("WRITE_BURSTS", n[SPHAERA_COUNT_WRITE_BURSTS], c.top.frame.requests);
    c.equals("WRITE_BEATS", n[SPHAERA_COUNT_WRITE_BEATS], c.top.frame.beats);
    c.equals("READ_BURSTS", n[SPHAERA_COUNT_READ_BURSTS], c.top.scene.requests);
    c.equals("READ_BEATS", n[SPHAERA_COUNT_READ_BEATS], c.top.scene.answers);
    printf("# %llu pixels in %llu bursts, %.2f of 8; %llu lines read, %llu clocks\n",
           (unsigned long long)n[SPHAERA_COUNT_WRITE_PIXELS],
           (unsigned long long)n[SPHAERA_COUNT_WRITE_BURSTS],
           (double)n[SPHAERA_COUNT_WRITE_PIXELS] / (double)n[SPHAERA_COUNT_WRITE_BURSTS],
           (unsigned long long)n[SPHAERA_COUNT_READ_BURSTS],
           (unsigned long long)n[SPHAERA_COUNT_CYCLES]);
    for (int i = 0; i < 8; i++) { /* they stand still, however often they are asked */
        uint64_t again[SPHAERA_COUNTS];
        c.top.clocks(c.top.random.below(20));
        sphaera_counters(&c.top.driver, again);
        for (uint32_t k = 0; k < SPHAERA_COUNTS; k++)
            c.equals("a counter between two frames", again[k], n[k]);
    }
    uint64_t cold = n[SPHAERA_COUNT_READ_BURSTS];
    c.equals("start", (uint64_t)sphaera_start(&c.top.driver, 1), SPHAERA_OK);
    c.equals("draw", (uint64_t)sphaera_wait(&c.top.driver, POLLS), SPHAERA_OK);
    c.same(a, c.newest(), c.depth(a));
    c.equals("none changes without SNAPSHOT",
             c.top.read(SPHAERA_COUNTERS + 8 * SPHAERA_COUNT_READ_BURSTS), cold);
    c.top.write(SPHAERA_CONTROL, SPHAERA_CONTROL_SNAPSHOT); /* a read waits until it is taken */
    uint32_t warm = c.top.read(SPHAERA_COUNTERS + 8 * SPHAERA_COUNT_READ_BURSTS);
    c.note("KEEP_CACHE: lines are not read again", warm < cold);
    c.done("counters");
}

/* Scene and frames anywhere, each in 4 GB: all bits of addresses are what they should be. */
static void far(Checks &c, const Golden &a, const Golden &b) {
    TopHost &t = c.top;
    for (int i = 0; i < 6; i++) {
        const uint32_t scene = (uint32_t)t.random.next() & 0xfdeff000;
        t.scene.above = {(HIGH_SCENE + scene) >> 26};
        t.frame.above.clear();
        for (uint32_t k = 0; k < 3; k++) {
            const uint32_t free = i & 2 ? 0xfc7effc0 : 0xfc77ffc0; /* there is room behind it */
            c.stores[k] = HIGH[k] + ((uint32_t)t.random.next() & free) + STORE + k * 0x800000;
            t.frame.above.push_back(c.stores[k] >> 26);
        }
        c.store(2560 + 32 * (uint32_t)t.random.below(8), i & 1);
        const Golden &drawn = i & 1 ? b : a;
        c.whole(drawn, scene);
        unsigned shown = 0;
        c.equals("take", (uint64_t)sphaera_take(&t.driver, &shown), SPHAERA_OK);
        c.equals("its address", t.dut.show_base_o, c.place(drawn, shown));
    }
    t.scene.above.clear();
    t.frame.above.clear();
    for (uint32_t k = 0; k < 3; k++)
        c.stores[k] = HIGH[k] + STORE + k * APART;
    c.store(2560, 0);
    c.done("scene and frames anywhere, each in 4 GB");
}

static void busy(Checks &c, const Golden &a, const Golden &b) {
    for (int i = 0; i < 8; i++) { /* at once, while registers go to the core, and later */
        c.load(a, SCENE_A);
        c.spoil();
        sphaera_start(&c.top.driver, 0);
        c.top.clocks(c.top.random.below(i < 4 ? 150 : 4000));
        c.top.write(SPHAERA_SCENE_BASE, SCENE_B); /* these count from the next START on */
        for (uint32_t at : {SPHAERA_FRAME0, SPHAERA_FRAME1, SPHAERA_FRAME2})
            c.top.write(at, STORE + 3 * APART);
        c.top.write(SPHAERA_STRIDE, 1280);
        c.top.write(SPHAERA_FORMAT, SPHAERA_FORMAT_RGB565);
        if (c.layers) c.top.write(SPHAERA_LAYER_BYTES, 0x1000);
        c.top.write(SPHAERA_CONTROL, SPHAERA_CONTROL_START);
        c.equals("a second START is refused", c.top.read(SPHAERA_ERRORS), SPHAERA_ERRORS_REFUSED);
        c.equals("the driver says busy", (uint64_t)sphaera_start(&c.top.driver, 0), SPHAERA_BUSY);
        c.load(b, SCENE_B); /* while a is drawn */
        c.equals("still busy", c.top.read(SPHAERA_STATUS) & SPHAERA_STATUS_BUSY, 1);
        sphaera_errors(&c.top.driver);
        c.equals("draw", (uint64_t)sphaera_wait(&c.top.driver, POLLS), SPHAERA_OK);
        c.same(a, c.newest(), c.depth(a));
        c.store(2560, 0);
        c.equals("draw", (uint64_t)c.draw(), SPHAERA_OK);
        c.same(b, c.newest(), c.depth(b));
    }
    c.done("START while busy; the next machine written while one is drawn");
}

static void store(Checks &c, const Golden &a) {
    TopHost &t = c.top;
    sphaera_reset(&t.driver, 0, POLLS);
    sphaera_interrupts(&t.driver, SPHAERA_INTERRUPTS_SWAP | SPHAERA_INTERRUPTS_FRAME_DONE);
    unsigned shown = 9, frame;
    c.equals("nothing to show", (uint64_t)sphaera_take(&t.driver, &frame), SPHAERA_BUSY);
    c.load(a, SCENE_A);
    for (int i = 0; i < 9; i++) {
        c.equals("no interrupt", t.dut.irq_o, 0);
        c.equals("draw", (uint64_t)c.draw(), SPHAERA_OK);
        c.note("what is shown is not drawn", shown != c.drawn());
        c.equals("interrupt", t.dut.irq_o, 1);
        c.equals("frame done", sphaera_handle(&t.driver), SPHAERA_INTERRUPTS_FRAME_DONE);
        if (i % 3 == 0) continue;
        unsigned newest = c.newest();
        if (i % 2) { /* by the port: then TAKE would show the same again */
            t.clocks(4);
            t.take_in = 1;
            t.clock();
            shown = (t.read(SPHAERA_STATUS) & SPHAERA_STATUS_SHOWN) >> SPHAERA_STATUS_SHOWN_LSB;
        } else {
            c.equals("take", (uint64_t)sphaera_take(&t.driver, &shown), SPHAERA_OK);
        }
        c.equals("the newest is shown", shown, newest);
        c.equals("its address", t.dut.show_base_o, c.place(a, shown));
        c.equals("swap", sphaera_handle(&t.driver), SPHAERA_INTERRUPTS_SWAP);
        const uint64_t place = t.dut.show_base_o;
        c.choose((c.mux + (unsigned)i) % 4);
        t.clocks(5);
        c.equals("MUX counts when a frame is taken", t.dut.show_base_o, place);
        sphaera_take(&t.driver, &frame);
        c.equals("the same again", frame, shown);
        c.equals("its layer", t.dut.show_base_o, c.place(a, shown));
        c.equals("no swap", sphaera_handle(&t.driver), 0);
    }
    uint64_t n[SPHAERA_COUNTS];
    sphaera_counters(&t.driver, n);
    c.equals("FRAME_COUNT", t.read(SPHAERA_FRAME_COUNT), 9);
    c.equals("FRAMES_SHOWN", n[SPHAERA_COUNT_FRAMES_SHOWN], 6);
    c.equals("FRAMES_AGAIN", n[SPHAERA_COUNT_FRAMES_AGAIN], 6);
    c.equals("FRAMES_LOST", n[SPHAERA_COUNT_FRAMES_LOST], 3);
    t.write(SPHAERA_FRAME_MODE, SPHAERA_FRAME_MODE_WAIT);
    c.equals("draw", (uint64_t)c.draw(), SPHAERA_OK);
    sphaera_start(&t.driver, 0);
    c.equals("it waits", (uint64_t)sphaera_wait(&t.driver, 3000), SPHAERA_LATE);
    c.note("and says so", t.read(SPHAERA_STATUS) & SPHAERA_STATUS_WAITING);
    sphaera_take(&t.driver, &shown);
    c.equals("then goes on", (uint64_t)sphaera_wait(&t.driver, POLLS), SPHAERA_OK);
    t.write(SPHAERA_FRAME_MODE, 0);
    sphaera_interrupts(&t.driver, 0);
    c.choose(0);
    c.note("active_o was low, and clk stood still", t.stood > 0);
    c.done("frame store: three frames, interrupts, counts");
}

/* What happens between the driver's read and its write that clears stays. */
static void handles(Checks &c, const Golden &a) {
    TopHost &t = c.top;
    const struct sphaera_bus bus = t.driver.bus;
    c.whole(a, SCENE_A);
    sphaera_handle(&t.driver);
    t.driver.bus.read = [](void *user, uint32_t offset) {
        TopHost &host = *(TopHost *)user;
        const uint32_t value = host.read(offset);
        if (offset == SPHAERA_INTERRUPTS) host.take_in = 1;
        if (offset == SPHAERA_INTERRUPTS) host.clock();
        if (offset != SPHAERA_ERRORS) return value;
        host.write(SPHAERA_CONTROL, SPHAERA_CONTROL_START); /* one of both is refused */
        host.write(SPHAERA_CONTROL, SPHAERA_CONTROL_START);
        return value;
    };
    c.equals("nothing yet", sphaera_handle(&t.driver), 0);
    c.equals("no error yet", sphaera_errors(&t.driver), 0);
    t.driver.bus = bus;
    c.equals("SWAP stays", sphaera_handle(&t.driver) & SPHAERA_INTERRUPTS_SWAP,
             SPHAERA_INTERRUPTS_SWAP);
    c.equals("REFUSED stays", sphaera_errors(&t.driver), SPHAERA_ERRORS_REFUSED);
    c.equals("draw", (uint64_t)sphaera_wait(&t.driver, POLLS), SPHAERA_OK);
    c.done("what happens while the driver handles it stays");
}

/* Layers, without MUX: register FRAME of the frame that is shown chooses, not of the next one. */
static void own_layers(Checks &c, const Golden &a) {
    TopHost &t = c.top;
    unsigned shown = 0;
    uint32_t frame = SPH_FRAMES;
    c.load(a, SCENE_A);
    for (int i = 0; i < 12; i++) {
        const uint32_t before = frame;
        frame = (uint32_t)t.random.below(SPH_FRAMES + 1); /* the last is L2, too */
        sphaera_set(&t.driver, SPH_REG_FRAME, frame);
        sphaera_start(&t.driver, 0);
        t.clocks(200); /* registers are in the core */
        if (i) {
            sphaera_take(&t.driver, &shown);
            c.equals("the layer of the frame that is shown", t.dut.show_base_o,
                     c.stores[shown] + std::min(before, 2u) * c.apart);
        }
        c.note("while the next is drawn", t.read(SPHAERA_STATUS) & SPHAERA_STATUS_BUSY);
        c.equals("draw", (uint64_t)sphaera_wait(&t.driver, POLLS), SPHAERA_OK);
        c.same(a, c.newest(), 0);
        sphaera_take(&t.driver, &shown);
        c.equals("then its own", t.dut.show_base_o,
                 c.stores[shown] + std::min(frame, 2u) * c.apart);
    }
    c.done("layers: register FRAME of each frame chooses its own");
}

int main(int argc, char **argv) {
    if (argc < 3) {
        fprintf(stderr, "usage: tb_top A.sph B.sph [seed]\n");
        return 2;
    }
    Golden a(argv[1]), b(argv[2]);
    auto c = std::make_unique<Checks>(test_number(argc > 3 ? argv[3] : nullptr, "argument 3", 1));
    settings(*c);
    registers(*c, a);
    frames(*c, a, b);
    mux(*c, a);
    counters(*c, a);
    far(*c, a, b);
    busy(*c, a, b);
    store(*c, a);
    handles(*c, a);
    if (c->layers) own_layers(*c, a);
    answers(*c, a, b);
    resets(*c, a, b);
    silence(*c, a, b);
    if (c->builds()) {
        built_words(*c, a);
        built_frames(*c, a);
        built_resets(*c, a);
        built_silence(*c, a);
    }
    if (c->top.driver.built & SPHAERA_CORE_BUS_VIDEO) display(*c, a, b);
    if (c->layers && c->top.driver.built & SPHAERA_CORE_BUS_VIDEO) display_layers(*c, a);
#ifdef SCRIPTED
    scripted(*c, b);
    environment(*c, a, b);
#endif
    return c->finish();
}
