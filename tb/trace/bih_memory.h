/* bih_memory.h - the memory of tb_bih: a scene's BIH, or nodes that no scene has
 * SPDX-License-Identifier: Apache-2.0
 *
 *     0 .. ROOM-1         random nodes, or a chain of them; the root is one of the first
 *     ROOM .. the end     the scene, moved up; its leaf records serve both
 *
 * Registers may name the same lines far away, where world.h's repeat() has them too.
 * Lines may be spoilt: they answer with an error. The model's memory then has nodes there that end
 * a ray in the same place, malformed ones; such a phase has no others.
 */
#ifndef TB_TRACE_BIH_MEMORY_H
#define TB_TRACE_BIH_MEMORY_H

#include "engine/world.h"

extern "C" {
#include "trace/bih.h"
}

namespace {

constexpr uint32_t ROOM = 160; /* lines */

enum Tree { SCENE_TREE, RANDOM_TREE, CHAIN, TREES };
enum Trouble { NO_TROUBLE, BROKEN, SPOILT_LINES, UNSOUND };

class BihMemory {
  public:
    struct sph_machine model = {}; /* as world.m, but for spoilt lines */
    Tree tree = SCENE_TREE;
    Trouble trouble = NO_TROUBLE;
    int pushes = 0; /* of a ray that runs down the chain */

    explicit BihMemory(world::World &w) : scene(w.m), lines(ROOM + w.m.lines) {
        w.repeat();
        uint32_t *from = scene.mem, *end = from + (lines - ROOM) * SPH_LINE_WORDS;
        std::copy_backward(from, end, end + ROOM * SPH_LINE_WORDS);
        for (int reg : {SPH_REG_ROOT, SPH_REG_LEAF_BASE})
            scene.regs[reg] += ROOM;
        scene.regs[SPH_REG_MEM_LINES] = (int32_t)lines;
        saved = scene;
    }

    /* Another tree, with registers; which lines are spoilt. */
    void fill(bench::Random &random, std::vector<bool> &spoilt) {
        int32_t *r = scene.regs;
        std::copy(saved.regs, saved.regs + SPH_N_REGS, r);
        tree = (Tree)random.below(TREES);
        trouble = random.percent(55) ? NO_TROUBLE : (Trouble)random.between(BROKEN, UNSOUND);
        if (random.percent(50)) /* memory ends where the registers say that records may */
            r[SPH_REG_MEM_LINES] = r[SPH_REG_LEAF_BASE] + r[SPH_REG_N_PRIMS];
        if (random.percent(50))
            r[SPH_REG_N_LOOSE] =
                (int32_t)random.below((uint64_t)r[SPH_REG_N_PRIMS] + 1) >> random.below(8);
        if (tree != SCENE_TREE) {
            r[SPH_REG_ROOT] = (int32_t)random.below(8);
            for (int i = 0; i < 6; i++) /* mostly the whole world */
                if (random.percent(90)) r[SPH_REG_BOX_X0 + i] = i < 3 ? -(1 << W) : 1 << W;
        }
        if (tree == RANDOM_TREE)
            for (uint32_t line = 0; line < ROOM; line++)
                put_random(random, line, 0), put_random(random, line, 1);
        if (tree == CHAIN) put_chain(random);
        if (trouble == UNSOUND) unsound(random);
        const uint32_t leaves = (uint32_t)r[SPH_REG_LEAF_BASE];
        first = world::World::part(random);
        for (int reg : {SPH_REG_ROOT, SPH_REG_LEAF_BASE, SPH_REG_MEM_LINES})
            r[reg] += (int32_t)first;
        model = scene;
        model.mem = copy.words;
        std::copy(scene.mem, scene.mem + lines * SPH_LINE_WORDS, model.mem);
        for (uint32_t line = 0; line < lines; line++) {
            spoilt[line] = trouble == SPOILT_LINES && random.percent(line ? 4 : 50);
            if (spoilt[line] && line < leaves)
                for (int half = 0; half < 2; half++)
                    put_inner(model, line, half, 0, 0, (1u << SPH_BIH_CHILD_BITS) - 1, 0, 0);
        }
    }

    int32_t root() const { return scene.regs[SPH_REG_ROOT]; }
    /* A line that there is; a visit that is refused asks for line 0. */
    bool there(uint32_t line) const { return !line || (line >= first && line - first < lines); }

