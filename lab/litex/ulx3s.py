# ulx3s.py - a ULX3S with VexRiscv, SDRAM and rt_top
# SPDX-License-Identifier: Apache-2.0
"""Writes the Verilog of the whole into FOLDER/gateware and headers for the driver's caller into
FOLDER/software. No compiler of the CPU is needed for that, nor is any tool of the FPGA run.
"""
from pathlib import Path

from litex.soc.integration.builder import Builder
from litex_boards.targets import radiona_ulx3s

from lab.litex.sphaera import Sphaera


class Crg(radiona_ulx3s._CRG):
    """The clocks of the board's target, those of a display always with them."""

    def __init__(self, platform, sys_clk_freq, with_usb_pll=False, with_video_pll=False,
                 sdram_rate="1:1"):
        super().__init__(platform, sys_clk_freq, with_usb_pll, True, sdram_rate)


def main(folder, *given):
    root = Path(__file__).resolve().parents[2]
    files = [str(path) for path in sorted(root.glob("rtl/*/*.v"))
             if path.parent.name != "board" or path.name == "rt_serialise.v"]
    radiona_ulx3s._CRG = Crg
    soc = radiona_ulx3s.BaseSoC(
        device="LFE5U-85F", sys_clk_freq=40e6, cpu_type="vexriscv", cpu_variant="lite",
        integrated_rom_size=0x10000, integrated_sram_size=0x2000,
        l2_size=0)  # the block reads SDRAM beside a cache of the system: there must be none
    core = {name: int(value) for name, value in (word.split("=") for word in given)}
    soc.sphaera = Sphaera(soc, core, files, soc.platform.request("gpdi"))
    soc.irq.add("sphaera", use_loc_if_exists=True)
    builder = Builder(soc, output_dir=folder, compile_software=False, csr_csv=f"{folder}/csr.csv")
    builder.build(build_name="sphaera_ulx3s", run=False)
