#!/bin/sh
# test_faults.sh - full disks, signals, kills and two runs at once; memory that a file asks for
# SPDX-License-Identifier: Apache-2.0
#
# Some commands and some places; `make faults` goes through all of them.
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
s=$SPHAERA
has() { grep -q -- "$1" "$TMP/err"; }

python3 tests/tool/faults.py "$s" "$TMP/faults" --some 2 build gen >"$TMP/lines"
python3 tests/tool/faults.py "$s" "$TMP/faults" --some 1 "render movie" >>"$TMP/lines"
python3 tests/tool/faults.py "$s" "$TMP/faults" --malloc 12 render info "import aff" \
    "build frames" >>"$TMP/lines"
while read -r line; do # its lines as checks of this suite
    case $line in
    "ok "* | "not ok "*)
        checks=$((checks + 1))
        echo "$line" | sed "s/ok [0-9]* - /ok $checks - /"
        ;;
    "#"* | Bail*) echo "$line" ;;
    esac
done <"$TMP/lines"
check "faults were tried" grep -q '^1\.\.' "$TMP/lines"

# ---- Ctrl-C: within a tenth of a second; on a busy machine one of some tries is ----
cat >"$TMP/interrupt.py" <<'END'
import os, signal, subprocess, sys, time
tool, folder, *words = sys.argv[1:]
os.makedirs(folder)
late = []
for wait in (0.3, 0.5, 0.7, 0.9, 1.1):
    run = subprocess.Popen([tool, *words], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                           preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
    time.sleep(wait)
    assert run.poll() is None, "it had ended"
    start = time.monotonic()
    run.send_signal(signal.SIGINT)
    said = run.communicate()[1].decode()
    late.append(time.monotonic() - start)
    assert run.returncode == -signal.SIGINT and "ended by signal 2" in said, said
    assert not os.listdir(folder), os.listdir(folder)
assert min(late) < 0.1, late
END
"$s" build scenes/paper100.nff --profile standard --size 4000x2250 -o "$TMP/large.sph" >"$TMP/out"
check "Ctrl-C ends a drawing at once" python3 "$TMP/interrupt.py" "$s" "$TMP/drawn" \
    render "$TMP/large.sph" --frame "$TMP/drawn/x.frame"
check "... and a reference" python3 "$TMP/interrupt.py" "$s" \
    "$TMP/film" reference scenes/paper100.nff --size 3200x1800 -o "$TMP/film/x.png"

# ---- memory ----
refused() { # what the message says, words of the tool
    message=$1
    shift
    fails 1 "refused: sphaera $*" timeout 60 "$s" "$@"
    check "... $message" has "$message"
    check "... and the limit is named" has "SPHAERA_MEMORY=4G allows more"
    check "... and nothing is there" sh -c '! ls "$0"/x.* 2>/dev/null' "$TMP/new"
}
mkdir "$TMP/new"
refused "no memory for a frame of 16383x16383" render scenes/paper5.nff --size 16383x16383 \
    --frame "$TMP/new/x.frame"
refused "no memory" render scenes/paper5.nff --size 16383x16383 -o "$TMP/new/x.png"
refused "no memory" reference scenes/paper5.nff --size 16383x16383 -o "$TMP/new/x.png"
SPHAERA_MEMORY=1M
export SPHAERA_MEMORY
refused "memory" gen random --spheres 600000 -o "$TMP/new/x.nff"
export SPHAERA_MEMORY=some
fails 2 "SPHAERA_MEMORY=some" "$s" gen paper5
export SPHAERA_MEMORY=64M
check "in 64 MiB a small scene is built" "$s" build scenes/paper5.nff -o "$TMP/new/y.sph"
unset SPHAERA_MEMORY
"$s" gen paper5 | awk '1; $1 == "f" { exit }' >"$TMP/cones.nff"
awk 'BEGIN { for (i = 0; i < 300; i++) print "c", 9 * i, 0, 0, 1, 9 * i, 1, 0, 1 }' \
    >>"$TMP/cones.nff"
fails 1 "cones of millions of triangles" "$s" build "$TMP/cones.nff" --round 1e-6 \
    -o "$TMP/new/x.sph"
check "... are refused by name and line" has "cones.nff:[0-9]*: .*\(more than\|no memory\)"

# ---- words ----
fails 2 "a byte that no text has" "$s" render -"$(printf '\377')" scenes/paper5.nff
check "... is named" has "word 2 .*byte 0xff"
many=$(awk -v o="-o $TMP/many.sph" 'BEGIN { for (i = 0; i < 40; i++) print o i }')
check "the last of many outputs is written" sh -c '"$1" build scenes/paper5.nff $2 >/dev/null &&
    [ "$(ls "$3"/many.sph*)" = "$3/many.sph39" ]' - "$s" "$many" "$TMP"
for word in --HANG --H --program-name=x --p; do
    fails 2 "$word, which argp would take" timeout 9 "$s" load "$word"
    check "... is no option" has "^sphaera load: unrecognized option '$word'"
done
done_testing
