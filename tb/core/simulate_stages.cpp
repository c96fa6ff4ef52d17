/* simulate_stages.cpp - see stage_watch.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * A watch for each module that the pixel's rays come through: what it reads in which clock is told
 * by the header of the module. Signals are read before a clock edge: a register shows what was
 * loaded at the edge before.
 */
#include "stage_watch.h"

#include <array>
#include <deque>

#include "../bundles.h"
#include "shown.h"
extern "C" {
#include "core/stages.h"
#include "shade/material.h"
}

namespace {

using Words = std::array<sph_i128, SPH_STAGE_WORDS>;

/* Three numbers of n bits from bit lsb on. */
void three(Words &words, size_t at, const Shown &signal, int lsb, int all) {
    for (int i = 0; i < 3; i++)
        words[at++] = signal.number(lsb + all / 3 * i, all / 3);
}

/* What all watches share: the pixel, its slot, where its lines go. */
struct Followed {
    Followed(const sph_machine &m, int x, int y, sph_stages &to)
        : machine(m), x(x), y(y), to(to), W(sph_machine_profile(&m)->w),
          WD(sph_machine_profile(&m)->wd), NG(sph_machine_profile(&m)->ng),
          FW(sph_machine_profile(&m)->fw),
          textured(sph_machine_effect(&m, SPH_EFFECT_TEXTURE) != 0) {}
    void note(int stage, uint32_t number, const Words &words) {
        sph_stages_note(&to, stage, number, words.data());
    }
    const sph_machine &machine;
    const int x, y;
    sph_stages &to;
    const int W, WD, NG, FW; /* as bundles.h has them */
    const bool textured;
    bool on = false, done = false;
    int engine = -1;
    uint32_t slot = 0;
    bool refracted = false; /* the next ray that leaves a surface */
};

/* Looks at some signals in every clock. */
class Watch {
  public:
    Watch(Followed &f, const Place &place) : f(f), engine_(place.number("g_engine")) {}
    virtual ~Watch() = default;
    virtual void clock() = 0;

  protected:
    /* Whether a slot number of `bits` bits of unit `number` is that of the pixel. */
    bool mine(int number, uint64_t slot, int bits) const {
        const uint64_t unit = number < 0 ? 0 : static_cast<uint64_t>(number);
        return f.on && engine_ == f.engine && (unit << bits | slot) == f.slot;
    }
    bool mine(int number, const Shown &slot) const {
        return mine(number, slot.word(), slot.bits());
    }
    /* SLOT of a bundle, which stands last. */
    bool mine(int number, const Shown &bundle, int lsb) const {
        const int bits = bundle.bits() - lsb;
        return mine(number, static_cast<uint64_t>(bundle.get(lsb, bits)), bits);
    }
    Followed &f;

  private:
    int engine_;
};

constexpr int SLOTW = 0; /* a bundle's SLOT is as wide as the bundle leaves it */
constexpr int lsb_of(int lsb, int) {
    return lsb;
}

// ---- slots: the pixel comes, its rays are done, it leaves ----

class Slots : public Watch {
  public:
    Slots(Followed &f, const Place &p)
        : Watch(f, p), engine_(p.number("g_engine")), taken_(p["taken"]), free_(p["free_slot"]),
          start_(p["start_i"]), out_(p["out_done"]), out_slot_(p["out_slot"]),
          valid_(p["d_valid_q"]), slot_(p["d_slot_q"]), done_(p["d_q"]) {}
    void clock() override {
        const int W = f.W, WD = f.WD;
        (void)W;
        if (taken_.bit() && !f.on && !f.done &&
            static_cast<int>(start_.get(RT_START_X)) == f.x &&
            static_cast<int>(start_.get(RT_START_Y)) == f.y) {
            f.on = true;
            f.engine = engine_;
            f.slot = free_.word();
        }
        if (valid_.bit() && mine(-1, slot_)) {
            const bool found = done_.get(RT_DONE_FOUND) != 0,
                       told = found && !done_.get(RT_DONE_SHADOW);
            f.note(SPH_STAGE_HIT, 0,
                   {found, told ? static_cast<sph_i128>(done_.get(RT_DONE_ID)) : SPH_ID_NONE,
                    told ? static_cast<sph_i128>(done_.get(RT_DONE_KEY)) : 0,
                    told && done_.get(RT_DONE_FAR)});
        }
        if (out_.bit() && mine(-1, out_slot_)) {
            f.on = false;
            f.done = true;
        }
    }

