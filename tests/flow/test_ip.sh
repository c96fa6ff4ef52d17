#!/bin/sh
# test_ip.sh - the folder of make ip: it is whole, elaborates by itself, each crossing has a name
# SPDX-License-Identifier: Apache-2.0
#
# Its own check of crossings has to find what is planted into its sources: a crossing without a
# name, logic before a synchroniser, a flip-flop that is not marked, a port that two clocks read.
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
command -v yosys >"$TMP/yosys" || {
    echo "ok 1 - # SKIP no yosys"
    echo "1..1"
    exit 0
}
ip=$TMP/ip
make_ip() { # folder, parameters
    to=$1
    shift
    make -s ip B="$BUILD" IP="$to" PROFILE=draft EFFECTS=none TOP_PARAMETERS="$*" >"$TMP/said" 2>&1
}
no() { ! "$@"; }
says() { grep -q -- "$1" "$TMP/said" || { cat "$TMP/said"; return 1; }; }
check "a folder of rt_top with video" make_ip "$ip" VIDEO=1
check "... which says its crossings" says "16 crossings, each with a constraint"
if [ -x "$BUILD/venv/ip/bin/python" ]; then
    check "... and what PeakRDL reads of it" says "component.xml is valid"
else
    check "... and that PeakRDL is absent" says "make ip-setup installs it"
fi

# ---- whole ----
there() (
    cd "$ip" || exit 1
    sed -n 's/^      - \(rtl[^:]*\).*/\1/p' sphaera.core | sort >"$TMP/core"
    find rtl -type f | sort >"$TMP/files"
    diff "$TMP/core" "$TMP/files" && [ "$(wc -l <"$TMP/core")" -gt 90 ] &&
        ls driver/sphaera.c driver/sphaera_regs.h rt_top.rdl sphaera.sdc LICENSE
)
check "sphaera.core names its sources, and what else ships is there" there
check "its component has every register, port and file" python3 -c '
import re, sys, xml.etree.ElementTree as ET
folder, space = sys.argv[1], "{http://www.accellera.org/XMLSchema/IPXACT/1685-2014}"
root = ET.parse(f"{folder}/component.xml").getroot()
names = {tag: [one.find(space + "name").text for one in root.iter(space + tag)]
         for tag in ("register", "port", "file", "busInterface")}
rdl = re.findall(r"} (\w+) @", open("docs/reference/rt_top.rdl").read())
wires = re.findall(r"^    \.(\w+)\(\w+\)", open(f"{folder}/rt_top_instance.v").read(), re.M)
assert names["register"] == rdl and len(rdl) > 180, "registers"
assert set(names["port"]) <= set(wires) and len(names["port"]) > 60, "ports"
assert {"sphaera.xdc", "driver/sphaera.h", "rtl/top/rt_top.v"} <= set(names["file"]), "files"
assert len(names["busInterface"]) == 5, "buses"' "$ip"
elaborates() (
    cd "$ip" || exit 1
    { echo 'module outside;' && sed 1,2d rt_top_instance.v && echo endmodule; } >"$TMP/outside.v"
    # shellcheck disable=SC2046  # a list of words
    iverilog -g2005 $(find rtl -type d | sed 's/^/-I/') -s outside -o "$TMP/vvp" \
        $(find rtl -name '*.v') "$TMP/outside.v"
)
check "its template elaborates with its own sources alone" elaborates
check "its data sheet names a frame, a clock and each port" \
    [ "$(grep -c '^| `' "$ip/datasheet.md")" -gt 70 ]

# ---- its driver, and the example for Linux ----
check "the driver is freestanding C99, and UIO's example is built with it" \
    "${CC:-gcc}" -std=c99 -pedantic -Wall -Wextra -Wconversion -Wshadow -Werror -I"$ip/driver" \
    "$ip/driver/uio.c" "$ip/driver/sphaera.c" -o "$TMP/uio"
"$TMP/uio" /dev/null LICENSE >"$TMP/said" 2>&1 && echo "exit code 0" >>"$TMP/said"
check "... which says what a device lacks" [ "$(cat "$TMP/said")" = \
    "uio: /dev/null: has no map1: reserved memory in the device tree" ]
if command -v dtc >"$TMP/dtc"; then
    check "the device tree's overlay" dtc -q -@ -O dtb -o "$TMP/dtbo" "$ip/driver/rt-top.dts"
else
    echo "# no dtc: the overlay is not compiled"
