/* tb_frames.cpp - frames of a moving scene, one behind the other on one rt_top, without a reset
 * SPDX-License-Identifier: Apache-2.0
 *
 * usage: tb_frames LATENCY STALL SEED FOLDER MACHINE.sph...
 *
 * FOLDER gets frames.tsv, the clocks of each frame, and what the frame store held: shown-0000.ppm,
 * of an rt_top with layers each of them too: rendering-0000.ppm, l1-0000.ppm, l2-0000.ppm.
 *
 * While a frame is drawn the driver writes the next machine to the other half of memory, a beat a
 * clock, and its registers. Every frame is compared with what the golden model draws of that
 * machine alone.
 */
#include "top_checks.h"

#include <cmath>
extern "C" {
#include "tests/number.h"
}

static const uint32_t HALF[2] = {0, 0x01000000};

static const char *const LAYERS[SPH_FRAMES] = {"rendering", "l1", "l2"};

/* Memory as a processor writes it: a beat in each clock. */
static void put(void *user, uint64_t address, const uint8_t *from, uint32_t count) {
    auto &top = *static_cast<TopHost *>(user);
    for (uint32_t at = 0; at < count; at += DATA / 8) {
        uint32_t n = count - at < DATA / 8 ? count - at : DATA / 8;
        memcpy(&top.bytes[(address + at) % TopHost::MEMORY], from + at, n);
        top.clock();
    }
}

/* A byte of linear light as people see it (IEC 61966-2-1). */
static uint8_t seen(uint32_t byte) {
    double light = byte / 255.0;
    double code = light <= 0.0031308 ? 12.92 * light : 1.055 * pow(light, 1 / 2.4) - 0.055;
    return (uint8_t)lround(255 * code);
}

/* A frame of the store, as a picture. */
static bool picture(Checks &c, const sph_frame &size, uint64_t store, const std::string &path) {
    FILE *to = fopen(path.c_str(), "wb");
    if (!to) return false;
    fprintf(to, "P6 %d %d 255\n", size.width, size.height);
    for (int y = 0; y < size.height; y++)
        for (int x = 0; x < size.width; x++) {
            const uint8_t *p = &c.top.bytes[(store + (uint32_t)y * c.stride) % TopHost::MEMORY];
            for (int channel = 2; channel >= 0; channel--)
                fputc(seen(p[4 * x + channel]), to);
        }
    return fclose(to) == 0;
}

/* What is shown of the newest frame, and its layers. */
static void pictures(Checks &c, const Golden &golden, const std::string &folder, int number) {
    const unsigned newest = c.newest();
    const auto write = [&](const char *what, uint32_t place) {
        char name[32];
        snprintf(name, sizeof name, "/%s-%04d.ppm", what, number);
        c.note("a picture is written", picture(c, golden.frame, place, folder + name));
    };
    write("shown", c.place(golden, newest));
    for (uint32_t layer = 0; c.layers && layer < std::size(LAYERS); layer++)
        write(LAYERS[layer], c.stores[newest] + layer * c.apart);
}

int main(int argc, char **argv) {
    if (argc < 6) {
        fprintf(stderr, "usage: tb_frames LATENCY STALL SEED FOLDER MACHINE.sph...\n");
        return 2;
    }
    auto c = std::make_unique<Checks>(test_number(argv[3], "argument 3", 0));
    TopHost &t = c->top;
    t.driver.bus.put = put;
    Manner manner;
    manner.latency = (unsigned)test_number(argv[1], "argument", 0);
    manner.stall = (unsigned)test_number(argv[2], "argument", 0);
    t.write(SPHAERA_WATCHDOG, 0);
    sphaera_interrupts(&t.driver, SPHAERA_INTERRUPTS_FRAME_DONE);
    const int first = 5; /* of the machines */
    const std::string folder = argv[first - 1];
    FILE *table = fopen((folder + "/frames.tsv").c_str(), "w");
    if (!table) {
        fprintf(stderr, "%s: cannot write\n", folder.c_str());
        return 2;
    }
    fprintf(table, "bytes\tupload\tdraw\twritten\tpixels_a_burst\n");
    auto now = std::make_unique<Golden>(argv[first]);
    bool fits = c->place(*now) && now->file.size() <= HALF[1];
    uint64_t upload = t.cycle;
    c->equals("load", (uint64_t)c->load(*now, HALF[0]), SPHAERA_OK);
    upload = t.cycle - upload;
    for (int i = first; fits && i < argc; i++) {
        t.scene.behave(manner);
        t.frame.behave(manner);
        sphaera_handle(&t.driver);
        t.irq_at = 0;
        uint64_t begin = t.cycle, next_upload = 0, n[SPHAERA_COUNTS];
        c->equals("start", (uint64_t)sphaera_start(&t.driver, 0), SPHAERA_OK);
        std::unique_ptr<Golden> next;
        if (i + 1 < argc) {
            next = std::make_unique<Golden>(argv[i + 1]);
            fits = next->file.size() <= HALF[1];
            next_upload = t.cycle;
            c->equals("load", (uint64_t)c->load(*next, HALF[(i + 1 - first) % 2]), SPHAERA_OK);
            next_upload = t.cycle - next_upload;
        }
        uint64_t end = c->finish_frame();
        c->equals("errors", sphaera_errors(&t.driver), 0);
        sphaera_counters(&t.driver, n);
        c->same(*now, c->newest(), Checks::depth(*now));
        fprintf(table, "%u\t%llu\t%llu\t%llu\t%.2f\n", 32 * now->machine.lines,
                (unsigned long long)upload, (unsigned long long)n[SPHAERA_COUNT_CYCLES],
                (unsigned long long)(end - begin),
                (double)n[SPHAERA_COUNT_WRITE_PIXELS] / (double)n[SPHAERA_COUNT_WRITE_BURSTS]);
        pictures(*c, *now, folder, i - first);
        upload = next_upload;
        now = std::move(next);
    }
    c->note("the table is written", fclose(table) == 0);
    c->note("frames and machines fit into 64 MB", fits);
    c->done(c->layers ? "Rendering, L1 and L2 of every frame equal those of its machine alone"
                      : "every frame equals that of its machine alone");
    return c->finish();
}
