#!/bin/sh
# test_report_schema.sh - reports of every command are as docs/reference/report.schema.json says
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
root=$(cd "$(dirname "$0")/../.." && pwd)
cd "$TMP" || exit 1
mkdir work
cd work || exit 1
s=$SPHAERA scenes=$root/scenes schema=$root/docs/reference/report.schema.json

# usage: python3 schema.py SCHEMA NAME...: what is wrong of NAME.json; NAME may be followed by a
# colon and a change of the report r.
cat >schema.py <<'END'
import json, sys
from jsonschema import Draft202012Validator
schema = Draft202012Validator(json.load(open(sys.argv[1])))
Draft202012Validator.check_schema(schema.schema)
for name in sys.argv[2:]:
    name, _, change = name.partition(": ")
    r = json.load(open(name + ".json"))
    exec(change)
    for error in schema.iter_errors(r):
        print(f"{name}: {error.json_path}: {error.message[-200:]}")
END
names=
reports() { # NAME COMMAND...: it writes NAME.json
    names="$names $1" name=$1
    shift
    check "$name" "$s" "$@" --json "$name.json"
}
reports build build "$scenes/facets/room.nff" --size 16x10 -o room.sph
reports build-frames build "$scenes/texture/robot.nff" --frames 0..1 --size 16x10 -o robot.sph
reports info info room.sph --pixel 8,5 --stages
reports info-scene info "$scenes/texture/hall.nff"
reports render render "$scenes/facets/plane.nff" --size 16x10 -o a.png --frame a.frame
reports render-frames render "$scenes/texture/robot.nff" --frames 0..1 --size 16x10 -o robot.png
reports compare compare a.frame a.frame
reports accuracy accuracy "$scenes/paper5.nff" --size 16x10
reports accuracy-texture accuracy "$scenes/texture/hall.nff" --size 16x10
reports background background "$scenes/paper5.nff" --size 16x10
reports texels texels "$scenes/texture/hall.nff" --size 16x10
reports operations operations "$scenes/paper5.nff" --size 16x10
reports trees trees "$scenes/paper5.nff" --size 16x10
reports floats floats "$scenes/paper5.nff" --size 16x10
reports price price "$scenes/huge_tiny.nff" --size 16x10 --more
covered() { # a command with --json that is not tried here
    for command in $("$s" --help | sed -n '/^Commands:/,/^$/s/^  \([a-z]*\) .*/\1/p'); do
        "$s" "$command" --help | grep -q -- --json || continue
        [ -s "$command.json" ] || { echo "$command" && return 1; }
    done
}
check "every command that writes a report is tried" covered

# shellcheck disable=SC2086  # a list of words on purpose
python3 schema.py "$schema" $names >wrong 2>&1
check "all are as the schema has them" sh -c 'cat wrong; [ ! -s wrong ]'

# ---- what this check notices ----
python3 schema.py "$schema" "build: r['version'] = 1" "info: r['machine']['fog'] = 1" \
    "render: r['frame']['width'] = '16'" "build-frames: del r['frames'][0]['at']" \
    "background: r['texels'] = 5" "accuracy: r['frame']['hash'] = '0x12'" >wrong 2>&1
notices() { # what, words
    check "$1" grep -q -- "$2" wrong
}
notices "another version" '^build: $.version: 2 was expected'
notices "a member that nobody tells of" "^info: .*'fog' was unexpected"
notices "a member of another type" "^render: .*width: '16' is not of type 'integer'"
notices "a member that is gone" "^build-frames: .*'at' is a required property"
notices "a member of another command" "^background: $.command: 'background' is not one of"
notices "a hash that is none" "^accuracy: .*'0x12' does not match"
done_testing
