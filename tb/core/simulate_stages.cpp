/* simulate_stages.cpp - see stage_watch.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * A watch for each module that the pixel's rays come through: what it reads in which clock is told
 * by the header of the module. Signals are read before a clock edge: a register shows what was
 * loaded at the edge before.
 */
#include "stage_watch.h"

#include <initializer_list>
#include <vector>

#include "stages_shade.h"
#include "stages_trace.h"

namespace {

int log2_of(size_t n) {
    int bits = 0;
    while (size_t{1} << bits < n)
        bits++;
    return bits;
}

} // namespace

class StageWatch::Core {
  public:
    Core(VerilatedContext &context, const sph_machine &machine, int x, int y, sph_stages &to)
        : followed_{machine, x, y, to, false, false, -1, 0, false, {}} {
        const Places places(context);
        Followed &f = followed_;
        const auto slots = places.with("free_slot");
        if (slots.empty()) return;
        /* of one engine */
        const auto units = [&](const char *signal) {
            return places.with(signal).size() / slots.size();
        };
        const int slot_bits = slots[0]["free_slot"].bits(),
                  exact = slot_bits - log2_of(units("result_o")),
                  shade = slot_bits - log2_of(units("albedo"));
        for (const Place &p : slots)
            add<Slots>({SPH_STAGE_HIT}, f, p);
        for (const Place &p : places.with("ray_o"))
            add<SetUp>({SPH_STAGE_RAY, SPH_STAGE_NORMAL, SPH_STAGE_PIXEL}, f, p);
        for (const Place &p : places.with("out_cosine_o"))
            add<Cosine>({SPH_STAGE_LIGHT}, f, p);
        for (const Place &p : places.with("i3_line_q")) {
            add<Traverse>({SPH_STAGE_NODE}, f, p, places);
            if (static_cast<Traverse &>(*watches_.back()).boxes())
                shows({SPH_STAGE_BOX});
            else
                shows({SPH_STAGE_ACROSS, SPH_STAGE_FILTER});
        }
        for (const Place &p : places.with("t1_words_q"))
            add<Bih>({SPH_STAGE_PLANES, SPH_STAGE_LEAF}, f, p);
        for (const Place &p : places.with("in_rad_i"))
            add<Sphere>({SPH_STAGE_SPHERE}, f, p, places, exact);
        for (const Place &p : places.with("out_tag_o"))
            add<Roots>({SPH_STAGE_ROOT}, f, p, exact);
        for (const Place &p : places.with("s1_det_q"))
            add<Facet>({SPH_STAGE_TRIANGLE, SPH_STAGE_PLANE}, f, p, exact);
        for (const Place &p : places.with("result_o"))
            add<Results>({SPH_STAGE_KEY}, f, p);
        for (const Place &p : places.with("t_slot"))
            add<Surface>({SPH_STAGE_QUOTIENT, SPH_STAGE_POINT, SPH_STAGE_MATERIAL}, f, p, places);
        for (const Place &p : places.with("highlight"))
            add<Highlights>({SPH_STAGE_HIGHLIGHT}, f, p);
        for (const Place &p : places.with("texel_line"))
            add<Textures>({SPH_STAGE_PATH, SPH_STAGE_LEVEL, SPH_STAGE_TEXEL, SPH_STAGE_ALBEDO}, f,
                          p, places);
        for (const Place &p : places.with("albedo"))
            add<Shade>({}, f, p);
        for (const Place &p : places.with("s3_colour_q"))
            add<Blend>({SPH_STAGE_COLOUR}, f, p, shade);
        for (const Place &p : places.with("tag_q"))
            if (p["ph_q"]) add<Share>({SPH_STAGE_COLOUR}, f, p, places, shade);
    }
    void clock() {
        if (followed_.done) return;
        followed_.to.clock += followed_.on;
        for (const auto &watch : watches_)
            watch->clock();
    }
    uint32_t shown() const { return shown_; }

  private:
    template <class W, class... A> void add(std::initializer_list<int> stages, A &&...args) {
        watches_.push_back(std::make_unique<W>(std::forward<A>(args)...));
        shows(stages);
    }
    void shows(std::initializer_list<int> stages) {
        for (int stage : stages)
            shown_ |= 1u << stage;
    }
    Followed followed_;
    std::vector<std::unique_ptr<Watch>> watches_;
    uint32_t shown_ = 0;
};

StageWatch::StageWatch(VerilatedContext &context, const sph_machine &machine, int x, int y,
                       sph_stages &to)
    : core_(std::make_unique<Core>(context, machine, x, y, to)) {}
StageWatch::~StageWatch() = default;
void StageWatch::clock() {
    core_->clock();
}
uint32_t StageWatch::shown() const {
    return core_->shown();
}
