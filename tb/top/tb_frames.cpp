/* tb_frames.cpp - frames of a moving scene, one behind the other on one rt_top, without a reset
 * SPDX-License-Identifier: Apache-2.0
 *
 * usage: tb_frames LATENCY STALL SEED MACHINE.sph...
 *
 * While a frame is drawn the driver writes the next machine to the other half of memory, a beat a
 * clock, and its registers. Every frame is compared with what the golden model draws of that
 * machine alone.
 */
#include "top_checks.h"

static const uint32_t HALF[2] = {0, 0x01000000};

/* Memory as a processor writes it: a beat in each clock. */
static void put(void *user, uint32_t address, const uint8_t *from, uint32_t count) {
    auto &top = *static_cast<TopHost *>(user);
    for (uint32_t at = 0; at < count; at += DATA / 8) {
        uint32_t n = count - at < DATA / 8 ? count - at : DATA / 8;
        memcpy(&top.bytes[address + at], from + at, n);
        top.clock();
    }
}

int main(int argc, char **argv) {
    if (argc < 5) {
        fprintf(stderr, "usage: tb_frames LATENCY STALL SEED MACHINE.sph...\n");
        return 2;
    }
    auto c = std::make_unique<Checks>(strtoull(argv[3], nullptr, 0));
    TopHost &t = c->top;
    t.driver.bus.put = put;
    Manner manner;
    manner.latency = (unsigned)atoi(argv[1]);
    manner.stall = (unsigned)atoi(argv[2]);
    t.write(SPHAERA_WATCHDOG, 0);
    sphaera_interrupts(&t.driver, SPHAERA_INTERRUPTS_FRAME_DONE);
    printf("frame      bytes     upload       draw   from START to all written   pixels a burst\n");
    auto now = std::make_unique<Golden>(argv[4]);
    bool fits = c->place(*now) && now->file.size() <= HALF[1];
    uint64_t upload = t.cycle;
    c->equals("load", (uint64_t)c->load(*now, HALF[0]), SPHAERA_OK);
    upload = t.cycle - upload;
    for (int i = 4; fits && i < argc; i++) {
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
            c->equals("load", (uint64_t)c->load(*next, HALF[(i + 1) % 2]), SPHAERA_OK);
            next_upload = t.cycle - next_upload;
        }
        uint64_t end = c->finish_frame();
        c->equals("errors", sphaera_errors(&t.driver), 0);
        sphaera_counters(&t.driver, n);
        c->same(*now, c->newest(), Checks::depth(*now));
        printf("%5d %10u %10llu %10llu %27llu %16.2f\n", i - 4, 32 * now->machine.lines,
               (unsigned long long)upload, (unsigned long long)n[SPHAERA_COUNT_CYCLES],
               (unsigned long long)(end - begin),
               (double)n[SPHAERA_COUNT_WRITE_PIXELS] / (double)n[SPHAERA_COUNT_WRITE_BURSTS]);
        upload = next_upload;
        now = std::move(next);
    }
    c->note("frames and machines fit into 64 MB", fits);
    c->done("every frame equals that of its machine alone");
    return c->finish();
}
