#!/bin/sh
# test_why.sh - lab/papers/why.py and the model, which share no code, find the same of the papers
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
tool=$BUILD/sphaera

says() { python3 -c "import json, sys
from pathlib import Path
from lab.pages import data
from lab.papers import why
$1"; }
"$tool" background scenes/views/off_axis.nff --size 160x90 --json "$TMP/off_axis.json" >/dev/null
check "the square loses the pixels that it loses in the model" says "
ways = json.load(open('$TMP/off_axis.json'))['ways']
model = next(way['wrong'] for way in ways if way['way'] == 'rect literal')
found = why.square()
print(model, found)
assert model == found['square_lost'] and found['square_angle'] == '44.4'"
check "so does the outline, but for pixels that a radius rounded up moves" says "
model = {row[0]: int(row[2]) for row in data.read('effects.background_series')[1]}
for points in 16, 64:
    left_out, between = why.outline(160, 90, points)
    print(points, model, left_out, between)
    assert abs(left_out - model[f'{points} x {points}']) <= 3 and between <= left_out"
"$tool" gen random -n 256 -o "$TMP/random.nff" >/dev/null
"$tool" render "$TMP/random.nff" --tree paper --traverse first --interpenetrate off --depth 0 \
    --shadow off --size 64x36 --profile reference --json "$TMP/random.json" >"$TMP/said" 2>&1
check "the paper's tree and walk test as many spheres as the model's" says "
count = json.load(open('$TMP/random.json'))['counters']
model = 1 + count['child_tests'] / count['rays_primary']
seen = why.view(Path('$TMP/random.nff').read_text().splitlines())
root, rays = why.by_z(seen.balls), why.rays(seen, 64, 36)
found = sum(why.at_once(root, way) for _, way in rays) / len(rays)
print(model, found)
assert abs(found / model - 1) < .02"
mkdir "$TMP/why"
check "Listing 3.5 is wrong in most pixels that see a sphere, and in none by the ray's direction" \
    says "
found = why.listings('$tool', '$TMP/why')
print(found)
assert found['listing_aware'] == 0 < found['listing_seen'] / 2 < found['listing_printed']"
check "a P_b by its definition falls by 1 with twice the texels a side; the printed rises by 2" \
    says "
found = {name: float(value) for name, value in why.base(None, None).items()}
assert abs(found['base_true'] - found['base_true_512'] - 1) < .11, found
assert abs(found['base_printed_512'] - found['base_printed'] - 2) < .11, found"
done_testing
