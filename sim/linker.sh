#!/bin/sh
# linker.sh - prints the option for a linker that takes a quarter of the usual one's time, if one is
# SPDX-License-Identifier: Apache-2.0
#
# For programs that tests run, of which there are hundreds; what is installed takes the usual one.
command -v ld.gold >/dev/null && echo -fuse-ld=gold
exit 0
