# test_study.sh - the study of accuracy and time: small jobs end to end, broken results, the page
# SPDX-License-Identifier: Apache-2.0
#
# The short form of the study (pictures and the price of one scene, one RTL frame on a core that
# other tests build too, no synthesis), then what must not happen: a job done twice, half a file, a
# damaged result that counts. lab/checks/page.py checks the page's numbers on results that are made
# up.
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
BUILD=${BUILD:-build} tool=${SPHAERA:-$BUILD/sphaera}
export STUDY_OPT=-O0 TMPDIR="$TMP"
results=$TMP/results

plan() { python3 -m lab study-plan --short "$@" "$tool" "$BUILD" "$results" "$TMP/jobs"; }
jobs() { env -u MAKEFLAGS -u MFLAGS python3 -m lab jobs make "$TMP/jobs"; }
run() { python3 -m lab sweep-job "$tool" "$BUILD" "$results" "$1"; }
has() { grep -q -- "$1" "$2"; }
says() { # pattern, command: its output has the pattern, whatever its exit code
    pattern=$1
    shift
    "$@" >"$TMP/said" 2>&1
    cat "$TMP/said"
    has "$pattern" "$TMP/said"
}
count() { ls "$results" | wc -l; }
state() { ls -l --time-style=full-iso "$results"; }
mine() { python3 -c "from lab.jobs import store
from lab.sweep import axes
print($1)"; }

# ---- all of it, twice ----
check "five jobs to run" says '5 jobs, 5 to run' plan
check "all jobs run" jobs
check "a file each, and nothing else" [ "$(count)" = 5 ]
state >"$TMP/before"
check "nothing to run" says '5 jobs, 0 to run' plan
check "... and nothing is run" jobs
key=$(mine "axes.job('accuracy', scene='paper5', size='32x18')")
file=$(mine "store.path('$results', '$key')")
check "a job that is there is not done again" run "$key"
state >"$TMP/after"
check "no file was touched" cmp "$TMP/before" "$TMP/after"
check "model and RTL made the same visits" python3 -c "
from lab.jobs import store
from lab.sweep import axes
core = dict(effects='shadow+reflect2+lights1', scene='paper5', size='32x18')
rtl = store.look('$results', axes.job('cycles', **core))[0]['counters']
model = store.look('$results', '$key')[0]['counters']
assert rtl['node_visits'] == model['node_visits'] > 0 and rtl['cycles'] >= rtl['node_visits'], rtl"

# ---- results that do not count ----
cp "$file" "$TMP/good"
sed -i 's/"pixels": 576/"pixels": 577/' "$file"
check "a digit changed is noticed" says "$file is damaged" plan
check "... and the job is to run" says '5 jobs, 1 to run' plan
head -c 300 "$TMP/good" >"$file"
check "half a file is noticed" says "$file is damaged" plan
check "... and made anew" jobs
check "... as it was, but for the time" sh -c "grep -v 'seconds\|check' '$file' >'$TMP/new' &&
    grep -v 'seconds\|check' '$TMP/good' | cmp - '$TMP/new'"
other=$(mine "store.path('$results', axes.job('accuracy', scene='paper5', size='32x18',
    profile='draft'))")
cp "$other" "$file"
check "the result of another job is noticed" says "$file is damaged" plan
cp "$TMP/good" "$file"
check "sources that change are noticed, a write that breaks leaves nothing" \
    python3 -m lab.checks.jobs "$TMP/folder"
mkdir "$TMP/whole"
check "four that write one file at once leave it whole, and so does each call that fails" \
    python3 -m lab.checks.intact "$TMP/whole"

# ---- jobs that fail or are killed ----
slow=$TMP/slow
printf '#!/bin/sh\necho started >%s/started\nexec sleep 60\n' "$TMP" >"$slow"
chmod +x "$slow"
rm "$file"
python3 -m lab sweep-job "$slow" "$BUILD" "$results" "$key" >"$TMP/killed" 2>&1 &
victim=$!
tries=0
while [ ! -f "$TMP/started" ] && [ $tries -lt 100 ]; do sleep 0.1 && tries=$((tries + 1)); done
kill -9 $victim
check "a killed job leaves no file" sh -c "[ -f '$TMP/started' ] && [ ! -e '$file' ]"
check "... and is to run" says '5 jobs, 1 to run' plan
check "... and then there" sh -c "python3 -m lab jobs make '$TMP/jobs' && [ -f '$file' ]"
refused=$(mine "axes.job('accuracy', scene='huge_tiny', size='32x18', profile='draft')")
check "a scene that the profile refuses is a result" run "$refused"
check "... that says why" has 'nothing on the grid' "$(mine "store.path('$results', '$refused')")"
before=$(count)
no() { ! "$@"; }
check "no such scene: the job fails" no run "$(mine "axes.job('accuracy', scene='x', size='8x8')")"
check "no such profile: the job fails" no run "$(mine "axes.job('accuracy', scene='paper5',
    size='8x8', profile='huge')")"
for bad in "measure=tea" "profile=draft" "measure=cells effects=all" "$key more=1" ""; do
    check "no job: '$bad'" says "^sweep: .*'$bad'" no run "$bad"
done
check "no result of any of these" [ "$(count)" = "$before" ]

# ---- the page, and place and route ----
check "numbers, dashes and plots of the page" python3 -m lab.checks.page "$TMP/page"
check "what nextpnr reports, in short" python3 -m lab.checks.placed "$TMP"
check "families of slow paths" python3 -m lab.checks.families "$TMP"
if command -v nextpnr-ecp5 >"$TMP/which"; then
    echo "ok $((checks += 1)) - # SKIP there is a nextpnr-ecp5"
else
    check "without nextpnr-ecp5 it says so" says 'no nextpnr-ecp5' \
        env BUILD="$TMP" sh synth/place.sh "$TMP" "$TMP"
fi
done_testing
