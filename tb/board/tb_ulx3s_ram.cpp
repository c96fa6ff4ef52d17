/* tb_ulx3s_ram.cpp - the board of block RAM, pin to pin: its picture is the golden model's
 * SPDX-License-Identifier: Apache-2.0
 *
 * usage: tb_ulx3s_ram MACHINE.sph [MODE...]    in the folder from which the paths of its ROMs count
 * The display must see black pictures, then the machine's, no other, with every sync in its place.
 * The ten numbers of a mode are those of video::Mode; without them it is 640x480.
 */
#include "Vrt_ulx3s_ram.h"
#include "board_link.h"
extern "C" {
#include "tests/number.h"
}

int main(int argc, char **argv) {
    if (argc != 2 && argc != 12)
        return fprintf(stderr, "usage: tb_ulx3s_ram MACHINE.sph [MODE...]\n"), 2;
    unsigned fields[][10] = {
#define MODE(name, khz, ...) {__VA_ARGS__},
        SPHAERA_MODES(MODE)
#undef MODE
    };
    for (int i = 2; i < argc; i++)
        fields[0][i - 2] = (unsigned)test_number(argv[i], "argument", 0);
    video::Mode mode;
    memcpy(&mode, fields[0], sizeof mode);
    const std::vector<uint32_t> golden = golden_picture(argv[1], mode);
    const std::vector<uint32_t> black(golden.size(), 0);
    Vrt_ulx3s_ram dut;
    Link link(mode);
    const uint64_t most = (argc > 2 ? 6ull : 30ull) * 50 * mode.h_total() * mode.v_total();
    unsigned blacks = 0, right = 0, wrong = 0;
    for (uint64_t step = 0; step < most && right < 2 && !wrong && link.display.error().empty();
         step++) {
        dut.clk_25mhz = step & 1; /* tb/board/EHXPLLL.v */
        dut.eval();
        if (step % 5 == 3) link.bit(dut.gpdi_o);
        while (link.display.has_picture()) {
            const std::vector<uint32_t> rgb = link.display.picture().rgb;
            size_t at = 0;
            while (at < rgb.size() && rgb[at] == golden[at])
                at++;
            if (rgb == golden)
                right++;
            else if (rgb == black && !right)
                blacks++;
            else {
                wrong++;
                printf("# pixel %zu of row %zu is %06x, not %06x\n", at % mode.h_active,
                       at / mode.h_active, rgb[at], golden[at]);
            }
        }
    }
    dut.final();
    if (!link.display.error().empty()) printf("# %s\n", link.display.error().c_str());
    const bool good = right == 2 && !wrong && !link.broken && link.display.error().empty() &&
                      (dut.led_o & 14) == 6;
    printf("%s - tb_ulx3s_ram: %u black pictures, %u as the golden model has them, lights %02x\n",
           good ? "ok" : "not ok", blacks, right, dut.led_o);
    return !good;
}
