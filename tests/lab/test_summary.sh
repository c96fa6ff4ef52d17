#!/bin/sh
# test_summary.sh - which profile auto takes for the scenes of the pages, and what standard misses
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1

build=$(dirname "$SPHAERA")
check "what auto takes" python3 -m lab profiles "$build" "$TMP/profiles"
check "... is as the pages have it: make summary" \
    diff "$TMP/profiles" docs/results/data/profiles.tsv
check "headline figures are at the profile of auto, others say what standard misses" python3 -c "
from lab import summary
from lab.pages import data
head, rows = data.read(summary.AUTO)
takes = {row[0]: row[1] for row in rows}
head, rows = data.read('speed_and_area.speed')
for row in rows:
    scene, profile = row[0].split(',')[0], row[head.index('profile')]
    assert takes[scene] == profile, row
told = summary.misses('paper100', 'random:256', 'random:4096')
assert '\`random:4096\`' in told and 'random:256' not in told and 'paper100' not in told, told
assert 'for all of them' in summary.misses('paper100', 'paper5')
head, rows = data.read(summary.AUTO)
row = next(row for row in rows if row[0] == '\`random:4096\`')
summary.ENOUGH = float(row[head.index('dB of standard')])
assert 'for all of them' in summary.misses('random:4096'), 'as much as is asked for is missed'"
done_testing
