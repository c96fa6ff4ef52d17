#!/bin/sh
# test_setup.sh - make setup: packages of goals, a release that lacks some, no error before it ends
# SPDX-License-Identifier: Apache-2.0
#
# Stubs stand for dpkg and apt: nothing is installed until apt-get does it; apt knows clang 19 and
# the packages in $TMP/known, from `apt-get update` on.
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
mkdir "$TMP/bin" || exit 1
stub() { # command; its script
    { echo '#!/bin/sh' && cat; } >"$TMP/bin/$1" && chmod +x "$TMP/bin/$1"
}
stub dpkg-query <<STUB
grep -qx "\$4" '$TMP/installed' && echo installed
STUB
stub apt-cache <<STUB
[ -e '$TMP/updated' ] || exit 1
case \$1 in
depends) printf 'clang\n  Depends: clang-19\n' ;;
show) grep -qx "\$2" '$TMP/known' ;;
esac
STUB
stub apt-get <<STUB
echo "\$*" >>'$TMP/calls'
[ \$1 != update ] || { touch '$TMP/updated' && exit; }
[ -e '$TMP/updated' ] || { echo "E: no list" >&2 && exit 100; }
printf '%s\n' "\$@" >>'$TMP/installed'
STUB
echo 'exec "$@"' | stub sudo
sed -n 's/MAJOR/19/; s/^\([a-z][^ ]*\).*/\1/p' sim/packages.txt >"$TMP/all"

fresh() { # packages that the release lacks
    rm -f "$TMP/updated" "$TMP/calls"
    : >"$TMP/installed"
    printf '%s\n' nothing "$@" | grep -vxFf - "$TMP/all" >"$TMP/known"
}
setup() { PATH="$TMP/bin:$PATH" sh sim/setup.sh "$@" >"$TMP/text" 2>"$TMP/err"; }
has() { grep -qx -- "$1" "$2" || { cat "$2" && false; }; }
lacks() { ! grep -qx -- "$1" "$2"; }
silent() { cat "$TMP/err" && [ ! -s "$TMP/err" ]; }

# ---- which packages: a goal, several, one in no group ----
while read -r goals with without; do
    fresh
    # shellcheck disable=SC2046  # words
    setup --for $(echo "$goals" | tr , ' ')
    for package in $(echo "$with" | tr , ' '); do
        check "setup for $goals: $package" has "$package" "$TMP/installed"
    done
    for package in $(echo "$without" | tr , ' '); do
        check "setup for $goals: not $package" lacks "$package" "$TMP/installed"
    done
    check "setup for $goals: no error" silent
done <<'ROWS'
sim gcc,verilator,iverilog yosys,libopenimageio-dev,libcmocka-dev,gnuplot-nox
synth gcc,yosys libopenimageio-dev,libcmocka-dev
sim,synth verilator,yosys libcmocka-dev
images-setup libopenimageio-dev yosys,libcmocka-dev
price gcc,gnuplot-nox yosys,libcmocka-dev
test gcc,yosys,libopenimageio-dev,libcmocka-dev,libclang-rt-19-dev nothing
sim,lint gcc,yosys,clang-tidy nothing
ROWS
fresh
setup --for
everything() { grep -vxFf "$TMP/installed" "$TMP/all"; [ $? = 1 ]; }
check "setup alone installs all" everything
check "... asks apt once for its list" [ "$(grep -c '^update' "$TMP/calls")" = 1 ]
: >"$TMP/calls"
setup --for
check "... and the next time nothing" [ ! -s "$TMP/calls" ]
check "... as it says" has 'setup: every package is installed' "$TMP/text"

# ---- what a release lacks ----
fresh bodr tachyon-doc
check "packages that a release lacks end nothing" setup --for
check "... are said" has "setup: this release has no package tachyon-doc bodr" "$TMP/text"
lacking() { grep -vxFf "$TMP/installed" "$TMP/all" | tr '\n' ' '; }
check "... all others are installed" [ "$(lacking)" = "tachyon-doc bodr " ]
check "... and the next time, too" setup --for
fresh
refused() { ! setup no-such && has "setup: this release has no package no-such" "$TMP/text"; }
check "a package that is asked for by its name is an error" refused

# ---- goals beside setup; a system that has no compilers yet ----
plain_make() { env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL make --no-print-directory "$@"; }
planned() { plain_make -n setup tool B="$TMP/b" | head -n 1 >"$TMP/text" &&
    has 'sh sim/setup.sh --for tool' "$TMP/text"; }
check "make setup GOAL hands on the goal" planned
refused() { ! plain_make setup snyth 2>"$TMP/err" && cat "$TMP/err" &&
    grep -q 'no target snyth; is synth meant' "$TMP/err"; }
check "... and looks at it before" refused
for tool in sh sed awk find dirname mkdir cat make sort touch grep env mktemp mv cp cmp rm uname \
    nproc head cksum realpath tr id; do
    ln -s "$(command -v $tool)" "$TMP/bin/$tool"
done
fresh
env -i PATH="$TMP/bin" HOME="$TMP" make --no-print-directory setup >"$TMP/text" 2>"$TMP/err"
check "without compilers make setup installs them" has gcc "$TMP/installed"
check "... and prints no error" silent

# ---- other releases ----
unknown() { ! python3 -m lab matrix "$TMP/m" "$TMP/page" wheezy 2>"$TMP/err" && has \
    'matrix: there is no wheezy; there are bookworm, trixie, noble' "$TMP/err"; }
check "make matrix knows its releases" unknown

# ---- what is compiled shares a line of a terminal, and has lines elsewhere ----
cr=$(printf '\r')
b=$(sh sim/folder.sh "$TMP/b") # as make names it
objects="$b/obj/cmodel/common/kind.o $b/obj/cmodel/common/error.o"
rm -rf "$b"
lines() {
    # shellcheck disable=SC2086  # words
    plain_make B="$b" $objects >"$TMP/text" &&
        [ "$(grep -c '^  CC   [a-z]*[.]c$' "$TMP/text")" = 2 ]
}
check "lines in a file" lines
rm -rf "$b"
terminal() {
    script -qec "env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL make B=$b $objects" "$TMP/text" &&
        [ "$(grep -o '  CC   [12] [a-z]*[.]c.' "$TMP/text" | grep -c "$cr")" = 2 ]
}
check "one line on a terminal" terminal

echo "# the hosts' own files run .ci/run, on Debian 12, with what README has installed before"
for file in .github/workflows/ci.yml .gitlab-ci.yml; do
    hosted() {
        grep -q '^ *- \(run: \)\?bash [.]ci/run$' "$file" && grep -q ' debian:12$' "$file" &&
            grep -q 'apt-get install -y --no-install-recommends .*git make$' "$file"
    }
    check "$file" hosted
done
done_testing
