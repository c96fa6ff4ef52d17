#!/bin/sh
# test_numbers.sh - each option that takes a number refuses what is none, by its name, and writes
# nothing. Options are those that `--help` has. So do programs of tests and make.
# SPDX-License-Identifier: Apache-2.0
. tests/tap.sh
. tests/numbers.sh
cp tests/fuzz/corpus/aff/moving.aff "$TMP/t.aff"
sed 's/^resolution.*/resolution 32 18/' scenes/one_sphere.nff >"$TMP/s.nff"
here=$PWD
"$SPHAERA" build "$TMP/s.nff" --size 32x18 -o "$TMP/m.sph" >"$TMP/log" 2>&1 || exit 1
"$SPHAERA" render "$TMP/m.sph" --frame "$TMP/m.frame" >"$TMP/log" 2>&1 || exit 1
cd "$TMP" || exit 1

numbers() { # of a command: its options that take numbers
    "$SPHAERA" "$1" --help |
        grep -oE -e '--[a-z-]+=(N|[A-Z]|X,Y|A\.\.B|DEGREES|PIXELS\[,DB\]|WxH)( |$)' |
        sed 's/=.*//' | sort -u
}
input_of() {
    case $1 in
    info | export) echo m.sph ;;
    gen) [ "$2" = --radius ] && echo scenario1 || echo random ;;
    compare) echo a.png b.png ;;
    import) echo s.pdb ;;
    *) echo s.nff ;;
    esac
}
refused() { # command, option, value
    timeout 10 "$SPHAERA" "$1" $(input_of "$1" "$2") "$2=$3" -o out.x >log 2>&1
    rc=$?
    if [ $rc -ne 2 ] || ! grep -qF -e "$2" log || { [ -n "$3" ] && ! grep -qF -e "$3" log; } ||
        [ -e out.x ]; then
        echo "$1 $2='$3': exit code $rc"
        head -n 2 log
        rm -f out.x
        return 1
    fi
}
# Of an option: what is large, small or has a point may be right, since help has no N or WxH for it.
is_real() { # command, option
    ! "$SPHAERA" "$1" --help | grep -qE -e "$2=(N|X,Y|A\.\.B|WxH)( |\$)"
}
all_refused() {
    bad=0
    no_numbers >words
    while IFS= read -r value; do
        case $value in 9999999999* | 1844674407* | 1e-320) ! is_real "$1" "$2" || continue ;; esac
        refused "$1" "$2" "$value" </dev/null || bad=1
    done <words
    return $bad
}
# A real number, as large or small as one may be: taken or refused, within seconds, with a message.
answered() { # command, option
    bad=0
    case $1 in
    build) set -- "$@" -o out.sph ;;
    render | reference) set -- "$@" -o out.png ;;
    gen | import) set -- "$@" -o out.nff ;;
    movie) set -- "$@" -o out.gif b.png ;;
    esac
    command=$1 option=$2 input=$(input_of "$1" "$2")
    [ "$option" != --time ] || input=t.aff
    shift 2
    for value in 0 1e-320 5e-324 1e-300 1e-30 1e30 1e29 -1e30 -0 0.5 1 359.9999999999 1e9; do
        timeout 5 "$SPHAERA" "$command" $input "$option=$value" "$@" >log 2>&1 </dev/null
        rc=$?
        rm -f out.*
        case $rc in
        0) continue ;;
        1 | 2) ! grep -q '^sphaera' log || continue ;;
        esac
        echo "$command $option=$value: exit code $rc" && head -n 2 log
        bad=1
    done
    return $bad
}
for command in build render info compare gen import background texels accuracy reference export \
    operations trees floats view movie; do
    for option in $(numbers "$command"); do
        check "$command $option" all_refused "$command" "$option"
        [ "$command" != view ] && is_real "$command" "$option" || continue
        check "... answers reals" answered "$command" "$option"
    done
done
fails 2 "a pixel that would be 16,12 in 32 bits" "$SPHAERA" info m.sph --pixel 4294967312,12
fails 2 "SPHAERA_MEMORY that wraps around" env SPHAERA_MEMORY=18446744073709551617 \
    "$SPHAERA" info m.sph

# ---- programs of the tests and of make ----
cd "$here" || exit 1
check "hard --cases" refuses 2 --cases= "$BUILD/test/hard" --exhaustive 0
check "hard --seed" refuses 2 --seed= "$BUILD/test/hard" --exhaustive 0 --cases 1
check "hard --case" refuses 2 --case=graze0:standard: "$BUILD/test/hard"
check "pictures SAMPLES" refuses 2 "" "$BUILD/sim/pictures" "$TMP/m.frame" "$TMP/m.frame" "$TMP"
check "a seed of a test" refuses 2 "" "$BUILD/test/test_frustum"
check "SEED of a test" refuses 2 SEED= sh -c 'env "$1" "$0"' "$BUILD/test/test_malformed"
for option in --runs --seconds --seed; do
    check "a fuzzer's $option" refuses 2 "" "$BUILD/fuzz/plain/fuzz_options" "$option"
done
done_testing
