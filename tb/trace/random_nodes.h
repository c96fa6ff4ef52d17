/* random_nodes.h - a memory of random nodes of four children, sound and broken, for tb_traverse
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef TB_TRACE_RANDOM_NODES_H
#define TB_TRACE_RANDOM_NODES_H

#include "engine/world.h"

extern "C" {
#include "machine/records.h"
}

namespace {

/* Takes the place of a scene's memory: all lines of it are nodes, and the same ones far away. */
class RandomNodes {
  public:
    RandomNodes(world::World &world, bench::Random &numbers)
        : m(world.m), random(numbers), different(world.m.lines) {
        world.repeat();
    }

    uint32_t lines() const { return (uint32_t)m.regs[SPH_REG_MEM_LINES]; }

    /* Where memory ends, and all of it; which lines answer with an error. */
    void fill(std::vector<bool> &spoilt) {
        m.regs[SPH_REG_MEM_LINES] =
            (int32_t)(random.percent(50) ? random.between(20, different)
                                         : random.between(different, world::Repeated::MOST));
        bool errors = random.percent(30);
        for (uint32_t line = 0; line < different; line++) {
            put_node(sph_line(&m, line));
            spoilt[line] = errors && random.percent(line ? 10 : 50);
        }
    }

    /* A line of memory, now and then behind its end. */
    uint32_t some_line() {
        uint32_t line = (uint32_t)random.below(std::min(lines(), different));
        uint32_t far = line + world::World::part(random);
        if (random.percent(97)) return far < lines() ? far : line;
        far = lines() + (random.percent(50) ? 0 : (uint32_t)random.log_bits(25));
        return std::min(far, world::Repeated::MOST);
    }

    /* The line behind the children of the node in a line. */
    uint32_t end(uint32_t line, uint32_t first_leaf) const {
        uint32_t leaf = sph_field(sph_line(&m, line), SPH_NODE_N_LEAF_LSB, SPH_NODE_N_LEAF_BITS);
        return first_leaf + (uint32_t)sph_record_lines(sph_whole(&m), leaf);
    }

  private:
    struct sph_machine &m;
    bench::Random &random;
    const uint32_t different; /* lines */

    static void put(uint32_t *line, int lsb, int bits, uint64_t x) {
        sph_field_set(line, lsb, bits, (uint32_t)x);
    }

    void put_node(uint32_t *line) {
        uint32_t inner = (uint32_t)random.below(5), leaf = (uint32_t)random.below(5 - inner);
        if (random.percent(3)) inner = (uint32_t)random.bits(3), leaf = (uint32_t)random.bits(3);
        uint64_t last = lines() - inner - sph_record_lines(sph_whole(&m), leaf);
        uint64_t base = random.below(last + 1);
        if (random.percent(10)) base = last;
        if (random.percent(3)) base = last + 1;
        if (random.percent(3)) base = (uint64_t)random.mixed(26);
        put(line, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS, base);
        put(line, SPH_NODE_N_INNER_LSB, SPH_NODE_N_INNER_BITS, inner);
        put(line, SPH_NODE_N_LEAF_LSB, SPH_NODE_N_LEAF_BITS, leaf);
        for (int i = 0; i < 4; i++) { /* a copy of the one before, or a ball of any size */
            int at = i * SPH_CHILD_STRIDE;
            if (i && random.percent(20))
                put_copy(line, at);
            else
                put_child(line, at);
        }
    }

    static void put_copy(uint32_t *line, int at) {
        for (int bit = 0; bit < SPH_CHILD_STRIDE; bit += 14)
            put(line, at + bit, 14, sph_field(line, at - SPH_CHILD_STRIDE + bit, 14));
    }

    void put_child(uint32_t *line, int at) {
        int64_t middle = random.percent(50) ? 0 : random.sbits(13);
        for (int j = 0; j < 3; j++)
            put(line, at + SPH_CHILD_CTR_X_LSB + j * SPH_CHILD_CTR_X_BITS, SPH_CHILD_CTR_X_BITS,
                (uint64_t)(middle + random.log_sbits(13)));
        put(line, at + SPH_CHILD_RAD_LSB, SPH_CHILD_RAD_BITS,
            (uint64_t)(random.percent(50) ? random.bits(13) : random.mixed(14)));
    }
};

} // namespace

#endif
