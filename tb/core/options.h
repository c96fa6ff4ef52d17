/* options.h - command line of the core's harness
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef TB_OPTIONS_H
#define TB_OPTIONS_H

#include <cstdint>
#include <string>
#include <vector>

struct Window {
    int x0, y0, x1, y1; /* pixels; x1, y1: one past the last; all zero: the machine's own */
};

/* Overwrites `width` bits (1..32) from bit `lsb` of memory line `line`: malformed trees. */
struct Poke {
    uint32_t line;
    int lsb, width;
    uint32_t value;
};

struct Register {
    int number;
    int32_t value;
};

struct Options {
    std::string machine;
    Window window = {0, 0, 0, 0};
    std::string memory = "ideal";  /* or a named part of dram.h */
    int core_mhz = 84;             /* clock of the core, of which the part's clocks are told */
    int latency = 20;              /* clocks from a request to its first beat; of a part on top */
    int stall = 0;                 /* percent of clocks a handshake is held back */
    uint64_t seed = 1;             /* of the stalls */
    bool warm = false;             /* renders twice, the second time with caches kept */
    bool literal = false;          /* the model's frame by sph_traverse() */
    uint64_t watchdog = 200000;    /* clocks without progress: given up */
    uint64_t max_cycles = 0;       /* 0: no limit */
    bool stop = false;             /* at the first pixel that differs; the rest counts as equal */
    int64_t bus_error_at = -1;     /* this line request, from 0, answers with an error */
    bool gated = false;            /* the clock stands still while the core does not ask for it */
    int64_t reset_at = -1;         /* the frame is first begun, and cut off in this clock, from 0 */
    int reset_for = 1;             /* by a reset of so many clocks */
    bool life = false;             /* all that a host may do, instead of one frame: see player.h */
    std::vector<std::string> then; /* --life: other machines */
    int64_t cuts = 0;              /* --life: frames cut off, in random clocks; 0: in each clock */
    int64_t trials = 0;            /* --life: trials instead, see trials.h */
    int64_t spoil = -1;         /* lines from here on answer with an error; --warm: from then on */
    int64_t expect_errors = -1; /* sticky bits that must be set */
    std::vector<Poke> pokes;    /* in the memory, for model and core alike */
    std::vector<Register> writes; /* in the registers, for model and core alike */
    int pixel[2] = {-1, -1};      /* x, y whose stages are printed and compared; -1: none */
    bool progress = false;
    bool info = false;  /* prints profile and effects of the machine and ends */
    std::string engine; /* Icarus: the compiled bench; gates: the netlist as JSON */
    std::string core;   /* what the core was built with: a list of sim/cores.py */
    std::string built;  /* the same as parameters, NAME=VALUE ... */
    std::string trace, frame, model_frame, clocks, json, toggles;
    std::string repeat; /* how the command that repeats a failure starts */
};

/* Reads argv; prints usage and exits on --help and on errors. */
Options read_options(int argc, char **argv);

/* The command that repeats this run for one window, with a waveform. */
std::string repeat_command(const Options &o, const Window &window);

#endif
