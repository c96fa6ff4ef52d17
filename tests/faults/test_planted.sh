#!/bin/sh
# test_planted.sh - lab.faults: what survives or has no verdict is told; lists that are wrong, too
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
unset ALL MUTANT

list=$TMP/list.txt
# A record that is right, with lines of it replaced: KEY, LINE that comes there.
record() {
    cat >"$list" <<'END'
fault a-tangent
rule  a tangent is a miss
model prim/sphere.c
from  ahead = r.disc > 0
to    ahead = r.disc >= 0
by    hard 1
END
    while [ $# -gt 0 ]; do
        KEY=$1 LINE=$2 awk '$1 == ENVIRON["KEY"] { $0 = ENVIRON["LINE"] } { print }' "$list" \
            >"$list.new" && mv "$list.new" "$list"
        shift 2
    done
}
run() { python3 -m lab faults run --list "$list" --build "$BUILD" >"$TMP/told" 2>&1; }
noticed() {
    record && run &&
        grep '^ok 2 - fault a-tangent (.*) noticed by hard 1: not ok 1 ' "$TMP/told"
}
check "a fault that is noticed" noticed
# What is told of such a record, which fails.
told() { # name, pattern, KEY, LINE...
    name=$1 pattern=$2
    shift 2
    record "$@"
    run && rc=1 || rc=0
    grep -q "$pattern" "$TMP/told" || rc=1
    tap $rc "$name" "$TMP/told"
}
told "an edit that nobody can notice" '^not ok 2 - fault a-tangent .* survives hard 1$' \
    to 'to ahead = 0 < r.disc'
told "a judge that does not meet it" '^not ok 2 - fault a-tangent .* survives hard 29$' \
    by 'by hard 29'
told "an edit that does not compile" \
    '^not ok 2 - fault a-tangent .*: no verdict of hard 1: cmodel/prim/sphere.c does not compile' \
    to 'to ahead = r.disk >= 0'
told "a crash" '^not ok 2 - fault a-tangent .*: no verdict of hard 1: ends with -' \
    to 'to ahead = *(volatile int *)0'
set -- model 'rtl shade/rt_light_add.v' from 'from out_tag_o <= in_tag_q;' \
    by 'by bench tb_light_add'
told "RTL that Verilator refuses" \
    '^not ok 1 - .*: no verdict of bench tb_light_add: verilator does not build it' \
    "$@" to 'to out_tag_o <= in_tag;'
told "RTL that aborts its simulator" \
    '^not ok 1 - fault a-tangent .*: no verdict of bench tb_light_add: ends with -' \
    "$@" to 'to out_tag_o <= in_tag_q; if (ph_q[3]) $stop;'

# ---- lists that are wrong ----
told "a text that is not there" \
    '^.*list.txt:3: from: stands 0 times in cmodel/prim/sphere.c, not once: ahead = none$' \
    from 'from ahead = none'
told "a text that stands there often" 'list.txt:3: from: stands [0-9]* times in' from 'from r'
told "an edit of nothing" 'list.txt:3: to: is what stands in cmodel/prim/sphere.c already' \
    to 'to ahead = r.disc > 0'
told "a file that is none" 'list.txt:3: model: there is no cmodel/prim/shpere.c; .*sphere.c is' \
    model 'model prim/shpere.c'
told "a judge that is none" 'list.txt:6: by: hrad is no judge; hard is meant?' by 'by hrad 1'
told "a case that is none" 'list.txt:6: by: 88 is no named case, 1 to 87' by 'by hard 88'
told "a test that is none" 'list.txt:6: by: there is no test test_limit; test_limits is' \
    by 'by test test_limit'
told "a bench that is none" 'by: there is no bench tb_laef/draft; tb_leaf/draft is meant?' \
    by 'by bench tb_laef/draft'
told "a proof that is none" 'by: there is no proof fifo_8x61; fifo_8x16 is' by 'by proof fifo_8x61'
told "a scene that is none" 'by: there is no scene scenes/none.nff' by 'by core scenes/none.nff'
told "a judge that sees another side" \
    'by: bench tb_leaf/draft: the record edits nothing that it sees' by 'by bench tb_leaf/draft'
told "the naive model without a scene" 'by: naive: draws the scene of an agree' by 'by naive'
told "a field that is none" 'list.txt:2: rull: is no field; rule is meant?' rule 'rull a miss'
told "no rule" 'list.txt:1: fault: a-tangent has no rule' rule ''
told "no judge" 'list.txt:1: fault: a-tangent has no by' by ''
told "a name with blanks" 'list.txt:1: fault: a tangent: not of small' fault 'fault a tangent'
twice() {
    record && cat "$list" "$list" >"$list.new" && mv "$list.new" "$list" && ! run &&
        grep 'list.txt:7: fault: a-tangent stands in .*list.txt:1, too' "$TMP/told"
}
check "a name that stands twice" twice
alike() {
    record && { cat "$list" && sed 's/a-tangent/b-tangent/' "$list"; } >"$list.new" &&
        mv "$list.new" "$list" && ! run && grep 'model: is edited as in a-tangent' "$TMP/told"
}
check "an edit that stands twice" alike
shown() { # the record that a page shows
    sed -n '/^fault /,/^```/p' docs/design/extending.md | grep -v '^```' >"$TMP/shown"
    head=$(sed -n 1p "$TMP/shown")
    [ -n "$head" ] && sed -n "/^$head\$/,/^\$/p" tests/faults/shade.txt | grep . |
        diff - "$TMP/shown"
}
check "docs/design/extending.md: the record that it shows" shown
check "the lists of tests/faults" python3 -m lab faults check
done_testing