  private:
    struct sph_machine &scene, saved = {};
    const uint32_t lines;
    uint32_t first = 0; /* where lines begin */
    world::Repeated copy;

    static uint32_t *node(struct sph_machine &m, uint32_t line, int half) {
        return sph_line(&m, line) + half * (SPH_BIH_STRIDE / 32);
    }
    static void put_inner(struct sph_machine &m, uint32_t line, int half, int axis, int fit,
                          uint32_t child, int64_t l, int64_t r) {
        uint32_t *n = node(m, line, half);
        sph_field_set(n, SPH_BIH_CHILD_LSB, SPH_BIH_CHILD_BITS, child);
        sph_field_set(n, SPH_BIH_FIT_LSB, SPH_BIH_FIT_BITS, (uint32_t)fit);
        sph_field_set(n, SPH_BIH_AXIS_LSB, SPH_BIH_AXIS_BITS, (uint32_t)axis);
        sph_field_set(n, SPH_BIH_CLIP_L_LSB, SPH_BIH_CLIP_L_BITS, (uint32_t)l);
        sph_field_set(n, SPH_BIH_CLIP_R_LSB, SPH_BIH_CLIP_R_BITS, (uint32_t)r);
    }
    static void put_leaf(struct sph_machine &m, uint32_t line, int half, uint32_t first,
                         uint32_t count) {
        put_inner(m, line, half, SPH_BIH_LEAF, 0, 0, 0, 0);
        sph_field_set(node(m, line, half), SPH_BIH_FIRST_LSB, SPH_BIH_FIRST_BITS, first);
        sph_field_set(node(m, line, half), SPH_BIH_COUNT_LSB, SPH_BIH_COUNT_BITS, count);
    }
    uint32_t prims() const { return (uint32_t)scene.regs[SPH_REG_N_PRIMS]; }

    void put_random(bench::Random &random, uint32_t line, int half) {
        bool broken = trouble == BROKEN && random.percent(4);
        uint32_t count = (uint32_t)random.below(10);
        if (random.percent(25)) {
            uint32_t first = prims() - count; /* the last records */
            if (random.percent(80)) first = (uint32_t)random.below(first + 1);
            if (broken) first = prims() - count + 1;
            if (broken && random.percent(30)) first = (uint32_t)random.log_bits(32) | 1u << 31;
            return put_leaf(scene, line, half, first, count);
        }
        int64_t l = random.percent(50) ? random.sbits(W) : random.smixed(W + 2), r = l;
        r += random.percent(20) ? 0 : random.log_sbits(W - 1); /* apart, or one in the other */
        int fit = random.percent(20);
        if (fit && l > r && random.percent(90)) std::swap(l, r);
        uint32_t child = (uint32_t)random.below(ROOM - 8);
        if (broken) child = (uint32_t)(scene.regs[SPH_REG_MEM_LINES] - root());
        if (broken && random.percent(30)) child = (uint32_t)random.bits(29) | 1u << 28;
        put_inner(scene, line, half, (int)random.below(3), fit, child, l, r);
    }

    /* Nodes of which a ray puts a leaf aside each, and meets the next one first; the other way it
     * meets the leaf first. Behind them a leaf, or a node that is its own child for ever. */
    void put_chain(bench::Random &random) {
        pushes = SPH_BIH_STACK + (int)random.between(-1, 1);
        int axis = (int)random.below(3);
        for (int i = 0; i <= pushes; i++) {
            uint32_t line = (uint32_t)(root() + i);
            put_inner(scene, line, 0, axis, 0, (uint32_t)i + 1, 1 << W, -(1 << W));
            put_leaf(scene, line, 1, (uint32_t)random.below(prims() - 3),
                     (uint32_t)random.below(3));
        }
        const uint32_t end = (uint32_t)(root() + pushes);
        if (random.percent(90))
            put_leaf(scene, end, 0, 0, 1);
        else
            put_inner(scene, end, 0, axis, 1, (uint32_t)pushes, -(1 << W), 1 << W);
    }

