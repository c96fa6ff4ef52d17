/* top_faults.h - errors of the buses, resets in mid-frame, buses that never answer
 * SPDX-License-Identifier: Apache-2.0
 *
 * Whatever happens, the frame ends, the error is told, what was shown stays, and the next frame is
 * whole.
 */
#ifndef TB_TOP_FAULTS_H
#define TB_TOP_FAULTS_H

#include "top_checks.h"

/* SLVERR and DECERR, of reads and of writes, early and late in the frame. */
static void answers(Checks &c, const Golden &a, const Golden &b) {
    TopHost &t = c.top;
    for (int i = 0; i < 12; i++) {
        bool write = i & 1;
        int error = i & 2 ? DECERR : SLVERR;
        uint32_t bit = write ? SPHAERA_ERRORS_FRAME_SLVERR : SPHAERA_ERRORS_SCENE_SLVERR;
        if (error == DECERR) bit <<= 1;
        if (!write) bit |= SPHAERA_ERRORS_BUS_ERROR;
        c.whole(b, SCENE_B);
        unsigned before = c.newest(), frames = t.read(SPHAERA_FRAME_COUNT);
        Manner bad;
        bad.stall = 20;
        bad.error = error;
        bad.error_at = (int64_t)t.random.below(write ? 90 : 20);
        c.load(a, SCENE_A);
        (write ? t.frame.behave(bad) : t.scene.behave(bad));
        c.equals("the frame has errors", (uint64_t)c.draw(), SPHAERA_FAILED);
        c.equals("which", t.read(SPHAERA_ERRORS), bit);
        t.write(SPHAERA_ERRORS, ~bit);
        c.equals("a zero clears none", t.read(SPHAERA_ERRORS), bit);
        c.equals("it is not complete", t.read(SPHAERA_FRAME_COUNT), frames);
        c.equals("and not the newest", c.newest(), before);
        uint32_t errors = sphaera_errors(&t.driver);
        const char *text = sphaera_error_text(&errors);
        c.note("in words", text && *text);
        c.equals("cleared by a one", t.read(SPHAERA_ERRORS), 0);
        t.scene.behave({});
        t.frame.behave({});
    }
    c.whole(a, SCENE_A);
    c.done("SLVERR and DECERR of both masters");
}

/* Soft resets and stops at many clocks of a frame, and resets of the whole. */
static void resets(Checks &c, const Golden &a, const Golden &b) {
    TopHost &t = c.top;
    Manner slow;
    slow.stall = 30;
    slow.latency = 20;
    for (int i = 0; i < 60; i++) {
        int how = i < 30 ? i & 1 : i % 3; /* no rst for long: nothing may add up */
        slow.latency = i % 4 ? 20 : 300;  /* the bus owes lines for long */
        t.scene.behave(slow);
        t.frame.behave(slow);
        c.load(a, SCENE_A);
        sphaera_start(&t.driver, 0);
        t.clocks(t.random.below(i < 30 ? 400 : 6000));
        if (how == 2) {
            t.reset();
            struct sphaera_bus bus = t.bus();
            c.equals("open", (uint64_t)sphaera_open(&t.driver, &bus), SPHAERA_OK);
            c.store(c.stride, c.rgb565);
        } else if (how == 1) {
            t.write(SPHAERA_INTERRUPTS, SPHAERA_INTERRUPTS_FRAME_DONE);
            const bool drawing = t.read(SPHAERA_STATUS) & SPHAERA_STATUS_BUSY;
            sphaera_stop(&t.driver);
            if (drawing) /* and by now it is told */
                c.equals("a frame ended",
                         t.read(SPHAERA_INTERRUPTS) & SPHAERA_INTERRUPTS_FRAME_DONE, 1);
        } else {
            c.equals("reset", (uint64_t)sphaera_reset(&t.driver, 0, POLLS), SPHAERA_OK);
            c.equals("no errors are left", t.read(SPHAERA_ERRORS), 0);
            c.equals("nor frames", t.read(SPHAERA_FRAME_COUNT), 0);
        }
        for (unsigned n = 0; n < 5000 && t.read(SPHAERA_STATUS) & SPHAERA_STATUS_DRAINING; n++)
            ;
        c.equals("the bus owes nothing", t.scene.waiting(), 0);
        c.whole(b, SCENE_B);
        c.equals("no error", sphaera_errors(&t.driver), 0);
    }
    t.scene.behave({});
    t.frame.behave({});
    c.done("STOP, SOFT_RESET and rst in mid-frame");
}

