/* tb_show.cpp - one frame of rt_top all the way: machine file, frame store, decoded video
 * SPDX-License-Identifier: Apache-2.0
 *
 * usage: tb_show MACHINE.sph
 *
 * The driver loads the machine and draws it; then the display is switched on, in the mode of
 * modes.def of this size or, for a small frame, in one with as little blanking as serves. Store and
 * decoded picture must equal the golden model's frame.
 */
#include "top_display.h"

#include <chrono>

static video::Mode mode_of(const sph_frame &frame) {
    struct Named {
        const char *name;
        unsigned khz;
        video::Mode mode;
    };
#define MODE_NAMED(name, khz, ...) {name, khz, {__VA_ARGS__}},
    const Named modes[] = {SPHAERA_MODES(MODE_NAMED)};
    unsigned width = (unsigned)frame.width, height = (unsigned)frame.height;
    for (const Named &n : modes)
        if (n.mode.h_active == width && n.mode.v_active == height) return n.mode;
    return {width, 2, 4, 30, height, 2, 2, 60, 0, 1};
}

static double seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

int main(int argc, char **argv) {
    if (argc < 2) {
        fprintf(stderr, "usage: tb_show MACHINE.sph\n");
        return 2;
    }
    Golden golden(argv[1]);
    auto c = std::make_unique<Checks>(1);
    TopHost &t = c->top;
    t.write(SPHAERA_WATCHDOG, 0);
    c->note("the frames fit into 64 MB", c->place(golden));
    c->equals("load", (uint64_t)c->load(golden, SCENE_A), SPHAERA_OK);
    sphaera_interrupts(&t.driver, SPHAERA_INTERRUPTS_FRAME_DONE);
    double start = seconds();
    uint64_t begin = t.cycle, n[SPHAERA_COUNTS];
    c->equals("start", (uint64_t)sphaera_start(&t.driver, 0), SPHAERA_OK);
    uint64_t clocks = c->finish_frame() - begin;
    double drawn = seconds() - start;
    c->equals("errors", sphaera_errors(&t.driver), 0);
    c->same(golden, c->newest(), Checks::depth(golden));
    sphaera_counters(&t.driver, n);
    printf("# %d x %d: %llu clocks, %llu of them the core's; %.2f of 8 pixels a burst; "
           "%llu lines read; %.1f s\n",
           golden.frame.width, golden.frame.height, (unsigned long long)clocks,
           (unsigned long long)n[SPHAERA_COUNT_CYCLES],
           (double)n[SPHAERA_COUNT_WRITE_PIXELS] / (double)n[SPHAERA_COUNT_WRITE_BURSTS],
           (unsigned long long)n[SPHAERA_COUNT_READ_BURSTS], drawn);
    c->done("a frame in the store");

    const video::Mode mode = mode_of(golden.frame);
    const struct sphaera_mode set = {(uint16_t)mode.h_active,
                                     (uint16_t)mode.h_front,
                                     (uint16_t)mode.h_sync,
                                     (uint16_t)mode.h_back,
                                     (uint16_t)mode.v_active,
                                     (uint16_t)mode.v_front,
                                     (uint16_t)mode.v_sync,
                                     (uint16_t)mode.v_back,
                                     (uint8_t)mode.h_pol,
                                     (uint8_t)mode.v_pol,
                                     0};
    t.pixel_every = 1;
    start = seconds();
    begin = t.cycle;
    Screen screen(*c, golden, golden, mode);
    sphaera_interrupts(&t.driver, SPHAERA_INTERRUPTS_UNDERRUN);
    sphaera_video(&t.driver, &set);
    c->note("a picture", screen.pictures(1));
    c->equals("it is the frame", screen.seen.empty() ? 9 : (uint64_t)screen.seen.back(), 0);
    c->note("no underrun", !t.dut.irq_o);
    c->note("every sync is in its place", screen.error().empty());
    printf("# decoded: %u x %u clocks a frame; %.1f s\n", mode.h_total(), mode.v_total(),
           seconds() - start);
    c->done("the same as decoded video");
    return c->finish();
}
