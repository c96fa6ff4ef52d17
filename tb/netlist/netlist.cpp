/* netlist.cpp - see netlist.h: evaluation
 * SPDX-License-Identifier: Apache-2.0
 */
#include "netlist.h"

#include <algorithm>
#include <queue>

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