    /* Registers of which no ray may start. */
    void unsound(bench::Random &random) {
        int32_t *r = scene.regs;
        int how = (int)random.below(3);
        if (how == 0) r[SPH_REG_ROOT] = r[SPH_REG_MEM_LINES];
        if (how == 1) r[SPH_REG_MEM_LINES] = r[SPH_REG_LEAF_BASE] + r[SPH_REG_N_PRIMS] - 1;
        if (how == 2) r[SPH_REG_N_LOOSE] = r[SPH_REG_N_PRIMS] + 1;
    }
};

} // namespace

/* ---- what may become of a ray of tb_bih, and how often it did ---- */

namespace {

enum Outcome {
    MISS,
    HIT,
    BLOCKED,        /* a shadow ray hits */
    NO_NODE,        /* the ray misses the global box */
    LOOSE_ONLY,     /* and records of no node were tested */
    BAD_NODE,       /* a child or leaf records behind the end */
    UNSOUND_REGS,   /* a start is refused */
    OVERFLOW,       /* of the stack */
    FULL,           /* the stack was filled, and no more */
    LIMIT,          /* one visit more than the limit */
    AT_LIMIT,       /* as many as the limit lets through, then done */
    NO_VISIT,       /* the limit is 0 */
    SPOILT,         /* an error of memory */
    SPOILT_REFUSED, /* an error of line 0, which a visit that is refused reads */
    BUBBLE,         /* something was put aside and lay behind the hit */
    OUTCOMES
};

struct Slot {
    enum { IDLE, HELD, RUNS } state = IDLE;
    struct sph_ray ray = {};
    struct sph_bih_ray bih = {};
    struct sph_hit wanted = {}, hit = {};     /* the model's, and of the records that were tested */
    struct sph_counters work = {}, ours = {}; /* the same */
    uint32_t pixel = 0;                       /* visits */
    bool begun = false;
};

class Outcomes {
  public:
    uint64_t errors[4] = {}; /* faults that rtl must tell, by number of the error */

    void add(Outcome outcome, bool seen) { count[outcome] += seen; }

    /* A ray of which the model says what it does; line0: line 0 answers with an error. */
    void ray(const Slot &s, uint32_t found, const BihMemory &trees, bool line0) {
        uint64_t n = s.work.count[SPH_COUNT_NODE_VISITS];
        auto limit = (uint64_t)trees.model.regs[SPH_REG_VISIT_LIMIT];
        bool broken = found >> SPH_ERROR_BAD_NODE & 1, late = found >> SPH_ERROR_VISIT_LIMIT & 1;
        bool spoilt = trees.trouble == SPOILT_LINES && broken, again = late && line0;
        bool unsound = trees.trouble == UNSOUND && broken && !n;
        bool shadow = s.ray.kind == SPH_SHADOW;
        for (int i = 0; i < 4; i++)
            errors[i] += found >> i & 1;
        errors[SPH_ERROR_BAD_NODE] -= spoilt;
        errors[SPH_ERROR_BUS_ERROR] += (uint64_t)spoilt + again;
        add(MISS, !found && !s.wanted.key);
        add(HIT, !found && s.wanted.key && !shadow);
        add(BLOCKED, !found && s.wanted.key && shadow);
        add(NO_NODE, !found && !n);
        add(LOOSE_ONLY, !found && !n && s.work.count[SPH_COUNT_LEAF_TESTS]);
        add(BAD_NODE, broken && !spoilt && !unsound);
        add(UNSOUND_REGS, unsound);
        add(OVERFLOW, found >> SPH_ERROR_STACK_OVERFLOW & 1);
        add(FULL, !found && trees.tree == CHAIN && trees.pushes == SPH_BIH_STACK && !s.wanted.key &&
                      n == 2 * SPH_BIH_STACK + 1);
        add(LIMIT, late && n);
        add(AT_LIMIT, !found && n && n == limit);
        add(NO_VISIT, late && !n);
        add(SPOILT, spoilt);
        add(SPOILT_REFUSED, again);
    }

    /* Whether each was seen; shadow: there are shadow rays. */
    bool all(bool shadow) const {
        bool each = true;
        for (int i = 0; i < OUTCOMES; i++)
            if (!count[i] && (shadow || i != BLOCKED)) {
                printf("# outcome %d of bih_memory.h was not seen\n", i);
                each = false;
            }
        return each;
    }

  private:
    uint64_t count[OUTCOMES] = {};
};

} // namespace

#endif
