# files.py - lists of the core's files for other tools: rtl/sphaera.f and sphaera.core
# SPDX-License-Identifier: Apache-2.0
"""Files of rtl without rtl/board, a board's parts of one vendor, by their paths from the root of
the tree; and the version of VERSION."""
import glob
import os

from .lines import told

FILELIST = """\
// sphaera.f - the core for iverilog -f and verilator -f, called in the repository's root
// SPDX-License-Identifier: Apache-2.0
"""
CORE = """\
CAPI=2:
# sphaera.core - the core for FuseSoC 2.4; make layout writes it
# SPDX-License-Identifier: Apache-2.0
name: ::sphaera:{version}
description: Ray tracer in synthesizable Verilog-2005

filesets:
  rtl:
    files:
{files}
    file_type: verilogSource-2005
  minimal:
    files:
      - examples/minimal/minimal.v: {{file_type: verilogSource-2005}}
      - examples/minimal/scene.regs.hex: {{file_type: user, copyto: scene.regs.hex}}
      - examples/minimal/scene.mem.hex: {{file_type: user, copyto: scene.mem.hex}}

targets:
  default:
    filesets: [rtl]
    toplevel: rt_core
  lint:
    description: Verilator's lint of rt_core
    filesets: [rtl]
    toplevel: rt_core
    default_tool: verilator
    tools:
      verilator:
        mode: lint-only
        verilator_options: [--language, 1364-2005, -Wall]
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


def lists():
    """(name of a file, its text)"""
    modules, headers = (sorted(name for name in glob.glob(f"rtl/**/*.{ending}", recursive=True)
                               if not name.startswith("rtl/board/")) for ending in ("v", "vh"))
    folders = sorted(set(map(os.path.dirname, headers)))
    yield "rtl/sphaera.f", FILELIST + told([f"+incdir+{name}" for name in folders] + modules)
    with open("VERSION", encoding="utf-8") as f:
        version = f.read().strip()
    files = [f"      - {name}: {{is_include_file: true, include_path: {os.path.dirname(name)}}}"
             for name in headers] + [f"      - {name}" for name in modules]
    yield "sphaera.core", CORE.format(version=version, files="\n".join(files))