  private:
    int engine_;
    Shown taken_, free_, start_, out_, out_slot_, valid_, slot_, done_;
};

// ---- set-up: rays, normals, vectors to lights; the light's ray, if there is one ----

class SetUp : public Watch {
  public:
    SetUp(Followed &f, const Place &p)
        : Watch(f, p), number_(p.number("g_setup")), ray_(p["ray_o"]) {}
    void clock() override {
        const int W = f.W, WD = f.WD;
        if (!ray_.get(0, 3) || !mine(number_, ray_, lsb_of(RT_RAY_SLOT))) return;
        if (ray_.get(RT_RAY_NORMAL)) {
            Words words{};
            three(words, 0, ray_, RT_RAY_DIR);
            words[3] = static_cast<sph_i128>(ray_.get(RT_RAY_A));
            three(words, 4, ray_, RT_RAY_UNIT);
            f.note(SPH_STAGE_NORMAL, 0, words);
            return;
        }
        ray = {};
        Words words{};
        three(words, 0, ray_, RT_RAY_ORG);
        three(words, 3, ray_, RT_RAY_DIR);
        three(words, 6, ray_, RT_RAY_UNIT);
        for (size_t i = 0; i < 3; i++) {
            ray.org[i] = static_cast<int64_t>(words[i]);
            ray.dir[i] = static_cast<int64_t>(words[3 + i]);
            ray.unit.u[i] = static_cast<int32_t>(words[6 + i]);
        }
        ray.a = static_cast<uint64_t>(ray_.get(RT_RAY_A));
        ray.skip = {static_cast<uint32_t>(ray_.get(RT_RAY_SKIP)), ray_.get(RT_RAY_INSIDE) != 0};
        ray.kind = ray_.get(RT_RAY_LIGHT)     ? SPH_SHADOW
                   : ray_.get(RT_RAY_PRIMARY) ? SPH_PRIMARY
                   : f.refracted              ? SPH_REFRACTED
                                              : SPH_REFLECTED;
        f.refracted = false;
        if (ray.kind != SPH_SHADOW) sph_stages_begin(&f.to, &ray);
    }
    sph_ray ray{}; /* the latest of the pixel; to a light: it may never start */

  private:
    int number_;
    Shown ray_;
};

class Cosine : public Watch {
  public:
    Cosine(Followed &f, const Place &p, const std::vector<std::unique_ptr<SetUp>> &setups)
        : Watch(f, p), setups_(setups), number_(p.number("g_shade")), valid_(p["out_valid_o"]),
          slot_(p["out_slot_o"]), cosine_(p["out_cosine_o"]), go_(p["shadow_go_o"]) {}
    void clock() override {
        if (!valid_.bit() || !mine(number_, slot_)) return;
        const sph_ray *ray = nullptr;
        for (const auto &setup : setups_)
            if (setup->ray.kind == SPH_SHADOW) ray = &setup->ray;
        if (!ray) return;
        f.note(SPH_STAGE_LIGHT, 0,
               {SPH_THREE(ray->dir), static_cast<sph_i128>(ray->a), SPH_THREE(ray->unit.u),
                cosine_.word()});
        if (go_.bit()) sph_stages_begin(&f.to, ray);
    }

