# jobs.py - results whose sources change, and a write that is broken off
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.checks.jobs FOLDER"""
import os
import sys

from ..study import jobs

folder = sys.argv[1]
source = os.path.join(folder, "source")
os.makedirs(folder)
key = jobs.job("cells", core="none")


def put(text):
    with open(source, "w", encoding="utf-8") as f:
        f.write(text)


put("one")
results = os.path.join(folder, "results")
jobs.save(results, key, [source], {"n": 1})
assert jobs.look(results, key) == ({"n": 1}, None)
put("two")
assert jobs.look(results, key) == (None, "sources changed")
put("one")
assert jobs.look(results, key)[0] == {"n": 1}
os.remove(source)
assert jobs.look(results, key) == (None, "sources changed")
assert jobs.look(results, jobs.job("cells", core="all")) == (None, "never run")


def broken(*_):
    raise KeyboardInterrupt


# a write that ends before its rename: the old result stays, nothing lies beside it
put("one")
replace, os.replace = os.replace, broken
try:
    jobs.save(results, key, [source], {"n": 2})
    raise AssertionError("no interrupt")
except KeyboardInterrupt:
    pass
os.replace = replace
assert jobs.look(results, key)[0] == {"n": 1}
assert os.listdir(results) == [os.path.basename(jobs.path(results, key))], os.listdir(results)

# a key is one text, whatever the order in which its words are given
assert jobs.job("cells", engines=2, core="none") == jobs.job("cells", core="none", engines="2")
assert len({jobs.path("", k) for k in (key, jobs.job("cells", core="none", root=1))}) == 2
