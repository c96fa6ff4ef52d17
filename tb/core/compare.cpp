/* compare.cpp - bit for bit, and the first difference explained; see outcome.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>

#include "outcome.h"
#include "report.h"

extern "C" {
#include "pixel/background.h"
}

namespace {

using ull = unsigned long long;
const char *const counter_names[] = {SPH_COUNTER_NAMES};
const char *const error_names[] = {SPH_ERROR_NAMES};
const char *const colour_names[SPH_FRAMES] = {"Rendering", "L1", "L2"};

std::string line(const char *format, ...) __attribute__((format(printf, 1, 2)));
std::string line(const char *format, ...) {
    char text[512];
    va_list ap;
    va_start(ap, format);
    std::vsnprintf(text, sizeof text, format, ap);
    va_end(ap);
    return std::string(text) + "\n";
}

/* The unit that a difference points at. */
const char *stage(const sph_pixel &model, const Sample &core) {
    if (!core.times) return "never delivered: launch, slots or pixel output";
    if (core.times > 1) return "delivered more than once: launch, slots or pixel output";
    const sph_pixel &p = core.pixel;
    if (model.id != p.id || model.key != p.key) return "traversal or leaf test (id, key)";
    if (model.texture != p.texture) return "texture unit (level of detail, addresses of texels)";
    if (model.colour[0] != p.colour[0]) return "shading at the first hit (Rendering)";
    if (model.colour[1] != p.colour[1]) return "first reflection: bounce, its traversal, blend";
    if (model.colour[2] != p.colour[2]) return "deeper reflections: bounce, traversal, blend";
    return "order of traversal (only visits differ)";
}

std::string colour(const char *name, uint32_t a, uint32_t b) {
    return line("  %-10s 0x%06x (%.4f %.4f %.4f)   0x%06x (%.4f %.4f %.4f)%s", name, a,
                (a & 255) / 255.0, (a >> 8 & 255) / 255.0, (a >> 16) / 255.0, b, (b & 255) / 255.0,
                (b >> 8 & 255) / 255.0, (b >> 16) / 255.0, a != b ? "  <--" : "");
}

std::string number(const char *name, uint64_t a, uint64_t b) {
    return line("  %-10s 0x%llx (%llu)   0x%llx (%llu)%s", name, static_cast<ull>(a),
                static_cast<ull>(a), static_cast<ull>(b), static_cast<ull>(b),
                a != b ? "  <--" : "");
}

} // namespace

sph_pixel dark_pixel(const sph_machine &m, uint32_t visits) {
    auto sky = static_cast<uint32_t>(m.regs[SPH_REG_BG_COLOUR]);
    return {{sky, sky, sky}, SPH_ID_NONE, visits, SPH_NO_TEXTURE, 0};
}

std::string difference(const sph_machine &m, const sph_pixel &p, const Sample &s, int x, int y) {
    int64_t dir[3];
    sph_primary_dir(&m, x, y, dir);
    double a = 0;
    for (int64_t d : dir)
        a += static_cast<double>(d) * static_cast<double>(d);
    std::string text = line("  stage      %s", stage(p, s));
    text += line("  %-10s model   core", "");
    text += number("id", p.id, s.pixel.id);
    text += number("key", p.key, s.pixel.key);
    auto model_key = static_cast<double>(p.key), core_key = static_cast<double>(s.pixel.key);
    text += line("  %-10s %.9g   %.9g", "t", model_key / a, core_key / a);
    text += line("  %-10s %.4f   %.4f grid units", "distance", model_key / std::sqrt(a),
                 core_key / std::sqrt(a));
    text += number("visits", p.visits & 0xffffff, s.pixel.visits);
    text += number("texture", p.texture, s.pixel.texture);
    for (int i = 0; i < SPH_FRAMES; i++)
        text += colour(colour_names[i], p.colour[i], s.pixel.colour[i]);
    return text + line("  ray        org %d %d %d dir %lld %lld %lld, delivered %u times",
                       m.regs[SPH_REG_EYE_X], m.regs[SPH_REG_EYE_Y], m.regs[SPH_REG_EYE_Z],
                       static_cast<long long>(dir[0]), static_cast<long long>(dir[1]),
                       static_cast<long long>(dir[2]), s.times);
}

