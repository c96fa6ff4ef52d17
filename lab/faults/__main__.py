# __main__.py - plants the faults of tests/faults and tells who notices them
# SPDX-License-Identifier: Apache-2.0
import argparse
import glob
import os
import re
import signal
import sys
from concurrent.futures import ThreadPoolExecutor

from .. import intact
from ..benches import Broken
from . import records
from .planted import Planting, Shop

MOST = 20   # messages of what is wrong in lists


def cell(record, side, judges):
    """Where a side has the fault, and who notices it; `*`: in the longer target alone."""
    files = ", ".join(f"`{edit.file}`" for edit in record.edits if edit.side == side)
    mine = [f"{judge}{' *' if judge.more else ''}" for judge in judges
            if side in {edit.side for edit in record.side(judge)}]
    return f"{files}: {'; '.join(mine)}" if mine else ""


def table(picked):
    """A table of faults and of who notices them."""
    print("| fault | rule | model | RTL | proof's own files |\n|---|---|---|---|---|")
    for record, judges in picked:
        print("|", record.name, "|", record.rule.replace("|", "\\|"), "|",
              " | ".join(cell(record, side, judges) for side in ("model", "rtl", "formal")), "|")


def groups(text):
    words = text.split(",")
    for word in words:
        if word not in records.GROUPS:
            raise argparse.ArgumentTypeError(
                f"{word} is none of {', '.join(records.GROUPS)}"
                + records.nearest(word, records.GROUPS))
    return words


def count(text):
    if not re.fullmatch("[1-9][0-9]{0,3}", text):
        raise argparse.ArgumentTypeError(f"{text} is no number of 1 to 9999")
    return int(text)


