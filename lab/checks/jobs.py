# jobs.py - results whose sources change, and a write that is broken off
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.checks.jobs FOLDER"""
import os
import sys

from ..jobs import store
from ..sweep import axes

folder = sys.argv[1]
source = os.path.join(folder, "source")
os.makedirs(folder)
key = axes.job("cells", effects="none")


def put(text):
    with open(source, "w", encoding="utf-8") as f:
        f.write(text)


put("one")
results = os.path.join(folder, "results")
store.save(results, key, [source], {"n": 1})
assert store.look(results, key) == ({"n": 1}, None)
put("two")
assert store.look(results, key) == (None, "sources changed")
put("one")
assert store.look(results, key)[0] == {"n": 1}
os.remove(source)
assert store.look(results, key) == (None, "sources changed")
assert store.look(results, axes.job("cells", effects="all")) == (None, "never run")


def broken(*_):
    raise KeyboardInterrupt


# a write that ends before its rename: the old result stays, nothing lies beside it
put("one")
replace, os.replace = os.replace, broken
try:
    store.save(results, key, [source], {"n": 2})
    raise AssertionError("no interrupt")
except KeyboardInterrupt:
    pass
os.replace = replace
assert store.look(results, key)[0] == {"n": 1}
assert os.listdir(results) == [os.path.basename(store.path(results, key))], os.listdir(results)

# a key is one text, whatever the order in which its words are given
assert axes.job("cells", engines=2, effects="none") == axes.job("cells", effects="none",
                                                                 engines="2")
assert len({store.path("", k) for k in (key, axes.job("cells", effects="none", root_step=2))}) == 2
