/* netlist.h - the cells that Yosys mapped a core to, simulated bit by bit
 * SPDX-License-Identifier: Apache-2.0
 *
 * Reads what write_json wrote of a flat netlist and lowers each cell to a few parts: tables of up
 * to 6 inputs, flip-flops, and blocks (memories, multipliers). All has one clock, the port clk.
 * settle() evaluates what depends on inputs and registers once, in an order that is found when the
 * netlist is read; a loop is refused, as is a cell or a setting of a cell that has no model.
 *
 * The models follow the vendors' descriptions of their cells, not Yosys's: cells_ecp5.cpp (Lattice
 * FPGA-TN-02204, FPGA-TN-02205), cells_xc7.cpp (Xilinx UG473, UG474, UG479).
 */
#ifndef TB_NETLIST_H
#define TB_NETLIST_H

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

using Net = uint32_t;          /* 0: constant 0, 1: constant 1 */
using Nets = std::vector<Net>; /* lowest bit first */

/* A part that is more than a table or a flip-flop. */
class Block {
  public:
    virtual ~Block() = default;
    /* Inputs on which outputs depend at once. */
    virtual Nets through() const { return {}; }
    virtual Nets outputs() const = 0;
    /* Outputs from inputs and state. */
    virtual void settle(uint8_t *net) = 0;
    /* Rising edge: the state from settled inputs. */
    virtual void edge(const uint8_t *net) = 0;
    /* Nets inside that changed since the last call, of a part that is counted for what is in it. */
    virtual uint64_t inside(const uint8_t *) { return 0; }
    /* Ports that look at memory in this clock. */
    virtual unsigned accesses(const uint8_t *) const { return 0; }
};

/* A cell as it stands in the file. */
struct Cell {
    std::string name, type;
    std::map<std::string, Nets> pins;
    std::map<std::string, std::string> settings;

    /* A bit of a pin; 0 if nothing is connected. */
    Net pin(const std::string &port, size_t bit = 0, Net otherwise = 0) const;
    /* The lowest `width` bits; what is not connected is 0. */
    Nets pins_of(const std::string &port, size_t width) const;
    /* Pins NAME0, NAME1, ... of one bit each. */
    Nets row(const std::string &port, size_t width) const;
    std::string text(const std::string &setting, const std::string &otherwise) const;
    uint64_t number(const std::string &setting, uint64_t otherwise) const;
    /* A setting of `width` bits, lowest first: '0', '1' or 'x', which it is filled up with. */
    std::string bits(const std::string &setting, size_t width, char fill) const;
};

class Netlist {
  public:
    /* error says why the file cannot be simulated; empty: it can. */
    Netlist(const std::string &file, std::string &error);
    size_t bits(const std::string &port) const;
    void set(const std::string &port, uint64_t value, size_t lsb = 0); /* up to 64 from lsb */
    uint64_t get(const std::string &port, size_t lsb = 0) const;       /* up to 64 bits from lsb */
    void settle();
    void edge();
    /* "LUT4 6349, ...", "none" */
    std::string cells() const;
    /* What switches in an instance, summed up over clocks. */
    struct Switching {
        uint64_t toggles;  /* nets that changed, those inside of multipliers too */
        uint64_t clocked;  /* flip-flops whose enable was high */
        uint64_t accesses; /* ports of block RAM that were enabled */
    };
    /* What changed between two settled clocks, added by instance; sums may be nullptr: of the first
     * clock, with which the second one is compared. */
    void tally(std::vector<Switching> *sums);
    const std::vector<std::string> &instances() const { return instances_; }

    /* ---- for the models of cells ---- */
    /* truth: bit i is the output for inputs i, the first input lowest. */
    void table(uint64_t truth, const Nets &in, Net out);
    struct Flop {
        Net d, q, enable, reset;
        uint8_t enable_low, reset_value;
    };
    void flop(const Flop &flop, char initial);
    void block(std::unique_ptr<Block> block) { blocks_.push_back(std::move(block)); }
    Net fresh(); /* a net of its own */
    /* Refuses the netlist. */
    void refuse(const Cell &cell, const std::string &why);
    /* Refuses it unless the setting, or what it is without one, is among the words. */
    void must(const Cell &cell, const std::string &setting, const std::vector<std::string> &words);
    /* ... unless a pin is tied to 0, open, or is the clock. */
    void tied(const Cell &cell, const std::vector<std::string> &ports);
    void clocked(const Cell &cell, const std::string &port);
    /* Whether anything but its driver sees a net. */
    bool is_read(Net net) const { return uses_[net] > 1; }
    /* '0', '1', or noise for 'x'. */
    bool initial(char bit);

  private:
    struct Table {
        uint64_t truth;
        std::array<Net, 6> in;
        Net out;
        uint32_t inputs;
    };
    void read(const std::string &file);
    void lower(const Cell &cell);
    uint32_t instance_of(const std::string &cell);
    void order();

    std::string error_;
    Net clock_ = 0;
    std::map<std::string, Nets> ports_;
    std::map<std::string, int> count_;
    std::vector<uint8_t> net_ = {0, 1}, next_;
    std::vector<uint32_t> uses_; /* pins at a net */
    std::vector<Table> tables_;
    std::vector<Flop> flops_;
    std::vector<std::unique_ptr<Block>> blocks_;
    std::vector<int32_t> order_; /* a table, or -1 - a block */
    std::vector<std::string> instances_;
    std::map<std::string, uint32_t> instance_numbers_;
    std::vector<uint32_t> owner_;       /* of a net: the instance that drives it, from 1; 0: none */
    std::vector<uint32_t> block_owner_; /* of a block, from 1 */
    std::vector<uint8_t> before_;       /* nets when they were tallied last */
    uint64_t noise_ = 88172645463325252U;
};

/* Lower a cell of the family; false: there is none of this type. */
bool lower_ecp5(Netlist &netlist, const Cell &cell);
bool lower_xc7(Netlist &netlist, const Cell &cell);
void lower_dsp48e1(Netlist &netlist, const Cell &cell);

#endif
