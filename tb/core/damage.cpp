/* damage.cpp - see damage.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "damage.h"

#include <algorithm>

namespace {

const int FEW_VISITS = 60; /* of a ray in a tree of random words, which may have circles */

uint32_t *line_of(sph_machine &m, uint32_t line) {
    return m.mem + static_cast<size_t>(line) * SPH_LINE_WORDS;
}

/* A number of any size up to `most`, or one of its ends. */
int32_t any(Random &random, int64_t least, int64_t most) {
    switch (random.below(6)) {
    case 0:
        return static_cast<int32_t>(least);
    case 1:
        return static_cast<int32_t>(most);
    default: {
        auto range = static_cast<uint64_t>(most - least + 1);
        return static_cast<int32_t>(least + static_cast<int64_t>(random.next() % range));
    }
    }
}

void add(uint32_t *line, int lsb, int bits, uint32_t by) {
    sph_field_set(line, lsb, bits, sph_field(line, lsb, bits) + by);
}

/* Lines that are named in nodes below one, whose own line stands where it is to be. */
void move_nodes(sph_machine &m, uint32_t node, uint32_t by) {
    uint32_t *line = line_of(m, node);
    add(line, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS, by);
    const uint32_t base = sph_field(line, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS);
    for (uint32_t i = 0; i < sph_field(line, SPH_NODE_N_INNER_LSB, SPH_NODE_N_INNER_BITS); i++)
        move_nodes(m, base + i, by);
}

/* ... in records and the mappings that they name, each once. */
void move_textures(sph_machine &m, uint32_t by) {
    std::vector<uint32_t> done;
    for (int id = 0; id < m.regs[SPH_REG_N_PRIMS]; id++) {
        uint32_t *line = line_of(m, static_cast<uint32_t>(m.regs[SPH_REG_PRIM_BASE] + id));
        if (!sph_field(line, SPH_PRIM_TEX_LSB, SPH_PRIM_TEX_BITS)) continue;
        add(line, SPH_PRIM_TEX_LSB, SPH_PRIM_TEX_BITS, by);
        const uint32_t map = sph_field(line, SPH_PRIM_TEX_LSB, SPH_PRIM_TEX_BITS);
        if (std::find(done.begin(), done.end(), map) != done.end()) continue;
        done.push_back(map);
        add(line_of(m, map), SPH_MAP_IMAGE_LSB, SPH_MAP_IMAGE_BITS, by);
    }
}

bool legal(const sph_machine &m) {
    sph_error err = {{0}};
    return !sph_machine_validate(&m, &err);
}

} // namespace

Copy::Copy(const sph_machine &m, uint32_t more)
    : machine(m), words_(m.mem, m.mem + static_cast<size_t>(m.lines) * SPH_LINE_WORDS) {
    words_.resize(words_.size() + static_cast<size_t>(more) * SPH_LINE_WORDS);
    machine.mem = words_.data();
    machine.lines += more;
    machine.regs[SPH_REG_MEM_LINES] += static_cast<int32_t>(more);
}

Moved::Moved(const sph_machine &m, uint32_t by) : machine(m) {
    const size_t line = SPH_LINE_WORDS;
    machine.lines += by;
    machine.mem = static_cast<uint32_t *>(calloc(machine.lines * line, sizeof *m.mem));
    if (!machine.mem) return;
    std::copy(m.mem, m.mem + m.lines * line, machine.mem + by * line);
    for (int number : {SPH_REG_ROOT, SPH_REG_PRIM_BASE, SPH_REG_MEM_LINES, SPH_REG_BG_BASE,
                       SPH_REG_FACET_BASE, SPH_REG_SMOOTH_BASE, SPH_REG_LEAF_BASE})
        machine.regs[number] += static_cast<int32_t>(by);
    if (!sph_tree_bih(m.regs[SPH_REG_TREE]))
        move_nodes(machine, static_cast<uint32_t>(machine.regs[SPH_REG_ROOT]), by);
    if (sph_machine_effect(&m, SPH_EFFECT_TEXTURE)) move_textures(machine, by);
}

Event kind_of(const sph_machine &m, uint32_t line) {
    const auto records = static_cast<uint32_t>(m.regs[SPH_REG_PRIM_BASE]);
    const auto all = static_cast<uint32_t>(m.regs[SPH_REG_N_PRIMS]);
    return line < records ? TREE_WORDS : line < records + all ? RECORD_WORDS : OTHER_WORDS;
}

std::vector<Event> spoil_words(sph_machine &m, Random &random) {
    std::vector<Event> held;
    for (uint32_t n = 1 + random.below(4); n; n--) {
        const uint32_t number = random.below(m.lines);
        uint32_t *line = line_of(m, number);
        const int how = static_cast<int>(random.below(7));
        const int lsb = static_cast<int>(random.below(256));
        for (uint32_t i = 0; i < SPH_LINE_WORDS; i++) {
            const bool here = static_cast<uint32_t>(lsb) / 32 == i;
            const auto word = static_cast<uint32_t>(random.next());
            if (how == 0) line[i] = word;
            if (how == 1) line[i] = 0;
            if (how == 2) line[i] = ~0u;
            if (how == 3 && here) line[i] = word;
            if (how == 4 && here) line[i] ^= 1u << lsb % 32;
            if (how == 5)
                line[i] ^= word & static_cast<uint32_t>(random.next()) &
                           static_cast<uint32_t>(random.next());
        }
        if (how == 6) {
            const uint32_t *from = line_of(m, random.below(m.lines));
            for (uint32_t i = 0; i < SPH_LINE_WORDS; i++)
                line[i] = from[i];
        }
        held.push_back(kind_of(m, number));
    }
    m.regs[SPH_REG_VISIT_LIMIT] = any(random, 0, FEW_VISITS);
    return held;
}

