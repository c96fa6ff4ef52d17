#!/bin/sh
# man.sh - manual pages of the tool and its commands, made of what --help prints
# SPDX-License-Identifier: Apache-2.0
#
# usage: SPHAERA=TOOL sim/man.sh FOLDER
set -eu
here=$(dirname "$0")
version=$("$SPHAERA" --version)
page() { # name of the page, words of the command
    name=$1
    shift
    "$SPHAERA" "$@" --help | awk -v name="$name" -v command="$*" -v version="$version" \
        -f "$here/man.awk" >"$folder/$name.1"
}
folder=$1
page sphaera
for command in $("$SPHAERA" --help | sed -n '/^Commands:/,/^$/s/^  \([a-z]*\) .*/\1/p'); do
    page "sphaera-$command" "$command"
done
