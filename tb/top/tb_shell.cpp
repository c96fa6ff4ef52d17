/* tb_shell.cpp - rt_top around the golden model: tb_top in seconds, for faults put into the RTL
 * SPDX-License-Identifier: Apache-2.0
 *
 * usage: as tb_top
 *
 * golden_core.h draws in the place of rt_core. So all around the core is as it is built, and builds
 * in seconds.
 */
#define SCRIPTED
#include "top/tb_top.cpp"

#include <set>

#include "top/top_meet.h"

namespace {

/* What rt_frame_groups makes of pixels that come one by one: bursts, pixels in them. */
struct Groups {
    struct Group {
        int mask = 0, column = 0, y = 0;
    } held[16];
    uint64_t bursts = 0, pixels = 0;

    void leave(Group &g) {
        bursts += g.mask != 0;
        pixels += (uint64_t)__builtin_popcount((unsigned)g.mask);
        g.mask = 0;
    }
    void put(const Pixel &p) {
        Group &g = held[p.y % 16];
        if (g.mask && (g.column != p.x / 8 || g.y != p.y)) leave(g);
        g = {g.mask | 1 << p.x % 8, p.x / 8, p.y};
        if (g.mask == 255) leave(g);
    }
    void flush() {
        for (Group &g : held)
            leave(g);
    }
};

/* Groups of a few places anywhere in 16384 x 16384: whole ones, and a pixel here and there; or
 * hardly any, so that the last one is the only one that is not written. once: each pixel is. */
std::vector<Pixel> pixels(bench::Random &r, bool once) {
    std::vector<Pixel> made;
    std::set<std::pair<int, int>> known;
    int columns[3], rows[6];
    for (int &column : columns)
        column = (int)r.below(2048) * 8;
    for (int &row : rows)
        row = (int)r.below(16384);
    const size_t many = r.percent(50) ? (once ? 100 : 300) : 1 + r.below(3); /* of 3 * 6 * 8 */
    while (made.size() < many) {
        const int x = columns[r.below(3)], y = rows[r.below(6)], first = (int)r.below(8);
        const int n = r.percent(40) ? 9 : 1; /* the ninth is the first once more */
        for (int i = 0; i < n; i++) {
            Pixel p = {x + (first + i) % 8, y, {}};
            for (int &colour : p.colour)
                colour = (int)r.below(1 << 24);
            if (known.insert({p.x, p.y}).second || !once) made.push_back(p);
        }
    }
    return made;
}

} // namespace

/* Pixels, errors and counters that no frame of a small machine has. */
static void scripted(Checks &c, const Golden &any) {
    TopHost &t = c.top;
    sphaera_reset(&t.driver, 0, POLLS);
    t.scene.behave({});
    t.frame.behave({});
    c.load(any, SCENE_A);
    core.scripted = true;
    for (int i = 0; i < 24; i++) {
        std::map<uint64_t, uint8_t> wanted, written;
        const unsigned mux = (unsigned)t.random.below(4);
        const bool half = t.random.percent(50);
        uint64_t frames[3];
        for (uint64_t &frame : frames)
            frame = t.random.next() & ADDRESSES & ~63ull;
        const uint32_t stride = 32 * (uint32_t)t.random.below(2048);
        core.fast = i % 4 > 1;
        core.script = pixels(t.random, core.fast);
        core.errors = i & 1 ? 0 : (int)t.random.below(64);
        for (uint64_t &count : core.counts)
            count = t.random.next() >> 16;
        sphaera_store(&t.driver, frames, stride, half);
        const uint32_t apart = (uint32_t)t.random.next() & SPHAERA_LAYER_BYTES_UNITS;
        sphaera_layers(&t.driver, apart);
        sphaera_mux(&t.driver, mux);
        sphaera_set(&t.driver, SPH_REG_MEM_LINES, 8 + 4 * i);
        t.scene.behave({});
        Manner slow;
        slow.stall = (unsigned)(i % 3) * 40;
        t.frame.behave(slow);
        t.frame.log = &written;
        sphaera_handle(&t.driver);
        sphaera_interrupts(&t.driver, SPHAERA_INTERRUPTS_FRAME_DONE);
        c.equals("start", (uint64_t)sphaera_start(&t.driver, 0), SPHAERA_OK);
        c.equals("a register while it goes to the core",
                 t.read(SPHAERA_MACHINE + 4 * SPH_REG_MEM_LINES), 8 + 4 * (uint64_t)i);
        for (int n = 0; n < 200000 && !t.dut.irq_o; n++)
            t.clock();
        const std::map<uint64_t, uint8_t> done = written;
        c.equals("wait", (uint64_t)sphaera_wait(&t.driver, POLLS),
                 core.errors ? SPHAERA_FAILED : SPHAERA_OK);
        t.frame.log = nullptr;
        Groups groups;
        const uint64_t base = frames[c.drawn()];
        const auto put = [&](uint64_t start, const Pixel &p, unsigned which) {
            const uint32_t colour = (uint32_t)p.colour[which];
            const uint32_t red = colour & 255, green = colour >> 8 & 255, blue = colour >> 16;
            uint32_t value = half ? (red >> 3) << 11 | (green >> 2) << 5 | blue >> 3
                                  : red << 16 | green << 8 | blue;
            uint64_t at = start + (uint64_t)p.y * stride + (uint32_t)p.x * (half ? 2 : 4);
            for (int k = 0; k < (half ? 2 : 4); k++, value >>= 8)
                wanted[at++ & ADDRESSES] = (uint8_t)value;
        };
        for (const Pixel &p : core.script) {
            groups.put(p);
            if (!c.layers) put(base, p, (mux + 3) % 4);
            for (unsigned layer = 0; c.layers && layer < SPH_FRAMES; layer++)
                put(base + (uint64_t)layer * apart, p, layer);
        }
        groups.flush();
        const uint64_t times = c.layers ? SPH_FRAMES : 1;
        c.note("bytes of the frame when it is done", done == wanted);
        c.note("bytes of the frame", written == wanted);
        uint64_t n[SPHAERA_COUNTS];
        t.clocks(t.random.below(3));
        sphaera_counters(&t.driver, n);
        for (int k = 0; k < 32; k++)
            c.equals("counter of the core", n[k], core.counts[k]);
        c.equals("READ_BURSTS", n[SPHAERA_COUNT_READ_BURSTS], t.scene.requests);
        if (!core.fast) /* or one may find its buffer full */
            c.equals("WRITE_BURSTS", n[SPHAERA_COUNT_WRITE_BURSTS], times * groups.bursts);
        c.equals("WRITE_PIXELS", n[SPHAERA_COUNT_WRITE_PIXELS], times * groups.pixels);
        c.equals("errors of the core", sphaera_errors(&t.driver), (uint64_t)core.errors);
        c.equals("each is told once", t.read(SPHAERA_ERRORS), 0);
    }
    core.scripted = core.fast = false;
    c.done("pixels, errors and counters of any kind");
}
