# tasks.py - files that commands make of others: order, age, failures, files that are named
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.checks.tasks FOLDER"""
import contextlib
import os
import sys
import time
from pathlib import Path

from ..tasks import Task, make_all

folder = Path(sys.argv[1])
folder.mkdir(parents=True)
source = folder / "source"
source.write_text("1")
ran, most = [], [0]
running = set()


def of(name, *needs, fails=False):
    """A task that joins what it needs."""
    def work():
        running.add(name)
        most[0] = max(most[0], len(running))
        ran.append(name)
        if fails:
            raise RuntimeError(f"{name} fails")
        time.sleep(0.05)
        (folder / name).write_text("".join((folder / need).read_text() for need in needs))
        running.discard(name)
    return Task(str(folder / name), [str(folder / need) for need in needs], work)


def made(tasks, *names):
    ran.clear()
    make_all(tasks, [str(folder / name) for name in names])
    return sorted(ran)


def ends(tasks, *names):
    """What is said when it cannot go on."""
    with contextlib.suppress(KeyError):
        try:
            made(tasks, *names)
        except SystemExit as fault:
            return str(fault)
    raise AssertionError("it went on")


os.environ["JOBS"] = "2"
every = [of("a", "source"), of("b", "source"), of("c", "source"), of("ab", "a", "b"),
         of("abc", "ab", "c")]
assert made(every, "ab") == ["a", "ab", "b"] and most[0] == 2, (ran, most)
assert made(every) == ["abc", "c"], ran
assert ran.index("c") < ran.index("abc") and (folder / "abc").read_text() == "111"
assert made(every) == [] and "nothing makes" in ends(every, "d")
time.sleep(0.01)
(folder / "b").write_text("2")
assert made(every) == ["ab", "abc"] and (folder / "abc").read_text() == "121"

# ---- what fails is told, what needs it is not begun, what is done stays done ----
source.touch()
os.environ["JOBS"] = "1"
broken = [*every[:2], of("c", "source", fails=True), *every[3:]]
assert ends(broken) == "c fails" and "abc" not in ran, ran
left = made(every)
assert "c" in left and "abc" in left and "a" not in left, left

os.environ["JOBS"] = "2"
assert ends([of("slow", "source"), of("bad", "source", fails=True), of("late", "source")]) == \
    "bad fails" and "late" not in ran, ran

# ---- commands: what they print, and no half file ----
shell = folder / "shell"
command = Task(str(shell), [str(source)], ["sh", "-c", f"echo half >'{shell}'; echo why; exit 1"])
assert "why" in ends([command]) and not shell.exists()
printed = Task(str(shell), [str(source)], ["sh", "-c", "echo ${BAD:-whole}; exit ${BAD:-0}"],
               prints=True)
make_all([printed])
assert shell.read_text() == "whole\n"
time.sleep(0.01)
source.touch()
os.environ["BAD"] = "1"
assert "exit status 1" in ends([printed]) and shell.read_text() == "whole\n"
assert [path.name for path in folder.glob("shell.*")] == ["shell.log"], "nothing is left of it"