namespace {

/* The machine is refused, or should be: not one pixel may come. */
bool refuses(const Options &o, const Outcome &c) {
    return (c.run->pass[COLD].errors & REFUSED) ||
           (o.expect_errors >= 0 && o.expect_errors & REFUSED);
}

/* The model knows nothing of bus errors: values are not compared then, only delivery. The warm pass
 * comes behind the one error. */
bool values_count(const Options &o, const Outcome &c, int pass) {
    return (o.bus_error_at < 0 || pass == WARM) && !refuses(o, c);
}

/* No primitive can be read. */
bool dark(const Options &o) {
    return o.spoil >= 0 && !o.warm;
}

/* Whether the run ended at the first difference, by wish: the rest was never simulated. */
bool stopped(const Outcome &c) {
    return c.run->stopped;
}

/* Pixels of one pass. */
void compare_pixels(const Options &o, const sph_machine &m, const Outcome &c, int pass,
                    Verdict &v) {
    const Window &w = c.window;
    const unsigned wanted = refuses(o, c) ? 0 : 1;
    const bool partly = stopped(c);
    uint64_t wrong = 0;
    std::string first;
    for (int y = w.y0; y < w.y1; y++)
        for (int x = w.x0; x < w.x1; x++) {
            size_t at = static_cast<size_t>(y) * static_cast<size_t>(c.model_frame.width) +
                        static_cast<size_t>(x);
            const Sample &s = c.samples[pass][at];
            if (partly && !s.times) continue;
            const sph_pixel p = dark(o) ? dark_pixel(m, s.pixel.visits) : c.model_frame.pixels[at];
            if (values_count(o, c, pass) ? equal(p, s) : s.times == wanted) continue;
            if (wrong++) continue;
            first = line("first wrong pixel x %d y %d%s:", x, y, pass ? " (warm pass)" : "");
            first += difference(m, p, s, x, y);
            if (!v.repeat.empty()) continue;
            v.first[0] = x;
            v.first[1] = y;
            v.repeat = repeat_command(o, {x, y, x + 1, y + 1});
        }
    if (!wrong) return;
    v.mismatches += wrong;
    v.text += first + line("%llu of %llu pixels differ", static_cast<ull>(wrong),
                           static_cast<ull>(c.pixels()));
}

/* Nothing was hit, and the core says why. */
void compare_dark(const Options &o, const sph_machine &m, const Outcome &c, Verdict &v) {
    const Pass &p = c.run->pass[COLD];
    uint64_t rays = p.count[SPH_COUNT_RAYS_PRIMARY], visits = p.count[SPH_COUNT_NODE_VISITS];
    bool root = o.spoil <= m.regs[SPH_REG_ROOT]; /* is all that a ray visits */
    if (p.errors == 1u << SPH_ERROR_BUS_ERROR && !p.count[SPH_COUNT_ROOTS] &&
        !p.count[SPH_COUNT_DIVISIONS] && (!root || visits == rays))
        return;
    v.mismatches++;
    v.text += line("errors 0x%x, %llu roots, %llu divisions, %llu visits of %llu rays, though no "
                   "line from %lld on can be read",
                   p.errors, static_cast<ull>(p.count[SPH_COUNT_ROOTS]),
                   static_cast<ull>(p.count[SPH_COUNT_DIVISIONS]), static_cast<ull>(visits),
                   static_cast<ull>(rays), static_cast<long long>(o.spoil));
}

void compare_totals(const Outcome &c, int pass, Verdict &v) {
    const char *where = pass ? " (warm pass)" : "";
    for (int i = 0; i < SPH_COUNTERS; i++) {
        uint64_t model = c.model_counters.count[i], core = c.run->pass[pass].count[i];
        if (model == core || !sph_counter_both(i)) continue;
        v.mismatches++;
        v.text += line("counter %-15s model %llu, core %llu%s", counter_names[i],
                       static_cast<ull>(model), static_cast<ull>(core), where);
    }
    for (int i = 0; i < SPH_ERRORS; i++) {
        unsigned model = c.model_errors >> i & 1, core = c.run->pass[pass].errors >> i & 1;
        if (model == core) continue;
        v.mismatches++;
        v.text += line("error bit %s: model %u, core %u%s", error_names[i], model, core, where);
    }
}

void compare_expected(const Options &o, const Outcome &c, Verdict &v) {
    const uint32_t camera = 1u << SPH_ERROR_LEFT_OUT; /* the only refusal that the model knows */
    const uint32_t errors = c.run->pass[COLD].errors;
    if (!(errors & REFUSED & ~camera) && (c.model_errors ^ errors) & camera) {
        v.mismatches++;
        v.text += line("error bit %s: model 0x%x, core 0x%x", error_names[SPH_ERROR_LEFT_OUT],
                       c.model_errors, errors);
    }
    if (o.expect_errors < 0) return;
    auto missing = static_cast<uint32_t>(o.expect_errors) & ~c.run->pass[COLD].errors;
    for (int i = 0; i < SPH_ERRORS; i++)
        if (missing >> i & 1) {
            v.mismatches++;
            v.text += line("error bit %s is not set", error_names[i]);
        }
}

} // namespace

