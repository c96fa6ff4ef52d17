/* blocks.cpp - see blocks.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "blocks.h"

// ---- memory of LUTs ----

Nets LutRam::through() const {
    Nets all;
    for (const Port &port : ports)
        all.insert(all.end(), port.address.begin(), port.address.end());
    return all;
}

Nets LutRam::outputs() const {
    Nets all;
    for (const Port &port : ports)
        all.insert(all.end(), port.out.begin(), port.out.end());
    return all;
}

void LutRam::settle(uint8_t *net) {
    for (const Port &port : ports)
        put(net, port.out, port.words[word(net, port.address)]);
}

void LutRam::edge(const uint8_t *net) {
    if (!net[write]) return;
    const uint64_t at = word(net, write_address);
    for (Port &port : ports)
        port.words[at] = word(net, port.in);
}

// ---- block RAM ----

Nets BlockRam::outputs() const {
    Nets all;
    for (const Port &port : reads)
        all.insert(all.end(), port.data.begin(), port.data.end());
    return all;
}

size_t BlockRam::place(const Port &port, size_t at, size_t bit) const {
    at &= ~static_cast<size_t>(port.width - 1);
    return bit < port.width ? at + bit : bits + at / 8 + (bit - port.width);
}

void BlockRam::settle(uint8_t *net) {
    for (const Port &port : reads)
        for (size_t i = 0; i < port.data.size(); i++)
            if (port.data[i] > 1) net[port.data[i]] = port.latch[i];
}

unsigned BlockRam::accesses(const uint8_t *net) const {
    unsigned sum = 0;
    for (const std::vector<Port> *ports : {&reads, &writes})
        for (const Port &port : *ports)
            sum += net[port.enable] && net[port.enable2];
    return sum;
}

void BlockRam::edge(const uint8_t *net) {
    noise_.resize(mem.size());
    struct Write {
        size_t place;
        uint8_t bit;
    };
    std::vector<Write> written;
    for (const Port &port : writes) {
        if (!net[port.enable] || !net[port.enable2]) continue;
        const size_t at = word(net, port.address);
        for (size_t i = 0; i < port.data.size(); i++) {
            const size_t byte = port.width < 8 ? 0 : i < port.width ? i / 8 : i - port.width;
            if (!net[port.bytes[byte]]) continue;
            written.push_back({place(port, at, i), net[port.data[i]]});
            noise_[written.back().place] = !port.keeps_old;
        }
    }
    for (Port &port : reads) {
        if (!net[port.enable] || !net[port.enable2]) continue;
        const size_t at = word(net, port.address);
        for (size_t i = 0; i < port.data.size(); i++) {
            const size_t from = place(port, at, i);
            port.latch[i] = mem[from] ^ noise_[from];
        }
    }
    for (const Write &w : written) {
        mem[w.place] = w.bit;
        noise_[w.place] = 0;
    }
}
