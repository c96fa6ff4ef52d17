/* read.cpp - see netlist.h: a netlist from what Yosys's write_json wrote
 * SPDX-License-Identifier: Apache-2.0
 */
#include <jansson.h>

#include <algorithm>

#include "netlist.h"

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
