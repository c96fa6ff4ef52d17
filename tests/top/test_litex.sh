#!/bin/sh
# test_litex.sh - the LiteX system with rt_top, where LiteX is installed
# SPDX-License-Identifier: Apache-2.0
cd "$(dirname "$0")/../.." || exit 1
if [ -x "${BUILD:-build}/venv/litex/bin/python" ]; then
    env -u MAKEFLAGS -u MFLAGS make -s --no-print-directory B="${BUILD:-build}" litex ||
        echo "not ok - make litex"
else
    echo "ok - make litex # SKIP no LiteX: make litex-setup"
fi
echo 1..1