  private:
    const std::vector<std::unique_ptr<SetUp>> &setups_;
    int number_;
    Shown valid_, slot_, cosine_, go_;
};

// ---- nodes of four children: a visit of the pixel at a time ----

class Traverse : public Watch {
  public:
    Traverse(Followed &f, const Place &p, const Places &places)
        : Watch(f, p), number_(p.number("g_pipe")), issue_(p["i3_valid_q"]),
          issue_slot_(p["i3_slot_q"]), kill_(p["i3_kill"]), issue_line_(p["i3_line_q"]),
          node_valid_(p["t1_valid_q"]), node_slot_(p["t1_slot_q"]), node_kill_(p["t1_kill_q"]),
          node_(p["t1_node_q"]), limit_(p["depth_i"]), filtered_(p["f_valid"]),
          filtered_slot_(p["f_slot"]), pass_(p["f_pass"]), near_(p["f_near"]) {
        const Place spheres = places.at(p.path + ".g_spheres");
        org_ = spheres["t1_org"], axis_ = spheres["t1_axis"];
        negative_ = spheres["t1_negative"], across_ = spheres["t1_across"];
        for (size_t i = 0; i < 4; i++) {
            const std::string n = "[" + std::to_string(i) + "]";
            const Place lane = places.at(spheres.path + ".g_lane" + n + ".u_filter");
            const Place box = places.at(p.path + ".g_boxes.u_boxes.g_child" + n);
            p_[i] = lane["s6_p_q"], q_[i] = lane["s6_q_q"];
            lo_[i] = box["t2_lo_q"], hi_[i] = box["t2_hi_q"];
        }
    }
    bool boxes() const { return static_cast<bool>(lo_[0]); }
    void clock() override {
        if (issue_.bit() && !kill_.bit() && mine(number_, issue_slot_)) line_ = issue_line_.word();
        age_++;
        if (node_valid_.bit() && !node_kill_.bit() && mine(number_, node_slot_)) visit();
        for (size_t i = 0; visiting_ && i < 4; i++) {
            if (age_ == 1 && boxes())
                three(words_[i], 0, lo_[i], 0, lo_[i].bits()),
                    three(words_[i], 3, hi_[i], 0, hi_[i].bits());
            if (age_ == 6 && !boxes()) words_[i][4] = p_[i].word(), words_[i][5] = q_[i].word();
        }
        if (visiting_ && filtered_.bit() && mine(number_, filtered_slot_)) filtered();
    }

  private:
    void visit() {
        const auto inner = node_.get(SPH_NODE_N_INNER_LSB, SPH_NODE_N_INNER_BITS),
                   leaves = node_.get(SPH_NODE_N_LEAF_LSB, SPH_NODE_N_LEAF_BITS);
        if (!f.to.visit && !boxes()) across();
        f.note(SPH_STAGE_NODE, 0,
               {line_, static_cast<sph_i128>(node_.get(SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS)),
                static_cast<sph_i128>(inner), static_cast<sph_i128>(leaves)});
        children_ = static_cast<size_t>(inner + leaves);
        visiting_ = children_ <= 4;
        age_ = 0;
        for (int i = 0; i < 4; i++) {
            Words &words = words_[static_cast<size_t>(i)] = {};
            const int at = SPH_CHILD_STRIDE * i;
            if (boxes()) {
                words[7] = limit_.word();
                continue;
            }
            words[0] = node_.number(at + SPH_CHILD_CTR_X_LSB, SPH_CHILD_CTR_X_BITS);
            words[1] = node_.number(at + SPH_CHILD_CTR_Y_LSB, SPH_CHILD_CTR_Y_BITS);
            words[2] = node_.number(at + SPH_CHILD_CTR_Z_LSB, SPH_CHILD_CTR_Z_BITS);
            words[3] = node_.number(at + SPH_CHILD_RAD_LSB, SPH_CHILD_RAD_BITS);
            words[7] = limit_.word();
        }
    }
    void across() {
        Words words{};
        three(words, 0, org_, 0, org_.bits());
        words[3] = axis_.word(), words[4] = negative_.bit();
        words[5] = across_.number(lsb_of(RT_ACROSS_P_A), 18);
        words[6] = across_.number(lsb_of(RT_ACROSS_P_B), 18);
        three(words, 7, across_, lsb_of(RT_ACROSS_Q), 54);
        f.note(SPH_STAGE_ACROSS, 0, words);
    }
    void filtered() {
        for (size_t i = 0; i < children_; i++) {
            words_[i][6] = near_.number(static_cast<int>(16 * i), 16);
            words_[i][8] = pass_.bit(static_cast<int>(i));
            f.note(boxes() ? SPH_STAGE_BOX : SPH_STAGE_FILTER, 0, words_[i]);
        }
        visiting_ = false;
    }
    int number_;
    Shown issue_, issue_slot_, kill_, issue_line_, node_valid_, node_slot_, node_kill_, node_,
        limit_, filtered_, filtered_slot_, pass_, near_, org_, axis_, negative_, across_;
    std::array<Shown, 4> p_, q_, lo_, hi_;
    uint32_t line_ = 0;
    bool visiting_ = false;
    int age_ = 0; /* clocks since the node came */
    size_t children_ = 0;
    std::array<Words, 4> words_{};
};

// ---- nodes of a BIH ----

class Bih : public Watch {
  public:
    Bih(Followed &f, const Place &p)
        : Watch(f, p), number_(p.number("g_pipe")), issue_(p["issue"]),
          issue_slot_(p["q_issue_slot"]), place_(p["q_issue_place"]), live_(p["t1_live"]),
          slot_(p["t1_slot_q"]), node_(p["t1_words_q"]) {}
    void clock() override {
        if (issue_.bit() && mine(number_, issue_slot_)) at_ = place_.word();
        if (!live_.bit() || !mine(number_, slot_)) return;
        const auto axis = node_.get(SPH_BIH_AXIS_LSB, SPH_BIH_AXIS_BITS);
        const sph_i128 line = at_ >> 1, half = at_ & 1;
        if (axis == SPH_BIH_LEAF)
            f.note(SPH_STAGE_LEAF, 0,
                   {line, half, node_.number(SPH_BIH_FIRST_LSB, SPH_BIH_FIRST_BITS),
                    node_.number(SPH_BIH_COUNT_LSB, SPH_BIH_COUNT_BITS)});
        else
            f.note(SPH_STAGE_PLANES, 0,
                   {line, half, static_cast<sph_i128>(axis),
                    node_.number(SPH_BIH_CLIP_L_LSB, f.W + 2),
                    node_.number(SPH_BIH_CLIP_R_LSB, f.W + 2),
                    node_.bit(SPH_BIH_FIT_LSB), node_.number(SPH_BIH_CHILD_LSB, SPH_BIH_CHILD_BITS)});
    }

