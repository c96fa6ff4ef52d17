#!/bin/sh
# test_campaign.sh - `make campaign` on one small module: faults are killed, results are kept
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
BUILD=${BUILD:-build}
BENCH_BUILD=$BUILD python3 -m lab benches --tools >"$TMP/tools" 2>&1 || cat "$TMP/tools"
mkdir -p "$TMP/sim" "$TMP/test"
ln -s "$(realpath "$BUILD")/sim/obj" "$TMP/sim/obj"
ln -s "$(realpath "$BUILD")/libsphaera.a" "$TMP/libsphaera.a"
ln -s "$(realpath "$BUILD")/test/libhard.a" "$TMP/test/libhard.a"

key="mutants round=0 bench=tb_light_add/all seed=7 faults=rt_light_add:9"
run() { python3 -m lab mutants one "$TMP" "$key"; }
result() { cat "$TMP"/mutants/results/*.json; }
killed() { # all faults that were chosen, and no few
    python3 - "$(result)" <<'END'
import json
import sys
rows = json.loads(sys.argv[1])["result"]["rows"]
print(*rows, sep="\n")
sys.exit(len(rows) < 8 or any(row[-2] != "killed" for row in rows))
END
}
kept() { # a second run does nothing, one of a damaged result is made anew
    result >"$TMP/first" && run && result | cmp - "$TMP/first"
}
again() {
    sed -i 's/"killed"/"survived"/' "$TMP"/mutants/results/*.json && run && killed
}
sums() { # the page's tables and the list of faults are of one run
    python3 - <<'END'
import collections
import sys
from lab.pages import data
head, faults = data.read("verification.faults")
_, modules = data.read("verification.modules")
count = collections.Counter(row[0].split()[0] for row in faults)
sys.exit({row[0]: int(row[1]) for row in modules} != dict(count))
END
}
check "a bench with nine faults" run
check "all of them are killed" killed
check "a result that counts is not made anew" kept
check "a damaged one is" again
check "each equivalent fault has its reason, and stands in the sources" \
    python3 -m lab equivalents
check "each module's faults are in the list" sums
done_testing
