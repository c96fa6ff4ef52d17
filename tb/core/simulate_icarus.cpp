/* simulate_icarus.cpp - the core in Icarus Verilog; see simulate.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * Writes registers and memory in hex, runs vvp with tb_core_icarus.v, reads its text, and ends it
 * by reading no more. The files lie in a folder of their own in /tmp and are removed at the end.
 */
#include "driven_icarus.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>

#include "words.h"

const char *const simulator_name = "icarus";

std::string simulator_version() {
    char text[128] = "";
    FILE *p = popen("iverilog -V 2>/dev/null", "r");
    if (!p || !std::fgets(text, sizeof text, p)) std::strcpy(text, "unknown");
    if (p) pclose(p);
    text[std::strcspn(text, "\n")] = 0;
    return text;
}

namespace {

const uint32_t BENCH_LINES = 131072; /* LINES of the bench */

using File = FILE *;

bool write_registers(const std::string &path, const sph_machine &m, const Window &w) {
    File f = std::fopen(path.c_str(), "w");
    if (!f) return false;
    for (int i = 0; i < SPH_N_REGS; i++)
        std::fprintf(f, "%08x\n", static_cast<uint32_t>(register_of(m, w, i)));
    return !std::fclose(f);
}

bool write_memory(const std::string &path, const sph_machine &m) {
    File f = std::fopen(path.c_str(), "w");
    if (!f) return false;
    for (uint32_t line = 0; line < m.lines; line++)
        for (uint32_t word = SPH_LINE_WORDS; word-- > 0;)
            std::fprintf(f, "%08x%s", m.mem[static_cast<size_t>(line) * SPH_LINE_WORDS + word],
                         word ? "" : "\n");
    return !std::fclose(f);
}

/* A word as the shell takes it. */
std::string quoted(const std::string &word) {
    std::string all = "'";
    for (char c : word)
        all += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return all + "'";
}

/* Starts vvp; the text that it writes. Icarus opens no file whose name has more than plain letters,
 * so that base has none, and the waveform gets its name at the end. */
File start_bench(const Options &o, const std::string &base) {
    std::string trace = o.trace.empty() ? "" : " +dump='" + base + ".fst' -fst";
    std::string command =
        "exec vvp -n " + quoted(o.engine) + " +regs='" + base + ".regs' +mem='" + base +
        ".mem' +out=/dev/fd/3 +latency=" + std::to_string(o.latency) +
        " +stall=" + std::to_string(o.stall) + " +seed=" + std::to_string(o.seed) +
        " +watchdog=" + std::to_string(o.watchdog) +
        " +error_at=" + std::to_string(o.bus_error_at) + " +warm=" + (o.warm ? "1" : "0") +
        " +gated=" + (o.gated ? "1" : "0") + " +spoil=" + std::to_string(o.spoil) +
        " +reset_at=" + std::to_string(o.reset_at) + " +reset_for=" + std::to_string(o.reset_for) +
        trace + " 3>&1 >'" + base + ".log' 2>&1";
    return popen(command.c_str(), "r"); // NOLINT(bugprone-command-processor): vvp has no library
}

/* The first line of vvp's own output: what an assertion said. */
std::string first_line(const std::string &path) {
    char text[256] = "";
    FILE *f = std::fopen(path.c_str(), "r");
    if (f && !std::fgets(text, sizeof text, f)) text[0] = 0;
    if (f) std::fclose(f);
    text[std::strcspn(text, "\n")] = 0;
    return text;
}

/* One line of the bench's text; false if it has unknown (x) bits or an unknown form. */
bool read_line(const char *text, const sph_machine &m, Sample *samples[PASSES], int &pass,
               Run &run) {
    unsigned x = 0, y = 0, number = 0;
    uint64_t key = 0, clock = 0;
    Words words(text + (text[0] != 0));
    sph_pixel p{};
    switch (text[0]) {
    case 'p':
        words.hex(x).hex(y);
        if (!hex_digits(words.word(), 6, p.colour, SPH_FRAMES) ||
            !words.hex(p.id).hex(p.key).hex(p.visits).hex(p.texture).hex(clock).good())
            return false;
        deliver(m, run, samples[pass], static_cast<int>(x), static_cast<int>(y), p, clock);
        return true;
    case 'c':
        if (!words.hex(number).hex(key).good() || number >= SPH_COUNTERS) return false;
        run.pass[pass].count[number] = key;
        return true;
    case 'k':
        if (!words.hex(key).good()) return false;
        if (key != run.pass[pass].count[SPH_COUNT_CYCLES])
            fail(run, "counter cycles %llu, %llu clocks from start to the last pixel",
                 static_cast<unsigned long long>(run.pass[pass].count[SPH_COUNT_CYCLES]),
                 static_cast<unsigned long long>(key));
        return true;
    case 'e':
        return words.hex(run.pass[pass].errors).good() || text[1] == 'n';
    case 'h':
        fail(run, "%.*s", static_cast<int>(std::strcspn(text + 2, "\n")), text + 2);
        return true;
    case 'g':
        run.given_up = true;
        fail(run, "%.*s", static_cast<int>(std::strcspn(text + 2, "\n")), text + 2);
        return true;
    case 'n':
        run.no_input = true;
        fail(run, "vvp has %.*s", static_cast<int>(std::strcspn(text + 2, "\n")), text + 2);
        return true;
    case 'w':
        pass = WARM;
        return true;
    default:
        return false;
    }
}

} // namespace

