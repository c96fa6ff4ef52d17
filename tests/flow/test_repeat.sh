# test_repeat.sh - figures that another machine repeats: no report depends on who asks, or where
# SPDX-License-Identifier: Apache-2.0
#
# Every report of the tool, of a sweep, of a run of the RTL and of the library, with 1, 2 and 7
# jobs, in another locale, folder and time zone, and by the other compiler with less effort, is
# byte by byte the same, but for what a clock says. test_python.sh has Python's.
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
root=$PWD
BUILD=$(realpath "${BUILD:-build}")
tool=$(realpath "${SPHAERA:-$BUILD/sphaera}")
version=$(cat VERSION)
shared=libsphaera.so.$version
same="python3 $root/tests/flow/same_reports.py"
# as if nothing of this run were there
plain() { env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL -u SPHAERA_JOBS "$@"; }

scene=$TMP/r.nff
"$tool" gen random:300 -o "$scene" >"$TMP/log"
mkdir "$TMP/results"

# tool, jobs: the reports, into the folder in which it is called
reports() {
    t=$1 n=$2
    cp "$scene" r.nff
    set -- --size 40x30 --threads "$n"
    "$t" build r.nff --size 40x30 --json build.json -o r.sph >build.txt &&
        "$t" info r.sph --pixel 20,15 --stages --json info.json >info.txt &&
        "$t" export r.sph --hex r >export.txt &&
        "$t" render r.nff "$@" --json render.json --frame r.frame -o r.png --counters >render.txt &&
        "$t" price r.nff "$@" --json price.json >price.txt &&
        "$t" accuracy r.nff "$@" --json accuracy.json -d strip.png >accuracy.txt &&
        "$t" reference r.nff "$@" --frame reference.frame -o reference.png >reference.txt &&
        "$t" background r.nff --size 40x30 --json background.json >background.txt &&
        "$t" operations r.nff --size 40x30 --json operations.json >operations.txt &&
        "$t" floats r.nff --size 40x30 --json floats.json >floats.txt &&
        "$t" trees r.nff --size 40x30 --json trees.json >trees.txt &&
        "$t" texels "$root/scenes/texture/kitchen.nff" --size 40x30 --json texels.json \
            >texels.txt ||
        return 1
    rm build.txt render.txt accuracy.txt trees.txt # have times; their JSON is there
}
# jobs: what needs the scripts, too. Results of a sweep are its own.
scripted() {
    plain RESULTS="$PWD/results" STUDY_OPT=-O0 "$tool" sweep --measure counts accuracy price \
        --scene paper5 "$scene" --profile draft standard --size 16x9 --jobs "$1" --out sweep \
        >log 2>&1 || return 1
    plain RESULTS="$PWD/results" STUDY_OPT=-O0 "$tool" sweep --measure cycles --scene paper5 \
        --effects shadow+reflect2+lights1 --size 16x9 --stall 20 --jobs "$1" --out cycles \
        >>log 2>&1 || return 1
    "$tool" build "$root/scenes/paper5.nff" --effects all --profile standard --size 16x9 \
        -o p.sph >>log || return 1
    plain EFFECTS=shadow+reflect2+lights1 OPT=-O0 BUILD="$BUILD" JOBS="$1" sh "$root/sim/core.sh" \
        --machine "$PWD/p.sph" --stall 20 --frame "$PWD/rtl.frame" --json "$PWD/sim.json" \
        >>log 2>&1 || return 1
    rm -r results log
}

in_folder() { # folder, command
    mkdir -p "$1" && cd "$1" && shift && "$@"
    rc=$?
    cd "$root" || exit 1
    return $rc
}

# ---- another locale, if this system can make one ----
locale=C.UTF-8
mkdir "$TMP/locales"
if localedef -i de_DE -f UTF-8 "$TMP/locales/de_DE.UTF-8" >"$TMP/log" 2>&1; then
    locale=de_DE.UTF-8
else
    echo "# no sources of locales here: C.UTF-8 instead of one with a comma"
fi
export LOCPATH="$TMP/locales"

check "reports with one job" in_folder "$TMP/one/tool" reports "$tool" 1
check "... of scripts" in_folder "$TMP/one/scripts" scripted 1
export LC_ALL=$locale TZ=Pacific/Chatham COLUMNS=40
check "two jobs, $locale, another folder" in_folder "$TMP/ж b/tool" reports "$tool" 2
check "... the same" $same "$TMP/one/tool" "$TMP/ж b/tool"
check "... of scripts" in_folder "$TMP/ж b/scripts" scripted 2
check "... the same" $same "$TMP/one/scripts" "$TMP/ж b/scripts"
unset LC_ALL TZ COLUMNS
check "seven jobs" in_folder "$TMP/seven/tool" reports "$tool" 7
check "... the same" $same "$TMP/one/tool" "$TMP/seven/tool"
check "... of scripts" in_folder "$TMP/seven/scripts" scripted 7
check "... the same" $same "$TMP/one/scripts" "$TMP/seven/scripts"

# ---- the other compiler ----
if command -v clang >"$TMP/which" && command -v gcc >"$TMP/which"; then
    other=clang
    ! "${CC:-cc}" --version | grep -q clang || other=gcc
    plus=++
    [ $other = clang ] || plus=
    check "the tool by $other, with -O1" plain make -s B="$BUILD/other" CC=$other \
        CXX="$(echo $other$plus | sed 's/gcc$/g++/')" \
        CFLAGS="-std=c11 -D_GNU_SOURCE -O1 -Icmodel" "$BUILD/other/sphaera" \
        "$BUILD/other/dist/$shared"
    check "its reports" in_folder "$TMP/other/tool" reports "$BUILD/other/sphaera" 2
    check "... are the same" $same "$TMP/one/tool" "$TMP/other/tool"
    check "the library" plain make -s B="$BUILD" "$BUILD/dist/$shared"
    for by in "" other; do
        threads=$((1 + 6 * ${#by} / 5))
        folder=$(realpath "$BUILD/$by/dist")
        check "a program, with the library ${by:-here}" in_folder "$TMP/library/by$by" sh -c "
            ln -sf '$folder/$shared' ../libsphaera.so.${version%%.*} &&
            cc '$root/tests/flow/repeat.c' -I'$root/cmodel' -o ../repeat '$folder/$shared' &&
            OMP_NUM_THREADS=$threads LC_ALL=$locale LD_LIBRARY_PATH=.. \
                ../repeat '$scene' >library.txt"
    done
    check "... says the same" $same "$TMP/library/by" "$TMP/library/byother"
else
    echo "ok $((checks += 1)) - # SKIP one compiler alone is here"
fi

# ---- a difference would be seen ----
cp -r "$TMP/one/tool" "$TMP/wrong"
sed -i 's/"node_visits": \([0-9]*\)/"node_visits": 1\1/' "$TMP/wrong/render.json"
check "a counter that differs is noticed" sh -c "
    ! $same '$TMP/one/tool' '$TMP/wrong' >'$TMP/said' && grep -q '^render.json' '$TMP/said'"
done_testing
