/* netlist.cpp - see netlist.h: evaluation
 * SPDX-License-Identifier: Apache-2.0
 */
#include <algorithm>
#include <jansson.h>
#include <queue>

#include "netlist.h"

Net Netlist::fresh() {
    net_.push_back(0);
    return static_cast<Net>(net_.size() - 1);
}

bool Netlist::initial(char bit) {
    noise_ ^= noise_ << 13;
    noise_ ^= noise_ >> 7;
    noise_ ^= noise_ << 17;
    return bit == '0' || bit == '1' ? bit == '1' : noise_ >> 40 & 1;
}

void Netlist::table(uint64_t truth, const Nets &in, Net out) {
    if (out < 2) return; /* nothing is connected */
    Table t = {truth, {}, out, static_cast<uint32_t>(in.size())};
    std::copy(in.begin(), in.end(), t.in.begin());
    tables_.push_back(t);
}

void Netlist::flop(const Flop &flop, char bit) {
    if (flop.q < 2) return;
    flops_.push_back(flop);
    net_[flop.q] = initial(bit);
}

/* Each table and block behind those that drive its inputs. */
void Netlist::order() {
    const size_t parts = tables_.size() + blocks_.size();
    std::vector<std::vector<uint32_t>> readers(net_.size());
    std::vector<uint32_t> waits(parts);
    std::vector<uint8_t> drivers(net_.size()), driven(net_.size());
    auto drive = [&](Net net) { drivers[net] = static_cast<uint8_t>(drivers[net] + 1); };
    for (const Table &t : tables_)
        drive(t.out), driven[t.out] = 1;
    for (const auto &b : blocks_)
        for (Net net : b->outputs())
            if (net > 1) drive(net), driven[net] = 1;
    for (const Flop &f : flops_)
        drive(f.q);
    for (const auto &[name, nets] : ports_)
        if (name.size() < 2 || name.compare(name.size() - 2, 2, "_o") != 0)
            for (Net net : nets)
                drive(net);
    auto read = [&](uint32_t part, Net net) {
        if (net > 1 && !drivers[net]) error_ = "a part reads a net that nothing drives";
        if (!driven[net]) return;
        readers[net].push_back(part);
        waits[part]++;
    };
    for (uint32_t i = 0; i < tables_.size(); i++)
        for (uint32_t k = 0; k < tables_[i].inputs; k++)
            read(i, tables_[i].in[k]);
    for (uint32_t i = 0; i < blocks_.size(); i++)
        for (Net net : blocks_[i]->through())
            read(static_cast<uint32_t>(tables_.size()) + i, net);
    for (const Flop &f : flops_)
        for (Net net : {f.d, f.enable, f.reset})
            if (net > 1 && !drivers[net]) error_ = "a flip-flop reads a net that nothing drives";
    if (*std::max_element(drivers.begin(), drivers.end()) > 1)
        error_ = "a net is driven more than once";

    std::queue<uint32_t> ready;
    for (uint32_t i = 0; i < parts; i++)
        if (!waits[i]) ready.push(i);
    while (!ready.empty()) {
        const uint32_t part = ready.front();
        ready.pop();
        auto done = [&](Net net) {
            for (uint32_t reader : readers[net])
                if (--waits[reader] == 0) ready.push(reader);
        };
        if (part < tables_.size()) {
            order_.push_back(static_cast<int32_t>(part));
            done(tables_[part].out);
        } else {
            const uint32_t at = part - static_cast<uint32_t>(tables_.size());
            order_.push_back(-1 - static_cast<int32_t>(at));
            for (Net net : blocks_[at]->outputs())
                done(net);
        }
    }
    if (order_.size() != parts && error_.empty()) error_ = "there is a loop without a register";
    next_.resize(flops_.size());
}

void Netlist::settle() {
    uint8_t *net = net_.data();
    for (int32_t part : order_) {
        if (part < 0) {
            blocks_[static_cast<size_t>(-1 - part)]->settle(net);
            continue;
        }
        const Table &t = tables_[static_cast<size_t>(part)];
        unsigned at = 0;
        for (uint32_t i = 0; i < t.inputs; i++)
            at |= static_cast<unsigned>(net[t.in[i]]) << i;
        net[t.out] = t.truth >> at & 1;
    }
}

