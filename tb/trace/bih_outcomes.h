/* bih_outcomes.h - what may become of a ray of tb_bih, and how often it did
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef TB_TRACE_BIH_OUTCOMES_H
#define TB_TRACE_BIH_OUTCOMES_H

#include "trace/bih_memory.h"

extern "C" {
#include "trace/bih.h"
}

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
                printf("# outcome %d of bih_outcomes.h was not seen\n", i);
                each = false;
            }
        return each;
    }

  private:
    uint64_t count[OUTCOMES] = {};
};

} // namespace

#endif
