# boards.py - the tops of boards, pin to pin, around the golden model: make/board.mk's simulations
# SPDX-License-Identifier: Apache-2.0
import glob
import os
import re
from functools import lru_cache

from ...benches import CELLS, shell, words_of
from . import netlist
from .benches import Drawn

CELL_FILES = sorted(glob.glob(CELLS))


@lru_cache(maxsize=None)
def options():
    """(BOARD_FAST, BOARD_MACHINE) of make/board.mk, words."""
    words = words_of("make", "-s", "board-words")   # behind what make may have built
    fast, machine = words.index("FAST:"), words.index("MACHINE:")
    return words[fast + 1:machine], words[machine + 1:]


class Board(Drawn):
    """A top whose core is the golden model, with models of the vendor's cells."""

    WAIT = "wait_q == 6"    # of golden_core.svh: a pixel in seven clocks

    def netlist(self):
        self.prepare()
        return netlist.Netlist(self.folder, self.top, self.parameters, ("rt_core",), CELL_FILES)

    def prepare(self):
        """What must be there before the RTL is read."""

    def sources(self):
        return [f"tb/board/tb_{self.top[3:]}.cpp", "tb/board/*.h", "tb/board/*.v", "tb/video/*.h",
                "tb/top/golden_core.*", "tb/sdram_times.h"]

    def machine(self, scene, size, name):
        _, machine = options()
        shell([f"{self.build}/sphaera", "build", scene, *machine, "--size", size, "-o",
               f"{self.folder}/{name}.sph"], f"{self.folder}/log")

    def objects(self):
        """The driver, and what the tool does with a board: make/board_sim.mk."""
        made, log = [], f"{self.folder}/log"
        for name, standard in (("driver/sphaera.c", "c99"), ("cmodel/tool/board.c", "gnu11")):
            made.append(f"{self.folder}/{os.path.basename(name)[:-2]}.o")
            shell(["gcc", f"-std={standard}", "-D_GNU_SOURCE", "-O2", "-Icmodel", "-c", name, "-o",
                   made[-1]], log)
        return made + sorted(glob.glob(f"{self.build}/sim/obj/bench_*.o"))

    def make(self, verilog, *more):
        golden = f"{self.folder}/rt_core.sv"
        fast, _ = options()
        with open("tb/top/golden_core.svh", encoding="utf-8") as f, \
                open(golden, "w", encoding="utf-8") as made:
            made.write(netlist.head("rt_core") + f.read().replace("wait_q == 6", self.WAIT))
        return self.compiled(verilog, f"tb/board/tb_{self.top[3:]}.cpp",
                            ["-DGOLDEN_CORE", "-Itb/board", *(f"-D{word}" for word in fast)],
                            self.objects(), [],
                            ["+1800-2017ext+sv", *(f"-I{n}" for n in sorted(glob.glob("rtl/*"))),
                             *CELL_FILES, golden, *more])

    @staticmethod
    def passed(text):
        del text
        return True     # its exit code says all


class RamBoard(Board):
    """rt_ulx3s_ram: its machine is in its ROMs; shown in a mode of its own size, for speed."""

    MODE = (320, 8, 8, 16, 240, 2, 2, 4, 0, 0)  # video::Mode
    WAIT = "wait_q == 2"

    def __init__(self, build):
        super().__init__("board/ram", "rt_ulx3s_ram", [], build)
        self.parameters = [[name.upper(), f'"{self.folder}/rom.{name}.hex"']
                           for name in ("registers", "scene")]
        self.runs = [[f"{self.folder}/rom.sph", *map(str, self.MODE)]]

    def prepare(self):
        os.makedirs(self.folder, exist_ok=True)
        self.machine("scenes/paper100.nff", "320x240", "rom")
        shell([f"{self.build}/sphaera", "load", "--rom", f"{self.folder}/rom",
               f"{self.folder}/rom.sph"], f"{self.folder}/log")
        name, mode = f"{self.folder}/rom.registers.hex", []
        for offset, low, high in ((0x64, 0, 1), (0x68, 2, 3), (0x6c, 4, 5), (0x70, 6, 7)):
            mode.append(f"{offset:03x}{self.MODE[high]:04x}{self.MODE[low]:04x}")
        with open(name, encoding="utf-8") as f:
            lines = [line for line in f.read().split()
                     if line[:3] not in ("064", "068", "06c", "070")]
        lines = [f"060{int(line[3:], 16) & ~2:08x}" if line[:3] == "060" else line
                 for line in lines]             # not doubled
        with open(name, "w", encoding="utf-8") as f:
            f.write("\n".join(mode + lines) + "\n")     # so that the first one counts


class SdramBoard(Board):
    """rt_ulx3s_sdram: machines come over its UART, buttons choose among them."""

    PINS = "tb/board/ulx3s_pins.v"

    def __init__(self, build):
        super().__init__("board/sdram", "rt_ulx3s_sdram",
                         [word.split("=") for word in options()[0]], build)
        self.outer = "ulx3s_pins"
        self.runs = [[f"{self.folder}/{n}.sph" for n in (1, 2, 3)]]

    def make(self, verilog, *more):
        with open("scenes/paper5.nff", encoding="utf-8") as f:
            scene = f.read()
        for number in (1, 2, 3):    # from a camera that moves to the right
            moved = f"{self.folder}/{number}.nff"
            with open(moved, "w", encoding="utf-8") as f:
                f.write(re.sub(r"^from (\S+)", lambda m, by=8 * (number - 1):
                               f"from {float(m[1]) + by}", scene, flags=re.M))
            self.machine(moved, "64x48", str(number))
        return super().make(verilog, self.pins())

    def pins(self):
        """What the bench sees; names are those that Yosys writes."""
        with open(self.PINS, encoding="utf-8") as f:
            pins = re.sub(r"(rt_ulx3s_sdram) #\(.*\) (u_board)", r"\1 \2", f.read())
        drives = ", ".join(rf"!u_board.u_pins.\g_pin[{i}].u_pin .T" for i in range(15, -1, -1))
        pins = re.sub(r"    genvar.*endgenerate", lambda _: "    assign sdram_drives_o = {"
                      + drives + "};", pins, flags=re.S)
        made = f"{self.folder}/ulx3s_pins.v"
        with open(made, "w", encoding="utf-8") as f:
            f.write(pins)
        return made
