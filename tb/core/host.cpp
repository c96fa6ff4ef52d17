/* host.cpp - see host.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "host.h"

int32_t register_of(const sph_machine &machine, const Window &w, int number) {
    switch (number) {
    case SPH_REG_WIN_X0:
        return w.x0;
    case SPH_REG_WIN_Y0:
        return w.y0;
    case SPH_REG_WIN_X1:
        return w.x1;
    case SPH_REG_WIN_Y1:
        return w.y1;
    default:
        return machine.regs[number];
    }
}

void configure(Host &host, const sph_machine &machine, const Window &w) {
    host.pins.cfg_valid = true;
    for (int i = 0; i < SPH_N_REGS; i++) {
        host.pins.cfg_addr = i;
        host.pins.cfg_data = static_cast<uint32_t>(register_of(machine, w, i));
        host.clock();
    }
    host.pins.cfg_valid = false;
}

void interrupt(Host &host, int64_t clocks, int length, bool drain) {
    auto pixel = std::move(host.pixel);
    host.pixel = nullptr;
    host.pins.start = true;
    host.clock();
    host.pins.start = false;
    for (int64_t i = 0; i < clocks; i++)
        host.clock();
    host.pins.rst = true;
    if (!drain) host.memory().reset();
    for (int i = 0; i < length || host.memory().waiting(); i++)
        host.clock();
    host.pins.rst = false;
    host.pixel = std::move(pixel);
}
