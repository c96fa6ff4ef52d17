# tasks.py - files that commands make of others: what is older than its sources is made anew
# SPDX-License-Identifier: Apache-2.0
"""A list of tasks is in an order in which each stands behind those that make what it needs. Several
run at once. What breaks off leaves no target, and the same call goes on from there."""
import glob
import os
import shlex
import subprocess
import sys
from collections import namedtuple
from concurrent.futures import FIRST_COMPLETED, ThreadPoolExecutor, wait

from . import intact

# target, needs: files; words: a command, or a function without arguments; say: what is shown;
# prints: the command prints the target, else it makes it and what it prints goes to a log beside it
Task = namedtuple("Task", "target needs words say prints env", defaults=("", False, None))

# of the make that called this: a make that is called from here has jobs of its own
OF_MAKE = ("MAKEFLAGS", "MFLAGS", "MAKELEVEL", "SPHAERA_JOBS")


def jobs():
    return int(os.environ.get("JOBS") or os.cpu_count())


def clean():
    """The environment without what a calling make has left."""
    return {name: value for name, value in os.environ.items() if name not in OF_MAKE}


def old(task):
    try:
        made = os.stat(task.target).st_mtime_ns
    except FileNotFoundError:
        return True
    return any(os.stat(need).st_mtime_ns > made for need in task.needs)


def run(words, log, env=None):
    """A command, and what it prints as a file; nothing is no file. A failure tells it."""
    done = subprocess.run(words, env={**clean(), **(env or {})}, check=False, text=True,
                          errors="replace", stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.stdout:
        intact.write(log, done.stdout)
    if done.returncode:
        raise RuntimeError(f"{shlex.join(words)}:\n{done.stdout}")


def make(task):
    if os.environ.get("V") == "1":
        print(task.words if callable(task.words) else shlex.join(task.words), flush=True)
    elif task.say:
        print("  {:<4} {}".format(*task.say.split(" ", 1)), flush=True)
    os.makedirs(os.path.dirname(task.target), exist_ok=True)
    if callable(task.words):
        task.words()
    elif task.prints:
        with intact.beside(task.target) as new:
            with open(new, "w", encoding="utf-8") as f:
                subprocess.run(task.words, check=True, stdout=f, env=clean())
    else:
        try:
            run(task.words, f"{task.target}.log", task.env)
        except BaseException:
            if os.path.exists(task.target):
                os.remove(task.target)
            raise


def wanted(tasks, targets):
    """Those tasks, and what they need."""
    chosen = set(targets)
    for task in reversed(tasks):
        if task.target in chosen:
            chosen.update(task.needs)
    unknown = set(targets) - {task.target for task in tasks}
    if unknown:
        sys.exit(f"nothing makes {' '.join(sorted(unknown))}")
    return [task for task in tasks if task.target in chosen]


def make_all(tasks, targets=()):
    """Makes the targets, all if none is named."""
    left = wanted(tasks, targets) if targets else list(tasks)
    coming, running, fault = {task.target for task in left}, {}, None
    with ThreadPoolExecutor(jobs()) as pool:
        while left or running:
            ready = [] if fault else [task for task in left if coming.isdisjoint(task.needs)]
            for task in ready[:jobs() - len(running)]:
                left.remove(task)
                if old(task):
                    running[pool.submit(make, task)] = task
                else:
                    coming.discard(task.target)
            if running and (len(running) == jobs() or not ready):
                for done in wait(running, return_when=FIRST_COMPLETED)[0]:
                    coming.discard(running.pop(done).target)
                    fault = fault or done.exception()
            if fault and not running:
                sys.exit(str(fault))


# ---- what the tasks of several experiments are ----
def rtl():
    return sorted(glob.glob("rtl/**/*.v", recursive=True) +
                  glob.glob("rtl/**/*.vh", recursive=True))


def tool(build, target, needs, *words, say="", prints=False):
    """A command of the tool; needs: what it reads."""
    path = f"{build}/sphaera"
    return Task(target, [*needs, path], [path, *words], say, prints)


def core(build, target, machine, *options, say="", **variables):
    """A machine through the RTL; variables: those of sim/core.sh."""
    return Task(target, [machine, *rtl()],
                ["sh", "sim/core.sh", "--machine", machine, *options, "--json", target], say,
                env={"BUILD": build, "JOBS": "1", **variables})
