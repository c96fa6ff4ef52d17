/* dsp48e1.cpp - Xilinx's DSP48E1, after UG479; see netlist.h
 * SPDX-License-Identifier: Apache-2.0
 *
 *   A -[A1]-[A2]-+             B -[B1]-[B2]-+
 *                +-(+/-)-[AD]---------------*--[M]--X,Y-+
 *   D -[D]-------+                                       +--(+/-)--[P]- P
 *   C -[C]--------------------------------------- Y,Z ---+
 *   PCIN ---------------------------------------- Z -----+
 * Each register is there or not. Of the modes OPMODE alone may change at run time.
 */
#include "blocks.h"

namespace {

int64_t extend(uint64_t value, unsigned bits) {
    return static_cast<int64_t>(value << (64 - bits)) >> (64 - bits);
}

class Dsp : public Block {
  public:
    Dsp(Netlist &n, const Cell &c);
    Nets through() const override;
    Nets outputs() const override;
    void settle(uint8_t *net) override {
        const uint64_t value = preg_ ? p_ : sum(net);
        put(net, out_, value);
        put(net, cascade_, value);
    }
    void edge(const uint8_t *net) override;

  private:
    struct Register {
        bool there = false;
        Net enable = 1, reset = 0;
        void step(const uint8_t *net, uint64_t &state, uint64_t value) const {
            if (!there) return;
            if (net[reset])
                state = 0;
            else if (net[enable])
                state = value;
        }
    };
    Register reg(Netlist &n, const Cell &c, bool there, const std::string &enable,
                 const std::string &reset);
    unsigned mode(Netlist &n, const Cell &c, const std::string &port, size_t width);

    uint64_t a(const uint8_t *net) const {
        return !a2_.there ? word(net, a_in_) : first_a_ ? s_a1_ : s_a2_;
    }
    uint64_t b(const uint8_t *net) const {
        return !b2_.there ? word(net, b_in_) : first_b_ ? s_b1_ : s_b2_;
    }
    uint64_t d(const uint8_t *net) const { return d_.there ? s_d_ : word(net, d_in_); }
    uint64_t c(const uint8_t *net) const { return c_.there ? s_c_ : word(net, c_in_); }
    uint64_t ad(const uint8_t *net) const;
    uint64_t product(const uint8_t *net) const;
    uint64_t sum(const uint8_t *net) const;
    void check_opmode(Netlist &n, const Cell &c) const;

