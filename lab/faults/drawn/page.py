# page.py - tables of docs/results/verification.md: the kill rate of modules, what is left and why
# SPDX-License-Identifier: Apache-2.0
import collections
import re
import subprocess

from ...jobs import store
from ...pages import data, place
from . import equivalent
from .netlist import Fault

PAGE = "docs/results/verification.md"


def text(fault):
    other = f":{fault.other}" if fault.other >= 0 else ""
    return (f"{fault.module} {fault.where} {fault.cell}#{fault.nth} {fault.port}.{fault.bit} "
            f"{fault.mode}{other}")


def verdicts(tried):
    """{fault: (killed, timeout, equivalent or survived, bench or reason)}"""
    found, met = {}, set()
    for fault, rounds in tried.items():
        bench, verdict, _ = rounds[-1]
        why = bench
        known = equivalent.rtl(text(fault)) if verdict == "survived" else None
        if known:
            verdict, why = "equivalent", known[1]
            met.add(known[0])
        found[fault] = verdict, why
    for entry in sorted({entry for entry, *_ in equivalent.entries(equivalent.RTL)} - met):
        print(f"mutants: {equivalent.RTL}: nothing that is left falls under {entry}")
    return found


def rate(count):
    alive = count["survived"]
    killed = count["killed"] + count["timeout"]
    return f"{100 * killed / (killed + alive):.1f}" if killed + alive else "-"


def row(name, count):
    return [name, str(sum(count.values())), str(count["killed"]), str(count["timeout"]),
            str(count["equivalent"]), str(count["survived"]), rate(count)]


BY = {"core": "the core", "proof": "a proof", "board": "a board", "top": "rt_top"}
HEAD = ["faults", "killed", "too long", "equivalent", "left", "killed, %"]


def folder(module, found={}):  # pylint: disable=dangerous-default-value
    if not found:
        import glob
        import os
        found.update({os.path.basename(n)[:-2]: n.split("/")[1] for n in glob.glob("rtl/*/*.v")})
    return found[module]


def parse(name):
    """The fault of a name."""
    head, cell, nth, port, bit, mode, other = re.fullmatch(
        r"(\S+ \S+) (.+)#(\d+) (\S+)\.(\d+) (\w+?)(?::(\d+))?", name).groups()
    module, where = head.split()
    return Fault(module, where, cell, int(nth), port, int(bit), mode, int(other or -1))


def known():
    """{fault: [verdict, bench, seconds]} as the page's list has them."""
    return {parse(row[0]): row[1:] for row in data.read("verification.faults")[1]}


def tables(found, rest=False):
    """The tables of {fault: (verdict, bench, reason, seconds)}; rest: some alone are new."""
    modules, folders = (collections.defaultdict(collections.Counter) for _ in range(2))
    for fault, (verdict, *_) in found.items():
        modules[fault.module][verdict] += 1
        folders[folder(fault.module)][verdict] += 1
    total = sum(folders.values(), collections.Counter())
    why = collections.Counter(w for v, _, w, _ in found.values() if v == "equivalent")
    by = collections.Counter(BY.get(bench.split("/")[0], "a bench")
                             for v, bench, *_ in found.values() if v in ("killed", "timeout"))
    place.place(PAGE, "make campaign", {
        "modules": [["module", *HEAD], *(row(m, modules[m]) for m in sorted(modules))],
        "faults": [["fault", "verdict", "by", "seconds"],
                   *([text(f), verdict, bench, seconds]
                     for f, (verdict, bench, _, seconds) in sorted(found.items()))],
        "folders": [["rtl/", *HEAD], *(row(n, folders[n]) for n in sorted(folders)),
                    row("**all**", total)],
        "reasons": [["faults", "why nothing can notice them"],
                    *([str(n), w] for w, n in why.most_common())],
        "rounds": [["killed by", "faults"], *([name, str(n)] for name, n in by.most_common())]},
                rest=rest)
    left = [text(f) for f in sorted(found) if found[f][0] == "survived"]
    print(f"mutants: {rate(total)} % of those that are not equivalent are killed, "
          f"{len(left)} are left", *left, sep="\n  ")


def write(tried, listed, seed):
    found = {}
    for fault, (verdict, why) in verdicts(tried).items():
        found[fault] = (verdict, tried[fault][-1][0], why,
                        f"{sum(s for _, _, s in tried[fault]):.2f}")
    tables(found)
    place.place(PAGE, "make campaign", {"run": [
        ["seed", "faults listed", "run", "rounds of 4", "processor's minutes", "digest of rtl/",
         "day"],
        [str(seed), str(listed), str(len(found)),
          str(max(map(len, tried.values()), default=0)),
          f"{sum(s for r in tried.values() for _, _, s in r) / 60:.0f}",
          store.digest(["rtl/*/*.v", "rtl/*/*.vh"])[:8],
          subprocess.run(["date", "-u", "+%F"], check=True, text=True,
                         stdout=subprocess.PIPE).stdout.strip()]]})
