#!/bin/sh
# scene.sh - the scene that somebody means
# SPDX-License-Identifier: Apache-2.0
#
# usage: [FROM=folder] sim/scene.sh NAME
# NAME is a file, from the folder FROM if it is relative; the name of a file in scenes/ without
# .nff; or KIND:N of `sphaera gen`. Prints the file, by its path from here if it lies below, or
# KIND:N; else says what there is, and ends with 2.
set -eu
cd "$(dirname "$0")/.."
name=$1 here=$(pwd -P)

file=$name
case $name in /*) ;; *) file=${FROM:-$here}/$name ;; esac
[ -f "$file" ] || file=$here/scenes/$name.nff
if [ -f "$file" ]; then
    folder=$(cd "$(dirname "$file")" && pwd -P)
    file=$folder/$(basename "$file")
    printf '%s\n' "${file#"$here"/}"
    exit
fi
kinds=$(sed -n '/SPH_TAKES_NOTHING/d; s/^    {"\([a-z0-9_]*\)", .*, SPH_TAKES_.*/\1/p' \
    cmodel/scene/generate.c)
# Which number a kind takes, says the tool (sph_generate_parse() of the model); here digits are part
# of a name.
case $name in
*:*[!0-9]* | *:) ;;
*:*) for kind in $kinds; do
    [ "$kind" != "${name%%:*}" ] || {
        printf '%s\n' "$name"
        exit
    }
done ;;
esac
scenes=$(find scenes -name '*.nff' | sed 's,^scenes/,,; s,\.nff$,,' | sort)
# shellcheck disable=SC2016,SC2086  # awk's $; a list of words on purpose
NAME=$name LIST=$(echo $scenes; printf '%s:N ' $kinds) awk "$(cat sim/nearest.awk)"'
BEGIN {
    n = split(ENVIRON["LIST"], list, /[ \n]+/)
    if (list[n] == "") n--
    name = ENVIRON["NAME"]
    meant = nearest(name, list, n)
    line = "is no file, and no scene" (meant != "" ? "; is " meant " meant?" : ".") " There are"
    for (i = 1; i <= n; i++) {
        if (length(line) + length(list[i]) > 98) {
            print line
            line = " "
        }
        line = line " " list[i]
    }
    print line
}' >&2
exit 2
