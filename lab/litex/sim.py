# sim.py - LiteX's simulator as the board
# SPDX-License-Identifier: Apache-2.0
"""VexRiscv, LiteDRAM before a model of the ULX3S's SDRAM, and rt_top, whose display runs at 25 MHz
beside 40. Builds FOLDER/gateware/obj_dir/Vsim; its ROM is firmware.c, MACHINE lies in the SDRAM."""
import subprocess
from pathlib import Path

import litex
from litedram.modules import MT48LC16M16
from litedram.phy.model import SDRAMPHYModel
from litex.build.generic_platform import Pins, Subsignal
from litex.build.sim import SimPlatform
from litex.build.sim.config import SimConfig
from litex.gen import ClockDomain, LiteXModule, Signal
from litex.soc.integration.builder import Builder
from litex.soc.integration.common import get_mem_data
from litex.soc.integration.soc_core import SoCCore

from lab.litex.sphaera import Sphaera

SYS, PIXEL = int(40e6), int(25e6)
FILE_AT = 0x40000  # of firmware.c
CHECK = 1          # LiteDRAM's model tells commands that come too soon
IO = [("sys_clk", 0, Pins(1)), ("hdmi_clk", 0, Pins(1)),
      ("serial", 0, *(Subsignal(f"{side}_{name}", Pins(8 if name == "data" else 1))
                      for side in ("source", "sink") for name in ("valid", "ready", "data")))]


class Crg(LiteXModule):
    """Two clocks of the simulator, each with a reset of some clocks."""

    def __init__(self, platform):
        for name in ("sys", "hdmi"):
            domain = ClockDomain(name)
            start = ClockDomain(f"{name}_start", reset_less=True)
            setattr(self, f"cd_{name}", domain)
            setattr(self, f"cd_{name}_start", start)
            clk, left = platform.request(f"{name}_clk"), Signal(3, reset=7)
            self.comb += [domain.clk.eq(clk), start.clk.eq(clk), domain.rst.eq(left != 0)]
            getattr(self.sync, f"{name}_start").__iadd__(left.eq(left - (left != 0)))


class System(SoCCore):
    """What lab/litex/ulx3s.py has, as far as a simulation needs it."""

    def __init__(self, platform, machine, core, files):
        self.crg = Crg(platform)
        super().__init__(
            platform, SYS, ident="Sphaera", uart_name="sim", cpu_type="vexriscv",
            cpu_variant="lite", integrated_rom_size=0x4000, integrated_sram_size=0x2000)
        module = MT48LC16M16(SYS, "1:1")
        words = [0] * (FILE_AT // 4) + get_mem_data(machine, data_width=32, endianness="little")
        self.sdrphy = SDRAMPHYModel(module, data_width=16, clk_freq=SYS, init=words,
                                    verbosity=CHECK)
        self.add_sdram("sdram", phy=self.sdrphy, module=module, l2_cache_size=0)
        self.sphaera = Sphaera(self, core, files)
        self.irq.add("sphaera", use_loc_if_exists=True)
        platform.add_debug(self)

    def init_mems(self, **_):
        """Headers of the system are written: its firmware can be made."""
        folder = Path(self.platform.output_dir)
        subprocess.run(["sh", "synth/firmware.sh", Path(litex.__file__).parent, folder, "rom"],
                       check=True, cwd=Path(__file__).resolve().parents[2])
        self.init_rom("rom", get_mem_data(str(folder / "firmware.bin"), data_width=32,
                                          endianness="little"))


def main(folder, machine, *given):
    root = Path(__file__).resolve().parents[2]
    files = [str(path) for path in sorted(root.glob("rtl/*/*.v")) if path.parent.name != "board"]
    core = {name: int(value) for name, value in (word.split("=") for word in given)}
    soc = System(SimPlatform("SIM", IO), machine, core, files)
    config = SimConfig()
    config.add_clocker("sys_clk", freq_hz=SYS)
    config.add_clocker("hdmi_clk", freq_hz=PIXEL)
    config.add_module("serial2console", "serial")
    builder = Builder(soc, output_dir=str(Path(folder).resolve()), compile_software=False)
    builder.build(sim_config=config, run=False, opt_level="O1")
