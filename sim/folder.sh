#!/bin/sh
# folder.sh - a name of a build folder that make and shells take for one plain word
# SPDX-License-Identifier: Apache-2.0
#
# usage: sim/folder.sh FOLDER
# Prints it by its path from the root of the sources if it lies below, so that one folder has one
# name, else whole. What has a blank or another character that make or a shell has a use for gets a
# link, build/links/DIGEST, and is made if it is absent: a link to nothing would be in the way.
set -eu
cd "$(dirname "$0")/.."
folder=$(realpath -ms -- "$1") # it may be a link itself
folder=$(realpath -ms --relative-base="$(pwd -P)" -- \
    "$(realpath -m -- "$(dirname -- "$folder")")/$(basename -- "$folder")")
case $folder in
*[][\ \	\$\'\"\`\\\;\&\|\<\>\(\)\{\}*?!~#%:=]*)
    link=build/links/$(printf '%s' "$folder" | sha256sum | cut -c 1-12)
    mkdir -p build/links "$folder"
    [ "$link" -ef "$folder" ] || ln -sfn -- "$(realpath -- "$folder")" "$link"
    folder=$link
    ;;
esac
printf '%s\n' "$folder"
