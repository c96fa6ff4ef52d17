#!/bin/sh
# test_options.sh - options of the core's harness that take numbers refuse what is none, by its name
# SPDX-License-Identifier: Apache-2.0
#
# Options are those that --help has; the harness is its command line alone, without a core.
set -u
. "$(dirname "$0")/../tap.sh"
. "$(dirname "$0")/../numbers.sh"
cd "$(dirname "$0")/../.." || exit 1
${CC:-cc} -std=c11 -D_GNU_SOURCE -Icmodel -c -o "$TMP/number.o" cmodel/common/number.c || exit 1
cat >"$TMP/main.cpp" <<'END'
#include <cstdio>
#include "options.h"
int main(int argc, char **argv) {
    const Options o = read_options(argc, argv);
    return std::printf("%d %d %s\n", o.latency, o.reset_for, o.built.c_str()) < 0;
}
END
check "it compiles" g++ -std=c++17 -Wall -Wextra -Wconversion -Werror -O0 -fsanitize=undefined \
    -fno-sanitize-recover=all -I. -Icmodel -Itb -Itb/core -o "$TMP/options" "$TMP/main.cpp" \
    tb/core/options.cpp tb/core/dram.cpp "$TMP/number.o"
o=$TMP/options
options=$("$o" --help | grep -oE -e '--[a-z-]+=(N|PERCENT|LINE|BITS)( |$)' | sed 's/=.*//')
check "there are options that take a number" [ "$(echo "$options" | grep -c .)" -ge 11 ]
for option in $options; do
    check "$option" refuses 64 "$option=" "$o" --machine m
done
check "--reset-at N:CLOCKS" refuses 64 --reset-at=5: "$o" --machine m
for at in '' 0, 0,0, 0,0,8,; do
    check "--window $at" refuses 64 "--window=$at" "$o" --machine m
done
for at in '' 0,; do
    check "--pixel $at" refuses 64 "--pixel=$at" "$o" --machine m
done
for at in '' 0: 0:0: 0:0:8=; do
    check "--poke $at" refuses 64 "--poke=$at" "$o" --machine m
done
for at in '' 0=; do
    check "--reg $at" refuses 64 "--reg=$at" "$o" --machine m
done
check "--built" refuses 64 "--built=SHADOW=1 REFLECT=" "$o" --machine m
check "a word that is no parameter" refuses 64 "--built=SHADOW=1 REFLECT" "$o" --machine m
check "numbers are taken" [ "$("$o" --machine m --latency 7 --reset-at 3:9 \
    --built 'SHADOW=1 REFLECT=2')" = "7 9 SHADOW=1 REFLECT=2" ]
done_testing
