/* tb_registers.cpp - rt_registers against the words that were written
 * SPDX-License-Identifier: Apache-2.0
 *
 * All registers are written once, then any word goes to any address, some of no register; after
 * each clock every output is compared. A vector is a clock.
 */
#include <algorithm>

#include "Vrt_registers.h"
#include "bench.h"
#include "bundles.h"
extern "C" {
#include "machine/camera.h"
}

#ifndef TEXTURE
#define TEXTURE 0
#endif
#ifndef SMOOTH
#define SMOOTH 0
#endif
#ifndef ACCEL
#define ACCEL 0
#endif
#ifndef TURNED
#define TURNED 0
#endif
#ifndef CAMERA
#define CAMERA 0
#endif

namespace {

constexpr int ADDRESSES = 128, FRACTION = 32 - WD;

class Registers : public bench::Bench<Vrt_registers> {
  public:
    Registers(int argc, char **argv) : Bench("tb_registers", argc, argv, 60000) {}

    void write(int address, bool valid) {
        uint32_t word = (uint32_t)random.bits(32);
        if (address == SPH_REG_TREE && random.percent(80)) word = (uint32_t)random.below(8);
        if (address == SPH_REG_ONE_CAMERA && random.percent(80)) word = sum;
        dut.valid_i = valid;
        dut.addr_i = (uint8_t)address;
        dut.data_i = word;
        settle();
        int offset = address - SPH_REG_LIGHT0_X;
        bool light = valid && offset >= 0 && offset < 64;
        expect("light_valid_o", dut.light_valid_o, light);
        if (light) expect("light_number_o", dut.light_number_o, offset / SPH_LIGHT_STRIDE, 3);
        if (light) expect("light_part_o", dut.light_part_o, offset % SPH_LIGHT_STRIDE, 3);
        tick();
        if (valid) written[address] = word;
    }

    void compare() {
        part("effects_o", dut.effects_o, SPH_REG_EFFECTS, 32);
#define FIELD(name, first, count, built)                                                           \
    field(#name " of regs_o", RT_REGS_##name, SPH_REG_##first, count, built);
        RT_REGS_EACH(FIELD)
        part("window_o", dut.window_o, SPH_REG_WIN_X0, 14, 4);
        part("bg_mode_o", dut.bg_mode_o, SPH_REG_BG_MODE, 2);
        part("rect_o", dut.rect_o, SPH_REG_RECT_X0, 14, 4);
        part("bg_base_o", dut.bg_base_o, SPH_REG_BG_BASE, SPH_LINE_BITS);
        part("bg_count_o", dut.bg_count_o, SPH_REG_BG_COUNT, 5);
        part("dir_o", dut.dir_o, SPH_REG_DIR_X0, WD, 3);
        part("pitch_o", dut.pitch_o, SPH_REG_PITCH, WD);
        part("profile_o", dut.profile_o, SPH_REG_PROFILE, 32);
        part("frame_o", dut.frame_o, SPH_REG_FRAME, 2);
        part("coarse_o", dut.coarse_o, SPH_REG_COARSE, 4, 1, TEXTURE);
        uint32_t tree = written[SPH_REG_TREE] & 7;
        expect("bih_o", dut.bih_o, tree == SPH_TREE_BIH || tree == SPH_TREE_BRUTE);
        expect("boxes_o", dut.boxes_o, tree == SPH_TREE_BOX4);
        camera();
        axes();
        if (bad()) show("addr_i", dut.addr_i, 7), show("data_i", dut.data_i, 32);
        done();
    }

  private:
    uint32_t written[ADDRESSES] = {}, sum = 0;

    /* Whether the camera is another one; often its sum is the register. */
    void camera() {
        sph_machine m{};
        std::copy(written, written + SPH_N_REGS, m.regs);
        m.profile.w = W, m.profile.wd = WD;
        if (!TURNED) {
            m.regs[SPH_REG_EFFECTS] &= ~(1 << SPH_EFFECT_TURNED);
            std::fill(m.regs + SPH_REG_ACROSS_X, m.regs + SPH_REG_DOWN_Z + 1, 0);
        }
        sum = (uint32_t)sph_camera_sum(&m);
        expect("strayed_o", dut.strayed_o, CAMERA && sph_camera_strayed(&m));
    }

    /* An output of `count` registers one behind the other; 0 if they are not built. */
    template <class Port>
    void part(const char *name, const Port &port, int first, int bits, int count = 1,
              bool built = true) {
        for (int i = 0; i < count; i++)
            expect(name, (bench::i128)bench::get(port, bits * i, bits),
                   built ? (bench::i128)bench::low(written[first + i], bits) : 0, bits);
    }

    /* A field of regs_o, likewise. */
    void field(const char *name, int lsb, int all, int first, int count, bool built) {
        int bits = all / count;
        for (int i = 0; i < count; i++)
            expect(name, (bench::i128)bench::get(dut.regs_o, lsb + bits * i, bits),
                   built ? (bench::i128)bench::low(written[first + i], bits) : 0, bits);
    }

    /* A grid in any axes; in the camera's, numbers have no fraction and steps one component. */
    void axes() {
        bool any = written[SPH_REG_EFFECTS] >> SPH_EFFECT_TURNED & 1;
        for (int i = 0; i < 3; i++) {
            uint32_t pitch = written[SPH_REG_PITCH] << FRACTION;
            uint32_t first = written[SPH_REG_DIR_X0 + i] << (any ? 0 : FRACTION);
            uint32_t across = any ? written[SPH_REG_ACROSS_X + i] : i == 0 ? pitch : 0;
            uint32_t down = any ? written[SPH_REG_DOWN_X + i] : i == 1 ? -pitch : 0;
            const uint32_t expected[3] = {first, across, down};
            const bench::u128 all[3] = {get(dut.first_o), get(dut.across_o), get(dut.down_o)};
            for (int k = 0; k < 3; k++)
                expect("first_o, across_o or down_o", (uint32_t)(all[k] >> 32 * i),
                       TURNED ? expected[k] : 0, 32);
        }
    }
};

} // namespace

int main(int argc, char **argv) {
    Registers b(argc, argv);
    for (int address = 0; address < ADDRESSES; address++)
        b.write(address, true);
    while (b.more()) {
        b.write((int)b.random.below(ADDRESSES), b.random.percent(70));
        b.compare();
    }
    return b.finish();
}
