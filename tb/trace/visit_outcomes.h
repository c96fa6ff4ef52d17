/* visit_outcomes.h - what a visit of tb_traverse may lead to, and how often it did
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef TB_TRACE_VISIT_OUTCOMES_H
#define TB_TRACE_VISIT_OUTCOMES_H

#include "bench.h"

extern "C" {
#include "trace/traverse.h"
}

namespace {

enum Outcome {
    NOTHING,   /* no child is met */
    ONE_INNER, /* 1 .. 4 inner children */
    FOUR_INNER = ONE_INNER + 3,
    LEAVES,         /* leaf children alone */
    BOTH,           /* inner and leaf children */
    TIES,           /* two inner children at the same depth */
    IN_ORDER,       /* two or more, in the order of the node */
    LAST_LINE,      /* the children end with memory */
    BEHIND,         /* they end one line behind it */
    FIVE,           /* more than four children */
    NO_LINE,        /* the node lies behind the end of memory */
    NO_ROOT,        /* and it is the first of its ray */
    LIMIT,          /* one visit more than the limit */
    AT_LIMIT,       /* the last visit that the limit lets through */
    NO_VISIT,       /* the limit is 0 */
    SPOILT,         /* an error of memory */
    SPOILT_REFUSED, /* an error of line 0, which a visit that is refused reads */
    OUTCOMES
};

struct Slot {
    enum { IDLE, HELD, QUEUED, ISSUED, FOUND } state = IDLE;
    struct sph_ray ray = {};
    uint32_t line = 0, visits = 0, pixel = 0; /* node to visit; visits of the ray, of the pixel */
    bool fresh = false, starts = false;       /* first visit of the ray, of the pixel */
    bool begun = false;                       /* the slot has a pixel */
    bool kill = false;                        /* the visit leads to nothing */
    int32_t depth = 0;                        /* limit of the visit */
};

class Outcomes {
  public:
    void add(Outcome outcome, bool seen) { count[outcome] += seen; }

    /* A token goes to the cache, or is refused. */
    void issue(const Slot &s, bool no_line, uint32_t limit) {
        add(no_line ? s.fresh ? NO_ROOT : NO_LINE : s.fresh ? NO_VISIT : LIMIT, s.kill);
        add(AT_LIMIT, !s.kill && s.visits == limit);
    }

    /* A node is there; its children end before line `end`, memory before line `lines`. */
    void node(const struct sph_found &f, bool sound, uint32_t end, uint32_t lines) {
        add(LAST_LINE, sound && end == lines);
        add(FIVE, !sound && f.tests > 4 && end <= lines);
        add(BEHIND, !sound && f.tests <= 4 && end == lines + 1);
    }

    /* A visit that was sound is over. */
    void found(const struct sph_ray &ray, const struct sph_found &f) {
        int n = f.inner.count;
        add(NOTHING, !n && !f.leaves);
        add(LEAVES, !n && f.leaves);
        add(BOTH, n && f.leaves);
        if (!n) return;
        add((Outcome)(ONE_INNER + n - 1), true);
        add(IN_ORDER, sph_ray_any(&ray) && n > 1);
        for (int i = 1; i < n && !sph_ray_any(&ray); i++)
            add(TIES, f.inner.list[i].near == f.inner.list[i - 1].near);
    }

    /* Whether each was seen; any: there are rays that any hit ends. */
    bool all(bool any) const {
        bool each = true;
        for (int i = 0; i < OUTCOMES; i++)
            if (!count[i] && (any || i != IN_ORDER)) {
                printf("# outcome %d of visit_outcomes.h was not seen\n", i);
                each = false;
            }
        return each;
    }

  private:
    uint64_t count[OUTCOMES] = {};
};

} // namespace

#endif
