/* outcome.h - model and core side by side
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef TB_OUTCOME_H
#define TB_OUTCOME_H

#include <string>

#include "simulate.h"

/* What a run is judged by. */
struct Outcome {
    Window window;
    sph_frame model_frame;
    sph_counters model_counters;
    uint32_t model_errors;
    Sample *samples[PASSES]; /* frame sized */
    const Run *run;
    sph_stages stages;       /* of the core, of Options::pixel */
    sph_stages model_stages; /* of the model */
    double seconds;          /* wall clock of the simulation */

    uint64_t pixels() const {
        return static_cast<uint64_t>(window.x1 - window.x0) *
               static_cast<uint64_t>(window.y1 - window.y0);
    }
};

/* Share of the clocks with rays waiting in which the issue port was used; 0..1. */
inline double issue_use(const Pass &p) {
    auto waiting = static_cast<double>(p.count[SPH_COUNT_RAYS_WAITING]);
    auto idle = static_cast<double>(p.count[SPH_COUNT_ISSUE_WAIT]);
    return waiting > 0 ? 1 - idle / waiting : 0;
}

struct Verdict {
    uint64_t mismatches; /* pixels, counters, error bits and failures of the run */
    std::string text;    /* what is wrong, the first pixel in full; empty if nothing */
    bool given_up;       /* the core had not its time: of what it owes nothing is said */
    bool no_input;       /* the bench read no machine: nothing is said of the core */
    bool refused;        /* the core takes no such machine, and nobody expected that */
    int first[2];        /* x, y of the first wrong pixel; -1: none */
    std::string stages;  /* of a pixel that is followed, as lines */
    std::string repeat;  /* the command that repeats what is wrong, if anything is */
};

/* A pixel that sees no primitive after so many visits. */
sph_pixel dark_pixel(const sph_machine &machine, uint32_t visits);

/* Stage that a difference points at, then all values side by side, as lines. */
std::string difference(const sph_machine &machine, const sph_pixel &model, const Sample &core,
                       int x, int y);

/* Compares every pixel of every pass that ran (delivered once, three colours, id, key, visits),
 * the counters that model and RTL share, and the error bits. A core that refuses the machine must
 * give no pixel; the text says what it lacks. */
Verdict compare(const Options &o, const sph_machine &machine, const Outcome &outcome);

/* The stages of the pixel that is followed, model and core line by line, into v.stages; a line that
 * differs counts as one mismatch and is told in v.text. */
void compare_stages(const Options &o, const sph_machine &machine, const Outcome &outcome,
                    Verdict &v);

#endif