  private:
    int number_;
    Shown issue_, issue_slot_, place_, live_, slot_, node_;
    uint32_t at_ = 0; /* {line, half} */
};

// ---- exact tests: those of a unit leave in the order in which they came ----

class Sphere : public Watch {
  public:
    Sphere(Followed &f, const Place &p, const Places &places, int slot_bits)
        : Watch(f, p), number_(p.number("g_exact")), bits_(slot_bits), take_(p["take"]),
          tag_(p["in_tag_i"]), id_(p["in_id_i"]),
          ctr_{p["in_ctr_x_i"], p["in_ctr_y_i"], p["in_ctr_z_i"]}, rad_(p["in_rad_i"]),
          disc_(p["disc"]), out_(p["out_valid_o"]), b_(p["out_b_o"]), hit_(p["out_hit_o"]),
          far_(p["out_far_o"]) {
        const Place two = places.at(p.path + ".g_two.u_two"), four = places.at(p.path + ".g_four.u_four");
        k_soon_ = two["xy_sub"] ? two["xy_sub"] : four["ready_i"];
        k_ = two["val_q"] ? two["val_q"] : four["k_q"];
    }
    void clock() override {
        if (k_next_ && !begun_.empty()) {
            begun_.front().words[5] = k_.number();
            tested_.push_back(begun_.front());
            begun_.pop_front();
        }
        k_next_ = k_soon_.bit();
        if (take_.bit()) { /* {shadow, slot, miss} */
            Test test{mine(number_, static_cast<uint64_t>(tag_.get(1, bits_)), bits_), id_.word(), {}};
            for (size_t i = 0; i < 3; i++)
                test.words[i] = ctr_[i].number();
            test.words[3] = static_cast<sph_i128>(rad_.all());
            begun_.push_back(test);
        }
        if (out_.bit() && !tested_.empty()) { /* disc stood there two clocks ago */
            Test &test = tested_.front();
            test.words[4] = b_.number();
            test.words[6] = disc_before_[1];
            test.words[7] = hit_.bit(), test.words[8] = far_.bit();
            if (test.mine) f.note(SPH_STAGE_SPHERE, test.id, test.words);
            tested_.pop_front();
        }
        disc_before_ = {disc_.number(), disc_before_[0]};
    }