Verdict compare(const Options &o, const sph_machine &machine, const Outcome &c) {
    if (c.run->no_input || c.run->given_up) {
        Verdict v{0, c.run->failure, c.run->given_up, c.run->no_input, false, {-1, -1}, "", ""};
        if (c.run->stages && c.run->given_up) compare_stages(o, machine, c, v);
        return v;
    }
    Verdict v{0, refusal(o, machine, c.run->pass[COLD].errors), false, false, false, {-1, -1}, "",
              ""};
    v.refused = !v.text.empty() && !(o.expect_errors >= 0 && o.expect_errors & REFUSED);
    if (c.run->failure[0]) {
        v.mismatches++;
        v.text += c.run->failure;
    }
    for (int pass = COLD; pass <= (o.warm ? WARM : COLD); pass++) {
        compare_pixels(o, machine, c, pass, v);
        if (values_count(o, c, pass) && !dark(o) && !stopped(c)) compare_totals(c, pass, v);
    }
    if (dark(o)) compare_dark(o, machine, c, v);
    compare_expected(o, c, v);
    if (c.run->stages && !v.refused) compare_stages(o, machine, c, v);
    if (v.mismatches && v.repeat.empty()) v.repeat = repeat_command(o, c.window);
    if (v.mismatches) v.text += "repeat: " + v.repeat + "\n";
    return v;
}

/* ---- the stages of one pixel, line by line; see outcome.h ---- */

namespace {

std::string text(const sph_machine &m, const sph_stage_line &line) {
    char said[SPH_STAGE_TEXT];
    sph_stages_text(&m, &line, said);
    return said;
}

/* What the core delivered. */
sph_stages whole(const Options &o, const Outcome &c) {
    sph_stages stages = c.stages;
    const size_t at = static_cast<size_t>(o.pixel[1]) * static_cast<size_t>(c.model_frame.width) +
                      static_cast<size_t>(o.pixel[0]);
    const Sample &sample = c.samples[COLD][at];
    if (sample.times) sph_stages_pixel(&stages, &sample.pixel);
    sph_stages_sort(&stages);
    return stages;
}

} // namespace

void compare_stages(const Options &o, const sph_machine &machine, const Outcome &c, Verdict &v) {
    sph_stages model = c.model_stages, core = whole(o, c);
    sph_stages_sort(&model);
    const std::string pixel = std::to_string(o.pixel[0]) + "," + std::to_string(o.pixel[1]);
    std::string first;
    int equal = 0, alone = 0;
    for (int i = 0, j = 0; i < model.n || j < core.n;) {
        const int order = i == model.n  ? 1
                          : j == core.n ? -1
                                        : sph_stages_order(&model.lines[i], &core.lines[j]);
        const std::string a = order <= 0 ? text(machine, model.lines[i]) : "",
                          b = order >= 0 ? text(machine, core.lines[j]) : "";
        const bool shown = order > 0 || c.run->stages_shown >> model.lines[i].stage & 1;
        const std::string clock =
            order >= 0 ? "  clock " + std::to_string(core.lines[j].clock) : "";
        i += order <= 0;
        j += order >= 0;
        if (a == b || !shown) {
            v.stages += a + (shown ? clock : "  (model only)") + "\n";
            equal += shown;
            alone += !shown;
            continue;
        }
        const std::string both = "  model: " + (a.empty() ? "no such line" : a) +
                                 "\n  core:  " + (b.empty() ? "no such line" : b) + "\n";
        v.stages += both;
        if (first.empty()) first = both;
    }
    if (model.full || core.full) first += "  no memory for all lines\n";
    if (first.empty()) {
        v.stages += std::to_string(equal) + " lines of pixel " + pixel + ": model and RTL agree" +
                    (alone ? ", " + std::to_string(alone) + " are the model's alone" : "") + "\n";
        return;
    }
    v.mismatches++;
    v.text += "stages of pixel " + pixel + ", the first that differs:\n" + first;
}
