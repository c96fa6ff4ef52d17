/* compare_stages.cpp - the stages of one pixel, line by line; see outcome.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "outcome.h"

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