  private:
    struct Test {
        bool mine;
        uint32_t id;
        Words words;
    };
    int number_, bits_;
    Shown take_, tag_, id_;
    std::array<Shown, 3> ctr_;
    Shown rad_, disc_, out_, b_, hit_, far_, k_soon_, k_;
    std::deque<Test> begun_, tested_; /* without k, with it */
    bool k_next_ = false;
    std::array<sph_i128, 2> disc_before_{};
};

class Roots : public Watch {
  public:
    Roots(Followed &f, const Place &p, const Places &places, int slot_bits)
        : Watch(f, p), number_(p.number("g_exact")), bits_(slot_bits), valid_(p["out_valid_o"]),
          ready_(p["out_ready_i"]), tag_(p["out_tag_o"]),
          give_(places.at(p.path + ".u_pool")["give_o"]) {
        for (int u = 0; u < give_.bits(); u++) {
            const Place unit = places.at(p.path + ".g_unit[" + std::to_string(u) + "]");
            units_.push_back({unit["root"], unit["shift"], unit["inexact"]});
        }
    }
    void clock() override {
        if (!valid_.bit() || !ready_.bit()) return;
        const auto slot = static_cast<uint64_t>(tag_.get(SPH_ID_BITS, bits_));
        if (!mine(number_, slot, bits_)) return;
        for (size_t u = 0; u < units_.size(); u++)
            if (give_.bit(static_cast<int>(u)))
                f.note(SPH_STAGE_ROOT, static_cast<uint32_t>(tag_.get(0, SPH_ID_BITS)),
                       {static_cast<sph_i128>(units_[u].root.all() << units_[u].shift.word()),
                        units_[u].inexact.bit()});
    }

  private:
    struct Unit {
        Shown root, shift, inexact;
    };
    int number_, bits_;
    Shown valid_, ready_, tag_, give_;
    std::vector<Unit> units_;
};

class Facet : public Watch {
  public:
    Facet(Followed &f, const Place &p, int slot_bits)
        : Watch(f, p), number_(p.number("g_exact")), bits_(slot_bits), det_(p["s1_det_q"]),
          num_(p["s1_num_q"]), u2_(p["s1_u2_q"]), v_(p["s1_v_q"]), valid_(p["s2_valid_q"]),
          tag_(p["a_all"]) {}
    void clock() override {
        const int id = 2 * f.WD + 2; /* {slot, id, shadow, plane, a} */
        if (valid_.bit() &&
            mine(number_, static_cast<uint64_t>(tag_.get(id + SPH_ID_BITS, bits_)), bits_))
            f.note(tag_.bit(2 * f.WD) ? SPH_STAGE_PLANE : SPH_STAGE_TRIANGLE,
                   static_cast<uint32_t>(tag_.get(id, SPH_ID_BITS)), before_);
        before_ = {det_.number(), num_.number(), -v_.number(), u2_.number()};
    }

  private:
    int number_, bits_;
    Shown det_, num_, u2_, v_, valid_, tag_;
    Words before_{}; /* sums of the clock before */
};

class Results : public Watch {
  public:
    Results(Followed &f, const Place &p)
        : Watch(f, p), number_(p.number("g_exact")), result_(p["result_o"]) {}
    void clock() override {
        const int W = f.W, WD = f.WD;
        if (!result_.get(RT_RESULT_VALID) || !result_.get(RT_RESULT_HIT) ||
            !mine(number_, result_, lsb_of(RT_RESULT_SLOT)))
            return;
        f.note(SPH_STAGE_KEY, static_cast<uint32_t>(result_.get(RT_RESULT_ID)),
               {static_cast<sph_i128>(result_.get(RT_RESULT_KEY)),
                result_.get(RT_RESULT_FAR) != 0});
    }

