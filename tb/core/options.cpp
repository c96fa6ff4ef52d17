/* options.cpp - see options.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "options.h"

#include <argp.h>
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "dram.h"
#include "model.h"

namespace {

enum Key {
    WINDOW = 256,
    MEMORY,
    CORE_MHZ,
    LATENCY,
    STALL,
    SEED,
    WARM,
    LITERAL,
    WATCHDOG,
    MAX_CYCLES,
    STOP,
    BUS_ERROR,
    SPOIL,
    EXPECT,
    GATED,
    RESET_AT,
    LIFE,
    THEN,
    CUTS,
    TRIALS,
    POKE,
    REG,
    PIXEL,
    PROGRESS,
    INFO,
    ENGINE,
    CORE,
    BUILT,
    TRACE,
    FRAME,
    MODEL_FRAME,
    CLOCKS,
    JSON,
    TOGGLES,
    REPEAT
};

const argp_option table[] = {
    {"machine", 'm', "FILE", 0, "machine file (.sph) to render", 0},
    {"window", WINDOW, "X0,Y0,X1,Y1", 0, "pixels to render (default: as the machine says)", 0},
    {"memory", MEMORY, "NAME", 0,
     "ideal: a beat a clock; or a part whose banks, rows, refresh and pins it keeps to: sdram16, "
     "ddr3x16 (ideal; parts not in Icarus)",
     0},
    {"core-mhz", CORE_MHZ, "N", 0, "clock of the core beside such a part (84)", 0},
    {"latency", LATENCY, "N", 0,
     "clocks from a memory request to its first beat, of a part on top of its own (20)", 0},
    {"stall", STALL, "PERCENT", 0, "clocks in which a handshake is held back (0)", 0},
    {"seed", SEED, "N", 0, "of the stalls (1)", 0},
    {"warm", WARM, nullptr, 0, "render twice and report the second pass, caches kept", 0},
    {"literal", LITERAL, nullptr, 0, "the model's frame by the functions read beside the RTL", 0},
    {"watchdog", WATCHDOG, "N", 0,
     "clocks without any progress of the core after which it is given up (200000)", 0},
    {"max-cycles", MAX_CYCLES, "N", 0, "end with a failure after N clocks", 0},
    {"stop", STOP, nullptr, 0, "end with the first pixel that differs", 0},
    {"bus-error-at", BUS_ERROR, "N", 0, "the N-th line request, from 0, answers with an error", 0},
    {"spoil", SPOIL, "LINE", 0,
     "lines from LINE on, all records of leaves or more, answer with an error: no pixel sees a "
     "primitive; with --warm only in the second pass, which needs no line",
     0},
    {"gated", GATED, nullptr, 0,
     "the core's clock stands still while active_o is low (not in CXXRTL)", 0},
    {"reset-at", RESET_AT, "N[:CLOCKS]", 0,
     "begin the frame, reset in its N-th clock, from 0, for CLOCKS clocks (1), and begin again", 0},
    {"life", LIFE, nullptr, 0, "frames, resets and errors one after another", 0},
    {"then", THEN, "FILE", 0, "with --life: another machine, drawn without a reset between", 0},
    {"cuts", CUTS, "N", 0, "with --life: reset in N random clocks (in each clock of a frame)", 0},
    {"trials", TRIALS, "N", 0,
     "with --life: N times something random that a host may do, and a clean frame", 0},
    {"expect-errors", EXPECT, "BITS", 0, "these sticky error bits must be set at the end", 0},
    {"poke", POKE, "LINE:LSB:WIDTH=VALUE", 0, "overwrite bits of memory, for both sides", 0},
    {"reg", REG, "N=VALUE", 0, "overwrite a register, for both sides", 0},
    {"pixel", PIXEL, "X,Y", 0,
     "print the stages of this pixel's rays and compare them too (Verilator alone)", 0},
    {"progress", PROGRESS, nullptr, 0, "say how far it is and how long it will take", 0},
    {"info", INFO, nullptr, 0,
     "print profile, effects, size, name of the machine; simulate nothing", 0},
    {"engine", ENGINE, "FILE", 0,
     "compiled Icarus bench, or netlist as JSON (of the harnesses for these)", 0},
    {"core", CORE, "LIST", 0, "what the core was built with, to name what it lacks", 0},
    {"built", BUILT, "PARAMETERS", 0, "the same as sim/cores.py prints it", 0},
    {"trace", TRACE, "FILE.fst", 0, "write a waveform (only if built with tracing)", 0},
    {"frame", FRAME, "FILE", 0, "write the core's pixels and counters", 0},
    {"model-frame", MODEL_FRAME, "FILE", 0, "write the model's pixels and counters", 0},
    {"clocks", CLOCKS, "FILE", 0,
     "write the clock in which each pixel left, a little-endian word of 32 bits, row by row", 0},
    {"json", JSON, "FILE", 0, "write a report", 0},
    {"toggles", TOGGLES, "FILE", 0,
     "count what switches in each instance, in the frame and in 1000 clocks behind it (of a "
     "netlist "
     "alone)",
     0},
    {"repeat", REPEAT, "COMMAND", 0, "how the command printed for repetition starts", 0},
    {nullptr, 0, nullptr, 0, nullptr, 0},
};

/* Integer in [low, high] of the whole text, or usage and exit. */
int64_t number(const char *text, int64_t low, int64_t high, argp_state *state) {
    int64_t value = 0;
    if (sph_parse_whole(text, low, high, &value))
        argp_error(state, "'%s' is not a number from %lld to %lld", text,
                   static_cast<long long>(low), static_cast<long long>(high));
    return value;
}