void Netlist::edge() {
    uint8_t *net = net_.data();
    for (size_t i = 0; i < flops_.size(); i++) {
        const Flop &f = flops_[i];
        next_[i] = net[f.reset]                     ? f.reset_value
                   : (net[f.enable] ^ f.enable_low) ? net[f.d]
                                                    : net[f.q];
    }
    for (const auto &b : blocks_)
        b->edge(net);
    for (size_t i = 0; i < flops_.size(); i++)
        net[flops_[i].q] = next_[i];
}

size_t Netlist::bits(const std::string &port) const {
    const auto found = ports_.find(port);
    return found == ports_.end() ? 0 : found->second.size();
}

void Netlist::tally(std::vector<Switching> *sums) {
    const uint8_t *net = net_.data();
    std::vector<Switching> unseen;
    if (!sums) sums = &unseen;
    sums->resize(instances_.size());
    before_.resize(net_.size());
    for (size_t i = 0; i < net_.size(); i++)
        if (net[i] != before_[i] && owner_[i]) (*sums)[owner_[i] - 1].toggles++;
    for (const Flop &f : flops_)
        if (net[f.reset] || net[f.enable] ^ f.enable_low) (*sums)[owner_[f.q] - 1].clocked++;
    for (size_t i = 0; i < blocks_.size(); i++) {
        (*sums)[block_owner_[i] - 1].toggles += blocks_[i]->inside(net);
        (*sums)[block_owner_[i] - 1].accesses += blocks_[i]->accesses(net);
    }
    before_ = net_;
}

void Netlist::set(const std::string &port, uint64_t value, size_t lsb) {
    const Nets &nets = ports_[port];
    for (size_t i = lsb; i < nets.size() && i < lsb + 64; i++) {
        net_[nets[i]] = value & 1;
        value >>= 1;
    }
}

uint64_t Netlist::get(const std::string &port, size_t lsb) const {
    const auto found = ports_.find(port);
    uint64_t value = 0;
    if (found == ports_.end()) return 0;
    for (size_t i = lsb; i < found->second.size() && i < lsb + 64; i++)
        value |= static_cast<uint64_t>(net_[found->second[i]]) << (i - lsb);
    return value;
}

std::string Netlist::cells() const {
    std::string text;
    for (const auto &[type, number] : count_)
        text += (text.empty() ? "" : ", ") + type + " " + std::to_string(number);
    return text.empty() ? "none" : text;
}

/* ---- read ---- */

namespace {

const char *const TOP = "rt_core";

/* '0', '1' or a number; x and z are 0. */
Nets nets_of(const json_t *list) {
    Nets nets;
    size_t i;
    json_t *bit;
    json_array_foreach(list, i, bit) {
        const char *constant = json_string_value(bit);
        nets.push_back(constant ? constant[0] == '1' : static_cast<Net>(json_integer_value(bit)));
    }
    return nets;
}

Cell cell_of(const char *name, json_t *from) {
    Cell cell;
    cell.name = name;
    cell.type = json_string_value(json_object_get(from, "type"));
    const char *key;
    json_t *value;
    json_object_foreach(json_object_get(from, "connections"), key, value) cell.pins[key] =
        nets_of(value);
    json_object_foreach(json_object_get(from, "parameters"), key, value) {
        std::string text = json_string_value(value) ? json_string_value(value) : "";
        /* Yosys ends a text of 0 and 1 with a blank. */
        if (!text.empty() && text.back() == ' ') text.pop_back();
        cell.settings[key] = text;
    }
    return cell;
}

} // namespace

Net Cell::pin(const std::string &port, size_t bit, Net otherwise) const {
    const auto found = pins.find(port);
    return found == pins.end() || bit >= found->second.size() ? otherwise : found->second[bit];
}

Nets Cell::pins_of(const std::string &port, size_t width) const {
    Nets nets;
    for (size_t i = 0; i < width; i++)
        nets.push_back(pin(port, i));
    return nets;
}

Nets Cell::row(const std::string &port, size_t width) const {
    Nets nets;
    for (size_t i = 0; i < width; i++)
        nets.push_back(pin(port + std::to_string(i)));
    return nets;
}

std::string Cell::text(const std::string &setting, const std::string &otherwise) const {
    const auto found = settings.find(setting);
    return found == settings.end() ? otherwise : found->second;
}

