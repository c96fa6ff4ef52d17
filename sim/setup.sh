#!/bin/sh
# setup.sh - installs Debian packages that are missing, through apt
# SPDX-License-Identifier: Apache-2.0
#
# usage: sim/setup.sh [--dry-run] [PACKAGE...]   those of packages.txt beside this script if none is
#                                                named
# Does nothing, and needs no network, when all are there.
set -eu

dry_run=
[ "${1:-}" != --dry-run ] || { dry_run=$1 && shift; }
# shellcheck disable=SC2046  # a list of words on purpose
[ $# -gt 0 ] || set -- $(sed 's/#.*//' "$(dirname "$0")/packages.txt")

if ! command -v dpkg-query >/dev/null; then
    echo "setup: no dpkg here; install with your own package manager: $*" >&2
    exit 1
fi

missing=
for package; do
    status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
    [ "$status" = installed ] || missing="$missing $package"
done
if [ -z "$missing" ]; then
    echo "setup: every package is installed"
    exit 0
fi

echo "setup: installing$missing"
[ "$dry_run" = --dry-run ] && exit 0
as_root=
if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { echo "setup: run it as root, or install sudo" >&2; exit 1; }
    as_root=sudo
fi
export DEBIAN_FRONTEND=noninteractive
# shellcheck disable=SC2086  # a list of words on purpose
install() { $as_root apt-get install -y -q --no-install-recommends $missing; }
install </dev/null || { $as_root apt-get update -q </dev/null && install </dev/null; }
