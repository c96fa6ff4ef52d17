/* blocks.h - memories of more than one family
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef TB_NETLIST_BLOCKS_H
#define TB_NETLIST_BLOCKS_H

#include "netlist.h"

/* Up to 64 bits of nets. */
inline uint64_t word(const uint8_t *net, const Nets &nets) {
    uint64_t value = 0;
    for (size_t i = 0; i < nets.size(); i++)
        value |= static_cast<uint64_t>(net[nets[i]]) << i;
    return value;
}

inline void put(uint8_t *net, const Nets &nets, uint64_t value) {
    for (size_t i = 0; i < nets.size(); i++)
        if (nets[i] > 1) net[nets[i]] = value >> i & 1;
}

/* Memory of LUTs: written at an edge, read at once; ports have the words' bits to themselves. */
class LutRam : public Block {
  public:
    struct Port {
        Nets address, in, out;
        std::vector<uint64_t> words;
    };
    Nets write_address;
    Net write = 0;
    std::vector<Port> ports;

    Nets through() const override;
    Nets outputs() const override;
    void settle(uint8_t *net) override;
    void edge(const uint8_t *net) override;
};

/* Block RAM: `bits` bits of data, an eighth as many of parity behind them. A port sees 1, 2, 4, 8,
 * ... bits of data and, from 8 on, an eighth as many of parity; its address is that of its lowest
 * bit of data. A port reads or writes. */
class BlockRam : public Block {
  public:
    struct Port {
        Nets address, data; /* data: bits of data, then of parity */
        uint32_t width;     /* bits of data */
        Net enable, enable2;
        Nets bytes;     /* writes: an enable for each byte */
        bool keeps_old; /* what it writes, others still read as it was in the same clock */
        std::vector<uint8_t> latch; /* reads */
    };
    std::vector<uint8_t> mem;
    std::vector<Port> reads, writes;
    uint32_t bits = 0;

    Nets outputs() const override;
    void settle(uint8_t *net) override;
    void edge(const uint8_t *net) override;
    unsigned accesses(const uint8_t *net) const override;

  private:
    /* Place in mem of a port's bit. */
    size_t place(const Port &port, size_t at, size_t bit) const;
    std::vector<uint8_t> noise_; /* a write of this clock that others must not look at */
};

#endif
