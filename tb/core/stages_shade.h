/* stages_shade.h - watches of surfaces, textures, lights and colours; for simulate_stages.cpp
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef TB_STAGES_SHADE_H
#define TB_STAGES_SHADE_H

#include <array>
#include <deque>
#include <memory>

#include "../bundles.h"
#include "signals.h"

/* ---- what the watches of stages share; for simulate_stages.cpp ---- */

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

extern "C" {
#include "shade/material.h"
}

class Surface : public Watch {
  public:
    Surface(Followed &f, const Place &p, const Places &places)
        : Watch(f, p, "g_shade"), t_valid_(p["t_valid"]), t_(p["t"]), t_slot_(p["t_slot"]),
          record_(p["record_i"]), surface_(p["surface_o"]) {
        const Place hit = places.at(p.path + ".g_point.u_hit");
        guarded_ = hit["guarded"], g_ = hit["s5_g_q"];
    }
    void clock() override {
        if (t_valid_.bit() && slot_of(t_slot_, 0))
            f.note(SPH_STAGE_QUOTIENT, 0, {t_.number(8, t_.bits() - 8), t_.number(0, 8)});
        if (record_.get(RT_RECORD_VALID) && slot_of(record_, lsb_of(RT_RECORD_SLOT))) {
            std::array<uint32_t, SPH_LINE_WORDS> prim{};
            for (int i = 0; i < SPH_LINE_WORDS; i++)
                prim[static_cast<size_t>(i)] =
                    static_cast<uint32_t>(record_.get(lsb_of(RT_RECORD_DATA) + 32 * i, 32));
            const sph_shading shading = sph_shading_read(&f.machine, prim.data());
            sph_shading_note(&f.to, &shading);
        }
        if (guarded_.bit()) { /* x, y, z of a hit; hits leave in their order */
            coming_.push_back(g_.number());
        }
        if (surface_.get(RT_SURFACE_VALID) && coming_.size() >= 3) {
            if (slot_of(surface_, lsb_of(RT_SURFACE_SLOT))) {
                Words words{coming_[0], coming_[1], coming_[2]};
                three(words, 3, surface_, RT_SURFACE_POINT);
                f.note(SPH_STAGE_POINT, 0, words);
            }
            coming_.erase(coming_.begin(), coming_.begin() + 3);
        }
    }

  private:
    Shown t_valid_, t_, t_slot_, record_, surface_, guarded_, g_;
    std::deque<sph_i128> coming_;
};

class Highlights : public Watch {
  public:
    Highlights(Followed &f, const Place &p)
        : Watch(f, p, "g_shade"), valid_(p["g_valid"]), slot_(p["g_slot"]),
          highlight_(p["highlight"]) {}
    void clock() override {
        if (valid_.bit() && mine(slot_)) f.note(SPH_STAGE_HIGHLIGHT, 0, {highlight_.word()});
    }

  private:
    Shown valid_, slot_, highlight_;
};

class Textures : public Watch {
  public:
    Textures(Followed &f, const Place &p, const Places &places)
        : Watch(f, p, "g_shade"), path_valid_(p["p_valid"]), path_slot_(p["p_slot"]),
          path_(p["p_path"]), texel_(p["texel_valid"]), ready_(p["texel_ready"]),
          slot_(p["texel_slot"]), line_(p["texel_line"]), word_(p["texel_word"]) {
        const Place image = places.at(p.path + ".u_image");
        level_ = image["l_valid_q"], level_slot_ = image["l_slot_q"], lod_ = image["l_lod_q"];
    }
    void clock() override {
        if (!f.textured()) return;
        if (level_.bit() && mine(level_slot_)) f.note(SPH_STAGE_LEVEL, 0, {lod_.word()});
        if (path_valid_.bit() && mine(path_slot_))
            f.note(SPH_STAGE_PATH, 0, {static_cast<sph_i128>(path_.get(0, W + 8))});
        if (texel_.bit() && ready_.bit() && mine(slot_))
            f.note(SPH_STAGE_TEXEL, 0,
                   {static_cast<sph_i128>(line_.all() * SPH_LINE_WORDS + word_.all())});
    }

