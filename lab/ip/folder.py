# folder.py - a folder that another project takes: rt_top of one configuration, and what goes along
# SPDX-License-Identifier: Apache-2.0
"""Writes FOLDER anew: sources of the configuration (of PROFILE and EFFECTS as sim/cores.py takes
them, with ENGINES, PIPES, SIZES... of the environment, and parameters of rt_top), component.xml
(IP-XACT), sphaera.core, constraints and what checks them, registers in C, SystemRDL, and, if
`make ip-setup` ran, UVM and HTML, the driver, a template, a data sheet. Nothing is written if a
crossing of clocks has no constraint. A folder that is none of these stays as it is."""
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from sim.definition import Definition

from .. import clocks
from ..generate import files as lists
from ..generate.top import Registers
from ..pages import verilog
from ..runner import said
from . import check_crossings, component, constraints, sheet
from .netlist import Netlist

OWN = ("ENGINES", "PIPES", "LEAF_UNITS", "SHADES", "ROOT_STEP", "QUOTIENT_STEP")
ALONG = ("driver/sphaera.c", "driver/sphaera.h", "driver/sphaera_file.h", "driver/sphaera_regs.h",
         "driver/sphaera_modes.h", "examples/linux/uio.c", "examples/linux/rt-top.dts",
         "examples/linux/sphaera,rt-top.yaml", "docs/reference/rt_top.rdl", "LICENSE",
         "lab/ip/check_crossings.py", "lab/ip/netlist.py")
MARK = "component.xml"          # by which a folder is known


def parameters(profile, effects, given):
    """{name: value} of rt_top, by the defaults of its head, the words of sim/cores.py and given."""
    found, about = lists.parameters()
    words = [*said("sim/cores.py", "profile", profile).split(),
             *said("sim/cores.py", "parameters", effects).split(),
             *said("sim/cores.py", "sizes", os.environ.get("SIZES", "")).split(),
             *(f"{name}={os.environ[name]}" for name in OWN if os.environ.get(name)), *given]
    for word in words:
        name, _, value = word.partition("=")
        if name not in found or not value.isdecimal():
            sys.exit(f"ip: {word} is no parameter of rt_top and its value; there are "
                     f"{' '.join(found)}")
        found[name] = int(value)
    said("sim/cores.py", "legal",
         *(f"{n}={v}" for n, v in found.items() if n not in lists.OF_SHELL))
    return found, about


