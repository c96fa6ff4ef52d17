#!/bin/sh
# test_report_schema.sh - reports of every command are as docs/use/report.schema.json says
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
root=$(cd "$(dirname "$0")/../.." && pwd)
cd "$TMP" || exit 1
mkdir work
cd work || exit 1
s=$SPHAERA scenes=$root/scenes schema=$root/docs/use/report.schema.json
valid() { python3 -W ignore -m jsonschema -i "$1" "$schema"; }

reports() { # NAME COMMAND...: it writes NAME.json, which is as it should be
    name=$1
    shift
    check "$name" "$s" "$@" --json "$name.json"
    check "... as the schema has it" valid "$name.json"
}
reports build build "$scenes/facets/room.nff" --size 16x10 -o room.sph
reports build-frames build "$scenes/texture/robot.nff" --frames 0..1 --size 16x10 -o robot.sph
reports info info room.sph --pixel 8,5
reports render render "$scenes/facets/plane.nff" --size 16x10 -o a.png --frame a.frame
reports render-frames render "$scenes/texture/robot.nff" --frames 0..1 --size 16x10 -o robot.png
reports compare compare a.frame a.frame
reports accuracy accuracy "$scenes/paper5.nff" --size 16x10
reports accuracy-texture accuracy "$scenes/texture/hall.nff" --size 16x10
reports background background "$scenes/paper5.nff" --size 16x10
reports texels texels "$scenes/texture/hall.nff" --size 16x10
reports operations operations "$scenes/paper5.nff" --size 16x10
covered() { # a command with --json that is not tried here
    for command in $("$s" --help | sed -n '/^Commands:/,/^$/s/^  \([a-z]*\) .*/\1/p'); do
        "$s" "$command" --help | grep -q -- --json || continue
        [ -s "$command.json" ] || { echo "$command" && return 1; }
    done
}
check "every command that writes a report is tried" covered

# ---- what these checks notice ----
broken() { # file, what is done to it, what is said
    python3 -c "import json, sys
r = json.load(open('$1.json'))
$2
json.dump(r, open('broken.json', 'w'))"
    valid broken.json >said 2>&1 && return 1
    cat said
    grep -q -- "$3" said
}
check "another version" broken build "r['version'] = 1" "2 was expected"
check "a member that nobody tells of" broken info "r['machine']['fog'] = 1" "'fog' was unexpected"
check "a member of another type" broken render "r['frame']['width'] = '16'" "'integer'"
check "a member that is gone" broken build "del r['build']['effects'][0]['why']" "'why' is a requ"
check "a member of another command" broken info "r['texels'] = 5" "'info' is not one of"
check "a hash that is none" broken render "r['frame']['hash'] = '0x12'" "does not match"
done_testing
