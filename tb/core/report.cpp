/* report.cpp - see report.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <algorithm>
#include <climits>
#include <cstdio>
#include <jansson.h>
#include <sstream>
#include <vector>

#include "common/number.h"
#include "dram.h"
#include "report.h"

/* ---- refuse ---- */

namespace {

/* Value of a parameter in "SHADOW=1 REFLECT=2 ...". 0 if it is not there, or no number. */
int built_with(const std::string &built, const std::string &parameter) {
    std::istringstream words(built);
    std::string word;
    uint64_t value = 0;
    while (words >> word)
        if (word.compare(0, parameter.size() + 1, parameter + "=") == 0)
            return sph_parse_count(word.c_str() + parameter.size() + 1, 0, INT_MAX, &value)
                       ? 0
                       : static_cast<int>(value);
    return 0;
}

/* What the machine asks for and the core has too little of, as words such as reflect2. */
std::vector<std::string> missing(const sph_machine &m, const std::string &built) {
    std::vector<std::string> result;
    for (int i = 0; i < SPH_PARTS; i++) {
        int asked = sph_part_asked(&m, i);
        if (built_with(built, sph_parts[i].core) >= asked) continue;
        result.push_back(sph_parts[i].word);
        if (sph_parts[i].most > 1) result.back() += std::to_string(asked);
    }
    return result;
}

} // namespace

std::string refusal(const Options &o, const sph_machine &machine, uint32_t errors) {
    static const char *const names[] = {SPH_ERROR_NAMES};
    if (!(errors & REFUSED)) return "";
    auto words = missing(machine, o.built);
    if (!(errors >> SPH_ERROR_MISSING_EFFECT & 1) || words.empty()) {
        std::string text = "refused: the core sets";
        for (int i = 0; i < SPH_ERRORS; i++)
            if (errors & REFUSED & 1u << i) text += std::string(" ") + names[i];
        text += " and gives no pixel";
        if (errors >> SPH_ERROR_WRONG_PROFILE & 1)
            text += std::string("; the machine was built for profile ") +
                    sph_machine_profile(&machine)->name;
        if (errors >> SPH_ERROR_LEFT_OUT & 1)
            text += "; what another camera would show is left out of the machine";
        return text + "\n";
    }
    std::string text = "refused: the machine asks for ";
    for (size_t i = 0; i < words.size(); i++)
        text += (!i ? "" : i + 1 < words.size() ? ", " : " and ") + words[i];
    return text + ", the core was built with " + o.core + "\n";
}

extern "C" {
#include "common/file.h"
}