def arguments(words):
    parser = argparse.ArgumentParser(prog="python3 -m lab faults", epilog=records.__doc__,
                                     description="Plants the faults of tests/faults/*.txt, each "
                                     "in a private copy, and tells who notices them.",
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", metavar="COMMAND", required=True)
    chosen = argparse.ArgumentParser(add_help=False)
    chosen.add_argument("pattern", nargs="?", default=os.environ.get("MUTANT", ""),
                        metavar="PATTERN", help="faults whose name or judge has it in it, or "
                        "FILE.txt: of one list ($MUTANT)")
    chosen.add_argument("--list", action="append", default=[], metavar="FILE",
                        help=f"other lists than {records.LISTS}")
    chosen.add_argument("--by", type=groups, default=list(records.GROUPS), metavar="GROUP,...",
                        help="judges of these groups: " + ", ".join(records.GROUPS))
    built = argparse.ArgumentParser(add_help=False)
    built.add_argument("--build", default=os.environ.get("BUILD", "build"), metavar="FOLDER",
                       help="build folder ($BUILD or %(default)s)")
    run = commands.add_parser("run", parents=[chosen, built], help="prints TAP, a line a judge",
                              description="Asks the judges that run in the tests, with a PATTERN "
                              "or --all those of the longer target too.")
    run.add_argument("--all", action="store_true", default=bool(os.environ.get("ALL")),
                     help="judges of the longer target too ($ALL)")
    run.add_argument("--jobs", type=count, default=os.environ.get("JOBS") or "2", metavar="N",
                     help="faults at once ($JOBS or 2)")
    commands.add_parser("check", parents=[chosen], help="reads the lists and tells what is wrong")
    commands.add_parser("table", parents=[chosen], help="prints a table: fault, rule, who notices")
    keep = commands.add_parser("program", parents=[built], help="keeps a program with a fault",
                               description="Links `hard` with the fault of a name in the model.")
    keep.add_argument("name", metavar="FAULT")
    keep.add_argument("out", metavar="PROGRAM")
    edit = commands.add_parser("edit", help="edits one file, for a test that does the rest itself")
    edit.add_argument("file", metavar="FILE")
    edit.add_argument("old", metavar="FROM", help="stands there exactly once, as in a list")
    edit.add_argument("new", metavar="TO")
    return parser.parse_args(words)


def chosen(found, pattern, by):
    """[(record, judges)] of what is asked for."""
    picked = []
    for record in found:
        mine = [judge for judge in record.judges if judge.group in by and judge.kind != "naive" and
                (pattern in record.name or pattern in str(judge)
                 or pattern == os.path.basename(record.file))]
        if mine:
            picked.append((record, mine))
    return picked


def nothing(asked, found):
    return (f"faults: no fault has {asked.pattern} in its name or judge"
            + records.nearest(asked.pattern, [record.name for record in found]))


class Tap:
    def __init__(self):
        self.count, self.bad = 0, 0

    def line(self, ok, what, log=""):
        self.count += 1
        self.bad += not ok
        print(f"{'ok' if ok else 'not ok'} {self.count} - {what}", flush=True)
        if not ok:
            print(*("# " + line for line in log.splitlines()[-60:]), sep="\n", flush=True)


def sound(picked, longer):
    """Judges that the sound sources have to pass, by what is built for them. Benches as a whole
    are run by tests/flow/test_benches.sh, proofs and resets by `make formal`."""
    found = {}
    for record, judges in picked:
        for judge in judges + [record.oracle()] * (record.agree() in judges):
            if judge.kind in ("proof", "reset", "crossings", "test", "naive") or (
                    judge.kind == "bench" and not longer):
                continue
            built = judge.words[0] if judge.kind in ("bench", "case") else judge.kind
            found.setdefault(built, {})[judge.kind, judge.words] = judge
    return [list(judges.values()) for judges in found.values()]


def run(asked):
    found = records.read(asked.list)
    longer = asked.all or bool(asked.pattern)
    picked = [(record, [j for j in judges if longer or not j.more])
              for record, judges in chosen(found, asked.pattern, asked.by)]
    picked = [(record, judges) for record, judges in picked if judges]
    if not picked:
        sys.exit(nothing(asked, found))
    shop, tap = Shop(asked.build), Tap()

    def ask(record, judges, name=""):
        planting = Planting(shop, record, name or record.name)
        try:
            said = []
            for judge in judges:
                planting.log.clear()
                said.append((*planting.ask(judge), "\n".join(planting.log)))
            return said
        finally:
            planting.close()

    pool = ThreadPoolExecutor(asked.jobs)
    try:
        shop.prepare([judge for record, judges in picked for judge in record.judges
                      if judge in judges])
        first = sound(picked, longer)
        sounds = pool.map(lambda named: ask(None, named[1], f"sound{named[0]}"), enumerate(first))
        faults = pool.map(lambda pick: ask(*pick), picked)
        for judges, said in zip(first, sounds):
            for judge, (what, how, log) in zip(judges, said):
                tap.line(what == "passed", f"the sound sources pass {judge}"
                         + ("" if what == "passed" else f": {what}, {how}"), log)
        for (record, judges), said in zip(picked, faults):
            for judge, (what, how, log) in zip(judges, said):
                tell(tap, record, judge, what, how, log)
    except Broken as why:
        sys.exit(f"faults: {why}")
    finally:
        shop.close()
        pool.shutdown(cancel_futures=True)
        shop.remove()
    print(f"1..{tap.count}")
    return tap.bad > 0


def tell(tap, record, judge, what, how, log):
    name = f"fault {record.name} ({record.rule})"
    if "CBMC is not installed" in log:
        tap.line(True, f"{name}, {judge} # SKIP CBMC is not installed: make cbmc-setup")
    elif what == "noticed":
        tap.line(True, f"{name} noticed by {judge}: {how}")
    elif what == "passed":
        tap.line(False, f"{name} survives {judge}{': ' + how if how else ''}", log)
    else:
        tap.line(False, f"{name}: no verdict of {judge}: {how}", log)


def program(asked):
    record = next((r for r in records.read() if r.name == asked.name), None)
    judge = next((j for j in record.judges if j.kind == "hard"), None) if record else None
    if not judge:
        sys.exit(f"faults: {asked.name}: no fault of that name is noticed by a hard case")
    shop = Shop(asked.build)
    try:
        shop.prepare([judge])
        os.replace(Planting(shop, record, record.name).program(judge, "hard_named"), asked.out)
    finally:
        shop.remove()


def main(words):
    asked = arguments(words)
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
    try:
        if asked.command == "run":
            sys.exit(run(asked))
        if asked.command == "program":
            program(asked)
            return
        if asked.command == "edit":
            text = records.edited(asked.file, asked.old, asked.new)
            intact.write(asked.file, text)
            return
        found = records.read(asked.list)
        if asked.command == "check" and not asked.list:
            records.read(glob.glob(records.DESIGNED), judged=False)
        picked = chosen(found, asked.pattern, asked.by)
        if not picked:
            sys.exit(nothing(asked, found))
        if asked.command == "table":
            table(picked)
        else:
            print(f"{len(picked)} faults, {sum(len(judges) for _, judges in picked)} judges")
    except records.Refused as why:
        told = str(why).splitlines()
        sys.exit("\n".join(told[:MOST]) + (f"\nand {len(told) - MOST} more" * (len(told) > MOST)))

