/* top_builds.h - trees that rt_top builds: their words, frames of them, errors, resets, silence
 * SPDX-License-Identifier: Apache-2.0
 *
 * sph_bt_build() says what memory and registers hold behind each BUILD.
 */
#ifndef TB_TOP_BUILDS_H
#define TB_TOP_BUILDS_H

#include "top_faults.h"
extern "C" {
#include "build/places.h"
#include "tests/drawn_spheres.h"
}

class Builds {
  public:
    /* Lines behind SCENE_A that hold what is drawn here: trees, records, lines between them. */
    static constexpr uint32_t FROM = 0x1000, LINES = 0x800;
    enum Trouble { NONE, MANY, ROOM, RECORD, READ, WRITE, ORDER, TROUBLES, SILENCE };

    Builds(Checks &checks, const Golden &a)
        : c_(checks), t_(checks.top), profile_(a.machine.profile),
          most_(1u << ((t_.driver.built & SPHAERA_CORE_BUS_BUILD) >> SPHAERA_CORE_BUS_BUILD_LSB)) {
        sphaera_reset(&t_.driver, 0, POLLS);
        t_.scene.behave({});
        t_.frame.behave({});
        c_.load(a, SCENE_A);
    }
    uint32_t *line(uint32_t number) { return (uint32_t *)&t_.bytes[SCENE_A + 32 * number]; }
    uint32_t most() const { return most_; }
    bool valid() const { return places_.valid; }
    void forget() {
        places_.valid = 0;
        sph_bt_forget(&kept_);
    }
    ~Builds() { sph_bt_forget(&kept_); }

