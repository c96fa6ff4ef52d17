#!/bin/sh
# test_second_readers.sh - what the tool reads, by readers that share no code with it
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
molecules=/usr/share/pymol/data/demo

for kind in rings tree mount jacks; do
    "$SPHAERA" gen $kind --size 1 -o "$TMP/$kind.nff" >"$TMP/text"
done
check "NFF, from the format's text" python3 tests/tool/second_nff.py "$SPHAERA" scenes/[!e]*.nff \
    scenes/facets/*.nff scenes/refraction/*.nff scenes/texture/*.nff "$TMP"/[jmrt]*.nff
cp "$TMP/out" "$TMP/read"
check "... cones among them" grep -q ' [1-9][0-9]* cones.*: the same' "$TMP/read"
changed() { # a scene and a number of it changed: it is noticed
    sed "$2" "$1" >"$TMP/changed.nff"
    ! python3 - "$SPHAERA" "$1" "$TMP/changed.nff" <<'END'
import sys
sys.path.insert(0, "tests/tool")
import second_nff
read = second_nff.read
second_nff.read = lambda text: read(open(sys.argv[3], encoding="utf-8").read())
sys.exit(second_nff.main(*sys.argv[1:3]))
END
}
check "... notices another radius" changed scenes/paper5.nff '0,/^s /s/^\(s .*\)[0-9]$/\19/'
check "... another corner" changed scenes/facets/room.nff \
    '0,/^p /s/^p 4  -3 0 -2/& .5/; 0,/^p /s/-2 .5/-2.5/'
check "... another light" changed scenes/paper5.nff 's/^l /l 1/'

for python in python3 /usr/bin/python3; do # another python3 may come first in the PATH
    "$python" tests/tool/second_atoms.py "$SPHAERA" "$TMP" $molecules/1tii.pdb $molecules/pept.pdb \
        >"$TMP/out" 2>&1
    rc=$?
    [ $rc -eq 3 ] || break
done
if [ $rc -eq 3 ]; then
    echo "ok $((checks += 1)) - # SKIP there is no gemmi (make gemmi-setup)"
else
    tap $rc "molecules, by gemmi" "$TMP/out"
fi
done_testing