def elaborated(top, values, path, work, rtl="rtl"):
    """A flat netlist as JSON, and the sources that it was made of."""
    folders = sorted({str(p.parent) for p in Path(rtl).rglob("*.v*")})
    script = f"""verilog_defaults -add {' '.join(f'-I{f}' for f in folders)} -DSYNTHESIS
        read_verilog -lib +/ecp5/cells_bb.v +/ecp5/cells_sim.v
        read_verilog {rtl}/{Path(verilog.files()[top]).relative_to('rtl')}
        {'chparam' if values else ''} {' '.join(f'-set {n} {v}' for n, v in values.items())} {
            top if values else ''}
        hierarchy -purge_lib -check -top {top} {' '.join(f'-libdir {f}' for f in folders)}
        proc
        flatten
        opt_expr
        opt_clean
        write_json {path}"""
    (work / "netlist.ys").write_text("\n".join(line.strip() for line in script.splitlines()))
    done = subprocess.run(["yosys", "-q", "-E", f"{work}/sources", "-s", f"{work}/netlist.ys"],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode:
        sys.exit(f"ip: {done.stdout[-2000:]}")
    words = (work / "sources").read_text().replace("\\", "").partition(":")[2].split()
    return sorted({os.path.relpath(w) for w in words if os.path.relpath(w).startswith("rtl/")} |
                  {str(p) for p in Path("rtl").rglob("*.vh") if p.parts[1] != "board"})


def template(ports, values):
    """An instance of rt_top, its ports tied to wires of their names."""
    wires = "".join(f"wire {f'[{n - 1}:0] ' if n > 1 else ''}{name};\n"
                    for name, (_, n) in ports.items())
    tied = ",\n".join(f"    .{name}({name})" for name in ports)
    chosen = ",\n".join(f"    .{name}({value})" for name, value in values.items())
    return ("// rt_top_instance.v - a template: rt_top of this configuration\n"
            "// SPDX-License-Identifier: Apache-2.0\n"
            f"{wires}rt_top #(\n{chosen}\n) u_rt_top (\n{tied}\n);\n")


def models(python, rdl, out):
    """UVM and HTML by the packages of `make ip-setup`, or a word that they are absent."""
    if not os.access(python, os.X_OK):
        return "no UVM and HTML register models: PeakRDL is absent, make ip-setup installs it"
    return said(python, "-m", "lab.ip.models", rdl, f"{out}/{MARK}", f"{out}/rt_top_uvm.sv",
                f"{out}/html").strip()


def wanted(path):
    """Whether it may be written."""
    if path.exists() and any(path.iterdir()) and not (path / MARK).exists():
        sys.exit(f"ip: {path}: is there, and no IP folder: it stays as it is")


def main(build, folder, profile, effects, *given):
    folder = Path(folder)
    wanted(folder)
    values, about = parameters(profile, effects, given)
    folder.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=folder.parent, prefix=".ip.") as work:
        work, out = Path(work), Path(work) / "ip"
        out.mkdir()
        sources = elaborated("rt_top", values, work / "netlist.json", work)
        netlist = Netlist(work / "netlist.json")
        crossings = list(constraints.crossings(netlist))
        (out / "sphaera.xdc").write_text(constraints.xdc(crossings))
        (out / "sphaera.sdc").write_text(constraints.sdc(crossings, netlist.clocks))
        inside = {n: v for n, v in values.items() if n not in lists.OF_SHELL}
        elaborated("rt_core", inside, work / "core.json", work)
        wrong = check_crossings.ports(netlist)
        for kind in ("xdc", "sdc"):
            lines, number = check_crossings.check(netlist, f"{out}/sphaera.{kind}")
            wrong += lines
        if wrong:
            sys.exit("\n".join(wrong))
        for name in sources:
            (out / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(name, out / name)
        (out / "driver").mkdir()
        for name in ALONG:
            shutil.copy(name, out / "driver" if name.startswith(("driver/", "examples/")) else out)
        ports = {name: (way, len(bits)) for name, (way, bits) in netlist.ports.items()}
        registers = Registers(Definition())
        release = Path("VERSION").read_text(encoding="utf-8").strip()
        (out / "rt_top_instance.v").write_text(template(ports, values))
        (out / "sphaera.core").write_text(lists.whole(release, sources, values, about, True))
        core = said("sim/cores.py", "key", profile, effects, "ecp5").strip()
        plain = values["VIDEO"] == 1 and not values["LAYERS"] and values["DATA"] == 64
        (out / "datasheet.md").write_text(sheet.text(
            build, core, release, profile, values, registers.registers_of_machine,
            (core, f"{core}-top" if plain else None), netlist, number,
            Netlist(work / "core.json")))
        there = sorted(str(p.relative_to(out)) for p in out.rglob("*") if p.is_file())
        (out / MARK).write_text(component.text(
            registers, ports, {n: (v, about[n]) for n, v in values.items()}, there, release,
            len(netlist.ports["m_scene_araddr"][1])))
        told = models(f"{build}/venv/ip/bin/python", "docs/reference/rt_top.rdl", out)
        if folder.exists():
            folder.rename(work / "old")
        out.rename(folder)
    print(f"{folder}: {core}, {len(sources)} sources, {number} crossings, each with a constraint\n"
          f"{told}; MHz of rt_top {clocks.mhz(core + '-top') if plain else clocks.NOT}")