void simulate(const Options &o, const sph_machine &machine, Sample *samples[PASSES], Run &run) {
    auto begin = std::chrono::steady_clock::now();
    const Window &w = run.window;
    char real[PATH_MAX] = "";
    if (o.engine.empty() || !realpath(o.engine.c_str(), real)) {
        fail(run, "--engine: no compiled bench '%s'", o.engine.c_str());
        return;
    }
    if (machine.lines > BENCH_LINES) {
        fail(run, "%u lines of memory; the Icarus bench holds %u", machine.lines, BENCH_LINES);
        return;
    }
    char folder[] = "/tmp/sphaera_icarus.XXXXXX";
    if (!mkdtemp(folder)) return fail(run, "%s: %s", folder, std::strerror(errno));
    const std::string base = std::string(folder) + "/bench";
    int pass = COLD;
    bool ended = false;
    if (!write_registers(base + ".regs", machine, w) || !write_memory(base + ".mem", machine)) {
        fail(run, "cannot write %s.regs and .mem", base.c_str());
    } else {
        File f = start_bench(o, base);
        char text[512];
        while (f && !run.stopped && std::fgets(text, sizeof text, f)) {
            ended = ended || !std::strncmp(text, "end", 3);
            if (!read_line(text, machine, samples, pass, run))
                fail(run, "unknown bits or form: %.*s", static_cast<int>(std::strcspn(text, "\n")),
                     text);
        }
        int status = f ? pclose(f) : -1;
        if (!run.stopped && !run.no_input && (status || !ended))
            fail(run, "vvp ended with status 0x%x before its time: %s",
                 static_cast<unsigned>(status), first_line(base + ".log").c_str());
    }
    if (!o.trace.empty()) {
        std::error_code why;
        std::filesystem::copy_file(base + ".fst", o.trace,
                                   std::filesystem::copy_options::overwrite_existing, why);
        if (why) fail(run, "%s: %s", o.trace.c_str(), why.message().c_str());
    }
    for (const char *ending : {".regs", ".mem", ".log", ".fst"})
        std::remove((base + ending).c_str());
    rmdir(folder);
    run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

std::unique_ptr<Host> make_host(const Options &o, const sph_machine &machine, Run &run) {
    return std::make_unique<DrivenIcarus>(o, machine, run);
}
