/* cells_xc7.cpp - cells of Xilinx's series 7 but DSP48E1; see netlist.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <cinttypes>
#include <cstdio>

#include "blocks.h"

namespace {

/* A LUT as a shift register: looked at where the address says. */
class Shift : public Block {
  public:
    Shift(const Cell &c, uint32_t state)
        : at_({c.pin("A0"), c.pin("A1"), c.pin("A2"), c.pin("A3")}), d_(c.pin("D")),
          enable_(c.pin("CE", 0, 1)), q_(c.pin("Q")), state_(state) {}
    Nets through() const override { return at_; }
    Nets outputs() const override { return {q_}; }
    void settle(uint8_t *net) override { put(net, {q_}, state_ >> word(net, at_)); }
    void edge(const uint8_t *net) override {
        if (net[enable_]) state_ = (state_ << 1 | net[d_]) & 0xffff;
    }

  private:
    Nets at_;
    Net d_, enable_, q_;
    uint32_t state_;
};

void flip_flop(Netlist &n, const Cell &c, bool sets) {
    n.clocked(c, "C");
    n.flop({c.pin("D"), c.pin("Q"), c.pin("CE", 0, 1), c.pin(sets ? "S" : "R"), 0, sets},
           c.bits("INIT", 1, sets ? '1' : '0')[0]);
}

/* Sums are S xor carry; a carry goes on where S is 1, else DI is the next. */
void carry(Netlist &n, const Cell &c) {
    const Net first = n.fresh();
    n.table(0xe, {c.pin("CI"), c.pin("CYINIT")}, first);
    Net in = first;
    for (size_t i = 0; i < 4; i++) {
        const Net out = c.pin("CO", i) ? c.pin("CO", i) : n.fresh();
        n.table(0x6, {c.pin("S", i), in}, c.pin("O", i));
        n.table(0xca, {c.pin("DI", i), in, c.pin("S", i)}, out);
        in = out;
    }
}

/* RAM32M, RAM64M: four memories of a LUT each, written where D looks. */
void lut_ram(Netlist &n, const Cell &c, size_t address, size_t width) {
    auto ram = std::make_unique<LutRam>();
    n.clocked(c, "WCLK");
    ram->write_address = c.pins_of("ADDRD", address);
    ram->write = c.pin("WE");
    for (const char *which : {"A", "B", "C", "D"}) {
        const std::string s = which;
        LutRam::Port port = {c.pins_of("ADDR" + s, address),
                             c.pins_of("DI" + s, width),
                             c.pins_of("DO" + s, width),
                             {}};
        const std::string init = c.bits("INIT_" + s, 64, '0');
        for (size_t at = 0; at < 64 / width && at < size_t{1} << address; at++) {
            uint64_t value = 0;
            for (size_t i = 0; i < width; i++)
                value |= static_cast<uint64_t>(n.initial(init[width * at + i])) << i;
            port.words.push_back(value);
        }
        ram->ports.push_back(port);
    }
    n.block(std::move(ram));
}

/* ---- block RAM ---- */
struct Side { /* names of a port's pins */
    const char *letter, *clock, *address, *enable, *write;
};
const Side SIDES[] = {{"A", "CLKARDCLK", "ADDRARDADDR", "ENARDEN", "WEA"},
                      {"B", "CLKBWRCLK", "ADDRBWRADDR", "ENBWREN", "WEBWE"}};

/* Data pins, then those of parity; a port as wide as both sides has A's as its low half. */
Nets data_pins(const Cell &c, const char *direction, const std::string &letter, uint32_t width,
               uint32_t most, bool both) {
    auto pins = [&](const char *parity, uint32_t bits, uint32_t limit) {
        const std::string name = std::string("D") + direction + parity;
        auto of = [&](const std::string &s) { return name + s + "D" + direction + parity; };
        Nets nets = c.pins_of(of(both ? "A" : letter), bits < limit ? bits : limit);
        if (both) {
            const Nets high = c.pins_of(of("B"), bits - limit);
            nets.insert(nets.end(), high.begin(), high.end());
        }
        return nets;
    };
    Nets all = pins("", width, most);
    const Nets parity = pins("P", width / 8, most / 8);
    all.insert(all.end(), parity.begin(), parity.end());
    return all;
}

