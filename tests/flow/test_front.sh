#!/bin/sh
# test_front.sh - what a user types to make: wrong words are refused at once, and no run answers for
# another, whatever is typed twice, at the same time, or from elsewhere
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
has() { grep -q -- "$1" "$2"; } # pattern, file
plain_make() { env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL make --no-print-directory "$@"; }

# ---- two calls at the same time: a compiler that takes its time never sees half a file ----
cat >"$TMP/slow" <<'END'
#!/bin/sh
for word; do
    case $previous in -o) to=$word ;; -MF) dependencies=$word ;; esac
    case $previous/$word in
    -o/* | -MT/*) ;;
    */*.o | */*.a) { [ -s "$word" ] && ! grep -q half "$word"; } || echo "$word" >>"$HALVES" ;;
    esac
    previous=$word
done
echo half >"$to"
case $to in *.o | */sphaera) echo "$to is seen before it is whole" >>"$HALVES" ;; esac
case $to in *sphaera*) sleep 1 ;; *) sleep 0.05 ;; esac
echo whole >"$to"
[ -z "$dependencies" ] || : >"$dependencies"
END
chmod +x "$TMP/slow"
cold() { # name: the tool in a folder that both calls share
    previous='' dependencies='' HALVES=$TMP/halves plain_make -j8 -s B="$TMP/cold" CC="$TMP/slow" \
        CXX="$TMP/slow" tool >"$TMP/cold.$1" 2>&1 || echo "call $1 failed" >>"$TMP/halves"
    [ "$(cat "$TMP/cold/sphaera")" = whole ] || echo "call $1: half a tool" >>"$TMP/halves"
}
: >"$TMP/halves"
cold first &
sleep 0.3
cold second
wait
check "two calls build one tool" sh -c "head -n 5 '$TMP/halves'; [ ! -s '$TMP/halves' ]"

# ---- one build folder by two names ----
mkdir "$TMP/tree"
tar c --exclude=./build --exclude=./.git --exclude=./docs . | tar x -C "$TMP/tree"
object=obj/$(find cmodel -name error.c | sed 's/c$/o/')
in_tree() (
    cd "$TMP/tree" || exit 1
    "$@"
)
rebuilt() { # file that is touched, command, object: by a relative name, and then an absolute one
    touched=$1 call=$2
    in_tree $call B=build "build/$3" >"$TMP/text" 2>&1
    in_tree touch -r "build/$3" "$TMP/before"
    sleep 0.01
    in_tree touch $touched
    in_tree $call B="$TMP/tree/build" "$TMP/tree/build/$3" >>"$TMP/text" 2>&1
    cat "$TMP/text"
    [ "$TMP/tree/build/$3" -nt "$TMP/before" ]
}
check "a header of the model is seen by either name" rebuilt \
    "$(find cmodel -name error.h)" "plain_make" "$object"
in_tree touch build/libsphaera.a
check "a core is built by one name" sh -c "cd '$TMP/tree' && make -n -f '$(find . -name core.mk)' \
    B='$TMP/tree/build' tools >'$TMP/text' && ! grep '$TMP/tree/build' '$TMP/text'"
done_testing
