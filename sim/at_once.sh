#!/bin/sh
# at_once.sh - a C++ file that includes a harness and all that Verilator wrote
# SPDX-License-Identifier: Apache-2.0
#
# usage: sim/at_once.sh FOLDER HARNESS.cpp
# One file, for each by itself would read the same headers again, which takes a second. What runs
# once, before the first clock (Verilator's __Slow), is not worth an optimiser's time.
set -eu
echo "#include \"$2\""
cd "$1"
for part in V*.cpp; do
    case $part in *__Slow.cpp) ;; *) echo "#include <$part>" ;; esac
done
cat <<END
#ifdef __clang__
#pragma clang optimize off
#else
#pragma GCC optimize("O0")
#endif
END
for part in V*__Slow.cpp; do
    echo "#include <$part>"
done
