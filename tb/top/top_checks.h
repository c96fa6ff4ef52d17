/* top_checks.h - machines, golden frames and TAP lines for the harness of rt_top
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef TB_TOP_CHECKS_H
#define TB_TOP_CHECKS_H

#include <memory>
#include <set>

#include "top_host.h"

extern "C" {
#include "render/render.h"
#include "machine/format.h"
#include "../../driver/sphaera_file.h"
#include "validate/validate.h"
}

static_assert((int)SPHAERA_FILE_VERSION == (int)SPH_FILE_VERSION &&
                  (int)SPHAERA_HEADER_LEAST == (int)SPH_AT_REGS &&
                  (int)SPHAERA_AT_LINES == (int)SPH_AT_LINES,
              "driver/sphaera_file.h reads the machine file as it is");

/* A machine file, and what the golden model draws of it. */
struct Golden {
    std::vector<uint8_t> file;
    sph_machine machine{};
    sph_frame frame{};
    sph_counters counters{};

    explicit Golden(const char *path) {
        struct sph_error err = {{0}};
        FILE *from = fopen(path, "rb");
        uint8_t part[4096];
        for (size_t n; from && (n = fread(part, 1, sizeof part, from)) > 0;)
            file.insert(file.end(), part, part + n);
        if (from) fclose(from);
        const struct sph_render_options options = {};
        if (sph_machine_read(path, &machine, &err) ||
            sph_render(&machine, &options, &frame, &counters, &err) < 0) {
            fprintf(stderr, "%s\n", err.text);
            exit(2);
        }
    }
    ~Golden() {
        sph_frame_free(&frame);
        sph_machine_free(&machine);
    }
    Golden(const Golden &) = delete;
};

/* Where the checks put things. */
enum : uint32_t {
    SCENE_A = 0x00100000,
    SCENE_B = 0x00803000,
    STORE = 0x02000000,
    APART = 0x200000
};
/* Bits of addresses from 32 up, of the scene and of each frame; memory is seen at all of them. */
const uint64_t ADDRESSES = (1ull << ADDR) - 1;
const uint64_t HIGH_SCENE = 0x9600000000 & ADDRESSES;
const uint64_t HIGH[3] = {0x5a00000000 & ADDRESSES, 0xc300000000 & ADDRESSES,
                          0x3c00000000 & ADDRESSES};
const uint32_t POLLS = 100000;
const uint32_t LIMIT = 100000000; /* clocks of the longest frame */

class Checks {
  public:
    TopHost top;
    std::set<std::string> names; /* of the checks that came to their end */
    uint64_t stores[3] = {HIGH[0] + STORE, HIGH[1] + STORE + APART, HIGH[2] + STORE + 2 * APART};
    uint32_t stride = 2560;
    int rgb565 = 0;
    bool layers;              /* a frame has three of them, */
    uint32_t apart = 0x40000; /* so many bytes apart */
    unsigned mux = 0;         /* what register MUX has */