namespace {

using ull = unsigned long long;
const char *const counter_names[] = {SPH_COUNTER_NAMES};

json_t *integer(uint64_t value) {
    return json_integer(static_cast<json_int_t>(value));
}

/* All counters, or those that the model has too. */
json_t *counters(const uint64_t *count, bool model) {
    json_t *object = json_object();
    for (int i = 0; i < SPH_COUNTERS; i++)
        if (!model || sph_counter_both(i))
            json_object_set_new(object, counter_names[i], integer(count[i]));
    return object;
}

double cycles_per_pixel(const Outcome &c, int pass) {
    return static_cast<double>(c.run->pass[pass].count[SPH_COUNT_CYCLES]) /
           static_cast<double>(c.pixels());
}

/* Clocks each visit costs the issue port. */
double cycles_per_visit(const Pass &p) {
    auto visits = static_cast<double>(p.count[SPH_COUNT_NODE_VISITS]);
    return visits > 0 ? static_cast<double>(p.count[SPH_COUNT_CYCLES]) / visits : 0;
}

/* Bytes, and what the clocks went to; of a named part its rows too. */
json_t *memory_json(const Options &o, const Outcome &c, int pass) {
    static const char *const names[] = {MEMORY_COUNT_NAMES};
    const Pass &p = c.run->pass[pass];
    const bool part = dram_part(o.memory) != nullptr;
    json_t *object = json_object();
    for (int i = 0; i < MEMORY_COUNTS; i++)
        if (part || i < MEMORY_ROW_HITS || i > MEMORY_REFRESHES)
            json_object_set_new(object, names[i], integer(p.memory[i]));
    const auto lines = static_cast<double>(p.memory[MEMORY_LINES]);
    const auto cycles = static_cast<double>(p.count[SPH_COUNT_CYCLES]);
    json_object_set_new(object, "bytes_per_pixel",
                        json_real(lines * Dram::LINE_BYTES / static_cast<double>(c.pixels())));
    if (part)
        json_object_set_new(
            object, "row_hit_share",
            json_real(lines > 0 ? static_cast<double>(p.memory[MEMORY_ROW_HITS]) / lines : 0));
    json_object_set_new(
        object, "bound_share",
        json_real(cycles > 0 ? static_cast<double>(p.memory[MEMORY_BOUND]) / cycles : 0));
    return object;
}

double share(uint64_t clocks, const Pass &p) {
    const auto cycles = static_cast<double>(p.count[SPH_COUNT_CYCLES]);
    return cycles > 0 ? static_cast<double>(clocks) / cycles : 0;
}

/* Of the clocks that units of one name have, those in which they work. */
double busy(const Work &w, const Pass &p) {
    return share(w.clocks, p) / w.units;
}

std::string words(const Work &w) {
    std::string name = w.name;
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

/* The busiest row; null if nobody counts, or the core refused. */
const Work *busiest(const Pass &p) {
    const Work *most =
        std::max_element(p.work, p.work + p.works,
                         [&](const Work &a, const Work &b) { return busy(a, p) < busy(b, p); });
    return p.works && p.count[SPH_COUNT_CYCLES] ? most : nullptr;
}

/* Share of the clocks in which a pixel waits for a free slot. */
double slots_taken(const Pass &p) {
    const uint64_t waiting = p.count[SPH_COUNT_RAYS_WAITING];
    return share(waiting - std::min(waiting, p.count[SPH_COUNT_RAYS_PRIMARY]), p);
}

/* What a pass is limited by: the unit that works in nearly every clock; else who binds which part
 * of the frame, or what waits. */
std::string limit(const Pass &p) {
    const Work &w = *busiest(p);
    char text[128];
    if (busy(w, p) >= BINDS) {
        std::snprintf(text, sizeof text, ": busy in %.1f %% of the clocks, %.1f clocks each",
                      100 * busy(w, p),
                      static_cast<double>(w.clocks) / static_cast<double>(w.taken));
        return words(w) + text;
    }
    std::vector<const Work *> parts;
    uint64_t bound = 0;
    for (int i = 0; i < p.works; i++)
        if (p.work[i].binds) {
            parts.push_back(p.work + i);
            bound += p.work[i].binds;
        }
    std::stable_sort(parts.begin(), parts.end(),
                     [](const Work *a, const Work *b) { return a->binds > b->binds; });
    std::string said = "no single unit: ";
    for (const Work *part : parts) {
        std::snprintf(text, sizeof text, " in %.1f %% of the clocks, ",
                      100 * share(part->binds, p));
        said += words(*part) + text;
    }
    std::snprintf(text, sizeof text, "none in %.1f %%; the busiest is ",
                  100 * (1 - std::min(1.0, share(bound, p))));
    said += text + words(w);
    std::snprintf(text, sizeof text,
                  " (%.1f %%); a pixel waits for a slot in %.1f %%, rays for memory in %.1f %%",
                  100 * busy(w, p), 100 * slots_taken(p), 100 * share(p.memory[MEMORY_BOUND], p));
    return said + text;
}

json_t *limit_json(const Pass &p) {
    const Work &w = *busiest(p);
    return json_pack("{s:b, s:s, s:f, s:s}", "binds", busy(w, p) >= BINDS, "unit", words(w).c_str(),
                     "busy", busy(w, p), "said", limit(p).c_str());
}

/* A row a name, the busiest first. */
json_t *units_json(const Pass &p) {
    std::vector<const Work *> rows;
    for (int i = 0; i < p.works; i++)
        rows.push_back(p.work + i);
    std::stable_sort(rows.begin(), rows.end(),
                     [&](const Work *a, const Work *b) { return busy(*a, p) > busy(*b, p); });
    json_t *list = json_array();
    for (const Work *w : rows)
        json_array_append_new(list, json_pack("{s:s, s:i, s:f, s:I, s:I, s:I, s:I}", "name",
                                              words(*w).c_str(), "units",
                                              static_cast<int>(w->units), "busy", busy(*w, p),
                                              "taken", static_cast<json_int_t>(w->taken), "clocks",
                                              static_cast<json_int_t>(w->clocks), "binds",
                                              static_cast<json_int_t>(w->binds), "turned_away",
                                              static_cast<json_int_t>(w->away)));
    return list;
}

/* Bytes that memory can give in a clock of the core. */
double peak(const Options &o) {
    const DramPart *part = dram_part(o.memory);
    const double port = 8;
    return part ? std::min(port, Dram::peak(*part, static_cast<unsigned>(o.core_mhz))) : port;
}

json_t *pass_json(const Options &o, const Outcome &c, int pass) {
    json_t *object = json_object();
    json_object_set_new(object, "counters", counters(c.run->pass[pass].count, false));
    json_object_set_new(object, "errors", integer(c.run->pass[pass].errors));
    json_object_set_new(object, "cycles_per_pixel", json_real(cycles_per_pixel(c, pass)));
    json_object_set_new(object, "cycles_per_visit", json_real(cycles_per_visit(c.run->pass[pass])));
    json_object_set_new(object, "issue_port_busy", json_real(issue_use(c.run->pass[pass])));
    if (std::string(simulator_name) == "verilator")
        json_object_set_new(object, "memory", memory_json(o, c, pass));
    if (busiest(c.run->pass[pass])) {
        json_object_set_new(object, "limit", limit_json(c.run->pass[pass]));
        json_object_set_new(object, "units", units_json(c.run->pass[pass]));
    }
    return object;
}

} // namespace

std::string counter_table(const Options &o, const Outcome &c) {
    char text[256];
    std::snprintf(text, sizeof text, "  %-15s %14s %14s%s\n", "", "model", "core, cold",
                  o.warm ? "     core, warm" : "");
    std::string table = text;
    for (int i = 0; i < SPH_COUNTERS; i++) {
        char model[32] = "", warm[32] = "";
        if (sph_counter_both(i))
            std::snprintf(model, sizeof model, "%llu", static_cast<ull>(c.model_counters.count[i]));
        if (o.warm)
            std::snprintf(warm, sizeof warm, " %14llu",
                          static_cast<ull>(c.run->pass[WARM].count[i]));
        bool wrong = sph_counter_both(i) && c.model_counters.count[i] != c.run->pass[COLD].count[i];
        std::snprintf(text, sizeof text, "  %-15s %14s %14llu%s%s\n", counter_names[i], model,
                      static_cast<ull>(c.run->pass[COLD].count[i]), warm, wrong ? "  <--" : "");
        table += text;
    }
    const Pass &last = c.run->pass[o.warm ? WARM : COLD];
    if (last.works)
        table +=
            "  unit, last pass                      busy   results  clocks each  turned away\n";
    for (int i = 0; i < last.works; i++) {
        const Work &w = last.work[i];
        std::snprintf(text, sizeof text, "  %2u %-28s %6.1f %% %9llu %12.2f %10.1f %%\n", w.units,
                      words(w).c_str(), 100 * busy(w, last), static_cast<ull>(w.taken),
                      w.taken ? static_cast<double>(w.clocks) / static_cast<double>(w.taken) : 0,
                      100 * share(w.away, last) / static_cast<double>(w.units));
        table += text;
    }
    return table;
}

std::string limits(const Options &o, const Outcome &c) {
    std::string lines;
    for (int pass = COLD; pass <= (o.warm ? WARM : COLD); pass++)
        if (busiest(c.run->pass[pass]))
            lines += std::string("limit, ") + (pass == WARM ? "warm" : "cold") +
                     " caches: " + limit(c.run->pass[pass]) + "\n";
    return lines;
}

/* What a pass costs, by the name of its caches. */
static std::string cost(const Outcome &c, int pass, const char *caches) {
    const Pass &p = c.run->pass[pass];
    char text[256];
    std::snprintf(text, sizeof text,
                  "%s caches: %llu cycles, %.2f cycles/pixel, %.3f cycles/visit, issue port busy "
                  "%.1f %% of cycles while rays wait",
                  caches, static_cast<ull>(p.count[SPH_COUNT_CYCLES]), cycles_per_pixel(c, pass),
                  cycles_per_visit(p), 100 * issue_use(p));
    return text;
}

std::string summary(const Options &o, const sph_machine &m, const Outcome &c, const Verdict &v) {
    char text[256];
    std::snprintf(text, sizeof text, "core %s %s %dx%d: %llu pixels, %llu mismatches; ", m.name,
                  sph_machine_profile(&m)->name, c.window.x1 - c.window.x0,
                  c.window.y1 - c.window.y0, static_cast<ull>(c.pixels()),
                  static_cast<ull>(v.mismatches));
    return text + cost(c, COLD, "cold") + (o.warm ? "; " + cost(c, WARM, "warm") : "");
}

bool write_json(const Options &o, const sph_machine &m, const Outcome &c, const Verdict &v,
                int argc, char **argv, std::string &error) {
    const Window &w = c.window;
    std::string command;
    for (int i = 0; i < argc; i++)
        command += std::string(i ? " " : "") + argv[i];
    json_t *root = json_pack(
        "{s:s, s:i, s:s, s:s, s:s, s:s, s:s, s:s, s:[iiii], s:i, s:i, s:I, s:I, s:I, s:f, s:f, "
        "s:b}",
        "schema", "sphaera-simulation", "version", 2, "scene", m.name, "profile",
        sph_machine_profile(&m)->name, "command", command.c_str(), "simulator", simulator_name,
        "simulator_version", simulator_version().c_str(), "compiler", __VERSION__, "window", w.x0,
        w.y0, w.x1, w.y1, "latency", o.latency, "stall", o.stall, "seed",
        static_cast<json_int_t>(o.seed), "pixels", static_cast<json_int_t>(c.pixels()),
        "mismatches", static_cast<json_int_t>(v.mismatches), "seconds", c.seconds, "cpu_seconds",
        c.run->cpu, "refused", v.refused);
    json_object_set_new(root, "memory",
                        json_pack("{s:s, s:i, s:f}", "name", o.memory.c_str(), "core_mhz",
                                  o.core_mhz, "peak_bytes_per_clock", peak(o)));
    if (const DramPart *part = dram_part(o.memory))
        json_object_set_new(json_object_get(root, "memory"), "part", json_string(part->chip));
    if (!o.core.empty()) json_object_set_new(root, "core", json_string(o.core.c_str()));
    if (v.first[0] >= 0)
        json_object_set_new(root, "first_wrong", json_pack("[ii]", v.first[0], v.first[1]));
    if (!v.repeat.empty()) json_object_set_new(root, "repeat", json_string(v.repeat.c_str()));
    json_object_set_new(root, "model", counters(c.model_counters.count, true));
    json_object_set_new(root, "cold", pass_json(o, c, COLD));
    if (o.warm) json_object_set_new(root, "warm", pass_json(o, c, WARM));
    if (!v.text.empty()) json_object_set_new(root, "explanation", json_string(v.text.c_str()));

    sph_error err = {{0}};
    sph_output out;
    bool ok = !sph_output_open(&out, o.json.c_str(), &err);
    if (ok) {
        int failed = json_dumpf(root, out.file, JSON_INDENT(2)) || std::fputc('\n', out.file) < 0;
        ok = !sph_output_close(&out, failed, &err);
    }
    json_decref(root);
    error = err.text;
    return ok;
}

namespace {

/* The clocks of the pixels of the last pass; 0: none was delivered. */
int write_clocks(const Options &o, const Outcome &c, sph_error *err) {
    const Sample *samples = c.samples[o.warm ? WARM : COLD];
    sph_output out;
    if (sph_output_open(&out, o.clocks.c_str(), err)) return -1;
    int bad = 0;
    size_t n = static_cast<size_t>(c.model_frame.width) * static_cast<size_t>(c.model_frame.height);
    for (size_t i = 0; i < n; i++)
        for (unsigned shift = 0; shift < 32; shift += 8)
            bad |= std::fputc(static_cast<int>(samples[i].clock >> shift & 255), out.file) < 0;
    return sph_output_close(&out, bad, err);
}

} // namespace

bool write_frames(const Options &o, const Outcome &c, std::string &error) {
    sph_error err = {{0}};
    int failed = 0;
    if (!o.model_frame.empty()) {
        sph_shot shot = {c.model_frame, c.model_counters, c.model_errors};
        failed |= sph_shot_write(&shot, o.model_frame.c_str(), &err);
    }
    if (!o.frame.empty()) {
        int pass = o.warm ? WARM : COLD;
        size_t n =
            static_cast<size_t>(c.model_frame.width) * static_cast<size_t>(c.model_frame.height);
        std::vector<sph_pixel> pixels(n);
        for (size_t i = 0; i < n; i++)
            pixels[i] = c.samples[pass][i].pixel;
        sph_shot shot = {{c.model_frame.width, c.model_frame.height, pixels.data()},
                         {{0}},
                         c.run->pass[pass].errors};
        for (int i = 0; i < SPH_COUNTERS; i++)
            shot.counters.count[i] = c.run->pass[pass].count[i];
        failed |= sph_shot_write(&shot, o.frame.c_str(), &err);
    }
    if (!o.clocks.empty() && !failed) failed = write_clocks(o, c, &err);
    error = err.text;
    return !failed;
}
