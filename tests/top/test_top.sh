#!/bin/sh
# test_top.sh - rt_top under its driver; with ALL=1 buses of 128 and 256 bits too
# SPDX-License-Identifier: Apache-2.0
cd "$(dirname "$0")/../.." || exit 1
TOP_DATA="64 ${ALL:+128 256}" env -u MAKEFLAGS -u MFLAGS make -s --no-print-directory \
    B="${BUILD:-build}" SEED=1 top || echo "not ok - make top"