    void interrupts(bool on) {
        interrupts_ = on;
        sphaera_interrupts(&t_.driver, on ? SPHAERA_INTERRUPTS_BUILD_DONE : 0);
    }
    /* Draws spheres and places, and something that is wrong. */
    void draw(Trouble trouble) {
        for (uint32_t i = 0; i < LINES * SPH_LINE_WORDS; i++)
            line(FROM)[i] = (uint32_t)t_.random.next();
        const uint32_t least = trouble == SILENCE ? most_ / 2 : trouble != NONE;
        uint32_t n = (uint32_t)t_.random.between(least, most_);
        int mode = (int)t_.random.below(3);
        if (trouble == ORDER) mode = 3;
        if (mode == SPH_BUILD_REFIT && kept_.order) n = kept_.n;
        if (mode == SPH_BUILD_REFIT && (n < least || !kept_.order)) mode = SPH_BUILD_CURVE;
        std::vector<sph_bt_leaf> leaves(n + 1);
        drawn_spheres((drawn_kind)t_.random.below(DRAWN_KINDS), leaves.data(), n, &profile_, next,
                      &t_.random);
        const uint32_t room = (uint32_t)sph_bt_lines(n) + (uint32_t)t_.random.below(3);
        uint32_t at = FROM;
        for (uint32_t &tree : places_.tree)
            tree = at += (uint32_t)t_.random.below(9), at += room;
        const uint32_t rounds = t_.random.percent(50) ? 0 : (uint32_t)t_.random.below(4);
        job_ = {n, at + (uint32_t)t_.random.below(9), 0, room, mode, rounds, &kept_};
        for (uint32_t id = 0; id < n; id++)
            drawn_record(line(job_.prim_base + id), id, &leaves[id], t_.random.next());
        const uint32_t one = (uint32_t)t_.random.below(n ? n : 1);
        if (trouble == MANY) job_.n = most_ + 1 + (uint32_t)t_.random.below(1u << 20);
        if (trouble == ROOM) job_.lines = (uint32_t)t_.random.below(2 * n);
        if (trouble == RECORD)
            sph_field_set(line(job_.prim_base + one), SPH_LEAF_RAD_LSB, SPH_LEAF_RAD_BITS, 0);
        trouble_ = trouble;
    }
    /* BUILD of what was drawn, not waited for. */
    void start(const Manner &manner) { start(manner, manner); }
    void start(Manner reads, Manner writes) {
        const uint32_t beats = 256 / (8 * sizeof t_.dut.m_scene_rdata);
        reads.error = writes.error = t_.random.percent(50) ? SLVERR : DECERR;
        if (trouble_ == READ) reads.error_at = (int64_t)t_.random.below(beats * job_.n);
        if (trouble_ == WRITE) writes.error_at = 0;
        t_.scene.behave(reads);
        t_.frame.behave(writes);
        settings(job_.n);
        expected_.assign(line(FROM), line(FROM) + LINES * SPH_LINE_WORDS);
        c_.equals("build", (uint64_t)sphaera_build(&t_.driver, 0), SPHAERA_OK);
        /* what is written now counts from the next one on */
        for (uint32_t at = SPHAERA_BUILD_COUNT; at <= SPHAERA_BUILD_MODE; at += 4)
            t_.write(at, (uint32_t)t_.random.next());
        t_.write(SPHAERA_SCENE_BASE, SCENE_B);
    }
    void settings(uint32_t n) {
        const struct sphaera_trees trees = {
            n <= most_ ? n : 0, job_.prim_base,      {places_.tree[0], places_.tree[1]},
            job_.lines,         (unsigned)job_.mode, job_.rounds};
        c_.equals("trees", (uint64_t)sphaera_trees(&t_.driver, &trees), SPHAERA_OK);
        if (n > most_) t_.write(SPHAERA_BUILD_COUNT, n);
        t_.write(SPHAERA_SCENE_BASE, SCENE_A);
    }
    /* Its end, against the model. */
    void finish() {
        const int waited = sphaera_build_wait(&t_.driver, POLLS);
        struct sph_error err;
        uint32_t written;
        const int bus = trouble_ == READ    ? SPH_BT_READ_ERROR
                        : trouble_ == WRITE ? SPH_BT_WRITE_ERROR
                                            : SPH_BT_ANSWERS;
        const int wrong =
            sph_bt_build(&places_, expected_.data() - (ptrdiff_t)FROM * SPH_LINE_WORDS, &job_,
                         most_, bus, &profile_, &written, &err);
        c_.equals("interrupt", t_.dut.irq_o, interrupts_);
        c_.equals("built", (uint64_t)waited, wrong ? SPHAERA_NOT_BUILT : SPHAERA_OK);
        status(wrong);
        if (!wrong) c_.equals("BUILD_WRITTEN", t_.read(SPHAERA_BUILD_WRITTEN), written);
        c_.note("memory", std::equal(expected_.begin(), expected_.end(), line(FROM)));
        sphaera_errors(&t_.driver);
        t_.scene.behave({});
        t_.frame.behave({});
    }
    /* What the registers say of the newest tree and of errors. */
    void status(int wrong) {
        const uint32_t is = t_.read(SPHAERA_STATUS);
        c_.equals("a tree", (is & SPHAERA_STATUS_TREE_VALID) != 0, (uint64_t)places_.valid);
        if (places_.valid)
            c_.equals("which", (is & SPHAERA_STATUS_TREE) != 0, (uint64_t)places_.newest);
        c_.equals("errors", t_.read(SPHAERA_ERRORS),
                  (uint32_t)wrong << SPHAERA_ERRORS_BUILD_MANY_LSB);
        c_.equals("interrupts",
                  sphaera_handle(&t_.driver) &
                      (SPHAERA_INTERRUPTS_BUILD_DONE | SPHAERA_INTERRUPTS_ERROR),
                  SPHAERA_INTERRUPTS_BUILD_DONE | (wrong ? SPHAERA_INTERRUPTS_ERROR : 0));
    }

  private:
    static uint64_t next(void *of) { return static_cast<bench::Random *>(of)->next(); }
    Checks &c_;
    TopHost &t_;
    sph_profile profile_;
    uint32_t most_;
    sph_bt_places places_ = {};
    sph_bt_job job_ = {};
    sph_bt_kept kept_ = {};
    Trouble trouble_ = NONE;
    bool interrupts_ = false;
    std::vector<uint32_t> expected_;
};

/* Trees of any spheres, anywhere; all that can be wrong. */
static void built_words(Checks &c, const Golden &a) {
    Builds b(c, a);
    TopHost &t = c.top;
    b.interrupts(true);
    for (int i = 0; i < 60; i++) {
        Manner manner;
        manner.stall = i & 1 ? 0 : (unsigned)t.random.below(80);
        manner.latency = 1 + (unsigned)t.random.below(60);
        b.draw(i & 2 ? Builds::NONE : (Builds::Trouble)t.random.below(Builds::TROUBLES));
        b.start(manner);
        b.finish();
        c.equals("an interrupt that was handled", t.dut.irq_o, 0);
    }
    b.interrupts(false);
    c.done("trees of any spheres; too many, no room, wrong records, errors of the buses");
}