  private:
    Shown path_valid_, path_slot_, path_, texel_, ready_, slot_, line_, word_, level_, level_slot_,
        lod_;
};

/* Between surfaces and lights; rays that wait. */
class Shade : public Watch {
  public:
    Shade(Followed &f, const Place &p)
        : Watch(f, p, "g_shade"), albedo_(p["albedo"]), back_(p["back"]) {}
    void clock() override {
        if (f.textured() && albedo_.get(RT_ALBEDO_VALID) &&
            slot_of(albedo_, lsb_of(RT_ALBEDO_SLOT))) {
            const auto rgb = static_cast<uint32_t>(albedo_.get(RT_ALBEDO_RGB));
            f.note(SPH_STAGE_ALBEDO, 0, {rgb & 255, rgb >> 8 & 255, rgb >> 16});
        }
        if (back_.get(RT_BACK_VALID) && slot_of(back_, lsb_of(RT_BACK_SLOT))) f.refracted = true;
    }

  private:
    Shown albedo_, back_;
};

/* rt_blend: a channel in each of the clocks 4 to 6. */
class Blend : public Watch {
  public:
    Blend(Followed &f, const Place &p, int slot_bits)
        : Watch(f, p, "g_shade"), bits_(slot_bits), phase_(p["ph_q"]), tag_(p["in_tag_q"]),
          colour_(p["s3_colour_q"]), weight_(p["weight_q"]) {}
    void clock() override {
        for (int i = 0; i < 3; i++) /* ph_q begins with bit 1 */
            if (phase_.bit(i + 3)) words_[static_cast<size_t>(i)] = colour_.word();
        if (!phase_.bit(5) || !mine(tag_.get(0, bits_), bits_)) return;
        words_[3] = weight_.word();
        f.note(SPH_STAGE_COLOUR, 0, words_);
    }

  private:
    int bits_;
    Shown phase_, tag_, colour_, weight_;
    Words words_{};
};

/* rt_share: all channels in clock 8. */
class Share : public Watch {
  public:
    Share(Followed &f, const Place &p, const Places &places, int slot_bits)
        : Watch(f, p, "g_shade"), bits_(slot_bits), phase_(p["ph_q"]), tag_(p["tag_q"]),
          weight_(p["weight_q"]) {
        for (size_t i = 0; i < 3; i++)
            colour_[i] = places.at(p.path + ".g_channel[" + std::to_string(i) + "]")["colour_q"];
    }
    void clock() override {
        if (phase_.bit(7) && mine(tag_.get(0, bits_), bits_))
            f.note(SPH_STAGE_COLOUR, 0,
                   {colour_[0].word(), colour_[1].word(), colour_[2].word(), weight_.word()});
    }

  private:
    int bits_;
    Shown phase_, tag_, weight_;
    std::array<Shown, 3> colour_;
};

/* Cosines of lights; the ray to the light goes, or none does. */
class Cosine : public Watch {
  public:
    Cosine(Followed &f, const Place &p)
        : Watch(f, p, "g_shade"), valid_(p["out_valid_o"]), slot_(p["out_slot_o"]),
          cosine_(p["out_cosine_o"]), go_(p["shadow_go_o"]) {}
    void clock() override {
        if (!valid_.bit() || !mine(slot_)) return;
        f.note(SPH_STAGE_LIGHT, 0,
               {SPH_THREE(f.ray.dir), static_cast<sph_i128>(f.ray.a), SPH_THREE(f.ray.unit.u),
                cosine_.word()});
        if (go_.bit()) sph_stages_begin(&f.to, &f.ray);
    }

  private:
    Shown valid_, slot_, cosine_, go_;
};

#endif
