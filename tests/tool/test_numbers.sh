#!/bin/sh
# test_numbers.sh - each option that takes a number refuses what is none, by its name, and writes
# nothing. Options are those that `--help` has. 4294967312 is 16 in 32 bits, 2^64 + 1 is 1 in 64.
# SPDX-License-Identifier: Apache-2.0
. tests/tap.sh
cp scenes/one_sphere.nff "$TMP/s.nff"
"$SPHAERA" build "$TMP/s.nff" --size 32x18 -o "$TMP/m.sph" >"$TMP/log" 2>&1 || exit 1
cd "$TMP" || exit 1

numbers() { # of a command: its options that take numbers
    "$SPHAERA" "$1" --help |
        grep -oE -e '--[a-z-]+=(N|[A-Z]|X,Y|A\.\.B|DEGREES|PIXELS(,DB)?|WxH)( |$)' |
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
all_refused() {
    bad=0
    big="99999999999999999999 18446744073709551617" # of what is no whole number, both are right
    case $2 in --drift | --radius) big= ;; esac
    for value in $big -4294967280 nan inf 0x10 1e400 5x '' \
        ' 7' '+-1' '1,,2' 4x; do
        refused "$1" "$2" "$value" || bad=1
    done
    return $bad
}
for command in build render info compare gen import background texels accuracy reference export \
    operations trees view movie; do
    for option in $(numbers "$command"); do
        check "$command $option" all_refused "$command" "$option"
    done
done
fails 2 "a pixel that would be 16,12 in 32 bits" "$SPHAERA" info m.sph --pixel 4294967312,12
fails 2 "SPHAERA_MEMORY that wraps around" env SPHAERA_MEMORY=18446744073709551617 \
    "$SPHAERA" info m.sph
done_testing