/* Resets both buses, which last until they are let go. */
static void hold(TopHost &t, bool on) {
    t.scene.reset();
    t.frame.reset();
    t.scene.in_reset = t.frame.in_reset = on;
}

/* A bus that takes or refuses requests and answers none. */
static void silence(Checks &c, const Golden &a, const Golden &b) {
    TopHost &t = c.top;
    for (int i = 0; i < 16; i++) {
        bool write = i & 1, forget = i & 4;
        Manner deaf;
        deaf.deaf_after = (int64_t)t.random.below(write ? 50 : 15);
        deaf.refuses = i & 2;
        c.load(a, SCENE_A);
        const uint32_t limit = 500 + (uint32_t)t.random.below(1000);
        t.write(SPHAERA_WATCHDOG, limit);
        (write ? t.frame.behave(deaf) : t.scene.behave(deaf));
        sphaera_interrupts(&t.driver, SPHAERA_INTERRUPTS_ERROR);
        sphaera_handle(&t.driver);
        t.irq_at = 0;
        c.equals("the frame ends", (uint64_t)c.draw(), SPHAERA_FAILED);
        c.equals("by the watchdog", t.read(SPHAERA_ERRORS), SPHAERA_ERRORS_WATCHDOG);
        c.equals("in time", write ? t.frame_silent : t.scene_silent, limit + 1);
        c.equals("interrupt", t.dut.irq_o, 1);
        t.write(SPHAERA_ERRORS, 0xffffffff);
        t.write(SPHAERA_CONTROL, SPHAERA_CONTROL_START);
        c.equals("no frame before a reset", t.read(SPHAERA_ERRORS), SPHAERA_ERRORS_REFUSED);
        if (i & 8 && !forget) { /* it answers after all: nobody waits for that */
            t.scene.revive();
            t.frame.revive();
            t.clocks(2000);
            c.equals("what is owed is taken", t.scene.waiting(), 0);
        } else {
            c.equals("which waits for the bus", (uint64_t)sphaera_reset(&t.driver, 0, 200),
                     SPHAERA_LATE);
        }
        if (forget) { /* the interconnect is reset meanwhile */
            hold(t, true);
            c.equals("reset", (uint64_t)sphaera_reset(&t.driver, 1, 2), SPHAERA_OK);
            hold(t, false);
        }
        t.scene.revive();
        t.frame.revive();
        c.equals("reset", (uint64_t)sphaera_reset(&t.driver, 0, POLLS), SPHAERA_OK);
        c.equals("no interrupt", t.dut.irq_o, 0);
        t.write(SPHAERA_WATCHDOG, SPHAERA_WATCHDOG_RESET);
        c.whole(b, SCENE_B);
    }
    Manner deaf;
    deaf.deaf_after = 3;
    t.write(SPHAERA_WATCHDOG, 0);
    t.scene.behave(deaf);
    sphaera_start(&t.driver, 0);
    c.equals("without a watchdog it waits", (uint64_t)sphaera_wait(&t.driver, 2000), SPHAERA_LATE);
    c.equals("no error", t.read(SPHAERA_ERRORS), 0);
    t.scene.revive();
    c.equals("and goes on", (uint64_t)sphaera_wait(&t.driver, POLLS), SPHAERA_OK);
    c.same(b, c.newest(), c.depth(b));
    t.write(SPHAERA_WATCHDOG, SPHAERA_WATCHDOG_RESET);
    c.done("buses that never answer: watchdog, recovery");
}

#endif
