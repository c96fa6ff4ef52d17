#!/bin/sh
# test_pairs.sh - parameters that do not go together are refused by name, all others elaborate
# SPDX-License-Identifier: Apache-2.0
cd "$(dirname "$0")/../.." || exit 1
exec python3 tests/core/pairs.py ${ALL:+all}
