#!/bin/sh
# filelist.sh - lists of the core's files for other tools: rtl/sphaera.f and sphaera.core
# SPDX-License-Identifier: Apache-2.0
#
# usage: sim/filelist.sh [FOLDER]
# Writes both from the files that are in rtl/, without rtl/board/ (a board, parts of one vendor),
# and the version of VERSION; to FOLDER if it is given, else in their places. Paths are
# relative to the repository's root. A file that stays the same keeps its time.
set -eu
cd "$(dirname "$0")/.."
. sim/beside.sh
modules=$(find rtl -name '*.v' ! -path 'rtl/board/*' | LC_ALL=C sort)
headers=$(find rtl -name '*.vh' ! -path 'rtl/board/*' | LC_ALL=C sort)
folders=$(for file in $headers; do echo "${file%/*}"; done | sort -u)
put() { # file: takes stdin
    to=${to_folder:+$to_folder/${1##*/}}
    to=${to:-$1}
    beside "$to"
    cat >"$new"
    named_anew "$to"
}
to_folder=${1:-}
put rtl/sphaera.f <<END
// sphaera.f - the core for iverilog -f and verilator -f, called in the repository's root
// SPDX-License-Identifier: Apache-2.0
$(printf '+incdir+%s\n' $folders)
$(printf '%s\n' $modules)
END
put sphaera.core <<END
CAPI=2:
# sphaera.core - the core for FuseSoC 2.4; sim/filelist.sh writes it
# SPDX-License-Identifier: Apache-2.0
name: ::sphaera:$(cat VERSION)
description: Ray tracer in synthesizable Verilog-2005

filesets:
  rtl:
    files:
$(printf '      - %s: {is_include_file: true, include_path: %s}\n' \
    $(for file in $headers; do echo "$file ${file%/*}"; done))
$(printf '      - %s\n' $modules)
    file_type: verilogSource-2005
  minimal:
    files:
      - examples/minimal/minimal.v: {file_type: verilogSource-2005}
      - examples/minimal/scene.regs.hex: {file_type: user, copyto: scene.regs.hex}
      - examples/minimal/scene.mem.hex: {file_type: user, copyto: scene.mem.hex}

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
END