  private:
    int number_;
    Shown result_;
};

// ---- surfaces ----

class Surface : public Watch {
  public:
    Surface(Followed &f, const Place &p, const Places &places)
        : Watch(f, p), number_(p.number("g_shade")), t_valid_(p["t_valid"]), t_(p["t"]),
          t_fetch_(p["t_fetch"]), record_(p["record_i"]), surface_(p["surface_o"]) {
        const Place hit = places.at(p.path + ".g_point.u_hit");
        guarded_ = hit["guarded"], g_ = hit["s5_g_q"];
    }
    void clock() override {
        const int W = f.W, WD = f.WD, NG = f.NG;
        if (t_valid_.bit() && mine(number_, t_fetch_, SPH_LINE_BITS))
            f.note(SPH_STAGE_QUOTIENT, 0, {t_.number(8, t_.bits() - 8), t_.number(0, 8)});
        if (record_.get(RT_RECORD_VALID) && mine(number_, record_, lsb_of(RT_RECORD_SLOT))) {
            std::array<uint32_t, SPH_LINE_WORDS> prim{};
            for (int i = 0; i < SPH_LINE_WORDS; i++)
                prim[static_cast<size_t>(i)] = static_cast<uint32_t>(
                    record_.get(lsb_of(RT_RECORD_DATA) + 32 * i, 32));
            const sph_look look = sph_look_read(&f.machine, prim.data());
            sph_look_note(&f.to, &look);
        }
        if (guarded_.bit()) { /* x, y, z of a hit; hits leave in their order */
            coming_.push_back(g_.number());
        }
        if (surface_.get(RT_SURFACE_VALID) && coming_.size() >= 3) {
            if (mine(number_, surface_, lsb_of(RT_SURFACE_SLOT))) {
                Words words{coming_[0], coming_[1], coming_[2]};
                three(words, 3, surface_, RT_SURFACE_POINT);
                f.note(SPH_STAGE_POINT, 0, words);
            }
            coming_.erase(coming_.begin(), coming_.begin() + 3);
        }
    }

  private:
    int number_;
    Shown t_valid_, t_, t_fetch_, record_, surface_, guarded_, g_;
    std::deque<sph_i128> coming_;
};

class Highlights : public Watch {
  public:
    Highlights(Followed &f, const Place &p)
        : Watch(f, p), number_(p.number("g_shade")), valid_(p["g_valid"]), slot_(p["g_slot"]),
          highlight_(p["highlight"]) {}
    void clock() override {
        if (valid_.bit() && mine(number_, slot_))
            f.note(SPH_STAGE_HIGHLIGHT, 0, {highlight_.word()});
    }

  private:
    int number_;
    Shown valid_, slot_, highlight_;
};

class Textures : public Watch {
  public:
    Textures(Followed &f, const Place &p)
        : Watch(f, p), number_(p.number("g_shade")), path_valid_(p["p_valid"]),
          path_slot_(p["p_slot"]), path_(p["p_path"]), texel_(p["texel_valid"]),
          ready_(p["texel_ready"]), slot_(p["texel_slot"]), line_(p["texel_line"]),
          word_(p["texel_word"]) {}
    void clock() override {
        if (!f.textured) return;
        if (path_valid_.bit() && mine(number_, path_slot_))
            f.note(SPH_STAGE_PATH, 0, {static_cast<sph_i128>(path_.get(0, f.W + 8))});
        if (texel_.bit() && ready_.bit() && mine(number_, slot_))
            f.note(SPH_STAGE_TEXEL, 0,
                   {static_cast<sph_i128>(line_.all() * SPH_LINE_WORDS + word_.all())});
    }

  private:
    int number_;
    Shown path_valid_, path_slot_, path_, texel_, ready_, slot_, line_, word_;
};

/* Between surfaces and lights; rays that wait. */
class Shade : public Watch {
  public:
    Shade(Followed &f, const Place &p)
        : Watch(f, p), number_(p.number("g_shade")), albedo_(p["albedo"]), back_(p["back"]) {}
    void clock() override {
        const int W = f.W;
        if (f.textured && albedo_.get(RT_ALBEDO_VALID) &&
            mine(number_, albedo_, lsb_of(RT_ALBEDO_SLOT))) {
            const auto rgb = static_cast<uint32_t>(albedo_.get(RT_ALBEDO_RGB));
            f.note(SPH_STAGE_ALBEDO, 0, {rgb & 255, rgb >> 8 & 255, rgb >> 16});
        }
        if (back_.get(RT_BACK_VALID) && mine(number_, back_, lsb_of(RT_BACK_SLOT)))
            f.refracted = true;
    }

