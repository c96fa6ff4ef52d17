#!/bin/sh
# ccache.sh - prints `ccache` if compilers can be called through it, or calls one so
# SPDX-License-Identifier: Apache-2.0
#
# usage: sim/ccache.sh [COMPILER ARGUMENT...]
# They cannot where there is none, or where it cannot write: there it would refuse to compile.
# A call is one of make/verilated.mk: of a precompiled header ccache takes the text of NAME.pch.sum.
# With CCACHE_DEPEND the compiler tells what a file includes, and no preprocessor is run before it:
# by -MD, for what Verilator wrote counts as system headers.
if [ $# -gt 0 ]; then
    case $PWD in *\$*) ;; *) export CCACHE_BASEDIR="$PWD" ;; esac # which ccache would expand
    exec env CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_PCH_EXTSUM=1 CCACHE_DEPEND=1 \
        ccache "$@"
fi
folder=$(ccache --get-config=cache_dir 2>/dev/null) && mkdir -p "$folder/tmp" 2>/dev/null &&
    [ -w "$folder/tmp" ] && echo ccache
exit 0
