/* tb_core.cpp - the core against the golden model, one machine file
 * SPDX-License-Identifier: Apache-2.0
 *
 * Linked with simulate_verilator.cpp it is build/sim/KEY/tb_core, with simulate_icarus.cpp
 * build/sim/tb_core_icarus. Exit code 0: every bit equal; 1: mismatch; 2: no such file, an input
 * that the bench cannot read...; 3: the core was built without what the machine asks for; 4: given
 * up, for the core made no progress.
 */
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "child.h"
#include "dram.h"
#include "player.h"
#include "report.h"

namespace {

int complain(const std::string &message) {
    std::fprintf(stderr, "tb_core: %s\n", message.c_str());
    return 2;
}

/* Pokes and register writes of the command line; the window goes into the registers too. */
bool prepare(const Options &o, sph_machine &m, Window &w, std::string &error) {
    for (const Poke &p : o.pokes) {
        if (p.line >= m.lines) return error = "--poke: no such line", false;
        sph_field_set(m.mem + static_cast<size_t>(p.line) * SPH_LINE_WORDS, p.lsb, p.width,
                      p.value);
    }
    for (const Register &r : o.writes) {
        if (r.number < 0 || r.number >= SPH_N_REGS) return error = "--reg: no such register", false;
        m.regs[r.number] = r.value;
    }
    int32_t *regs = m.regs;
    w = o.window;
    if (!w.x0 && !w.y0 && !w.x1 && !w.y1)
        w = {regs[SPH_REG_WIN_X0], regs[SPH_REG_WIN_Y0], regs[SPH_REG_WIN_X1],
             regs[SPH_REG_WIN_Y1]};
    if (w.x0 < 0 || w.y0 < 0 || w.x0 >= w.x1 || w.y0 >= w.y1 || w.x1 > regs[SPH_REG_FRAME_W] ||
        w.y1 > regs[SPH_REG_FRAME_H])
        return error = "the window is empty or not inside the frame", false;
    regs[SPH_REG_WIN_X0] = w.x0;
    regs[SPH_REG_WIN_Y0] = w.y0;
    regs[SPH_REG_WIN_X1] = w.x1;
    regs[SPH_REG_WIN_Y1] = w.y1;
    return true;
}

/* "PROFILE CORE WxH NAME": what a build script needs to know of a machine. */
std::string info(const sph_machine &m) {
    char core[160];
    sph_machine_core(&m, core, sizeof core);
    return std::string(sph_machine_profile(&m)->name) + " " + core + " " +
           std::to_string(m.regs[SPH_REG_FRAME_W]) + "x" + std::to_string(m.regs[SPH_REG_FRAME_H]) +
           " " + m.name;
}

/* The model's stages of the pixel that is followed. */
bool follow(const Options &o, const sph_machine &machine, Outcome &c, std::string &error) {
    const Window &w = c.window;
    error = "--pixel " + std::to_string(o.pixel[0]) + "," + std::to_string(o.pixel[1]) + ": ";
    if (std::string(simulator_name) != "verilator")
        return error += "only a core in Verilator shows its stages", false;
    if (o.life || o.bus_error_at >= 0 || o.spoil >= 0)
        return error += "not with --life, --bus-error-at, --spoil", false;
    if (o.pixel[0] < w.x0 || o.pixel[0] >= w.x1 || o.pixel[1] < w.y0 || o.pixel[1] >= w.y1)
        return error += "lies outside of what is drawn, " + std::to_string(w.x0) + "," +
                        std::to_string(w.y0) + "," + std::to_string(w.x1) + "," +
                        std::to_string(w.y1),
               false;
    sph_render_options how{};
    how.traverse = SPH_TRAVERSE_TREE;
    how.stages = &c.model_stages;
    sph_counters counters{};
    uint32_t errors = 0;
    sph_render_pixel(&machine, &how, o.pixel[0], o.pixel[1], &counters, &errors, nullptr);
    return true;
}

/* Can this simulator do what is asked for, and does the memory hold the machine? */
bool can(const Options &o, const sph_machine &machine, std::string &error) {
    const std::string simulator = simulator_name;
    const DramPart *part = dram_part(o.memory);
    if (part && simulator == "icarus")
        return error = "--memory " + o.memory + ": Icarus has memory 'ideal' alone", false;
    if (part && machine.lines > Dram::bytes(*part) / Dram::LINE_BYTES)
        return error = "the machine has " + std::to_string(machine.lines) +
                       " lines of memory, more than --memory " + o.memory + " holds",
               false;
    if (!o.toggles.empty() && simulator != "netlist")
        return error = "--toggles: only a netlist is counted (SIM=ecp5)", false;
    if (o.gated && simulator == "cxxrtl")
        return error = "--gated: not in cxxrtl, whose clock does not stop", false;
    return true;
}

int one_life(const Options &o, sph_machine &machine, const Window &window) {
    auto run = std::make_unique<Run>();
    std::string error;
    int rc = live(o, machine, *run, error);
    sph_machine_free(&machine);
    if (rc > 1) return complain(error);
    if (rc) std::printf("%srepeat: %s\n", run->failure, repeat_command(o, window).c_str());
    return rc;
}

} // namespace

int main(int argc, char **argv) {
    Options o = read_options(argc, argv);
    sph_error err = {{0}};
    sph_machine machine;
    if (sph_machine_read(o.machine.c_str(), &machine, &err)) return complain(err.text);
    Outcome c{};
    std::string error;
    const std::string as_read = info(machine);
    if (!prepare(o, machine, c.window, error)) return complain(error);
    if (o.info) {
        std::puts(as_read.c_str());
        sph_machine_free(&machine);
        return 0;
    }

    if (!can(o, machine, error)) return complain(error);
    if (o.pixel[0] >= 0 && !follow(o, machine, c, error)) return complain(error);
    if (o.life) return one_life(o, machine, c.window);

    sph_render_options how{};
    how.traverse = o.literal ? SPH_TRAVERSE_TREE : SPH_TRAVERSE_FAST;
    int model_errors = sph_render(&machine, &how, &c.model_frame, &c.model_counters, &err);
    if (model_errors < 0) return complain(err.text);
    c.model_errors = static_cast<uint32_t>(model_errors);

    if (!simulate_watched(o, machine, c, error)) return complain(error);
    Verdict v = compare(o, machine, c);
    if (v.no_input) return complain(v.text);
    if (!v.refused && !write_frames(o, c, error)) return complain(error);
    if (!o.json.empty() && !write_json(o, machine, c, v, argc, argv, error)) return complain(error);
    std::fputs(v.stages.c_str(), stdout);
    std::fputs(v.text.c_str(), stdout);
    if (v.refused) return v.mismatches ? 1 : 3;
    if (v.given_up) {
        std::printf("given up: core %s %s %dx%d: %llu of %llu pixels; more clocks by --watchdog, "
                    "WATCHDOG of make\n",
                    machine.name, sph_machine_profile(&machine)->name, c.window.x1 - c.window.x0,
                    c.window.y1 - c.window.y0, static_cast<unsigned long long>(c.run->pixels),
                    static_cast<unsigned long long>(c.pixels() * (o.warm ? 2 : 1)));
        return 4;
    }
    if (o.progress) std::fputs(counter_table(o, c).c_str(), stdout);
    std::printf("%s%s\n", limits(o, c).c_str(), summary(o, machine, c, v).c_str());
    sph_stages_free(&c.stages);
    sph_stages_free(&c.model_stages);
    sph_frame_free(&c.model_frame);
    sph_machine_free(&machine);
    return v.mismatches ? 1 : 0;
}
