/* golden_core.h - the golden model behind golden_core.svh, which stands in the place of rt_core
 * SPDX-License-Identifier: Apache-2.0
 *
 * It takes the registers, reads all lines over the bus, twice, and draws what came with the golden
 * model; or it is scripted. Whoever includes this is linked with libsphaera.a.
 */
#ifndef TB_GOLDEN_CORE_H
#define TB_GOLDEN_CORE_H

#include <cstdint>
#include <utility>
#include <vector>

extern "C" {
#include "render/render.h"
#include "machine/machine.h"
#include "validate/validate.h"
}

namespace {

struct Pixel {
    int x, y, colour[4]; /* Rendering, L1, L2, the chosen one */
};

struct GoldenCore {
    sph_machine machine{};
    std::vector<uint32_t> memory;
    sph_frame frame{};
    sph_counters counters{};
    std::vector<int> order; /* pixels as they leave */
    bool scripted = false;  /* draws nothing: these pixels, errors and counts instead */
    std::vector<Pixel> script;
    int errors = 0;
    uint64_t counts[32] = {};
} core;

} // namespace

extern "C" {
void golden_register(int number, int value) {
    core.machine.regs[number] = value;
}

/* How many lines are to be read; none if those of the last frame are kept. */
int golden_lines(int keep) {
    uint32_t lines = (uint32_t)core.machine.regs[SPH_REG_MEM_LINES];
    if (keep && lines == core.machine.lines) return 0;
    core.machine.lines = lines;
    core.memory.assign((lines + 1) * SPH_LINE_WORDS, 0);
    return (int)lines;
}

void golden_beat(int number, long long data) {
    core.memory[2 * (size_t)number] = (uint32_t)data;
    core.memory[2 * (size_t)number + 1] = (uint32_t)(data >> 32);
}

/* The bits of its errors; with bad lines, which the model might not survive, all is black. */
int golden_draw(int bad) {
    if (core.scripted) return core.errors;
    struct sph_error err = {{0}};
    sph_machine &m = core.machine;
    m.mem = core.memory.data();
    m.profile = sph_profile_unpack((uint32_t)m.regs[SPH_REG_PROFILE]);
    const struct sph_render_options options = {};
    sph_frame_free(&core.frame);
    core.frame = {};
    core.counters = {};
    core.order.clear();
    if (bad || sph_machine_validate(&m, &err)) return bad ? 0 : 1 << SPH_ERROR_BAD_NODE;
    int errors = sph_render(&m, &options, &core.frame, &core.counters, &err);
    int width = core.frame.width, height = core.frame.height;
    for (int band = 0; band < height; band += 8) /* down columns of eight, then not quite so */
        for (int x = 0; x < width; x++)
            for (int y = band; y < band + 8 && y < height; y++)
                core.order.push_back(y * width + x);
    for (size_t i = 0; i + 20 < core.order.size(); i += 3)
        std::swap(core.order[i], core.order[i + i * i % 20]);
    return errors;
}

/* The next pixel; 0 behind the last. */
int golden_pixel(int number, int *x, int *y, int *rendering, int *l1, int *l2, int *chosen) {
    if (core.scripted) {
        if ((size_t)number >= core.script.size()) return 0;
        const Pixel &p = core.script[(size_t)number];
        *x = p.x, *y = p.y;
        *rendering = p.colour[0], *l1 = p.colour[1], *l2 = p.colour[2], *chosen = p.colour[3];
        return 1;
    }
    if ((size_t)number >= core.order.size()) return 0;
    int at = core.order[(size_t)number];
    const struct sph_pixel &pixel = core.frame.pixels[at];
    int frame = core.machine.regs[SPH_REG_FRAME];
    *x = at % core.frame.width;
    *y = at / core.frame.width;
    *rendering = (int)pixel.colour[0];
    *l1 = (int)pixel.colour[1];
    *l2 = (int)pixel.colour[2];
    *chosen = (int)pixel.colour[frame < SPH_FRAMES ? frame : SPH_FRAMES - 1];
    return 1;
}

/* What an edge of clk saw, if somebody looks; nobody does at a netlist, or on a board. */
void golden_seen(int of_core, int rest, int errors, long long count) {
#ifdef TB_TOP_VIEW_H
    edge_seen = {true,
                 (of_core & 16) != 0,
                 (of_core & 8) != 0,
                 (of_core & 4) != 0,
                 (of_core & 2) != 0,
                 (of_core & 1) != 0,
                 (rest & 8) != 0,
                 (rest & 4) != 0,
                 (rest & 2) != 0,
                 (rest & 1) != 0,
                 (uint32_t)errors,
                 (uint64_t)count};
#else
    (void)of_core, (void)rest, (void)errors, (void)count;
#endif
}

long long golden_count(int number) {
    return (long long)(core.scripted ? core.counts[number] : core.counters.count[number]);
}
}

#endif
