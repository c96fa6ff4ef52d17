/* stages_trace.h - watches of set-up, traversal and exact tests; for simulate_stages.cpp
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef TB_STAGES_TRACE_H
#define TB_STAGES_TRACE_H

#include "stages_shade.h"

// ---- slots: the pixel comes, its rays are done, it leaves ----

class Slots : public Watch {
  public:
    Slots(Followed &f, const Place &p)
        : Watch(f, p, ""), taken_(p["taken"]), free_(p["free_slot"]), start_(p["start_i"]),
          out_(p["out_done"]), out_slot_(p["out_slot"]), valid_(p["d_valid_q"]),
          slot_(p["d_slot_q"]), done_(p["d_q"]) {}
    void clock() override {
        if (taken_.bit() && !f.on && !f.done && static_cast<int>(start_.get(RT_START_X)) == f.x &&
            static_cast<int>(start_.get(RT_START_Y)) == f.y) {
            f.on = true;
            f.engine = engine;
            f.slot = free_.word();
        }
        if (valid_.bit() && mine(slot_)) {
            const bool found = done_.get(RT_DONE_FOUND) != 0,
                       told = found && !done_.get(RT_DONE_SHADOW);
            f.note(SPH_STAGE_HIT, 0,
                   {found, told ? static_cast<sph_i128>(done_.get(RT_DONE_ID)) : SPH_ID_NONE,
                    told ? static_cast<sph_i128>(done_.get(RT_DONE_KEY)) : 0,
                    told && done_.get(RT_DONE_FAR)});
        }
        if (out_.bit() && mine(out_slot_)) {
            f.on = false;
            f.done = true;
        }
    }

  private:
    Shown taken_, free_, start_, out_, out_slot_, valid_, slot_, done_;
};

// ---- set-up: rays, normals, vectors to lights; the light's ray, if there is one ----

class SetUp : public Watch {
  public:
    SetUp(Followed &f, const Place &p) : Watch(f, p, "g_setup"), ray_(p["ray_o"]) {}
    void clock() override {
        if (!ray_.get(0, 3) || !slot_of(ray_, lsb_of(RT_RAY_SLOT))) return;
        if (ray_.get(RT_RAY_NORMAL)) {
            Words words{};
            three(words, 0, ray_, RT_RAY_DIR);
            words[3] = static_cast<sph_i128>(ray_.get(RT_RAY_A));
            three(words, 4, ray_, RT_RAY_UNIT);
            f.note(SPH_STAGE_NORMAL, 0, words);
            return;
        }
        Words words{};
        three(words, 0, ray_, RT_RAY_ORG);
        three(words, 3, ray_, RT_RAY_DIR);
        three(words, 6, ray_, RT_RAY_UNIT);
        sph_ray &ray = f.ray = {};
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

  private:
    Shown ray_;
};

// ---- nodes of four children: a visit of the pixel at a time ----

class Traverse : public Watch {
  public:
    Traverse(Followed &f, const Place &p, const Places &places)
        : Watch(f, p, "g_pipe"), issue_(p["i3_valid_q"]), issue_slot_(p["i3_slot_q"]),
          kill_(p["i3_kill"]), issue_line_(p["i3_line_q"]), node_valid_(p["t1_valid_q"]),
          node_slot_(p["t1_slot_q"]), node_kill_(p["t1_kill_q"]), node_(p["t1_node_q"]),
          limit_(p["depth_i"]), filtered_(p["f_valid"]), filtered_slot_(p["f_slot"]),
          killed_(p["f_kill"]), pass_(p["f_pass"]), near_(p["f_near"]) {
        const Place spheres = places.at(p.path + ".g_spheres");
        org_ = spheres["t1_org"], axis_ = spheres["t1_axis"];
        negative_ = spheres["t1_negative"], across_ = spheres["t1_across"];
        for (size_t i = 0; i < 4; i++) {
            const std::string n = "[" + std::to_string(i) + "]";
            const Place lane = places.at(spheres.path + ".g_lane" + n + ".u_filter");
            p_[i] = lane["s6_p_q"], q_[i] = lane["s6_q_q"];
        }
    }
    bool boxes() const { return !p_[0]; }
    void clock() override {
        if (issue_.bit() && !kill_.bit() && mine(issue_slot_)) line_ = issue_line_.word();
        age_++;
        if (node_valid_.bit() && !node_kill_.bit() && mine(node_slot_)) visit();
        for (size_t i = 0; visiting_ && i < 4; i++) {
            if (age_ == 6 && !boxes()) words_[i][4] = p_[i].word(), words_[i][5] = q_[i].word();
        }
        if (visiting_ && filtered_.bit() && mine(filtered_slot_)) filtered();
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
                for (size_t k = 0; k < 6; k++) /* lo, then hi */
                    words[k] = static_cast<sph_i128>(
                        node_.get(SPH_BOX_STRIDE * i + SPH_BOX_LO_X_BITS * static_cast<int>(k),
                                  SPH_BOX_LO_X_BITS));
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
        for (size_t i = 0; i < children_ && !killed_.bit(); i++) {
            words_[i][6] = near_.number(static_cast<int>(16 * i), 16);
            words_[i][8] = pass_.bit(static_cast<int>(i));
            f.note(boxes() ? SPH_STAGE_BOX : SPH_STAGE_FILTER, 0, words_[i]);
        }
        visiting_ = false;
    }
    Shown issue_, issue_slot_, kill_, issue_line_, node_valid_, node_slot_, node_kill_, node_,
        limit_, filtered_, filtered_slot_, killed_, pass_, near_, org_, axis_, negative_, across_;
    std::array<Shown, 4> p_, q_;
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
        : Watch(f, p, "g_pipe"), issue_(p["issue"]), issue_slot_(p["q_issue_slot"]),
          place_(p["q_issue_place"]), live_(p["t1_live"]), slot_(p["t1_slot_q"]),
          node_(p["t1_words_q"]) {}
    void clock() override {
        if (issue_.bit() && mine(issue_slot_)) at_ = place_.word();
        if (!live_.bit() || !mine(slot_)) return;
        const auto axis = node_.get(SPH_BIH_AXIS_LSB, SPH_BIH_AXIS_BITS);
        const sph_i128 line = at_ >> 1, half = at_ & 1;
        if (axis == SPH_BIH_LEAF)
            f.note(SPH_STAGE_LEAF, 0,
                   {line, half, node_.number(SPH_BIH_FIRST_LSB, SPH_BIH_FIRST_BITS),
                    node_.number(SPH_BIH_COUNT_LSB, SPH_BIH_COUNT_BITS)});
        else
            f.note(SPH_STAGE_PLANES, 0,
                   {line, half, static_cast<sph_i128>(axis),
                    node_.number(SPH_BIH_CLIP_L_LSB, W + 2),
                    node_.number(SPH_BIH_CLIP_R_LSB, W + 2), node_.bit(SPH_BIH_FIT_LSB),
                    node_.number(SPH_BIH_CHILD_LSB, SPH_BIH_CHILD_BITS)});
    }

  private:
    Shown issue_, issue_slot_, place_, live_, slot_, node_;
    uint32_t at_ = 0; /* {line, half} */
};

