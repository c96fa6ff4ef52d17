#!/bin/sh
# dist.sh - a tarball of the sources, and the same unpacked elsewhere, built and tested
# SPDX-License-Identifier: Apache-2.0
#
# usage: [ONLY=PATTERN] [JOBS=n] sim/dist.sh FOLDER
# Writes FOLDER/sphaera-VERSION.tar.gz, the same bytes for the same sources: files that git tracks,
# or where there is no git all but build/. Then FOLDER/check/ has it unpacked, and `make test` runs
# there. ONLY: as of make test.
set -eu
cd "$(dirname "$0")/.."
name=sphaera-$(cat VERSION)
mkdir -p "$1"
to=$(cd "$1" && pwd)
sources() {
    if [ -e .git ]; then
        git ls-files -z
    else
        find . -path ./build -prune -o -name __pycache__ -prune -o ! -type d -print0 |
            sed -z 's,^\./,,'
    fi
}
. sim/beside.sh
beside "$to/$name.tar.gz"
sources | LC_ALL=C sort -z >"$new.files"
tar --null -T "$new.files" --transform "s,^,$name/," --mtime=@0 --owner=0 --group=0 \
    --numeric-owner --mode=u+rw,go+r-w -c | gzip -n9 >"$new"
named "$to/$name.tar.gz"
rm -rf "$to/check"
mkdir "$to/check"
tar -xzf "$to/$name.tar.gz" -C "$to/check"
cd "$to/check/$name"
env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL -u SPHAERA_JOBS make --no-print-directory test \
    ONLY="${ONLY:-}" JOBS="${JOBS:-1}"
echo "dist: $to/$name.tar.gz, tested${ONLY:+ ($ONLY)}"
