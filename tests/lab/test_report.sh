#!/bin/sh
# test_report.sh - what `make sim` leaves to look at: the page in a real browser, JSON, CSV; a fault
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
export BUILD

# A small frame in Icarus.
sim() {
    env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL make --no-print-directory sim B="$BUILD" JOBS=1 \
        SIM=icarus SCENE=paper5 PROFILE=draft SIZE=12x8 "$@"
}
rm -f "$TMP/runs.csv" "$TMP/jobs.csv"

# What a run counts is of one core, whatever the processors of the host; both passes are named.
for jobs in 1 2 4; do
    sim SIZE=12x24 WARM=1 JOBS=$jobs CSV="$TMP/jobs.csv" | grep '^core ' >"$TMP/jobs.$jobs"
done
named() { # the figures of the terminal are those of the table, pass by pass
    python3 - "$TMP/jobs.csv" "$TMP/jobs.1" <<'CHECK'
import csv, re, sys
rows = list(csv.DictReader(open(sys.argv[1])))
told = dict(re.findall(r"(cold|warm) caches: (\d+) cycles", open(sys.argv[2]).read()))
assert [r["caches"] for r in rows] == ["cold", "warm"] * 3, rows
assert all(r["cycles"] == told[r["caches"]] for r in rows), (told, rows)
assert told["cold"] != told["warm"], told
CHECK
}
check "cycles do not depend on JOBS" sh -c "cmp '$TMP/jobs.1' '$TMP/jobs.2' &&
    cmp '$TMP/jobs.1' '$TMP/jobs.4'"
check "the terminal and the table tell both passes, by name" named