    explicit Checks(uint64_t seed) : top(seed), seed_(seed) {
        struct sphaera_bus bus = top.bus();
        note("open", sphaera_open(&top.driver, &bus) == SPHAERA_OK);
        layers = top.driver.built & SPHAERA_CORE_BUS_LAYERS;
        store(2560, 0);
    }
    void store(uint32_t bytes, int half) {
        stride = bytes;
        rgb565 = half;
        note("store", sphaera_store(&top.driver, stores, bytes, half) == SPHAERA_OK);
        equals("layers", (uint64_t)sphaera_layers(&top.driver, apart),
               layers ? SPHAERA_OK : SPHAERA_NO_LAYERS);
    }
    bool builds() const { return top.driver.built & SPHAERA_CORE_BUS_BUILD; }
    void choose(unsigned frame) {
        mux = frame;
        sphaera_mux(&top.driver, frame);
    }
    /* Frames apart as far as they are large, in the upper half of memory; whether they fit. */
    bool place(const Golden &first) {
        uint32_t bytes = ((uint32_t)first.frame.width * 4 + 31) / 32 * 32;
        apart = (bytes * (uint32_t)first.frame.height + 63) / 64 * 64;
        const uint32_t whole = layers ? SPH_FRAMES * apart : apart;
        for (uint32_t i = 0; i < 3; i++)
            stores[i] = HIGH[i] + STORE + i * whole;
        store(bytes, 0);
        return STORE + 3ull * whole <= TopHost::MEMORY;
    }
    /* Waits for the interrupt; the clock that it came in. */
    uint64_t finish_frame() {
        uint64_t end = top.cycle + LIMIT;
        while (!top.dut.irq_o && top.cycle < end)
            top.clock();
        equals("interrupt", sphaera_handle(&top.driver) & SPHAERA_INTERRUPTS_FRAME_DONE,
               SPHAERA_INTERRUPTS_FRAME_DONE);
        return top.irq_at;
    }
    /* One condition of the check that is under way; the first that does not hold is printed. */
    bool note(const char *what, bool holds) {
        conditions_++;
        if (!holds && good_) printf("# %s, clock %llu\n", what, (unsigned long long)top.cycle);
        good_ = good_ && holds;
        return holds;
    }
    bool equals(const char *what, uint64_t is, uint64_t wanted) {
        if (is == wanted) return note(what, true);
        if (good_ || !wanted)
            printf("# %s: 0x%llx, not 0x%llx\n", what, (unsigned long long)is,
                   (unsigned long long)wanted);
        return note(what, false);
    }
    /* Frame n of the store against the golden model's colours at depth `depth`; if it has layers,
     * each of them against its own. */
    bool same(const Golden &golden, unsigned n, int depth) {
        if (!layers) return same_at(golden, stores[n], depth);
        bool all = true;
        for (int layer = 0; layer < SPH_FRAMES; layer++)
            all = same_at(golden, stores[n] + (uint32_t)layer * apart, layer) && all;
        return all;
    }
    /* Where what is shown of frame n begins. */
    uint64_t place(const Golden &golden, unsigned n) {
        return stores[n] + (layers ? (uint32_t)shown_depth(golden) * apart : 0);
    }
    /* Colours at which depth MUX chooses. */
    int shown_depth(const Golden &golden) const { return mux ? (int)mux - 1 : depth(golden); }
    bool same_at(const Golden &golden, uint64_t base, int depth) {
        const sph_frame &f = golden.frame;
        for (int y = 0; y < f.height; y++)
            for (int x = 0; x < f.width; x++) {
                uint32_t c = f.pixels[y * f.width + x].colour[depth];
                uint32_t red = c & 255, green = c >> 8 & 255, blue = c >> 16 & 255;
                uint32_t want = rgb565 ? (red >> 3) << 11 | (green >> 2) << 5 | blue >> 3
                                       : red << 16 | green << 8 | blue;
                uint64_t at = base + (uint32_t)y * stride + (uint32_t)x * (rgb565 ? 2 : 4);
                uint32_t is = 0;
                memcpy(&is, &top.bytes[at % TopHost::MEMORY], rgb565 ? 2 : 4);
                if (is == want) continue;
                if (good_) printf("# depth %d, pixel %d %d: %x, not %x\n", depth, x, y, is, want);
                return note("a pixel differs", false);
            }
        return note("frame", true);
    }
    /* What STATUS says is drawn now, or was. */
    unsigned drawn() {
        return (top.read(SPHAERA_STATUS) & SPHAERA_STATUS_DRAWN) >> SPHAERA_STATUS_DRAWN_LSB;
    }
    unsigned newest() {
        return (top.read(SPHAERA_STATUS) & SPHAERA_STATUS_NEWEST) >> SPHAERA_STATUS_NEWEST_LSB;
    }
    /* Draws a machine that is loaded; the store is filled with noise before. A hang is the end. */
    int draw() {
        spoil();
        int result = sphaera_start(&top.driver, 0);
        if (result == SPHAERA_OK) result = sphaera_wait(&top.driver, POLLS);
        if (result != SPHAERA_LATE) return result;
        printf("not ok %d - a frame does not end, clock %llu\n", number_ + 1,
               (unsigned long long)top.cycle);
        exit(1);
    }
    void spoil() {
        memset(&top.bytes[STORE], 0xa5, 3 * APART);
        for (uint64_t at : stores)
            for (uint32_t layer = 0; layer < (layers ? SPH_FRAMES : 1); layer++)
                memset(&top.bytes[(at + layer * apart) % TopHost::MEMORY], 0xa5, 0x10000);
    }
    int load(const Golden &golden, uint32_t base) {
        return sphaera_load(&top.driver, golden.file.data(), (uint32_t)golden.file.size(),
                            HIGH_SCENE + base);
    }
    /* Loads and draws a machine, all of it right. */
    void whole(const Golden &golden, uint32_t base) {
        equals("load", (uint64_t)load(golden, base), SPHAERA_OK);
        if (!equals("draw", (uint64_t)draw(), SPHAERA_OK))
            equals("errors", top.read(SPHAERA_ERRORS), 0);
        same(golden, newest(), depth(golden));
    }
    /* Which colours register FRAME of the machine selects. */
    static int depth(const Golden &golden) {
        int frame = golden.machine.regs[SPH_REG_FRAME];
        return frame < SPH_FRAMES ? frame : SPH_FRAMES - 1;
    }
    /* Ends a check: one TAP line. */
    void done(const char *name) {
        for (const Channel *side :
             {(const Channel *)&top.scene, (const Channel *)&top.scan, (const Channel *)&top.frame})
            if (!side->broken.empty()) {
                printf("# %s\n", side->broken.c_str());
                good_ = false;
            }
        if (!top.view.broken.empty()) printf("# %s\n", top.view.broken.c_str());
        note("the host's view", top.view.broken.empty());
        note("a register did not answer", !top.hangs);
        printf("%s %d - %s, seed %llu: %ld conditions\n", good_ ? "ok" : "not ok", ++number_, name,
               (unsigned long long)seed_, conditions_);
        names.insert(name);
        failed_ += !good_;
        fflush(stdout);
        if (failed_ && getenv("BENCH_FIRST")) exit(1); /* the first one is enough */
        good_ = true;
        conditions_ = 0;
    }
    int finish() {
        printf("1..%d\n", number_);
        return failed_ != 0;
    }

  private:
    uint64_t seed_;
    bool good_ = true;
    long conditions_ = 0;
    int number_ = 0, failed_ = 0;
};

#endif