fi
properties() { # of the node, and of the binding: each is known there
    sed -n '/ray-tracer/,/};/s/^ *\([a-z-]*\) = .*/\1/p' "$ip/driver/rt-top.dts" |
        grep -v interrupt-parent | while read -r word; do
        grep -q "^  $word:" "$ip/driver/sphaera,rt-top.yaml" || { echo "$word"; exit 1; }
    done
}
check "the binding knows each property of its node" properties

# ---- crossings, as who takes the folder checks them ----
flat() (
    cd "$ip" || exit 1
    folders=$(find rtl -type d)
    yosys -q -p "verilog_defaults -add $(echo "$folders" | sed 's/^/-I/' | tr '\n' ' ') -DSYNTHESIS
        read_verilog rtl/top/rt_top.v
        chparam $(sed -n 's/^    \.\([A-Z_]*\)(\([0-9]*\)).*/-set \1 \2/p' rt_top_instance.v |
        tr '\n' ' ') rt_top
        hierarchy -check -top rt_top $(echo "$folders" | sed 's/^/-libdir /' | tr '\n' ' ')
        proc; flatten; opt_clean; write_json $TMP/flat.json"
)
crossings() { (cd "$ip" && ./check_crossings.py "$TMP/flat.json" "$@") >"$TMP/said" 2>&1; }
flat
check "each is named by both files" crossings sphaera.xdc sphaera.sdc
grep -v 'u_on/meta_q' "$ip/sphaera.xdc" >"$ip/less.xdc"
sed 's,u_on/settled_q,u_on/setled_q,' "$ip/sphaera.xdc" >"$ip/other.xdc"
{ cat "$ip/sphaera.sdc" && sed -n 's,u_on/meta_q,u_of/meta_q,p' "$ip/sphaera.sdc"; } >"$ip/more.sdc"
check "a constraint that is left out is missed" no crossings less.xdc
check "... by name" says 'u_video/on_q (clk) to .*u_on/meta_q (pix_clk): no constraint names'
check "a second flip-flop without ASYNC_REG" no crossings other.xdc
check "... by name" says "u_on/settled_q is no ASYNC_REG"
check "a constraint of what is not there" no crossings more.sdc
check "... by line" says "more.sdc:[0-9]*: there is no such crossing"
plant() { # file, what, in its place
    sed "s/$2/$3/" "$ip/$1" >"$TMP/planted" && ! cmp -s "$ip/$1" "$TMP/planted" &&
        cp "$TMP/planted" "$ip/$1"
}
check "faults are planted" eval "
    plant rtl/video/rt_video.v 'blank_q <= blank;' 'blank_q <= blank || leave_q;' &&
    plant rtl/video/rt_video.v 'd_i(on_q)' 'd_i(on_q \&\& !leave_q)' &&
    plant rtl/video/rt_video.v 'on_q && leave;' 'on_q \&\& leave \&\& m_video_tready;' &&
    plant rtl/memory/rt_sync.v '.RT_SYNC_FLOPS reg .WIDTH-1:0. settled' \
        'reg [WIDTH-1:0] settled'"
flat
check "and found" no crossings sphaera.xdc
check "... a crossing without a name" says 'leave_q (clk) to .*/blank_q (pix_clk): no constraint'
check "... logic before a synchroniser" says 'leave_q (clk) to .*u_on/meta_q (pix_clk): through'
check "... a flip-flop that is not marked" says "settled_q has no async_reg in the sources"
check "... a port that two clocks read" says "port m_video_tready is read by clk and pix_clk"

# ---- what is refused, and another configuration ----
check "a block without video has one clock" make_ip "$ip" LAYERS=1
check "... and no crossing" says " 0 crossings"
check "... and the folder is that block's" eval "! grep -q set_max_delay '$ip/sphaera.xdc'"
mkdir "$TMP/mine" && echo mine >"$TMP/mine/file"
check "a folder that is none stays" no make_ip "$TMP/mine" VIDEO=1
check "... as it is" [ "$(ls "$TMP/mine")" = file ]
check "a parameter that there is not" no make_ip "$TMP/new" VIDIO=1
check "... by name" says "VIDIO=1 is no parameter of rt_top"
check "a value that is illegal" no make_ip "$TMP/new" DATA=96
check "... by name" says "rt_top_DATA_must_be_64_or_128"
check "... and no folder" [ ! -e "$TMP/new" ]
done_testing