// ---- exact tests: those of a unit leave in the order in which they came ----

class Sphere : public Watch {
  public:
    Sphere(Followed &f, const Place &p, const Places &places, int slot_bits)
        : Watch(f, p, "g_exact"), bits_(slot_bits), take_(p["take"]), tag_(p["in_tag_i"]),
          id_(p["in_id_i"]), ctr_{p["in_ctr_x_i"], p["in_ctr_y_i"], p["in_ctr_z_i"]},
          rad_(p["in_rad_i"]), disc_(p["disc"]), out_(p["out_valid_o"]), b_(p["out_b_o"]),
          hit_(p["out_hit_o"]), far_(p["out_far_o"]) {
        const Place two = places.at(p.path + ".g_two.u_two"),
                    four = places.at(p.path + ".g_four.u_four");
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
            Test test{mine(tag_.get(1, bits_), bits_), id_.word(), {}};
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
    int bits_;
    Shown take_, tag_, id_;
    std::array<Shown, 3> ctr_;
    Shown rad_, disc_, out_, b_, hit_, far_, k_soon_, k_;
    std::deque<Test> begun_, tested_; /* without k, with it */
    bool k_next_ = false;
    std::array<sph_i128, 2> disc_before_{};
};

class Roots : public Watch {
  public:
    Roots(Followed &f, const Place &p, int slot_bits)
        : Watch(f, p, "g_exact"), bits_(slot_bits), valid_(p["out_valid_o"]), tag_(p["out_tag_o"]),
          root_(p["root"]), shift_(p["shift"]), inexact_(p["inexact"]) {}
    void clock() override {
        if (!valid_.bit()) return;
        const auto slot = static_cast<uint64_t>(tag_.get(SPH_ID_BITS, bits_));
        if (mine(slot, bits_))
            f.note(SPH_STAGE_ROOT, static_cast<uint32_t>(tag_.get(0, SPH_ID_BITS)),
                   {static_cast<sph_i128>(root_.all() << shift_.word()), inexact_.bit()});
    }

  private:
    int bits_;
    Shown valid_, tag_, root_, shift_, inexact_;
};

class Facet : public Watch {
  public:
    Facet(Followed &f, const Place &p, int slot_bits)
        : Watch(f, p, "g_exact"), bits_(slot_bits), det_(p["s1_det_q"]), num_(p["s1_num_q"]),
          u2_(p["s1_u2_q"]), v_(p["s1_v_q"]), valid_(p["s2_valid_q"]), tag_(p["a_all"]) {}
    void clock() override {
        const int id = 2 * WD + 2; /* {slot, id, shadow, plane, a} */
        if (valid_.bit() && mine(tag_.get(id + SPH_ID_BITS, bits_), bits_))
            f.note(tag_.bit(2 * WD) ? SPH_STAGE_PLANE : SPH_STAGE_TRIANGLE,
                   static_cast<uint32_t>(tag_.get(id, SPH_ID_BITS)), before_);
        before_ = {det_.number(), num_.number(), -v_.number(), u2_.number()};
    }

  private:
    int bits_;
    Shown det_, num_, u2_, v_, valid_, tag_;
    Words before_{}; /* sums of the clock before */
};

class Results : public Watch {
  public:
    Results(Followed &f, const Place &p) : Watch(f, p, "g_exact"), result_(p["result_o"]) {}
    void clock() override {
        if (!result_.get(RT_RESULT_VALID) || !result_.get(RT_RESULT_HIT) ||
            !slot_of(result_, lsb_of(RT_RESULT_SLOT)))
            return;
        f.note(
            SPH_STAGE_KEY, static_cast<uint32_t>(result_.get(RT_RESULT_ID)),
            {static_cast<sph_i128>(result_.get(RT_RESULT_KEY)), result_.get(RT_RESULT_FAR) != 0});
    }

  private:
    Shown result_;
};

#endif
