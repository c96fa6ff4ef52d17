/* tb_shell.cpp - rt_top around the golden model: tb_top in seconds, for faults put into the RTL
 * SPDX-License-Identifier: Apache-2.0
 *
 * usage: as tb_top
 *
 * golden_core.svh stands in the place of rt_core: it takes the registers, reads all lines over the
 * bus, twice, and draws what came with the golden model. So all around the core is as it is built,
 * and builds in seconds.
 */
#include "top/tb_top.cpp"

#include <algorithm>

namespace {

struct GoldenCore {
    sph_machine machine{};
    std::vector<uint32_t> memory;
    sph_frame frame{};
    sph_counters counters{};
    std::vector<int> order; /* pixels as they leave */
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

long long golden_count(int number) {
    return (long long)core.counters.count[number];
}
}
