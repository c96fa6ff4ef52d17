/* stages_followed.h - what the watches of stages share; for simulate_stages.cpp
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef TB_STAGES_FOLLOWED_H
#define TB_STAGES_FOLLOWED_H

#include <array>
#include <deque>
#include <memory>

#include "../bundles.h"
#include "shown.h"

using Words = std::array<sph_i128, SPH_STAGE_WORDS>;

/* Three numbers of `all` bits together from bit lsb on. */
inline void three(Words &words, size_t at, const Shown &signal, int lsb, int all) {
    for (int i = 0; i < 3; i++)
        words[at++] = signal.number(lsb + all / 3 * i, all / 3);
}

/* What all watches share: the pixel, its slot, where its lines go. */
struct Followed {
    void note(int stage, uint32_t number, const Words &words) {
        sph_stages_note(&to, stage, number, words.data(), words.size());
    }
    bool textured() const { return sph_machine_effect(&machine, SPH_EFFECT_TEXTURE) != 0; }
    const sph_machine &machine;
    const int x, y;
    sph_stages &to;
    bool on, done;
    int engine;
    uint32_t slot;
    bool refracted; /* the next ray that leaves a surface */
    sph_ray ray;    /* the latest that was set up; to a light: it may never start */
};

constexpr int lsb_of(int lsb, int) {
    return lsb;
}

/* Looks at some signals in every clock. */
class Watch {
  public:
    /* unit: g_WHAT around the module, of which there may be several in an engine; "": the engine */
    Watch(Followed &f, const Place &place, const char *unit)
        : f(f), W(sph_machine_profile(&f.machine)->w), WD(sph_machine_profile(&f.machine)->wd),
          NG(sph_machine_profile(&f.machine)->ng), engine(place.number("g_engine")),
          unit_(*unit ? place.number(unit) : 0) {}
    virtual ~Watch() = default;
    virtual void clock() = 0;

  protected:
    /* Whether a slot number of `bits` bits of this unit is that of the pixel. */
    bool mine(sph_u128 slot, int bits) const {
        const auto whole = static_cast<uint32_t>(unit_) << bits | static_cast<uint32_t>(slot);
        return f.on && engine == f.engine && whole == f.slot;
    }
    bool mine(const Shown &slot) const { return mine(slot.all(), slot.bits()); }
    /* SLOT of a bundle, which stands last from bit lsb on. */
    bool slot_of(const Shown &bundle, int lsb) const {
        const int bits = bundle.bits() - lsb;
        return mine(bundle.get(lsb, bits), bits);
    }
    Followed &f;
    const int W, WD, NG, SLOTW = 0; /* as bundles.h has them */
    const int engine;

  private:
    int unit_;
};

#endif