void block_side(Netlist &n, const Cell &c, BlockRam &ram, const Side &side) {
    const std::string letter = side.letter;
    const uint32_t most = ram.bits / 1024; /* bits of data of a side */
    auto width_of = [&](const char *what) {
        const auto pins = static_cast<uint32_t>(c.number(what + letter, 0));
        return pins < 8 ? pins : pins / 9 * 8;
    };
    const size_t address = ram.bits == 32768 ? 15 : 14;
    const uint32_t reads = width_of("READ_WIDTH_"), writes = width_of("WRITE_WIDTH_");
    BlockRam::Port port = {
        c.pins_of(side.address, address), {}, reads, c.pin(side.enable), 1, {}, false, {}};
    if (reads) {
        const bool both = reads > most;
        if (both && letter == "B") n.refuse(c, "a wide port B reads");
        port.data = data_pins(c, "O", letter, reads, most, both);
        port.latch.assign(port.data.size(), 0);
        ram.reads.push_back(port);
    }
    if (writes && port.enable && c.pin(side.write) + c.pin(side.write, 1) > 0) {
        const bool both = writes > most;
        if (reads) n.refuse(c, "port " + letter + " reads and writes");
        if (both && letter == "A") n.refuse(c, "a wide port A writes");
        port.width = writes;
        port.data = data_pins(c, "I", letter, writes, most, both);
        port.bytes = c.pins_of(side.write, 8);
        port.keeps_old = c.text("WRITE_MODE_" + letter, "WRITE_FIRST") == "READ_FIRST";
        ram.writes.push_back(port);
    }
    if (reads || writes) n.clocked(c, side.clock);
}

void block_ram(Netlist &n, const Cell &c, uint32_t bits) {
    auto ram = std::make_unique<BlockRam>();
    ram->bits = bits;
    ram->mem.resize(bits + bits / 8);
    for (size_t row = 0; row < ram->mem.size() / 256; row++) {
        const bool parity = row >= bits / 256;
        char name[16];
        std::snprintf(name, sizeof name, "INIT%s_%02zX", parity ? "P" : "",
                      parity ? row - bits / 256 : row);
        const std::string init = c.bits(name, 256, '0');
        for (size_t i = 0; i < 256; i++)
            ram->mem[256 * row + i] = n.initial(init[i]);
    }
    n.must(c, "DOA_REG", {"0"});
    n.must(c, "DOB_REG", {"0"});
    n.must(c, "RAM_EXTENSION_A", {"NONE"});
    n.must(c, "RAM_EXTENSION_B", {"NONE"});
    n.tied(c, {"RSTRAMARSTRAM", "RSTRAMB"});
    for (const Side &side : SIDES)
        block_side(n, c, *ram, side);
    n.block(std::move(ram));
}

} // namespace

bool lower_xc7(Netlist &n, const Cell &c) {
    const std::string &type = c.type;
    for (const auto &[name, value] : c.settings)
        if (name.size() > 9 && name.compare(name.size() - 9, 9, "_INVERTED") == 0)
            n.must(c, name, {"0"});
    if (type.size() == 4 && type.compare(0, 3, "LUT") == 0 && type[3] >= '1' && type[3] <= '6')
        n.table(c.number("INIT", 0), c.row("I", static_cast<size_t>(type[3] - '0')), c.pin("O"));
    else if (type == "INV")
        n.table(1, {c.pin("I")}, c.pin("O"));
    else if (type == "MUXF7" || type == "MUXF8")
        n.table(0xca, {c.pin("I0"), c.pin("I1"), c.pin("S")}, c.pin("O"));
    else if (type == "CARRY4")
        carry(n, c);
    else if (type == "FDRE" || type == "FDSE")
        flip_flop(n, c, type == "FDSE");
    else if (type == "SRL16E") {
        const std::string init = c.bits("INIT", 16, '0');
        uint32_t state = 0;
        for (size_t i = 0; i < 16; i++)
            state |= static_cast<uint32_t>(n.initial(init[i])) << i;
        n.clocked(c, "CLK");
        n.block(std::make_unique<Shift>(c, state));
    } else if (type == "RAM32M" || type == "RAM64M")
        lut_ram(n, c, type == "RAM32M" ? 5 : 6, type == "RAM32M" ? 2 : 1);
    else if (type == "RAMB18E1" || type == "RAMB36E1")
        block_ram(n, c, type == "RAMB18E1" ? 16384 : 32768);
    else if (type == "DSP48E1")
        lower_dsp48e1(n, c);
    else
        return false;
    return true;
}
