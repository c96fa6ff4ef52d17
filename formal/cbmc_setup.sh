#!/bin/sh
# cbmc_setup.sh - CBMC of Debian 11, from the archive that apt has its packages of
# SPDX-License-Identifier: Apache-2.0
#
# usage: formal/cbmc_setup.sh FOLDER      FOLDER/usr/bin/cbmc
# Its libraries are those of later releases too; it is unpacked, not installed.
set -eu
to=$1
file=cbmc_5.12-5_amd64.deb
sum=25fd26a1fad6b9334aaf498b12b6c094e8d0fb15384281fef5f1c5eaff047f20
if [ -x "$to/usr/bin/cbmc" ]; then
    echo "setup: CBMC is there"
    exit 0
fi
[ "$(dpkg --print-architecture)" = amd64 ] || { echo "setup: CBMC: amd64 only" >&2; exit 1; }
site=$(apt-get indextargets --format '$(LABEL) $(SITE)' | sed -n 's/^Debian //p' | head -n 1)
[ -n "$site" ] || { echo "setup: apt knows no archive of Debian: apt-get update" >&2; exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
chmod 755 "$work"
/usr/lib/apt/apt-helper -q download-file "$site/pool/main/c/cbmc/$file" "$work/$file" "SHA256:$sum"
mkdir -p "$(dirname "$to")"
dpkg-deb -x "$work/$file" "$work/cbmc"
mv "$work/cbmc" "$to"
"$to/usr/bin/cbmc" --version
