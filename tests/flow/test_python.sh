#!/bin/sh
# test_python.sh - pip install . in an environment of its own: what the package promises, examples
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
root=$PWD BUILD=${BUILD:-$root/build}
python=
for python in python3 /usr/bin/python3 none; do # another python3 may come first in the PATH
    "$python" -c 'import cffi, hatchling, numpy' 2>"$TMP/err" && break
done
if [ $python = none ]; then
    tap 1 "cffi, hatchling and numpy are there (make setup)" "$TMP/err"
    done_testing
    exit 1
fi
into() { # environment, source tree
    "$python" -m venv --system-site-packages "$1" &&
        env B="$BUILD" "$1/bin/pip" install -q --disable-pip-version-check --no-build-isolation \
            --no-index "$2"
}
check "pip install ." into "$TMP/env" .
mine=$TMP/env/bin/python
cd "$TMP" || exit 1 # nothing of the tree is found by chance
check "what it promises" "$mine" "$root/tests/flow/python_promises.py" "$root" "$BUILD/sphaera"
check "a sweep" sh -c "'$mine' '$root/examples/python/sweep.py' '$root/scenes/paper5.nff' >swept &&
    cat swept && [ \$(grep -cE '^[a-z]+ +[1-9][0-9]* visits, [0-9]+ pixels' swept) = 4 ] &&
    grep -q '^reference .* 0 pixels' swept"
check "... in ten lines" [ "$(sed '1,/^import sys/d' "$root/examples/python/sweep.py" |
    grep -c .)" -le 10 ]
check "rays, stages, a scoreboard" sh -c "'$mine' '$root/examples/python/rays.py' >rays &&
    cat rays && grep -qE '^[1-9][0-9]% hit, [0-9.]+ visits a ray' rays &&
    grep -q '^root root=0x' rays && grep -q '^1 differs: pixel 20,20 differs' rays"
packages=$("$mine" -c 'import sphaera; print(sphaera.__path__[0] + "/..")')

# ---- OpenImageIO is loaded for what needs it ----
check "neither import nor PNG loads OpenImageIO" "$mine" -c "
import sphaera
scene = sphaera.read('$root/scenes/paper5.nff')
frame = scene.build(profile='draft', width=16, height=9).render()
mapped = lambda: 'OpenImageIO' in open('/proc/self/maps').read()
frame.write('small.png')
assert not mapped()
frame.write('small.tif')
assert mapped()"
cp -r "$packages/sphaera" bare && mkdir moved && mv bare moved/sphaera
rm moved/sphaera/sphaera_image.so
check "without what writes TIFF it says so" sh -c "PYTHONPATH=moved '$mine' -c '
import sphaera
assert sphaera.__file__.startswith(\"$TMP/moved\"), sphaera.__file__
frame = sphaera.read(\"$root/scenes/paper5.nff\").build(width=16, height=9).render()
try:
    frame.write(\"none.tif\")
except sphaera.Error as e:
    assert \"moved/sphaera/sphaera_image.so\" in str(e), e
else:
    raise AssertionError(\"written\")'"

cat >forked.py <<END
import os, signal, sphaera
machine = sphaera.read('$root/scenes/texture/kitchen.nff').build(width=64, height=36)
right = machine.render().hash
if not os.fork():
    signal.alarm(60)
    os._exit(machine.render().hash != right)
raise SystemExit(os.wait()[1] != 0)
END
check "a forked child draws what its parent drew" "$mine" forked.py

cat >unload.py <<END
import sphaera
sphaera.read('$root/scenes/paper5.nff').build(width=16, height=9).render()
END
ends_well() { for _ in 1 2 3 4 5 6 7 8; do "$mine" unload.py || return 1; done; }
check "a program ends well that has drawn" ends_well

# ---- the notebook ----
cd "$root" || exit 1
PYTHONPATH=$packages "$python" -m lab notebook examples/python/sweep.ipynb >"$TMP/out" 2>&1
case $? in
3) echo "ok $((checks += 1)) - # SKIP there is no nbclient" ;;
0) tap 0 "the notebook shows what it stores" "$TMP/out" ;;
*) tap 1 "the notebook shows what it stores" "$TMP/out" ;;
esac
done_testing