check "a run leaves a page" sim CSV="$TMP/runs.csv"
run=$TMP/run wrong=$TMP/wrong
# the link `last` may be of another suite's run
cp -r "$(sed -n 's,^pictures and report in \(.*\)/$,\1,p' "$TMP/out")" "$run"
python() { PYTHONPATH=. python3 -c "import sys
from lab.report.run import Run
run = Run(sys.argv[1])
$2" "$1"; }
report() { python3 -m lab report "$@"; }

check "... of one file: nothing is asked for elsewhere" sh -c "! grep -oE \
    '(src|href)=\"[^\"]*\"|url\([^)]*\)|@import' '$run/report.html' | grep -vE '\"(data:|$)'"
check "... that says that Icarus ran" grep -q 'Icarus Verilog.*start as x' "$run/report.html"
check "... and how to repeat it" grep -q "make sim .*SIZE='*12x8" "$run/command"
check "the last pixel left in the last cycle" python "$run" \
    "assert max(run.left) == run.last['counters']['cycles'], max(run.left)"
check "every traced pixel was in flight, none longer than the frame" python "$run" \
    "took = run.in_flight(); assert min(took) > 0 and max(took) <= max(run.left), took"

check "two walks start in the two halves and take turns" python "$run" \
    "from lab.report import frames
halves = frames.halves((0, 0, 31, 2), 2)
assert halves == [(0, 0, 16, 2), (16, 0, 31, 2)], halves
order = frames.in_turn(list(frames.walk(half)) for half in halves)
assert order[:3] == [(0, 0), (16, 0), (1, 0)] and len(order) == 62, order"
cp -r "$run" "$TMP/two"
sed 's/^PIPES=.*/PIPES=2/' "$run/key" >"$TMP/two/key"
check "... of a core with two pipes" python "$TMP/two" \
    "assert run.parameters['WALKS'] == 2 and len(run.in_flight()) == 96, run.parameters"

check "... the roofline is on the page" grep -q 'limit is <b>[a-z]' "$run/report.html"
axes() { # numbers: two or more below, on one height, and as many at the left
    grep -o 'aria-label="roofline".*</svg>' "$1" | grep -oE '<text [^>]*>[0-9.e+-]+<' |
        sed 's/.* y="\([0-9]*\)".*/\1/' | sort | uniq -c |
        awk '{ print; if ($1 > 1) below += $1; else left++ } END { exit below < 2 || left < 2 }'
}
check "... with numbers on its axes" axes "$run/report.html"
parted=$TMP/parted # the same with what Verilator says of a part
cp -r "$run" "$parted"
python3 - "$parted/report.json" <<'END'
import json, sys
report = json.load(open(sys.argv[1]))
report["memory"].update(name="sdram16", part="a part", peak_bytes_per_clock=1e-3)
report["cold"]["memory"] = dict(lines=100, row_hits=75, row_opens=15, row_conflicts=10, refreshes=3,
                                owing=700, bound=60, bytes_per_pixel=33.0, row_hit_share=0.75,
                                bound_share=0.25)
json.dump(report, open(sys.argv[1], "w"))
END
check "a part's figures are there too" report "$parted" --csv "$TMP/parted.csv"
spaced="$TMP/a folder's"
cp -r "$parted" "$spaced"
opens() { # the address that is told leads to the page
    said=$(report "$spaced") && python3 -c "import sys, urllib.request
page = urllib.request.urlopen(sys.argv[1].removeprefix('look at ')).read()
assert b'has it (a part' in page" "$said"
}
check "it tells an address that opens the page" opens
for word in 'limit is <b>memory' '75.0%' '25.0%' 'has it (a part; the core at 84 MHz)'; do
    check "... $word" grep -q "$word" "$parted/report.html"
done
check "... and in the table" sh -c "sed -n 1p '$TMP/parted.csv' |
    grep -q ',memory,core_mhz,bytes_per_pixel,row_hit_share,bound_share,' &&
    grep -q ',sdram16,84,33.0,0.75,0.25,' '$TMP/parted.csv'"

check "... and without Verilator it is said that units are not counted" \
    grep -q 'Verilator alone counts every unit' "$run/report.html"
counted=$TMP/counted # the same with what Verilator counts
cp -r "$run" "$counted"
python3 - "$counted/report.json" <<'END'
import json, sys
report = json.load(open(sys.argv[1]))
clocks = report["cold"]["counters"]["cycles"]
report["cold"]["limit"] = dict(binds=True, unit="roots", busy=0.9, said="roots: busy in 90.0 %")
report["cold"]["units"] = [
    dict(name=name, units=many, busy=0.9 / many, taken=7, clocks=int(0.9 * clocks), binds=0,
         turned_away=0) for name, many in (("roots", 1), ("quotients", 2), ("highlights", 3))]
json.dump(report, open(sys.argv[1], "w"))
END
check "units that Verilator counted are on the page" report "$counted"
for word in '<b>roots: busy in 90.0 %' '<span>quotients<.*45.0%' '<span>highlights<.*30.0%'; do
    check "... $word" grep -q "$word" "$counted/report.html"
done

valid() { python3 -W ignore -m jsonschema -i "$1" docs/reference/simulation.schema.json; }
check "report.json is as its schema has it" valid "$run/report.json"
sed 's/"mismatches": 0/"mismatches": -1/' "$run/report.json" >"$TMP/broken.json"
check "... a part's too" valid "$parted/report.json"
check "... and one with units" valid "$counted/report.json"
check "... which notices what is wrong" sh -c "! $(command -v python3) -W ignore -m jsonschema -i \
    '$TMP/broken.json' docs/reference/simulation.schema.json >/dev/null 2>&1"

# ---- CSV ----
columns() { python3 -c "import csv, sys
rows = list(csv.DictReader(open('$TMP/runs.csv')))
assert len(rows) == $1 and rows[0]['cycles'] == rows[-1]['cycles'] > '0', rows
assert rows[0]['scene'] == 'paper5' and rows[0]['mismatches'] == '0', rows"; }
check "the run is a row below a header" columns 1
check "another row" report "$run" --csv "$TMP/runs.csv"
check "... has no header" columns 2
sed -i '1s/,seed,/,sead,/' "$TMP/runs.csv"
cp "$TMP/runs.csv" "$TMP/kept.csv"
refuses() { # words of the message, command
    words=$1
    shift
    "$@" >"$TMP/said" 2>&1 && return 1
    cat "$TMP/said"
    grep -q -- "$words" "$TMP/said"
}
check "a file with another header is refused" refuses "sead, seed in one of them alone" \
    report "$run" --csv "$TMP/runs.csv"
check "... and left alone" cmp "$TMP/runs.csv" "$TMP/kept.csv"

# ---- a fault ----
# A byte of L2 of pixel 6,4 of the core: the page has to find it by itself.
cp -r "$run" "$wrong"
python3 - "$wrong" <<'END'
import json, struct, sys
from pathlib import Path
folder = Path(sys.argv[1])
data = bytearray((folder / "rtl.frame").read_bytes())
at = len(data) - 8 - 32 * (12 * 8 - (4 * 12 + 6)) + 8
data[at] ^= 0x40
total = 0xcbf29ce484222325
for byte in data[:-8]:
    total = (total ^ byte) * 0x100000001b3 % 2**64
data[-8:] = struct.pack("<Q", total)
(folder / "rtl.frame").write_bytes(data)
report = json.loads((folder / "report.json").read_text())
report.update(mismatches=1, repeat="sim/core.sh --window 6,4,7,5 --trace pixel.fst")
(folder / "pixel.fst").touch()
(folder / "report.json").write_text(json.dumps(report))
END
check "a run with a fault has a page too" report "$wrong"
check "... that names the pixel" grep -q 'first wrong pixel is <b>6, 4</b>' "$wrong/report.html"
check "... what differs, and that alone" sh -c "grep -o '<tr class=\"wrong\"><td>[a-z0-9]*' \
    '$wrong/report.html' | grep -x '.*<td>l2'"
check "... its rays" grep -q '<b>primary</b>: id [0-9]*, key' "$wrong/report.html"
check "... its waveform" grep -q 'the pixel alone.*<a href="pixel.fst">' "$wrong/report.html"
check "... and the command that makes a waveform" grep -q -- '--trace .*/wrong/pixel.fst' \
    "$wrong/report.html"
check "the sound run says nothing of it" sh -c "! grep -q 'What is wrong' '$run/report.html'"
head -c 100 "$run/rtl.clocks" >"$wrong/rtl.clocks"
check "a file that is cut is refused" refuses "clocks of 25 pixels, not of 12x8" report "$wrong"

# ---- the gallery ----
mkdir -p "$TMP/gallery/facets"
for name in paper5 materials facets/plane; do
    "$SPHAERA" render "scenes/$name.nff" --size 32x18 --samples 2 -o "$TMP/gallery/$name.png" \
        --json "$TMP/gallery/$name.json" >"$TMP/drawn" 2>&1
done
check "three scenes on a page" python3 -m lab gallery "$TMP/gallery" "$TMP/gallery.html"
figures() { grep -o '<figure id="[^"]*"' "$TMP/gallery.html" | tr -d '\n'; }
check "... sorted into groups" [ "$(figures)" = \
    '<figure id="materials"<figure id="paper5"<figure id="facets/plane"' ]
check "... with what they are" grep -q '5 spheres and 1 light; shadow, reflect' "$TMP/gallery.html"
drawn() { env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL make -n B="$TMP/none" gallery |
    grep -c 'sphaera render scenes/'; }
check "make gallery draws every scene" [ "$(drawn)" = "$(find scenes -name '*.nff' | wc -l)" ]

# ---- frames of a moving scene, as `make sim TOP=1` leaves them ----
mkdir "$TMP/film"
for frame in 0 1; do
    oiiotool "$TMP/gallery/paper5.png" --mulc 1,1,0.$((9 - 3 * frame)) \
        -o "$TMP/film/shown-000$frame.ppm"
done
cat >"$TMP/film/report.json" <<'END'
{"input": "scenes/moving/orbit.nff", "frames": [
 {"at": 3, "build_seconds": 0.01, "refitted": false, "memory_bytes": 320, "upload_cycles": 400,
  "draw_cycles": 31758, "image_cycles": 31913, "pixels_a_burst": 6.33},
 {"at": 4, "build_seconds": 0.001, "refitted": true, "memory_bytes": 320, "upload_cycles": 446,
  "draw_cycles": 30792, "image_cycles": 30988, "pixels_a_burst": 6.59}]}
END
check "the page of a moving scene" python3 -m lab film-report "$TMP/film" "make sim TOP=1"
pixels() { # of the second picture in the page are those of the file
    python3 -c "import base64, re, sys
page = open('$TMP/film/report.html').read()
png = re.findall('base64,([^\"]*)\" alt=\"frame 4', page)[0]
open('$TMP/film/second.png', 'wb').write(base64.b64decode(png))" &&
        oiiotool "$TMP/film/second.png" "$TMP/film/shown-0001.ppm" --diff
}
check "... has the pictures bit by bit" pixels
rm "$TMP/film/shown-0001.ppm"
check "a picture that is missing is refused" refuses "1 pictures of 2 frames" \
    python3 -m lab film-report "$TMP/film"

# ---- a browser ----
python3 -m lab browse --there || {
    for page in report wrong gallery film; do
        echo "ok $((checks += 1)) - $page.html in a browser # SKIP no Chromium: make browser-setup"
    done
    done_testing
    exit
}
cp "$run/rtl.clocks" "$wrong"
report "$wrong"
PYTHONPATH=. python3 tests/lab/browse.py "$TMP" "report=$run/report.html" \
    "wrong=$wrong/report.html" "gallery=$TMP/gallery.html" "film=$TMP/film/report.html" \
    >"$TMP/browsed" 2>&1
browsed() { # kind: what was seen there, and nothing that is wrong
    sed -n "/^$1\$/,/complains of nothing/p" "$TMP/browsed" >"$TMP/seen"
    cat "$TMP/seen" && grep -q 'complains of nothing' "$TMP/seen" && ! grep -q WRONG "$TMP/seen"
}
check "the page in Chromium" browsed report
check "the page of a fault" browsed wrong
check "the gallery" browsed gallery
check "the moving scene" browsed film
done_testing
