/* simulate.h - one run of the core over one window, by whichever simulator is linked
 * SPDX-License-Identifier: Apache-2.0
 *
 * Three files implement it: simulate_verilator.cpp (the verilated core in this process),
 * simulate_icarus.cpp (tb_core_icarus.v in a vvp process) and simulate_host.cpp, with either
 * simulate_cxxrtl.cpp (the core in Yosys's C++) or simulate_netlist.cpp (the cells that Yosys maps
 * it to).
 */
#ifndef TB_SIMULATE_H
#define TB_SIMULATE_H

#include <atomic>
#include <string>

#include "model.h"
#include "options.h"

enum { COLD, WARM, PASSES };

/* What the core delivered for a pixel. */
struct Sample {
    sph_pixel pixel;
    uint32_t times; /* must be 1 */
    uint32_t clock; /* from the start of the pass, when it was last delivered */
};

/* What memory did in a pass; in Icarus all 0. */
enum {
    MEMORY_LINES,
    MEMORY_ROW_HITS,      /* lines whose row was open; this and what follows: of a part alone */
    MEMORY_ROW_OPENS,     /* ... whose bank was closed */
    MEMORY_ROW_CONFLICTS, /* ... of whose bank another row was open */
    MEMORY_REFRESHES,
    MEMORY_OWING, /* clocks in which a line was owed */
    MEMORY_BOUND, /* ... in which besides rays waited and none was issued */
    MEMORY_COUNTS
};
#define MEMORY_COUNT_NAMES                                                                         \
    "lines", "row_hits", "row_opens", "row_conflicts", "refreshes", "owing", "bound"

/* What the units of one name did in a pass; their clocks add up to at most units * cycles. */
struct Work {
    char name[40];
    uint32_t units;
    uint64_t away;   /* clocks in which an operand was turned away */
    uint64_t taken;  /* operands */
    uint64_t clocks; /* of their own work */
    uint64_t binds;  /* clocks of the frame in which nothing was busier, and these nearly always */
};
enum { WORKS = 64 };
constexpr double BINDS = 0.8; /* who is busy in less of the clocks is not what others wait for */

/* What the core said about one pass. */
struct Pass {
    uint64_t count[SPH_COUNTERS];
    uint64_t memory[MEMORY_COUNTS];
    uint32_t errors;
    int works; /* rows of work; only Verilator has any */
    Work work[WORKS];
};

/* A window's run; lies in memory that the simulating process shares with its parent. */
struct Run {
    Window window;
    Pass pass[PASSES];
    sph_stages *stages;     /* of Options::pixel in the core, in Verilator; null: nobody asks */
    uint32_t stages_shown;  /* bit SPH_STAGE_*: the core shows this one */
    const sph_frame *model; /* what the pixels are compared with at once; null: they are not */
    bool no_input;          /* the bench could not read the machine: nothing was simulated */
    bool given_up;          /* the core made no progress for too long, or took too many clocks */
    bool stopped;           /* a pixel differed, and nothing after it was simulated */
    std::atomic<uint64_t> pixels; /* delivered so far, all passes */
    std::atomic<int> done;
    double seconds;     /* of this process, by the clock */
    double cpu;         /* of the processor; Verilator only, 0 in Icarus */
    char failure[2000]; /* hang, broken handshake, pixel out of the window: empty if none */
};

extern const char *const simulator_name;

/* Version as the simulator says it. */
std::string simulator_version();

/* Renders run.window of the machine; samples: frame sized, one array a pass. Fills everything in
 * run but done. Without o.warm only pass COLD. */
void simulate(const Options &o, const sph_machine &machine, Sample *samples[PASSES], Run &run);

/* Whether the core delivered the model's pixel, once. */
bool equal(const sph_pixel &model, const Sample &core);

/* Stores the pixel if x, y lie in the window; else says so in run.failure. Stops the run if it is
 * not run.model's. clock: since the pass began. */
void deliver(const sph_machine &machine, Run &run, Sample *samples, int x, int y,
             const sph_pixel &pixel, uint64_t clock);

/* Appends a printf-style line to run.failure, as far as there is room. */
void fail(Run &run, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif
