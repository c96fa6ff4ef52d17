# test_sweep.sh - sphaera sweep: points, CSV, plots, what stands beside, what is not measured again
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
root=$PWD
BUILD=${BUILD:-build} tool=${SPHAERA:-$BUILD/sphaera}
BUILD=$(realpath "$BUILD") tool=$(realpath "$tool")
export BUILD STUDY_OPT=-O0 RESULTS="$TMP/results"
cd "$TMP" || exit 1

sweep() { env -u MAKEFLAGS -u MFLAGS "$tool" sweep "$@"; }
says() { # exit code, pattern, command
    want=$1 pattern=$2
    shift 2
    "$@" >"$TMP/said" 2>&1
    rc=$?
    cat "$TMP/said"
    [ $rc = "$want" ] && grep -qE -- "$pattern" "$TMP/said"
}
cell() { # file, row, column
    python3 - "$@" <<'END'
import csv, sys
rows = list(csv.DictReader(open(sys.argv[1], encoding="utf-8")))
print(rows[int(sys.argv[2])][sys.argv[3]])
END
}

# ---- the golden model: what the CSV says is what `render` says ----
small="--scene paper5 paper100 --size 16x9 --depth 0..1"
# shellcheck disable=SC2086  # words on purpose
{
    check "four points are measured" says 0 '4 jobs, 4 to run' sweep $small --out one --jobs 2
    check "... a row each, and the first line" [ "$(wc -l <one/sweep.csv)" = 5 ]
    "$tool" render paper100 --profile standard --size 16x9 --depth 1 --json report.json >log
    check "... with render's counters" [ "$(cell one/sweep.csv 3 node_visits)" = \
        "$(sed -n 's/.*"node_visits": \([0-9]*\).*/\1/p' report.json)" ]
    check "... and a plot with the values of its axis" \
        grep -q '>paper100<\|scene paper100' one/node_visits_per_ray.svg
    check "nothing is measured again" says 0 '4 jobs, 0 to run' sweep $small --out two
    check "... and gives the same, byte by byte" cmp one/sweep.csv two/sweep.csv
    rm "$(find results -name '*.json' | head -n 1)"
    check "a sweep goes on where it was" says 0 '4 jobs, 1 to run' sweep $small --out two --jobs 7
    check "... to the same" cmp one/sweep.csv two/sweep.csv
    check "--list runs nothing" says 0 '4 points, 4 jobs, 4 to run' env RESULTS=none \
        "$tool" sweep $small --list
    check "... and makes nothing" [ ! -e none ]
}

# ---- a file of words, and a part of it replaced ----
cat >s.txt <<'END'
# a comment
scene paper5        # of scenes/
size 16x9
show node_visits
also
pq 11..13
also
profile draft
END
check "parts of a file are put together" says 0 '4 points, 4 jobs' sweep s.txt --list
check "what stands behind the file counts" says 0 '8 points' sweep s.txt --depth 0 1 --list
cp "$root/scenes/paper5.nff" "own scene.nff"
check "a file of one's own, by where one is" says 0 '2 jobs, 2 to run' \
    sweep --scene "own scene.nff" --profile draft standard --size 8x6 --out own
check "... is not measured again" says 0 '0 to run' \
    sweep --scene "$PWD/own scene.nff" --profile draft standard --size 8x6 --list
echo "# changed" >>"own scene.nff"
check "... but when it changes" says 0 '2 jobs, 2 to run' \
    sweep --scene "own scene.nff" --profile draft standard --size 8x6 --list

# ---- the RTL, on a core that test_study has too; what is refused; another version of a tool ----
check "cycles, of a core held against the model" says 0 '3 jobs, 3 to run' sweep --measure cycles \
    counts --scene paper5 --size 16x9 --effects shadow+reflect2+lights1 --latency 20 200 --out rtl
check "... more clocks behind slower memory" python3 -c "
import csv
rows = list(csv.DictReader(open('rtl/sweep.csv')))
assert int(rows[1]['cycles']) > int(rows[0]['cycles']) >= int(rows[0]['node_visits']), rows
assert 'Verilator' in rows[0]['tools'], rows"
check "what a profile refuses is a row" says 0 'huge_tiny .*nothing on the grid' \
    sweep --scene huge_tiny paper5 --profile draft --size 8x6 --out refused
