#!/bin/sh
# test_kills.sh - make is killed at random times, with all that it started; the next one is right
# SPDX-License-Identifier: Apache-2.0
#
# 5 kills of the build of the library; with ALL=1 200 of the tool and of `make sim`.
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
cat >"$TMP/kills.py" <<'END'
import os, random, signal, subprocess, sys, time
kills, seed, *words = sys.argv[1:]
draw, env = random.Random(int(seed)), dict(os.environ)
for name in ("MAKEFLAGS", "MFLAGS", "MAKELEVEL", "SPHAERA_JOBS"):
    env.pop(name, None)
print("SEED=" + seed)
most, ended = 0.5, 0
for kill in range(int(kills)):
    start = time.monotonic()
    run = subprocess.Popen(words, env=env, start_new_session=True, stdout=subprocess.DEVNULL,
                           stderr=subprocess.DEVNULL, stdin=subprocess.DEVNULL)
    try:
        run.wait(draw.uniform(0, most))
        ended += 1
        assert run.returncode == 0, f"run {kill} after a kill: exit code {run.returncode}"
    except subprocess.TimeoutExpired:
        os.killpg(run.pid, signal.SIGKILL)
        run.wait()
        most = min(most * 1.5, 20)
print(f"{kills} kills, {ended} came too late")
END
if [ -n "${ALL:-}" ]; then
    goals="$TMP/b/sphaera $TMP/b/sphaera_image.so" kills=100
else
    goals=$TMP/b/libsphaera.a kills=5
fi
plain() { env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL -u SPHAERA_JOBS "$@"; }
killed() { # number, words of make
    n=$1
    shift
    python3 "$TMP/kills.py" "$n" "${SEED:-1}" make -s B="$TMP/b" "$@"
}
right() { # the archive has the members of one that nothing was done to, and no part is half there
    plain make B="$TMP/b" $goals >"$TMP/text" &&
        plain make B="$TMP/b" $goals | { ! grep '  CC\|  AR'; } &&
        find "$TMP/b" -name '*.o' -size 0 | { ! grep .; } &&
        nm --defined-only "$TMP/b/libsphaera.a" | sed '/^$/d; s/^[0-9a-f]* //' >"$TMP/mine" &&
        nm --defined-only "$BUILD/libsphaera.a" | sed '/^$/d; s/^[0-9a-f]* //' >"$TMP/good" &&
        cmp "$TMP/mine" "$TMP/good"
}
check "$kills kills of make" killed $kills $goals
check "... and it is right" right
if [ -n "${ALL:-}" ]; then
    set -- sim SCENE=paper5 PROFILE=draft SIZE=8x6
    check "$kills kills of make sim" killed $kills "$@"
    check "... and the RTL draws the model's picture" plain make -s B="$TMP/b" "$@"
fi
done_testing
