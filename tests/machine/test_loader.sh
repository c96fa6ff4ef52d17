#!/bin/sh
# test_loader.sh - a loader that knows docs/reference/machine_file.md alone reads what the tool
# wrote
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
page=docs/reference/machine_file.md

loads() { # page, machine
    "$SPHAERA" info "$2" >"$TMP/info" && python3 - "$1" "$2" "$TMP/info" <<'LOADER'
import re, struct, sys
page, machine, info = sys.argv[1:]
told = re.sub(r"<!--.*?-->", "", open(page, encoding="utf-8").read())
data = open(machine, "rb").read()
TYPE = {"u32": "I", "s32": "i", "f64": "d"}
field = {}
for at, name, what in re.findall(r"^\| *(\d+) *\| ([^|]+?) *\| ([^|]+?) *\|$", told, re.M):
    count, kind = re.fullmatch(r"(?:(\d+) )?(\w+)", what).groups()
    size = int(count or 1)
    field[re.match(r"[\w ]+", name)[0].strip()] = (
        data[int(at):int(at) + size] if kind == "bytes"
        else struct.unpack_from(f"<{size}{TYPE[kind]}", data, int(at)))
assert field["magic"] == b"SPHAERA1", field["magic"]
begin, line = map(int, re.search(r"file has\s+(\d+) \+\s+(\d+) \* lines", told).groups())
lines = field["lines of memory"][0]
assert field["bytes before memory"] == (begin,), (field["bytes before memory"], begin)
assert begin == int(re.search(r"From byte\s+(\d+) on", told)[1])
assert len(data) == begin + line * lines + 8, (len(data), begin, line, lines)
registers = next(value for name, value in field.items() if name.startswith("registers"))
assert field["number of registers"] == (len(registers),), len(registers)
shown = dict((int(n), int(v)) for n, v in
             re.findall(r"^ +(\d+) [A-Z_0-9]+ +(-?\d+) 0x", open(info).read(), re.M))
assert shown and all(registers[n] == v for n, v in shown.items()), "registers"
fnv = 0xcbf29ce484222325
for byte in data[:-8]:
    fnv = (fnv ^ byte) * 0x100000001b3 & (1 << 64) - 1
assert fnv == struct.unpack("<Q", data[-8:])[0], "FNV-1a"
word = struct.unpack_from("<8I", data, begin)   # the root: its children begin behind it
assert 0 < word[7] & 0x3ffffff < lines, word
LOADER
}
"$SPHAERA" build scenes/paper5.nff --size 32x18 -o "$TMP/m.sph" >"$TMP/log" 2>&1
check "a loader written from the page" loads $page "$TMP/m.sph"
sed 's/^| 280 /| 276 /' $page >"$TMP/page.md"
off() { ! loads "$TMP/page.md" "$TMP/m.sph"; }
check "... not from a page whose number is off" off
done_testing