/* A number low .. high at the start of a text, which then begins behind it. */
template <class T> bool take(const char *&text, int64_t low, int64_t high, T &value) {
    int64_t taken = 0;
    if (sph_take_whole(&text, low, high, &taken)) return false;
    value = static_cast<T>(taken);
    return true;
}

/* The same behind a character. */
template <class T> bool take(const char *&text, char c, int64_t low, int64_t high, T &value) {
    return !sph_take_char(&text, c) && take(text, low, high, value);
}

/* Whether a text is of words NAME=NUMBER alone. */
bool parameters(const char *text) {
    std::istringstream words(text);
    std::string word;
    uint64_t value = 0;
    while (words >> word) {
        const size_t at = word.find('=');
        if (!at || at == std::string::npos ||
            sph_parse_count(word.c_str() + at + 1, 0, UINT32_MAX, &value))
            return false;
    }
    return true;
}

int small(const char *text, int low, int high, argp_state *state) {
    return static_cast<int>(number(text, low, high, state));
}

error_t parse(int key, char *arg, argp_state *state) {
    auto &o = *static_cast<Options *>(state->input);
    Poke poke{};
    Register reg{};
    const char *at = arg;
    switch (key) {
    case 'm':
        o.machine = arg;
        break;
    case WINDOW:
        if (!take(at, 0, SPH_MAX_SIDE, o.window.x0) ||
            !take(at, ',', 0, SPH_MAX_SIDE, o.window.y0) ||
            !take(at, ',', 0, SPH_MAX_SIDE, o.window.x1) ||
            !take(at, ',', 0, SPH_MAX_SIDE, o.window.y1) || *at)
            argp_error(state, "--window wants X0,Y0,X1,Y1, got '%s'", arg);
        break;
    case MEMORY:
        o.memory = arg;
        if (o.memory != "ideal" && !dram_part(o.memory)) {
            std::string names = "ideal";
            for (const DramPart &part : dram_parts())
                names += std::string(", ") + part.name;
            argp_error(state, "--memory: '%s' is none of %s", arg, names.c_str());
        }
        break;
    case CORE_MHZ:
        o.core_mhz = small(arg, 1, 2000, state);
        break;
    case LATENCY:
        o.latency = small(arg, 1, 100000, state);
        break;
    case STALL:
        o.stall = small(arg, 0, 99, state);
        break;
    case SEED:
        o.seed = static_cast<uint64_t>(number(arg, 0, INT64_MAX, state));
        break;
    case WARM:
        o.warm = true;
        break;
    case LITERAL:
        o.literal = true;
        break;
    case WATCHDOG:
        o.watchdog = static_cast<uint64_t>(number(arg, 1, INT64_MAX, state));
        break;
    case MAX_CYCLES:
        o.max_cycles = static_cast<uint64_t>(number(arg, 1, INT64_MAX, state));
        break;
    case STOP:
        o.stop = true;
        break;
    case BUS_ERROR:
        o.bus_error_at = number(arg, 0, INT64_MAX, state);
        break;
    case GATED:
        o.gated = true;
        break;
    case RESET_AT:
        if (!take(at, 0, INT64_MAX, o.reset_at) ||
            (*at && !take(at, ':', 1, INT32_MAX, o.reset_for)) || *at)
            argp_error(state, "--reset-at wants N or N:CLOCKS, got '%s'", arg);
        break;
    case LIFE:
        o.life = true;
        break;
    case THEN:
        o.then.push_back(arg);
        break;
    case CUTS:
        o.cuts = number(arg, 1, INT64_MAX, state);
        break;
    case TRIALS:
        o.trials = number(arg, 1, INT64_MAX, state);
        break;
    case SPOIL:
        o.spoil = number(arg, 0, INT64_MAX, state);
        break;
    case EXPECT:
        o.expect_errors = number(arg, 0, 255, state);
        break;
    case POKE:
        if (!take(at, 0, UINT32_MAX, poke.line) || !take(at, ':', 0, 255, poke.lsb) ||
            !take(at, ':', 1, 32, poke.width) ||
            !take(at, '=', INT32_MIN, UINT32_MAX, poke.value) || *at || poke.lsb + poke.width > 256)
            argp_error(state, "--poke wants LINE:LSB:WIDTH=VALUE, got '%s'", arg);
        o.pokes.push_back(poke);
        break;
    case REG:
        if (!take(at, 0, INT32_MAX, reg.number) ||
            !take(at, '=', INT32_MIN, UINT32_MAX, reg.value) || *at)
            argp_error(state, "--reg wants N=VALUE, got '%s'", arg);
        o.writes.push_back(reg);
        break;
    case PIXEL:
        if (!take(at, 0, SPH_MAX_SIDE - 1, o.pixel[0]) ||
            !take(at, ',', 0, SPH_MAX_SIDE - 1, o.pixel[1]) || *at)
            argp_error(state, "--pixel wants X,Y, got '%s'", arg);
        break;
    case PROGRESS:
        o.progress = true;
        break;
    case INFO:
        o.info = true;
        break;
    case ENGINE:
        o.engine = arg;
        break;
    case CORE:
        o.core = arg;
        break;
    case BUILT:
        if (!parameters(arg)) argp_error(state, "--built wants NAME=NUMBER ..., got '%s'", arg);
        o.built = arg;
        break;
    case TRACE:
        o.trace = arg;
        break;
    case FRAME:
        o.frame = arg;
        break;
    case MODEL_FRAME:
        o.model_frame = arg;
        break;
    case CLOCKS:
        o.clocks = arg;
        break;
    case JSON:
        o.json = arg;
        break;
    case TOGGLES:
        o.toggles = arg;
        break;
    case REPEAT:
        o.repeat = arg;
        break;
    case ARGP_KEY_ARG:
        argp_error(state, "'%s' is not an option", arg);
        break;
    case ARGP_KEY_END:
        if (o.machine.empty()) argp_error(state, "--machine is missing");
        break;
    default:
        return ARGP_ERR_UNKNOWN;
    }
    return 0;
}

} // namespace

