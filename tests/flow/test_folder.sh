#!/bin/sh
# test_folder.sh - a checkout, a build folder and a PREFIX may have any name
# SPDX-License-Identifier: Apache-2.0
#
# A copy of the sources in a folder with blanks, quotes, letters of any script: tool, simulations in
# Verilator and Icarus, suites, a bench, synthesis (of a block; ALL=1: of a core), install.
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
odd="a b'c \"d\" (e) & ;f, #g \$h é ж"
there="$TMP/$odd"
mkdir "$there"
tar c --exclude=./build --exclude=./.git --exclude=./docs/pictures . | tar x -C "$there"
unset BUILD SPHAERA TESTING TMPDIR ONLY
cd "$there" || exit 1
plain_make() { env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL make --no-print-directory "$@"; }
check "tool" plain_make tool
simulated() { plain_make sim SCENE=paper5 PROFILE=draft SIZE=8x6 "$@" &&
    grep "48 pixels, 0 mismatches" build/out/last/log && test -s build/out/last/report.html; }
check "simulation in Verilator" simulated SIM=verilator
check "simulation in Icarus" simulated SIM=icarus
for suite in test_export.sh test_generated.sh test_light.sh; do
    check "suite $suite" plain_make test ONLY=$suite
done
check "a bench" sh -c "python3 -m lab benches tb_isqrt/draft | grep '^ok'"
check "synthesis of a block" sh synth/module.sh rt_square BITS=4
[ -z "${ALL:-}" ] || check "synthesis of a core" plain_make synth EFFECTS=none PROFILE=draft \
    TARGET=generic

# ---- a build folder; make has no value with a dollar ----
odd=$(printf '%s' "$odd" | tr -d '$')
check "a build folder of such a name" plain_make B="$odd/b" tool
check "... has the tool" sh -c '"$1/sphaera" --version' sh "$odd/b"
check "... elsewhere too" plain_make B="$TMP/else where/$odd" render SCENE=paper5 SIZE=8x6
check "... and runs" test -s "$TMP/else where/$odd/out/last/model.png"
check "clean removes it" plain_make B="$odd/b" clean
check "... and nothing else" sh -c '[ ! -e "$1/b" ] && [ -e build/sphaera ]' sh "$odd"

# ---- installed ----
prefix="$TMP/to/p $odd"
check "install" plain_make install PREFIX="$prefix"
cd "$TMP" || exit 1
check "the tool draws" "$prefix/bin/sphaera" render "$there/scenes/paper5.nff" --size 8x6 -o x.png
own=$(PKG_CONFIG_PATH="$prefix/lib/pkgconfig" pkg-config --variable=includedir sphaera)
check "pkg-config has the folder" [ "$(eval "echo $own")" = "$prefix/include" ]
linked() {
    gcc "$there/examples/c/render.c" -I"$prefix/include" -L"$prefix/lib" -lsphaera -o program &&
        (cd "$prefix/lib" && LD_LIBRARY_PATH=. "$TMP/program" "$TMP/y.png" \
            "$there/scenes/paper5.nff")
}
check "a program with its library draws" linked
cd "$there" || exit 1
check "uninstall" plain_make uninstall PREFIX="$prefix"
check "... leaves no file" [ -z "$(find "$prefix" -type f)" ]
done_testing
