#!/bin/sh
# version.sh - versions of tools, which belong to what is known of every result that is kept
# SPDX-License-Identifier: Apache-2.0
#
# usage: sim/version.sh WORD...
# A line for each tool that is among the words of a command, `none` if it is not there; options and
# what only calls another one (ccache, env, sh) are no tools.
for word; do
    case $word in
    -* | *=* | *.sh | sh | env | ccache) continue ;;
    yosys | iverilog | */yosys | */iverilog) option=-V ;;
    *) option=--version ;;
    esac
    said=$("$word" $option </dev/null 2>/dev/null | head -n 1)
    printf '%s: %s\n' "${word##*/}" "${said:-none}"
done