/* Resets at any clock of a build, and BUILD while one is built. */
static void built_resets(Checks &c, const Golden &a) {
    Builds b(c, a);
    TopHost &t = c.top;
    for (int i = 0; i < 60; i++) {
        Manner slow;
        slow.stall = 30;
        slow.latency = i % 4 ? 20 : 300;
        b.draw(Builds::NONE);
        b.start(slow);
        t.clocks(t.random.below(i < 20 ? 60 : 4000));
        if (t.read(SPHAERA_STATUS) & SPHAERA_STATUS_BUILDING) {
            t.write(SPHAERA_CONTROL, SPHAERA_CONTROL_BUILD);
            const uint32_t errors = t.read(SPHAERA_ERRORS);
            c.note("a second BUILD is refused",
                   errors & SPHAERA_ERRORS_BUILD_REFUSED ||
                       !(t.read(SPHAERA_STATUS) & SPHAERA_STATUS_BUILDING));
        }
        if (i % 3 == 2) {
            t.reset();
            struct sphaera_bus bus = t.bus();
            c.equals("open", (uint64_t)sphaera_open(&t.driver, &bus), SPHAERA_OK);
            c.store(c.stride, c.rgb565);
        } else {
            c.equals("reset", (uint64_t)sphaera_reset(&t.driver, 0, POLLS), SPHAERA_OK);
        }
        b.forget();
        c.equals("nothing is built",
                 t.read(SPHAERA_STATUS) & (SPHAERA_STATUS_BUILDING | SPHAERA_STATUS_TREE_VALID), 0);
        c.equals("no errors are left", t.read(SPHAERA_ERRORS), 0);
        c.equals("the bus owes nothing", t.scene.waiting(), 0);
        sphaera_handle(&t.driver);
        b.draw(Builds::NONE);
        b.start({});
        b.finish();
    }
    c.done("SOFT_RESET and rst at any clock of a build");
}

/* A bus that answers nothing while a tree is built. */
static void built_silence(Checks &c, const Golden &a) {
    Builds b(c, a);
    TopHost &t = c.top;
    for (int i = 0; i < 12; i++) {
        b.draw(Builds::NONE);
        b.start({});
        b.finish();
        b.draw(Builds::SILENCE);
        Manner deaf;
        deaf.deaf_after = i & 1 ? 0 : 5;
        deaf.refuses = i & 2;
        t.write(SPHAERA_WATCHDOG, 700);
        b.start(i & 1 ? Manner{} : deaf, i & 1 ? deaf : Manner{});
        const uint32_t before = t.read(SPHAERA_STATUS) & SPHAERA_STATUS_TREE;
        const int waited = sphaera_build_wait(&t.driver, POLLS);
        c.equals("it ends", (uint64_t)waited, SPHAERA_NOT_BUILT);
        c.equals("by the watchdog", t.read(SPHAERA_ERRORS), SPHAERA_ERRORS_BUILD_BUS);
        const uint32_t status = t.read(SPHAERA_STATUS);
        c.equals("the last tree stays", status & (SPHAERA_STATUS_TREE_VALID | SPHAERA_STATUS_TREE),
                 SPHAERA_STATUS_TREE_VALID | before);
        c.note("the bus is drained", status & SPHAERA_STATUS_DRAINING);
        c.equals("no other meanwhile", (uint64_t)sphaera_build(&t.driver, 0), SPHAERA_BUSY);
        if (i & 4) { /* it is reset, with what is around it */
            hold(t, true);
            c.equals("reset", (uint64_t)sphaera_reset(&t.driver, 1, 2), SPHAERA_OK);
            hold(t, false);
        }
        t.scene.revive(), t.frame.revive();
        t.clocks(2000);
        c.equals("then not", t.read(SPHAERA_STATUS) & SPHAERA_STATUS_DRAINING, 0);
        sphaera_reset(&t.driver, 0, POLLS);
        b.forget();
        t.write(SPHAERA_WATCHDOG, SPHAERA_WATCHDOG_RESET);
    }
    c.done("buses that never answer a builder");
}