    Nets a_in_, b_in_, c_in_, d_in_, p_in_, opmode_, out_, cascade_;
    Register a1_, a2_, b1_, b2_, c_, d_, ad_, m_, p_reg_;
    uint64_t s_a1_ = 0, s_a2_ = 0, s_b1_ = 0, s_b2_ = 0, s_c_ = 0, s_d_ = 0, s_ad_ = 0, s_m_ = 0,
             p_ = 0;
    unsigned inmode_, alumode_;
    bool first_a_, first_b_, adds_, preg_;
};

Dsp::Register Dsp::reg(Netlist &n, const Cell &c, bool there, const std::string &enable,
                       const std::string &reset) {
    if (there && !c.pins.count(enable)) n.refuse(c, enable + " of a register is open");
    return {there, c.pin(enable), c.pin(reset)};
}

unsigned Dsp::mode(Netlist &n, const Cell &c, const std::string &port, size_t width) {
    unsigned value = 0;
    for (size_t i = 0; i < width; i++) {
        if (c.pin(port, i) > 1) n.refuse(c, port + " changes");
        value |= c.pin(port, i) << i;
    }
    return value;
}

Dsp::Dsp(Netlist &n, const Cell &c)
    : a_in_(c.pins_of("A", 30)), b_in_(c.pins_of("B", 18)), c_in_(c.pins_of("C", 48)),
      d_in_(c.pins_of("D", 25)), p_in_(c.pins_of("PCIN", 48)), opmode_(c.pins_of("OPMODE", 7)),
      out_(c.pins_of("P", 48)), cascade_(c.pins_of("PCOUT", 48)), inmode_(mode(n, c, "INMODE", 5)),
      alumode_(mode(n, c, "ALUMODE", 4)), first_a_(c.number("AREG", 1) == 2 && inmode_ & 1),
      first_b_(c.number("BREG", 1) == 2 && inmode_ >> 4 & 1),
      adds_(c.text("USE_DPORT", "FALSE") == "TRUE"), preg_(c.number("PREG", 1) != 0) {
    n.clocked(c, "CLK");
    for (const char *setting : {"A_INPUT", "B_INPUT"})
        n.must(c, setting, {"DIRECT"});
    n.must(c, "USE_SIMD", {"ONE48"});
    n.must(c, "USE_PATTERN_DETECT", {"NO_PATDET"});
    n.tied(c, {"CARRYIN", "CARRYINSEL"});
    for (const char *port : {"ACOUT", "BCOUT", "CARRYOUT", "CARRYCASCOUT", "MULTSIGNOUT"})
        for (Net net : c.pins_of(port, 30))
            if (net > 1 && n.is_read(net)) n.refuse(c, std::string(port) + " is in use");
    const uint64_t areg = c.number("AREG", 1), breg = c.number("BREG", 1);
    a1_ = reg(n, c, areg == 2, "CEA1", "RSTA");
    a2_ = reg(n, c, areg != 0, "CEA2", "RSTA");
    b1_ = reg(n, c, breg == 2, "CEB1", "RSTB");
    b2_ = reg(n, c, breg != 0, "CEB2", "RSTB");
    c_ = reg(n, c, c.number("CREG", 1) != 0, "CEC", "RSTC");
    d_ = reg(n, c, adds_ && c.number("DREG", 1) != 0, "CED", "RSTD");
    ad_ = reg(n, c, adds_ && c.number("ADREG", 1) != 0, "CEAD", "RSTD");
    m_ = reg(n, c, c.number("MREG", 1) != 0, "CEM", "RSTM");
    p_reg_ = reg(n, c, preg_, "CEP", "RSTP");
    if (alumode_ != 0 && alumode_ != 3) n.refuse(c, "ALUMODE has no model");
    check_opmode(n, c);
}

/* Each value that OPMODE may have: X has nothing, M or P, Y nothing, M or C, Z nothing, PCIN, P or
 * C. */
void Dsp::check_opmode(Netlist &n, const Cell &c) const {
    bool changes = false;
    for (unsigned value = 0; value < 128; value++) {
        bool possible = true;
        for (size_t i = 0; i < 7; i++) {
            changes = changes || opmode_[i] > 1;
            possible = possible && (opmode_[i] > 1 || opmode_[i] == (value >> i & 1));
        }
        const unsigned x = value & 3, y = value >> 2 & 3, z = value >> 4;
        const bool known = x != 3 && y != 2 && z < 4 && (x == 1) == (y == 1);
        if (possible && !known) n.refuse(c, "OPMODE has no model");
        if (possible && (x == 2 || z == 2) && !preg_) n.refuse(c, "P goes round without PREG");
    }
    if (changes && c.number("OPMODEREG", 1)) n.refuse(c, "OPMODE has a register");
}

Nets Dsp::through() const {
    Nets all;
    auto add = [&all](bool there, const Nets &nets) {
        if (!there) all.insert(all.end(), nets.begin(), nets.end());
    };
    if (preg_) return all;
    add(false, opmode_);
    add(c_.there, c_in_);
    add(false, p_in_);
    if (m_.there) return all;
    add(b2_.there, b_in_);
    if (ad_.there) return all;
    add(a2_.there, a_in_);
    add(d_.there || !adds_, d_in_);
    return all;
}

Nets Dsp::outputs() const {
    Nets all = out_;
    all.insert(all.end(), cascade_.begin(), cascade_.end());
    return all;
}

/* What the multiplier gets beside B. */
uint64_t Dsp::ad(const uint8_t *net) const {
    const uint64_t own = inmode_ & 2 ? 0 : a(net);
    if (!adds_) return own;
    const uint64_t other = inmode_ & 4 ? d(net) : 0;
    return inmode_ & 8 ? other - own : other + own;
}

uint64_t Dsp::product(const uint8_t *net) const {
    return static_cast<uint64_t>(extend(ad_.there ? s_ad_ : ad(net), 25) * extend(b(net), 18));
}

uint64_t Dsp::sum(const uint8_t *net) const {
    const auto opmode = static_cast<unsigned>(word(net, opmode_));
    const unsigned x = opmode & 3, y = opmode >> 2 & 3, z = opmode >> 4;
    uint64_t add = x == 1 ? m_.there ? s_m_ : product(net) : x == 2 ? p_ : 0;
    if (y == 3) add += c(net);
    const uint64_t to = z == 0 ? 0 : z == 1 ? word(net, p_in_) : z == 2 ? p_ : c(net);
    return (alumode_ == 3 ? to - add : to + add) & ((uint64_t{1} << 48) - 1);
}

void Dsp::edge(const uint8_t *net) {
    if (preg_) p_reg_.step(net, p_, sum(net));
    m_.step(net, s_m_, product(net));
    ad_.step(net, s_ad_, ad(net));
    const uint64_t a = word(net, a_in_), b = word(net, b_in_);
    a2_.step(net, s_a2_, a1_.there ? s_a1_ : a);
    b2_.step(net, s_b2_, b1_.there ? s_b1_ : b);
    a1_.step(net, s_a1_, a);
    b1_.step(net, s_b1_, b);
    c_.step(net, s_c_, word(net, c_in_));
    d_.step(net, s_d_, word(net, d_in_));
}

} // namespace

void lower_dsp48e1(Netlist &n, const Cell &c) {
    n.block(std::make_unique<Dsp>(n, c));
}
