#!/bin/sh
# test_tutorial.sh - what the tutorial shows is what its commands print
# SPDX-License-Identifier: Apache-2.0
#
# The RTL's lines are the model's: tests/core/test_stages.sh.
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
page=${PAGE:-docs/guide/tutorial.md} scene=examples/tutorial/three.nff

sed -n '/^v  /,/^```/p' "$page" | sed 's/ *#.*//; /^```/d' >"$TMP/shown.nff"
check "the scene" sh -c "grep -v '^#' $scene | cmp - '$TMP/shown.nff'"
check "its machine" "$SPHAERA" build $scene --profile draft -o "$TMP/three.sph"
cp "$TMP/out" "$TMP/built"
"$SPHAERA" export "$TMP/three.sph" --hex="$TMP/three"
"$SPHAERA" info "$TMP/three.sph" --pixel 20,17 --stages >"$TMP/stages"
for profile in draft standard; do
    "$SPHAERA" accuracy $scene --profile $profile >>"$TMP/built" 2>"$TMP/warned"
done
check "effects, memory, stages, accuracy" python3 - "$page" "$TMP" <<'EOT'
import re
import sys
page, folder = sys.argv[1:]
text = open(page, encoding="utf-8").read()
printed = {name: open(f"{folder}/{name}", encoding="utf-8").read()
           for name in ("built", "stages", "three.mem.hex")}
shown = [("built", line) for line in re.findall("^(?:effect|psnr|pixels|wrong)  .*", text, re.M)]
shown += [("three.mem.hex", word) for word in re.findall("^[0-9a-f]{64}", text, re.M)]
numbers = re.findall(r"0x[0-9a-f]+ \(=[^)]*\)", text.partition("## 4.")[0])
shown += [("stages", number) for number in numbers]
assert {name for name, _ in shown} == set(printed), "the page shows nothing of a file"
lacking = [f"{name}: {what}" for name, what in shown if what not in printed[name]]
assert not lacking, "\n".join(lacking)
disc = int(re.search("disc 0x([0-9a-f]+)", text)[1], 16)
a, b, k = (int(n.replace(" ", "")) for n in re.search(
    "b is ([0-9 ]+), k is (-[0-9 ]+) and a is ([0-9 ]+)\\.", text).group(3, 1, 2))
assert k * a + b * b == disc and f"k is {k:,}".replace(",", " ") in text, (a, b, k, disc)
EOT
cp -r rtl "$TMP/rtl"
edit=$(sed -n "s,^    \(python3 -m lab faults edit\) build/rtl-wrong,\1 $TMP/rtl,p" "$page")
check "the fault's text stands once in the RTL" sh -c "${edit:-false}"
done_testing