/* Frames of trees that are built before them, beside them, and of none. */
static void built_frames(Checks &c, const Golden &a) {
    TopHost &t = c.top;
    const uint32_t n = (uint32_t)a.machine.regs[SPH_REG_N_PRIMS], lines = a.machine.lines;
    const uint32_t from = (uint32_t)a.machine.regs[SPH_REG_PRIM_BASE];
    struct sphaera_trees trees = {n, from, {lines, lines + 2 * n}, 2 * n, 0, 0};
    const auto noise =
        [&](int place) { /* where the newest tree is not */
                         const bool newest = t.read(SPHAERA_STATUS) & SPHAERA_STATUS_TREE;
                         const uint32_t at = trees.tree[place < 0 ? !newest : place];
                         for (uint32_t i = 0; i < 2 * n * 32; i++)
                             t.bytes[SCENE_A + 32 * at + i] = (uint8_t)t.random.next();
        };
    sphaera_reset(&t.driver, 0, POLLS);
    t.scene.behave({});
    t.frame.behave({});
    c.load(a, SCENE_A);
    sphaera_set(&t.driver, SPH_REG_MEM_LINES, lines + 4 * n);
    c.equals("trees", (uint64_t)sphaera_trees(&t.driver, &trees), SPHAERA_OK);
    c.equals("a frame of the host's tree", (uint64_t)c.draw(), SPHAERA_OK);
    c.same(a, c.newest(), c.depth(a));
    sphaera_set(&t.driver, SPH_REG_ROOT, lines + 4 * n - 1); /* nobody reads that from now on */
    noise(0), noise(1);
    c.spoil();
    c.equals("build and draw", (uint64_t)sphaera_build(&t.driver, 1), SPHAERA_OK);
    c.note("a START that waits is busy", t.read(SPHAERA_STATUS) & SPHAERA_STATUS_BUSY);
    c.equals("wait", (uint64_t)sphaera_wait(&t.driver, POLLS), SPHAERA_OK);
    c.same(a, c.newest(), c.depth(a));
    for (int i = 0; i < 24; i++) {
        Manner manner;
        manner.stall = i & 1 ? 30 : 0;
        t.scene.behave(manner);
        t.frame.behave(manner);
        const bool fails = i % 4 == 3;
        if (!fails) noise(-1);
        c.spoil();
        c.equals("start", (uint64_t)sphaera_start(&t.driver, 0), SPHAERA_OK);
        t.clocks(t.random.below(i < 8 ? 150 : 2000));
        if (fails) t.write(SPHAERA_BUILD_COUNT, 0xffffff);
        c.equals("build beside it", (uint64_t)sphaera_build(&t.driver, 0), SPHAERA_OK);
        c.equals("built", (uint64_t)sphaera_build_wait(&t.driver, POLLS),
                 fails ? SPHAERA_NOT_BUILT : SPHAERA_OK);
        t.write(SPHAERA_BUILD_COUNT, n);
        const bool drawn = t.read(SPHAERA_STATUS) & SPHAERA_STATUS_BUSY;
        if (i % 4 == 1 && drawn) { /* its place is read: it waits for the frame */
            c.equals("another", (uint64_t)sphaera_build(&t.driver, 0), SPHAERA_OK);
            t.clocks(50);
            const uint32_t status = t.read(SPHAERA_STATUS);
            c.note("it waits", status & SPHAERA_STATUS_BUILDING || !(status & SPHAERA_STATUS_BUSY));
        }
        c.equals("the frame", (uint64_t)sphaera_wait(&t.driver, POLLS), SPHAERA_OK);
        c.same(a, c.newest(), c.depth(a));
        c.equals("the other", (uint64_t)sphaera_build_wait(&t.driver, POLLS),
                 fails ? SPHAERA_NOT_BUILT : SPHAERA_OK);
        sphaera_errors(&t.driver);
    }
    /* a START that waits for a tree with errors, or that is stopped, does nothing */
    const uint32_t frames = t.read(SPHAERA_FRAME_COUNT);
    t.write(SPHAERA_BUILD_COUNT, 0xffffff);
    sphaera_build(&t.driver, 1);
    c.equals("too many", (uint64_t)sphaera_build_wait(&t.driver, POLLS), SPHAERA_NOT_BUILT);
    t.clocks(300);
    c.equals("no frame of it", t.read(SPHAERA_STATUS) & SPHAERA_STATUS_BUSY, 0);
    t.write(SPHAERA_BUILD_COUNT, n);
    sphaera_build(&t.driver, 1);
    sphaera_stop(&t.driver);
    c.equals("built", (uint64_t)sphaera_build_wait(&t.driver, POLLS), SPHAERA_OK);
    t.clocks(300);
    c.equals("no frame", t.read(SPHAERA_FRAME_COUNT), frames);
    c.equals("nothing is drawn", t.read(SPHAERA_STATUS) & SPHAERA_STATUS_BUSY, 0);
    c.equals("off", (uint64_t)sphaera_trees(&t.driver, nullptr), SPHAERA_OK);
    c.whole(a, SCENE_A);
    c.done("frames of trees built before and beside them; the last good one stays");
}

#endif
