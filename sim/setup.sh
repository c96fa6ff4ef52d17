#!/bin/sh
# setup.sh - installs Debian packages that are missing, through apt
# SPDX-License-Identifier: Apache-2.0
#
# usage: sim/setup.sh [--dry-run] --for [GOAL...]   those that goals of make need: packages.txt
#        sim/setup.sh [--dry-run] PACKAGE...
# Does nothing, and needs no network, when all are there. What this release does not have is said
# and skipped; of PACKAGEs it is an error.
set -eu

dry_run=
[ "${1:-}" != --dry-run ] || { dry_run=$1 && shift; }

of_goals() { # packages of the groups
    awk -v goals="$*" '
        BEGIN { n = split(goals, goal); all = n == 0 }
        { sub("#.*", "") }
        /^\[/ {
            group += 1
            for (i = 2; i <= NF; i++)
                for (g = 1; g <= n; g++)
                    if ($i == goal[g]) wanted[group] = known[g] = 1
        }
        /^[a-z]/ { package[++packages] = $1; of[packages] = group }
        END {
            for (g = 1; g <= n; g++) all = all || !known[g]
            for (p = 1; p <= packages; p++) if (all || of[p] == 1 || wanted[of[p]]) print package[p]
        }' "$(dirname "$0")/packages.txt"
}
named=1 # one by one
if [ "${1:-}" = --for ]; then
    shift
    named=
    # shellcheck disable=SC2046  # a list of words on purpose
    set -- $(of_goals "$@")
fi

if ! command -v dpkg-query >/dev/null; then
    echo "setup: no dpkg here; install with your own package manager: $*" >&2
    exit 1
fi

# What is not installed: in `missing` what this release has, in `lacking` what it has not.
look() {
    missing='' lacking=''
    for package; do
        case $package in # of the release's clang
        *-MAJOR-*)
            major=$(apt-cache depends clang 2>/dev/null | sed -n 's/.*: clang-\([0-9]*\)$/\1/p')
            package=${package%MAJOR*}${major:-MAJOR}${package#*MAJOR}
            ;;
        esac
        status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
        if [ "$status" != installed ]; then
            if apt-cache show "$package" >/dev/null 2>&1; then
                missing="$missing $package"
            else
                lacking="$lacking $package"
            fi
        fi
    done
}
look "$@"
if [ -z "$missing$lacking" ]; then
    echo "setup: every package is installed"
    exit 0
fi
if [ "$dry_run" = --dry-run ]; then
    echo "setup: installing$missing$lacking"
    exit 0
fi

as_root=
if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { echo "setup: run it as root, or install sudo" >&2; exit 1; }
    as_root=sudo
fi
export DEBIAN_FRONTEND=noninteractive
update() { $as_root apt-get update -q </dev/null; }
install() {
    # shellcheck disable=SC2086  # a list of words on purpose
    $as_root apt-get install -y -q --no-install-recommends $missing </dev/null
}
if [ -n "$lacking" ]; then # the list of packages may be absent or old
    echo "setup: asking apt for its list of packages"
    update && look "$@"
fi
[ -z "$lacking" ] || echo "setup: this release has no package$lacking"
[ -z "$named" ] || [ -z "$lacking" ] || exit 1
[ -n "$missing" ] || exit 0
echo "setup: installing$missing"
install || { update && install; }