mkdir bin
cells="--measure cells --effects none --profile draft"
versioned() { # version: how many jobs are to run with that Yosys
    printf '#!/bin/sh\necho "Yosys %s (git)"\n' "$1" >bin/yosys && chmod +x bin/yosys
    # shellcheck disable=SC2086  # words on purpose
    PATH=$TMP/bin:$PATH sweep $cells --list
}
versioned 1 >said
(cd "$root" && PATH=$TMP/bin:$PATH python3 -c "
from lab.jobs import store
from lab.sweep import axes
store.save('$RESULTS', axes.job('cells', effects='none', profile='draft'), ['tool:yosys'], {})")
check "what one Yosys has made counts" says 0 ' 0 to run' versioned 1
check "... and not for another one" says 0 ' 1 to run' versioned 2

# ---- figures of others ----
printf '# a paper\nscene,node_visits,source\npaper5,100,p. 3\npaper9,7,p. 4\n' >paper.csv
check "a figure beside, and its ratio" says 0 'paper5 .* 100  [0-9.]+$' \
    sweep --scene paper5 one_sphere --size 16x9 --show node_visits --beside paper.csv --out beside
check "... a row that no point is, is told" \
    grep -q 'paper.csv: no point of this sweep is paper9' said
check "... is a column of the CSV" [ "$(cell beside/sweep.csv 0 node_visits_beside)" = 100 ]
check "... empty where there is none" [ -z "$(cell beside/sweep.csv 1 node_visits_beside)" ]
check "maps side by side" says 0 'leaf_tests.svg' sweep s.txt --scene paper5 paper100 --pq 11 12 \
    --profile standard --heat scene pq --show leaf_tests --beside "$TMP/one/sweep.csv" --out maps
check "... as SVG" python3 -c "import xml.dom.minidom as x; x.parse('maps/leaf_tests.svg')"

printf "scene paper5\nsie 8x6\n" >s2.txt
printf "depth 11\n" >s3.txt
printf "scene,leaf_test\npaper5,1\n" >b.csv
printf "scene,leaf_tests\npaper5\n" >ragged.csv
# ---- what is wrong is told, with what may be meant ----
while IFS='|' read -r pattern words; do
    check "wrong: $words" eval "says 2 '$pattern' sweep $words"
done <<'END'
no axis and no word pofile; is profile meant|--scene paper5 --pofile draft
is no file, and no scene; is paper100 meant|--scene papr100
profile: .*is standard meant|--scene paper5 --profile standart
depth: 99 is none of 0 to 10|--scene paper5 --depth 99
pq is 99, not in|--scene paper5 --pq 99
tree: papr is none of .*is paper meant|--scene paper5 --tree papr
measure: cicles is none of .*is cycles meant|--scene paper5 --measure cicles
latency shapes none of what is measured|--scene paper5 --latency 20
no scene is given|--profile draft
depth: no value is given|--scene paper5 --depth
depth: 1 stands there twice|--scene paper5 --depth 0..1 1
depth: 9..0 is no range|--scene paper5 --depth 9..0
x: dpth is no axis with several values here; is depth meant|--scene paper5 --depth 0 1 --x dpth
is no file, and no --AXIS stands before|s.txt t.txt
s2.txt:2: there is no axis and no word sie; is size meant|s2.txt
s3.txt:1: depth: 11 is none of|s3.txt
nothere.txt: No such file|nothere.txt
nothere.csv: No such file|--scene paper5 --beside nothere.csv
leaf_test is no axis and no figure of this sweep; is leaf_tests|--scene paper5 --beside b.csv
row 1 has not as many columns|--scene paper5 --size 8x6 --beside ragged.csv
there is no figure visit|--scene paper5 --size 8x6 --show visit
--jobs: x is no number|--scene paper5 --jobs x
--engine: slum is none of make, slurm; is slurm meant|--scene paper5 --engine slum
END
done_testing
