#!/bin/sh
# lint_text.sh - SPDX lines, columns, spaces, run bits, folders of files, readers of numbers
# SPDX-License-Identifier: Apache-2.0
cd "$(dirname "$0")/.." || exit 1

sources=$(find Makefile .ci make cmodel driver examples lab rtl formal python tb sim synth tests \
    -type f \( \
    -name Makefile -o -name run -o -name '*.c' -o -name '*.h' -o -name '*.cpp' -o -name '*.v' \
    -o -name '*.vh' -o -name '*.vlt' -o -name '*.sh' -o -name '*.mk' \
    -o -name '*.py' -o -name '*.ys' -o -name '*.def' -o -name '*.txt' -o -name '*.lib' \
    -o -name '*.smt2' \))
generated='/(rt_(layout|modes|bundles|top|core_rules)\.vh|'
generated=$generated'(layout|bundles|sphaera_[rm].*|[a-z_]*_table)\.h)$'
written=$(printf '%s\n' "$sources" | grep -vE "$generated")
texts=$(find docs scenes README.md -type f \( -name '*.md' -o -name '*.nff' \) 2>/dev/null)
bad=0
report() { # title, findings
    [ -z "$2" ] && return
    printf '%s:\n%s\n' "$1" "$2"
    bad=1
}
# shellcheck disable=SC2086  # lists of words on purpose
{
    report "no SPDX line" "$(grep -L 'SPDX-License-Identifier: Apache-2.0' $sources)"
    report "longer than 100 columns" \
        "$(LC_ALL=C.UTF-8 grep -noE '^.{101}' $written | cut -d: -f1,2)"
    report "script without run bit" \
        "$(find $(awk 'FNR == 1 && /^#!/ { print FILENAME }' $sources) ! -perm -u=x)"
    report "no timescale of 1ns / 1ps" "$(grep -L '^`timescale 1ns / 1ps$' \
        $(printf '%s\n' "$sources" | grep '\.v$'))"
    report "a vendor's part outside of rtl/board" "$(grep -nE \
        '^ *(ODDRX|IDDRX|DP16KD|PDPW16KD|MULT18X18D|EHXPLL|TRELLIS_|CCU2C|DCCA|OBUF|IBUF|RAMB)' \
        $(find rtl -name '*.v' ! -path 'rtl/board/*'))"
    report "space at the end" "$(grep -nE '[[:space:]]+$' $sources $texts)"
    report "main of more than 60 lines" "$(find tb -name '*.cpp' -exec awk '
        FNR == 1 { from = 0 }
        /^int main\(/ { from = FNR }
        from && /^}/ { if (FNR - from >= 60) print FILENAME ":" from; from = 0 }' {} +)"
    report "more than 40 ports (rt_top has those of three AXI buses)" "$(find rtl -name '*.v' \
        ! -name rt_top.v -exec awk '
        FNR == 1 { ports = 0 }
        /^    (input|output) / && ++ports == 41 { print FILENAME }' {} +)"
    report "fields of a bundle beside a port" "$(python3 -m lab layout --check-ports)"
    report "rt_engine only wires, in fewer than 200 lines" "$(awk '
        FNR == 200 || /^ *(always|initial|reg|function)/ { print FILENAME ":" FNR }' \
        rtl/engine/rt_engine.v)"
    kinds=$(awk '$1 == "kind" { printf "%s|", $3 }' cmodel/machine/machine.def)facet
    report "a kind of primitive outside of rtl/prim" "$(find rtl -name '*.v' ! -path 'rtl/prim/*' \
        -exec awk -v kinds="$kinds" '
        { code = $0; sub("//.*", "", code); names = FILENAME ~ "^rtl/texture/" ? "" : kinds }
        code ~ "`RT_(" toupper(kinds) "_KIND|FACET_MORE|PRIM_KIND)([^A-Z]|$)" ||
            names && code ~ "(^|[^A-Za-z])(" kinds ")([^A-Za-z]|$)" {
                print FILENAME ":" FNR ":" $0 }' {} +)"
    # test_scene.c holds number.c against the C library's
    by='ato(f|i|ll?)|strto(d|f|ld|[iu]max|u?ll?)(_l)?|[fsv]*scanf|sto(d|f|i|ld|u?ll?)|from_chars'
    report "a number read by something else than cmodel/common/number.h" "$(grep -nE \
        "(^|[^A-Za-z_])($by) *\\(" $(printf '%s\n' "$sources" | grep -E '\.(c|h|cpp)$' |
            grep -vxE 'cmodel/common/number.c|tests/scene/test_scene.c'))"
    report "a temporary name that another may have: sim/beside.sh, make/stamp.mk, lab/intact.py" "$(
        grep -nE '[.]\$\$(\$\$)?([^({a-z]|$)|[^$ ][.](tmp|new|part)([". ]|$)' \
            $(printf '%s\n' "$sources" | grep -E '(\.(mk|sh|py)|Makefile|run)$' |
                grep -vE '^tests/|^lab/intact.py$'))"
    report "a test, bench or page outside of its folder" "$(ls tests/test_* tb/tb_* docs/*.md \
        2>/dev/null | grep -v '^docs/index.md$')"
}
exit $bad