  private:
    int number_;
    Shown albedo_, back_;
};

/* rt_blend: a channel in each of the clocks 4 to 6. */
class Blend : public Watch {
  public:
    Blend(Followed &f, const Place &p, int slot_bits)
        : Watch(f, p), number_(p.number("g_shade")), bits_(slot_bits), phase_(p["ph_q"]),
          tag_(p["in_tag_q"]), colour_(p["s3_colour_q"]), weight_(p["weight_q"]) {}
    void clock() override {
        for (int i = 0; i < 3; i++) /* ph_q begins with bit 1 */
            if (phase_.bit(i + 3)) words_[static_cast<size_t>(i)] = colour_.word();
        if (!phase_.bit(5) || !mine(number_, static_cast<uint64_t>(tag_.get(0, bits_)), bits_))
            return;
        words_[3] = weight_.word();
        f.note(SPH_STAGE_COLOUR, 0, words_);
    }

  private:
    int number_, bits_;
    Shown phase_, tag_, colour_, weight_;
    Words words_{};
};

/* rt_share: all channels in clock 8. */
class Share : public Watch {
  public:
    Share(Followed &f, const Place &p, const Places &places, int slot_bits)
        : Watch(f, p), number_(p.number("g_shade")), bits_(slot_bits), phase_(p["ph_q"]),
          tag_(p["tag_q"]), weight_(p["weight_q"]) {
        for (size_t i = 0; i < 3; i++)
            colour_[i] = places.at(p.path + ".g_channel[" + std::to_string(i) + "]")["colour_q"];
    }
    void clock() override {
        if (phase_.bit(7) && mine(number_, static_cast<uint64_t>(tag_.get(0, bits_)), bits_))
            f.note(SPH_STAGE_COLOUR, 0,
                   {colour_[0].word(), colour_[1].word(), colour_[2].word(), weight_.word()});
    }

  private:
    int number_, bits_;
    Shown phase_, tag_, weight_;
    std::array<Shown, 3> colour_;
};

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
        : followed_(machine, x, y, to) {
        const Places places(context);
        Followed &f = followed_;
        const auto slots = places.with("free_slot");
        if (slots.empty()) return;
        /* of one engine */
        const auto units = [&](const char *signal) { return places.with(signal).size() / slots.size(); };
        const int slot_bits = slots[0]["free_slot"].bits(),
                  exact = slot_bits - log2_of(units("result_o")),
                  shade = slot_bits - log2_of(units("albedo"));
        for (const Place &p : slots)
            add<Slots>({SPH_STAGE_HIT}, f, p);
        for (const Place &p : places.with("ray_o")) {
            setups_.push_back(std::make_unique<SetUp>(f, p));
            shows({SPH_STAGE_RAY, SPH_STAGE_NORMAL, SPH_STAGE_PIXEL});
        }
        for (const Place &p : places.with("out_cosine_o"))
            add<Cosine>({SPH_STAGE_LIGHT}, f, p, setups_);
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
            add<Roots>({SPH_STAGE_ROOT}, f, p, places, exact);
        for (const Place &p : places.with("s1_det_q"))
            add<Facet>({SPH_STAGE_TRIANGLE, SPH_STAGE_PLANE}, f, p, exact);
        for (const Place &p : places.with("result_o"))
            add<Results>({SPH_STAGE_KEY}, f, p);
        for (const Place &p : places.with("t_fetch"))
            add<Surface>({SPH_STAGE_QUOTIENT, SPH_STAGE_POINT, SPH_STAGE_MATERIAL}, f, p, places);
        for (const Place &p : places.with("highlight"))
            add<Highlights>({SPH_STAGE_HIGHLIGHT}, f, p);
        for (const Place &p : places.with("texel_line"))
            add<Textures>({SPH_STAGE_PATH, SPH_STAGE_TEXEL, SPH_STAGE_ALBEDO}, f, p);
        for (const Place &p : places.with("albedo"))
            add<Shade>({}, f, p);
        for (const Place &p : places.with("s3_colour_q"))
            add<Blend>({SPH_STAGE_COLOUR}, f, p, shade);
        for (const Place &p : places.with("tag_q"))
            if (p["ph_q"]) add<Share>({SPH_STAGE_COLOUR}, f, p, places, shade);
    }
    void clock() {
        if (followed_.done) return;
        for (const auto &setup : setups_)
            setup->clock();
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
    std::vector<std::unique_ptr<SetUp>> setups_;
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
