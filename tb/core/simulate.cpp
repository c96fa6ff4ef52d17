/* simulate.cpp - see simulate.h: what both simulators share
 * SPDX-License-Identifier: Apache-2.0
 */
#include "simulate.h"

#include <cstdarg>
#include <cstdio>
#include <cstring>

void fail(Run &run, const char *format, ...) {
    size_t used = std::strlen(run.failure);
    va_list ap;
    va_start(ap, format);
    std::vsnprintf(run.failure + used, sizeof run.failure - used, format, ap);
    va_end(ap);
    used = std::strlen(run.failure);
    if (used + 1 < sizeof run.failure) std::memcpy(run.failure + used, "\n", 2);
}

bool equal(const sph_pixel &a, const Sample &s) {
    const sph_pixel &b = s.pixel;
    return s.times == 1 && a.id == b.id && a.key == b.key && (a.visits & 0xffffff) == b.visits &&
           a.texture == b.texture && a.colour[0] == b.colour[0] && a.colour[1] == b.colour[1] &&
           a.colour[2] == b.colour[2];
}

void deliver(const sph_machine &machine, Run &run, Sample *samples, int x, int y,
             const sph_pixel &pixel, uint64_t clock) {
    const Window &w = run.window;
    if (x < w.x0 || x >= w.x1 || y < w.y0 || y >= w.y1) {
        fail(run, "the core delivered pixel %d %d, outside of window %d,%d,%d,%d", x, y, w.x0, w.y0,
             w.x1, w.y1);
        return;
    }
    const size_t at = static_cast<size_t>(y) * static_cast<size_t>(machine.regs[SPH_REG_FRAME_W]) +
                      static_cast<size_t>(x);
    Sample &s = samples[at];
    s.pixel = pixel;
    s.times++;
    s.clock = static_cast<uint32_t>(clock);
    run.pixels++;
    if (run.model && !equal(run.model->pixels[at], s)) run.stopped = true;
}
