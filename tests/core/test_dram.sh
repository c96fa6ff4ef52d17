#!/bin/sh
# test_dram.sh - the memory parts of `make sim MEMORY=...`: times, rules, faults that are noticed
# SPDX-License-Identifier: Apache-2.0
#   SEED=n        other lines (1)
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
SEED=${SEED:-1}
echo "# SEED=$SEED; again: SEED=$SEED make test ONLY=test_dram"

built() { # folder of tb/core/dram.cpp, options
    folder=$1
    shift
    g++ -std=c++17 -Wall -Wextra -Wconversion -Wshadow -Werror -I. -Icmodel -Itb -Itb/core "$@" \
        -o "$folder/check" tests/core/dram_check.cpp "$folder/dram.cpp" "$TMP/number.o"
}
${CC:-cc} -std=c11 -D_GNU_SOURCE -Icmodel -c -o "$TMP/number.o" cmodel/common/number.c || exit 1
mkdir "$TMP/good"
cp tb/core/dram.cpp "$TMP/good"
sed -i 's,"../sdram_times.h","sdram_times.h",' "$TMP/good/dram.cpp"
check "it compiles" built "$TMP/good" -O0 -fsanitize=undefined -fno-sanitize-recover=all
"$TMP/good/check" "$SEED" >"$TMP/lines"
sed 's/^\(ok\|not ok\) [0-9]* - //; /^1\.\./d; /^#/d' "$TMP/lines" >"$TMP/names"
while read -r name; do # its lines, counted here
    ! grep "^not ok .* - $name\$" -A 1 "$TMP/lines"
    tap $? "$name" "$TMP/lines"
done <"$TMP/names"

# ---- planted faults ----
fault() { # what, text, what stands there instead
    rm -rf "$TMP/bad"
    cp -r "$TMP/good" "$TMP/bad"
    python3 -m lab faults edit "$TMP/bad/dram.cpp" "$2" "$3" >"$TMP/said" 2>&1 &&
        built "$TMP/bad" -O0 >>"$TMP/said" 2>&1 && ! "$TMP/bad/check" "$SEED" >>"$TMP/said"
    tap $? "noticed: $1" "$TMP/said"
}
fault "two commands in a clock" "while (!taken_.insert(earliest).second)" \
    "if (!taken_.insert(0).second && false)"
fault "a refresh with rows open" "if (bank.open) close(bank, at);" \
    "bank.activate = at + part_.rp;"
fault "a column of the row before" "if (bank.open && bank.row == row)" "if (bank.open)"
done_testing
