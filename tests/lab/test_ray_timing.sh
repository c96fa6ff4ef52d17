#!/bin/sh
# test_ray_timing.sh - the picture of a pixel's rays, from the run that is kept
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1

table=docs/results/data/ray_timing.tsv picture=docs/pictures/ray_timing.svg
python3 -c "from lab import ray_timing
ray_timing.main('$table', '$TMP/ray.svg')"
check "the picture is that of the table: python3 -m lab ray-timing ray_timing" \
    cmp "$TMP/ray.svg" $picture
check "bars, rays and surfaces of lines as the bench prints them" python3 -c "
from lab import ray_timing
events = ray_timing.rows('''ray 0 primary | set-up  org 0x1 (=1)  clock 20
ray 0 primary | node visit 1  line 0  clock 61
ray 0 primary | filter visit 1 child 0  pass 1  clock 70
ray 0 primary | sphere visit 1 id 0  hit 1  clock 117
ray 0 primary | sphere visit 1 id 1  hit 1  clock 119
ray 0 primary | root visit 1 id 0  root 0x2  clock 136
ray 0 primary | key visit 1 id 0  key 0x3  clock 136
ray 0 primary | hit  found 1  clock 150
ray 0 primary | quotient  t 0x4  clock 167
ray 0 primary | point  guarded 0x5  clock 221
ray 0 primary | material  rgb 0x6  clock 200
ray 0 primary | colour  rgb 0x7  (model only)
ray 1 reflected | set-up  org 0x8  clock 268
ray 1 reflected | hit  found 0  clock 288
pixel  rendering 0x9  clock 300
15 lines of pixel 8,6: model and RTL agree'''.splitlines())
names = [row[0] for row in ray_timing.ROWS]
found = [(names[row], begin, end) for row, begin, end in ray_timing.bars(events)]
wanted = [('set-up', 0, 20), ('issue, node cache', 20, 61), ('filters', 61, 70),
          ('leaf test', 70, 119), ('root, key', 119, 136), ('collect', 136, 150),
          ('quotient', 150, 167), ('record', 167, 200), ('point', 167, 221),
          ('reflect, set-up', 221, 268), ('collect', 268, 288), ('delivery', 288, 300)]
assert found == wanted, found
found = ray_timing.spans(events)
assert found == [('primary', 0, 150), ('surface', 150, 268), ('reflected', 268, 288),
                 ('surface', 288, 300)], found"
done_testing
