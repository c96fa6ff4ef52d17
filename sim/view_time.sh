#!/bin/sh
# view_time.sh - how soon the live view answers, and how many pictures a second it shows
# SPDX-License-Identifier: Apache-2.0
#
# usage: SPHAERA=TOOL TMP=FOLDER sim/view_time.sh
# 640x360, an orbit of two seconds and a walk of one, in a window that nobody sees. Exit code 1 if
# an answer took more than 100 ms or there were fewer than 15 pictures a second, as on a machine
# that has other things to do.
set -eu
mkdir -p "$TMP"
cat >"$TMP/move.txt" <<END
wait refined
press left
move 400 200 2000
release left
down w
wait 1000
up w
wait 300
report
END
bad=0
for scene in sphereflake:3 random:100000; do
    kind=${scene%:*} n=${scene#*:} size=spheres
    [ "$kind" = random ] || size=size
    "$SPHAERA" gen "$kind" --$size "$n" -o "$TMP/$kind.nff" >"$TMP/text"
    echo "$scene, load $(cut -d' ' -f1 /proc/loadavg) on $(nproc) processors"
    SDL_VIDEODRIVER=dummy "$SPHAERA" view "$TMP/$kind.nff" --profile standard --size 640x360 \
        --script "$TMP/move.txt" | tee "$TMP/said"
    awk '/^answers/ && $11 > 0 { bad = 1 } /^moving/ && !($2 >= 15) { bad = 1 } END { exit bad }' \
        "$TMP/said" || bad=1
done
exit $bad