void turn_registers(sph_machine &m, Random &random, bool rect) {
    const sph_profile &p = m.profile;
    const int64_t w = 1ll << (p.w - 1), wd = (1ll << (p.wd - 1)) - 1;
    const int32_t width = m.regs[SPH_REG_FRAME_W], height = m.regs[SPH_REG_FRAME_H];
    auto set = [&](int number, int64_t least, int64_t most) {
        const int32_t before = m.regs[number];
        m.regs[number] = any(random, least, most);
        if (!legal(m)) m.regs[number] = before;
    };
    for (int n = 1 + static_cast<int>(random.below(8)); n; n--) {
        const int light = SPH_LIGHT_STRIDE * static_cast<int>(random.below(SPH_MAX_LIGHTS));
        switch (random.below(13)) {
        case 0:
            set(SPH_REG_EYE_X + static_cast<int>(random.below(3)), -w, w - 1);
            break;
        case 1:
            set(SPH_REG_DIR_X0 + static_cast<int>(random.below(3)), -wd, wd);
            break;
        case 2:
            set(SPH_REG_PITCH, 1, wd / (width + height));
            break;
        case 3:
            set(SPH_REG_AMBIENT_R + static_cast<int>(random.below(3)), 0, 65535);
            break;
        case 4:
            set(SPH_REG_BG_COLOUR, 0, 0xffffff);
            break;
        case 5:
            set(SPH_REG_LIGHT0_X + light + static_cast<int>(random.below(3)), -w, w - 1);
            break;
        case 6:
            set(SPH_REG_LIGHT0_R + light + static_cast<int>(random.below(3)), 0, 65535);
            break;
        case 7:
            set(SPH_REG_RECT_X0, 0, width);
            set(SPH_REG_RECT_X1, 0, width);
            set(SPH_REG_RECT_Y0, 0, height);
            set(SPH_REG_RECT_Y1, 0, height);
            set(SPH_REG_BG_MODE, 0, rect);
            break;
        case 8:
            set(SPH_REG_WIN_X0, 0, width);
            set(SPH_REG_WIN_X1, 0, width);
            set(SPH_REG_WIN_Y0, 0, height);
            set(SPH_REG_WIN_Y1, 0, height);
            break;
        case 9:
            set(SPH_REG_MAX_DEPTH, 0, m.regs[SPH_REG_MAX_DEPTH]);
            break;
        case 10:
            set(SPH_REG_N_LIGHTS, 0, m.regs[SPH_REG_N_LIGHTS]);
            break;
        case 11:
            set(SPH_REG_FRAME, 0, 3);
            break;
        default:
            m.regs[SPH_REG_EFFECTS] &= static_cast<int32_t>(random.next());
            break;
        }
    }
}

void spoil_registers(sph_machine &m, Random &random) {
    for (int n = 1 + static_cast<int>(random.below(20)); n; n--) {
        const int number = static_cast<int>(random.below(SPH_N_REGS));
        switch (number) {
        case SPH_REG_EFFECTS: /* what a core refuses is another trial; a window has its pixels */
        case SPH_REG_MAX_DEPTH:
        case SPH_REG_N_LIGHTS:
        case SPH_REG_TREE:
        case SPH_REG_COARSE:
        case SPH_REG_PROFILE:
        case SPH_REG_BG_MODE:
        case SPH_REG_BG_COUNT:
        case SPH_REG_FRAME_W:
        case SPH_REG_FRAME_H:
        case SPH_REG_WIN_X0:
        case SPH_REG_WIN_X1:
        case SPH_REG_WIN_Y0:
        case SPH_REG_WIN_Y1:
            break;
        case SPH_REG_MEM_LINES:
            m.regs[number] = any(random, 1, m.lines);
            break;
        default:
            m.regs[number] = static_cast<int32_t>(random.next());
        }
    }
    m.regs[SPH_REG_VISIT_LIMIT] = any(random, 0, FEW_VISITS);
    m.regs[SPH_REG_EFFECTS] &= ~(1 << SPH_EFFECT_CAMERA); /* it would be refused */
}

void pile_up(sph_machine &m, uint32_t free, int depth) {
    const uint32_t most = (1u << SPH_CHILD_RAD_BITS) - 1;
    auto number = static_cast<uint32_t>(m.regs[SPH_REG_ROOT]);
    m.regs[SPH_REG_VISIT_LIMIT] = 4 * depth;
    for (int i = 0; i <= depth; i++, number = free, free += 2) {
        uint32_t *line = line_of(m, number);
        for (uint32_t word = 0; word < SPH_LINE_WORDS; word++)
            line[word] = 0;
        if (i == depth) break;
        sph_field_set(line, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS, free);
        sph_field_set(line, SPH_NODE_N_INNER_LSB, SPH_NODE_N_INNER_BITS, 2);
        for (int child = 0; child < 2; child++)
            sph_field_set(line, child * SPH_CHILD_STRIDE + SPH_CHILD_RAD_LSB, SPH_CHILD_RAD_BITS,
                          most);
    }
}
