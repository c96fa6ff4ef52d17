#!/bin/sh
# ccache.sh - prints `ccache` if compilers can be called through it
# SPDX-License-Identifier: Apache-2.0
#
# They cannot where there is none, or where it cannot write: there it would refuse to compile.
folder=$(ccache --get-config=cache_dir 2>/dev/null) && mkdir -p "$folder/tmp" 2>/dev/null &&
    [ -w "$folder/tmp" ] && echo ccache
exit 0