uint64_t Cell::number(const std::string &setting, uint64_t otherwise) const {
    const auto found = settings.find(setting);
    if (found == settings.end()) return otherwise;
    uint64_t value = 0;
    for (char bit : found->second)
        value = value << 1 | (bit == '1');
    return value;
}

std::string Cell::bits(const std::string &setting, size_t width, char fill) const {
    std::string text = this->text(setting, "");
    std::reverse(text.begin(), text.end());
    text.resize(width, fill);
    return text;
}

void Netlist::refuse(const Cell &cell, const std::string &why) {
    if (error_.empty()) error_ = cell.type + " " + cell.name + ": " + why;
}

void Netlist::must(const Cell &cell, const std::string &setting,
                   const std::vector<std::string> &words) {
    const std::string text = cell.text(setting, words[0]);
    const bool number = !text.empty() && text.find_first_not_of("01") == std::string::npos;
    const std::string short_text = number ? std::to_string(cell.number(setting, 0)) : text;
    if (std::find(words.begin(), words.end(), short_text) == words.end())
        refuse(cell, setting + " is " + short_text + ", which has no model");
}

void Netlist::tied(const Cell &cell, const std::vector<std::string> &ports) {
    for (const std::string &port : ports)
        for (size_t i = 0; i < cell.pins_of(port, 64).size(); i++)
            if (cell.pin(port, i)) refuse(cell, port + " is in use, which has no model");
}

void Netlist::clocked(const Cell &cell, const std::string &port) {
    if (cell.pin(port) != clock_) refuse(cell, port + " is not clk");
}

/* "g_engine[0].u_engine.u_slots" of a cell's name: up to its last instance, which is called u_...
 * The name's end is a net's. */
uint32_t Netlist::instance_of(const std::string &cell) {
    size_t end = 0;
    for (size_t at = 0, dot; (dot = cell.find('.', at)) != std::string::npos; at = dot + 1)
        if (!cell.compare(at, 2, "u_")) end = dot;
    const auto [found, is_new] = instance_numbers_.emplace(
        cell.substr(0, end), static_cast<uint32_t>(instances_.size() + 1));
    if (is_new) instances_.push_back(found->first);
    return found->second;
}

void Netlist::lower(const Cell &cell) {
    const size_t tables = tables_.size(), flops = flops_.size(), blocks = blocks_.size();
    count_[cell.type]++;
    if (!lower_ecp5(*this, cell) && !lower_xc7(*this, cell)) refuse(cell, "has no model");
    owner_.resize(net_.size());
    const uint32_t instance = instance_of(cell.name);
    for (size_t i = tables; i < tables_.size(); i++)
        owner_[tables_[i].out] = instance;
    for (size_t i = flops; i < flops_.size(); i++)
        owner_[flops_[i].q] = instance;
    block_owner_.resize(blocks_.size(), instance);
    for (size_t i = blocks; i < blocks_.size(); i++)
        for (Net net : blocks_[i]->outputs())
            if (net > 1) owner_[net] = instance;
}

void Netlist::read(const std::string &file) {
    json_error_t problem;
    json_t *root = json_load_file(file.c_str(), 0, &problem);
    json_t *top = json_object_get(json_object_get(root, "modules"), TOP);
    if (!top) error_ = file + ": " + (root ? "no module rt_core" : problem.text);
    const char *name;
    json_t *value;
    auto use = [this](const Nets &nets) {
        for (Net net : nets) {
            if (net >= uses_.size()) uses_.resize(net + 1);
            uses_[net]++;
        }
    };
    json_object_foreach(json_object_get(top, "ports"), name, value) {
        ports_[name] = nets_of(json_object_get(value, "bits"));
        use(ports_[name]);
    }
    clock_ = ports_["clk"].empty() ? 0 : ports_["clk"][0];
    std::vector<Cell> cells;
    json_object_foreach(json_object_get(top, "cells"), name, value) {
        cells.push_back(cell_of(name, value));
        for (const auto &pin : cells.back().pins)
            use(pin.second);
    }
    json_decref(root);
    net_.resize(std::max<size_t>(uses_.size(), 2));
    for (const Cell &cell : cells)
        lower(cell);
}

Netlist::Netlist(const std::string &file, std::string &error) {
    read(file);
    if (error_.empty()) order();
    error = error_;
}
