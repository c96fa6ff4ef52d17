# numbers.sh - words that are no number of any option, and what has to come of them; sourced
# SPDX-License-Identifier: Apache-2.0
#
# After tap.sh. 4294967312 is 16 in 32 bits, 18446744073709551617 is 1 in 64. A word is a line.
no_numbers() {
    printf '%s\n' 99999999999999999999 18446744073709551617 -4294967280 nan inf 1e400 1e-320 0x \
        5x ' 7' '+-1' '1,,2' '' 4x
}
# refuses CODE OPTION COMMAND...: with OPTION and each word behind it, as one argument, the command
# ends with CODE within ten seconds, and names the word.
refuses() {
    code=$1 option=$2
    shift 2
    no_numbers >"$TMP/no_numbers"
    while IFS= read -r word; do
        timeout 10 "$@" "$option$word" >"$TMP/said" 2>&1 </dev/null && rc=0 || rc=$?
        [ $rc -eq "$code" ] && grep -qF -e "$word" "$TMP/said" && continue
        echo "$* '$option$word': exit code $rc, not $code"
        head -n 3 "$TMP/said"
        return 1
    done <"$TMP/no_numbers"
}
