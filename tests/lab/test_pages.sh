#!/bin/sh
# test_pages.sh - pages tell what the sources say, and what they name is there
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1

check "pages are as the sources have them: make pages" python3 -m lab pages --check
check "files, modules, functions, targets that are named are there" python3 -m lab names

check "figures of results stand in tables and regions, or are named with a reason" \
    python3 -m lab typed

check "an empty first cell is the one above it" python3 -c "
from lab.pages import data
rows = data.of_markdown('| a | b |\n|---|---|\n| x | 1 |\n| | 2 |\n').splitlines()
assert rows[-1] == 'x\t2', rows"

suites() { # of the papers' items: each that a command names is there
    grep -o 'make test ONLY=[a-z_.]*' lab/papers/claims.py | sed 's/.*=//' | sort -u >"$TMP/suites"
    [ -s "$TMP/suites" ] && while read -r suite; do
        ls tests/*/"$suite"* || return 1
    done <"$TMP/suites"
}
check "suites that show a claim are there" suites

# faults in a copy of the tree
cp -r cmodel docs formal lab make rtl scenes sim synth tb Makefile VERSION README.md \
    CONTRIBUTING.md "$TMP"
cd "$TMP" || exit 1
# nothing that a table was measured with makes pages older: figures have a commit, and no age
edited() { # file, sed expression: it must change something
    cp "$1" before && sed -i "$2" "$1" && ! cmp -s before "$1"
}
unrelated() { # files of the tool, the RTL, the model, a scene, other pages; then all pages again
    edited "$(find cmodel -name options_accel.c)" 's/"[^"]*\(trees\?\)/"plainly \1/' &&
        edited "$(find rtl -name rt_cache.v)" '$s/$/ \/\/ a comment/' &&
        edited "$(find rtl -name rt_leaf.v)" 's/endmodule/wire more; endmodule/' &&
        edited "$(find cmodel -name leaf_unit.c)" '$s/$/\nint more(void);/' &&
        edited scenes/paper100.nff '$s/$/\ns 9 9 9 1/' &&
        edited docs/design/model.md '$s/$/\nOne more sentence./' &&
        edited docs/results/trees.md '/^# /s/$/, again/' && python3 -m lab pages --check
}
check "an edit of tool, RTL, model, scene and prose leaves no page old" unrelated
stale() { # name, file, sed expression, what the check prints: tried with the others, all at once
    check "$1: the fault changes its file" edited "$2" "$3"
    printf '%s|%s\n' "$1" "$4" >>stale
}
core=$(find rtl -name rt_core.v) sizes=$(find rtl -name rt_core_parameters.vh)
def=$(find cmodel -name machine.def)
profile=$(find cmodel -name profile.c)
stale "a default" $sizes 's/SLOTS      = 64/SLOTS      = 32/' '^+- `SLOTS` = 32: '
stale "a port" $core 's/\[47:0\]       count_data_o/[39:0] count_data_o/' 'count_data_o`: 40'
heading=$(find rtl -name rt_texture.v)
stale "a heading of two lines" $heading 's|^ *// then hit point|    // and hit point|' \
    'from rt_surface: material, and hit point'
leaf=$(find rtl -name rt_leaf.v)
stale "a model" $leaf 's/Model: sph_leaf_test()/Model: sph_leaf_key_bits()/' \
    '^+- Model: `sph_leaf_key_bits()`'
stale "a register" $def 's/^reg    98 /reg    103 /' '^+- 103 `BG_COUNT`'
stale "an effect" $def 's/^effect sum .*/&\neffect haze bit=15 : fog/' \
    '^+- `haze`, `HAZE` = 1 (0..1, bit 15): fog'
stale "a counter" $def 's/^counter 21 POWERS  *both/counter 21 POWERS rtl/' \
    '^+- 21.. `POWERS`'
python3 -m lab pages --check >all 2>&1
check "pages that are stale make the check fail" [ $? -ne 0 ]
noticed() { cat all && grep -q -- "$1" all; }
while IFS='|' read -r name said; do
    check "$name: is noticed" noticed "$said"
done <stale
mended() { python3 -m lab pages && python3 -m lab pages --check; }
check "make pages mends them all" mended
page=$(find docs -name core.md)
broken() { # sed expression, what is said
    cp "$page" kept
    edited "$page" "$1" && ! python3 -m lab pages >said 2>&1 && grep "$2" said
    rc=$?
    cp kept "$page"
    return $rc
}
area=$(find docs -name speed_and_area.md)
by_hand() {
    cp "$area" kept
    sed -i '/^<!-- ecp5/,/^<!-- end/s/^| standard  *|/&1/' "$area"
    cmp -s "$area" kept && return 1
    ! python3 -m lab pages --check >said 2>&1 && cat said && grep 'ecp5 is not the one' said
    rc=$?
    cp kept "$area"
    return $rc
}
cells() { # as if they were of these sources; then not
    python3 -c 'from lab.pages import cores, verilog
known, files = cores.record(), verilog.files()
for name, entry in known.items():
    for gone in set(entry["modules"]) - set(files):
        del entry["modules"][gone]
    entry.update(sources=cores.sources(entry["modules"]), parameters=cores.parameters(name))
cores.write(known)' && python3 -m lab cores --check || return 1
    leaf=$(find rtl -name rt_leaf.v) texel=$(find rtl -name rt_texel.v)
    edited "$leaf" '1s/$/ and more/' && python3 -m lab cores --check || return 1
    edited "$texel" 's/endmodule/wire more; endmodule/' &&
        ! python3 -m lab cores --check >said && cat said && grep 'core all+texture ' said &&
        ! grep 'core all ' said || return 1
    edited "$leaf" 's/endmodule/wire more; endmodule/' &&
        ! python3 -m lab cores --check >said && cat said && grep 'core all ' said
}
check "cells are old when a module of the core changed, and then alone" cells
check "a measured table that was changed by hand" by_hand
unknown() {
    bare=docs/reference/library.md # which has no measured table
    cp "$bare" kept
    printf '%s\n' '<!-- speed -->' '| 1 |' '<!-- end -->' >>"$bare"
    ! python3 -m lab pages --check >said 2>&1 && cat said && grep 'nothing says when' said &&
        python3 -c "from lab.pages import measured
measured.stamp('$bare', 'make speed', ['speed'])" &&
        ! python3 -m lab pages --check >said 2>&1 && cat said && grep 'does not tell' said
    rc=$?
    cp kept "$bare"
    return $rc
}
check "a measured table that no run has made, or that does not say which" unknown
typed() { # page, what is written behind it, what is said
    cp "$1" kept
    printf '%b\n' "\n$2" >>"$1"
    ! python3 -m lab typed >said 2>&1 && cat said && grep -q -- "$3" said
    rc=$?
    cp kept "$1"
    return $rc
}
results=docs/results
check "a figure that was typed" typed $results/effects.md 'It takes\n12.5 % more.' \
    'effects.md:[0-9]*: 12.5 %'
check "... in README, grouped in threes" typed README.md 'So 12 345 LUT4eq.' \
    'README.md:[0-9]*: 12 345 LUT4eq'
check "... in README's table" typed README.md '| a | b |\n|---|---|\n| x | 7 ms |' ': 7 ms'
check "a table that was typed" typed $results/effects.md '| a | b |\n|---|---|\n| x | 7.5 |' \
    'effects.md:[0-9]*: table: a, b'
needless() {
    cp lab/pages/typed.txt kept
    echo 'effects | 3 dB | none' >>lab/pages/typed.txt
    ! python3 -m lab typed >said && cat said && grep 'effects has no 3 dB' said
    rc=$?
    cp kept lab/pages/typed.txt
    return $rc
}
check "a reason for what is not there" needless
made() { # what is generated or code is not typed
    cp "$area" kept
    printf '%s\n' '<!-- begin: x -->9.1 dB<!-- end -->' '`9.2 dB`' '' '    9.3 dB' >>"$area"
    python3 -m lab typed
    rc=$?
    cp kept "$area"
    return $rc
}
check "regions, code and listings may have figures" made
check "a table that is not there" broken 's/begin: errors/begin: rows speed_and_area.none/' \
    speed_and_area.none
shown=docs/results/data/shown.txt
claims=lab/papers/claims.py values=docs/results/data/papers.tsv
claim() { # file, sed expression, what is said
    cp "$1" kept
    edited "$1" "$2" && ! python3 -m lab pages --check >said 2>&1 && cat said &&
        grep -q -- "$3" said
    rc=$?
    cp kept "$1"
    return $rc
}
check "a claim's verdict that is no word of ours" claim $claims 's/"refuted"),/"perhaps"),/' \
    'perhaps'
check "a claim whose reason rests on nothing of ours" claim $claims \
    's/rt_leaf_sums", "count"/rt_leaf_sums", "taste"/' 'the reason taste'
check "a claim that is nowhere in the model" claim $claims \
    's#reference/predicates.c; rt_leaf_sums#reference/predictions.c; rt_leaf_sums#' predictions
check "a claim that is nowhere in the RTL" claim $claims \
    's#predicates.c; rt_leaf_sums#predicates.c; rt_leaf_sum#' 'no rt_leaf_sum.v'
check "a claim that is built, without a command" claim $claims \
    's/"make background", "other"),/"-", "other"),/' 'has a command'
check "a claim that puts its answer off" claim $claims \
    's/seen, and its error measured/not measured/' 'it is not measured'
check "a claim's value that was not measured" claim $values '/^paper_mul/d' 'paper_mul'
check "a value of a claim, changed by hand" claim $values 's/^\(paper_mul.\)11/\112/' \
    '^+.*| 12 and 11'
selected() { # sed expression, what is said
    cp "$shown" kept
    edited "$shown" "$1" && ! python3 -m lab pages >said 2>&1 && cat said && grep "$2" said
    rc=$?
    cp kept "$shown"
    return $rc
}
check "a row that is not there" selected 's/^speed_and_area.xc7; standard/&s/' \
    'speed_and_area.xc7 has no row standards'
check "a column that is not there" selected '/^speed_and_area.xc7/s/| FF |/| FFS |/' \
    'speed_and_area.xc7 has no column FFS'
check "a region that nothing makes" broken 's/begin: errors/begin: erors/' 'there are '
check "a region without an end" broken '$s/.*/<!-- begin: errors -->/' 'regions begin'
check "a module that is not there" broken 's/begin: ports rt_core/begin: ports rt_cor/' 'rt_cor'

cat >>"$page" <<END
\`cmodel/render_pixels.c\`
\`render_pixels.c\`
\`pix_colours_o\`
\`sph_renders()\`
\`sph_render()\` in \`$profile\`
as \`make pagez SCNE=x\` does
\`build/sphaera operates\`
[x](core.md#regsters)
END
echo '// to rt_leaf_queue' >>$core
python3 -m lab names "$page" $core >said
says() { cat said && grep -q -- "$1" said; }
check "a file" says 'md:[0-9]*: cmodel/render_pixels.c is not a file or folder'
check "a file without its folder" says 'md:[0-9]*: render_pixels.c is not a file'
check "a port of no module" says 'md:[0-9]*: pix_colours_o is not a port'
check "a function" says 'md:[0-9]*: sph_renders is not a name of cmodel'
check "a function of another file" says 'sph_render() in .*profile.c is not a function of that'
check "a target" says 'md:[0-9]*: make pagez is not a target'
check "a command of the tool" says 'md:[0-9]*: .*build/sphaera operates is not a command'
check "a variable" says 'md:[0-9]*: SCNE=x is not a variable'
check "a heading" says 'md:[0-9]*: core.md#regsters is not a heading'
check "a module" says 'rt_core.v:[0-9]*: rt_leaf_queue is not a module'
done_testing