Options read_options(int argc, char **argv) {
    Options o;
    const argp parser = {table,
                         parse,
                         nullptr,
                         "Renders a machine with the RTL core and with the golden model and "
                         "compares them bit for bit.",
                         nullptr,
                         nullptr,
                         nullptr};
    o.repeat = argv[0];
    argp_parse(&parser, argc, argv, 0, nullptr, &o);
    return o;
}

std::string repeat_command(const Options &o, const Window &w) {
    char text[256];
    std::snprintf(text, sizeof text, " --window %d,%d,%d,%d --latency %d --stall %d --seed %llu",
                  w.x0, w.y0, w.x1, w.y1, o.latency, o.stall,
                  static_cast<unsigned long long>(o.seed));
    std::string command = o.repeat + " --machine " + o.machine + text;
    if (o.memory != "ideal")
        command += " --memory " + o.memory + " --core-mhz " + std::to_string(o.core_mhz);
    for (const Poke &p : o.pokes) {
        std::snprintf(text, sizeof text, " --poke %u:%d:%d=%u", p.line, p.lsb, p.width, p.value);
        command += text;
    }
    for (const Register &r : o.writes) {
        std::snprintf(text, sizeof text, " --reg %d=%d", r.number, r.value);
        command += text;
    }
    bool drawn = o.pixel[0] >= w.x0 && o.pixel[0] < w.x1 && o.pixel[1] >= w.y0 && o.pixel[1] < w.y1;
    if (drawn)
        command += " --pixel " + std::to_string(o.pixel[0]) + "," + std::to_string(o.pixel[1]);
    if (o.spoil >= 0) command += " --spoil " + std::to_string(o.spoil);
    if (o.bus_error_at >= 0) command += " --bus-error-at " + std::to_string(o.bus_error_at);
    if (o.gated) command += " --gated";
    if (o.life) command += " --life";
    for (const std::string &file : o.then)
        command += " --then " + file;
    if (o.trials) command += " --trials " + std::to_string(o.trials);
    if (o.cuts) command += " --cuts " + std::to_string(o.cuts);
    if (o.reset_at >= 0)
        command += " --reset-at " + std::to_string(o.reset_at) + ":" + std::to_string(o.reset_for);
    if (o.expect_errors >= 0) command += " --expect-errors " + std::to_string(o.expect_errors);
    return command + " --trace pixel.fst";
}
