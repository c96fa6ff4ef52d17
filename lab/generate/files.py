# files.py - lists of the core's files for other tools: rtl/sphaera.f and sphaera.core
# SPDX-License-Identifier: Apache-2.0
"""Files of rtl without rtl/board, a board's parts of one vendor, by their paths from the root of
the tree; and the version of VERSION."""
import glob
import json
import os

from ..pages import verilog
from .lines import told

OF_SHELL = ("DATA", "BUFFERS", "VIDEO", "LAYERS", "BUILD", "ADDR", "FRAME_ID", "SCAN_ID",
            "AXI_CACHE", "AXI_PROT", "AXI_QOS", "SCAN_QOS")     # parameters that rt_core lacks

FILELIST = """\
// sphaera.f - the core for iverilog -f and verilator -f, called in the repository's root
// SPDX-License-Identifier: Apache-2.0
"""
CORE = """\
CAPI=2:
# sphaera.core - the core for FuseSoC 2.4; {by} writes it
# SPDX-License-Identifier: Apache-2.0
name: ::sphaera:{version}
description: Ray tracer in synthesizable Verilog-2005

filesets:
  rtl:
    files:
{files}
    file_type: verilogSource-2005
"""
MINIMAL = """\
  minimal:
    files:
      - examples/minimal/minimal.v: {file_type: verilogSource-2005}
      - examples/minimal/scene.regs.hex: {file_type: user, copyto: scene.regs.hex}
      - examples/minimal/scene.mem.hex: {file_type: user, copyto: scene.mem.hex}
"""
LINT = """\
  {name}:
    description: Verilator's lint of {top}
    filesets: [rtl]
    toplevel: {top}
    parameters: [{parameters}]
    default_tool: verilator
    tools:
      verilator:
        mode: lint-only
        verilator_options: [--language, 1364-2005, -Wall]
"""
SIM = """\
  sim:
    description: examples/minimal draws scene.ppm in the folder of the run
    filesets: [rtl, minimal]
    toplevel: minimal
    default_tool: icarus
    tools:
      icarus:
        iverilog_options: [-g2005, -Wall]
      verilator:
        mode: binary
        verilator_options: [--timing, --language, 1364-2005]
"""


def whole(version, names, values, about, folder=False):
    """names: files from where it stands; values: {parameter of rt_top: default}; about: {parameter:
    what it is}. folder: it stands in that of make ip, which has one target, of rt_top."""
    files = [f"      - {name}: {{is_include_file: true, include_path: {os.path.dirname(name)}}}"
             if name.endswith(".vh") else f"      - {name}" for name in names]
    with_core = [name for name in values if name not in OF_SHELL]
    text = CORE.format(by="make ip" if folder else "make layout", version=version,
                       files="\n".join(files)) + MINIMAL * (not folder)
    text += "\nparameters:\n" + "".join(
        f"  {name}: {{datatype: int, paramtype: vlogparam, default: {value}, "
        f"description: {json.dumps(about[name])}}}\n" for name, value in values.items())
    top, parameters = ("rt_top", list(values)) if folder else ("rt_core", with_core)
    text += f"""
targets:
  default:
    filesets: [rtl]
    toplevel: {top}
    parameters: [{', '.join(parameters)}]
"""
    lints = [("lint", top, parameters)] + [("top", "rt_top", list(values))] * (not folder)
    return text + "".join(LINT.format(name=name, top=one, parameters=", ".join(own))
                          for name, one, own in lints) + SIM * (not folder)


def parameters():
    """{parameter of rt_top: default}, {parameter: what it is}, by its head."""
    head, _ = verilog.header(verilog.files()["rt_top"], verilog.defines())
    return {p.name: int(p.default) for p in head}, {p.name: p.comment for p in head}


def lists():
    """(name of a file, its text)"""
    modules, headers = (sorted(name for name in glob.glob(f"rtl/**/*.{ending}", recursive=True)
                               if not name.startswith("rtl/board/")) for ending in ("v", "vh"))
    folders = sorted(set(map(os.path.dirname, headers)))
    yield "rtl/sphaera.f", FILELIST + told([f"+incdir+{name}" for name in folders] + modules)
    with open("VERSION", encoding="utf-8") as f:
        version = f.read().strip()
    yield "sphaera.core", whole(version, headers + modules, *parameters())
