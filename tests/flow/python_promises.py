# python_promises.py - what the package's docstrings say, tried; see test_python.sh
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 python_promises.py ROOT TOOL"""
import inspect
import json
import multiprocessing
import os
import pickle
import re
import signal
import subprocess
import sys
import threading
import time
import typing
from pathlib import Path

import numpy as np
import sphaera
from sphaera._declared import ffi
from sphaera._library import lib

ROOT, TOOL = sys.argv[1:]
HEADER = Path(ROOT, "cmodel/sphaera/sphaera.h").read_text(encoding="utf-8")
PAPER5 = f"{ROOT}/scenes/paper5.nff"


def refused(kind, pattern, function, *words, **named):
    """Raises that kind of error, with a message that has the pattern."""
    try:
        function(*words, **named)
    except kind as e:
        assert re.search(pattern, str(e)), f"{e}: no {pattern}"
        return
    raise AssertionError(f"no {kind.__name__} {pattern}")


def declarations():
    """All of the header, as the C compiler sees it, and nothing that the package forgets."""
    names = set(re.findall(r"^SPHAERA_API .*?(sphaera_\w+)\(", HEADER, re.M))
    assert len(names) == HEADER.count("\nSPHAERA_API ")
    assert all(callable(getattr(lib, name)) for name in names)
    used = "".join(p.read_text(encoding="utf-8") for p in Path(sphaera.__path__[0]).glob("*.py")
                   if p.name != "_declared.py")
    unused = {name for name in names if name not in used}
    assert unused == {"sphaera_counter_find"}, unused  # a dictionary finds
    lines, expected = [], []
    for kind in ("sphaera_build_options", "sphaera_hit", "sphaera_error"):
        lines.append(f"sizeof({kind})")
        expected.append(ffi.sizeof(kind))
        for field, _ in ffi.typeof(kind).fields:
            lines += [f"offsetof({kind}, {field})", f"sizeof((({kind} *)0)->{field})"]
            expected += [ffi.offsetof(kind, field),
                         ffi.sizeof(dict(ffi.typeof(kind).fields)[field].type)]
    lines += [name for name in ("SPHAERA_AUTO", "SPHAERA_OFF", "SPHAERA_ON", "SPHAERA_NONE")]
    expected += [lib.SPHAERA_AUTO, lib.SPHAERA_OFF, lib.SPHAERA_ON, lib.SPHAERA_NONE]
    Path("sizes.c").write_text(
        '#include <stdio.h>\n#include "sphaera/sphaera.h"\nint main(void) {\n'
        + "".join(f'    printf("%ld\\n", (long)({line}));\n' for line in lines) + "}\n",
        encoding="utf-8")
    subprocess.run(["cc", f"-I{ROOT}/cmodel", "sizes.c", "-o", "sizes"], check=True)
    said = subprocess.run(["./sizes"], check=True, stdout=subprocess.PIPE, text=True).stdout
    assert [int(n) for n in said.split()] == expected, (said.split(), expected)


def words():
    """Each public name has a docstring and type hints that resolve."""
    for name in sphaera.__all__:
        thing = getattr(sphaera, name)
        if not callable(thing):
            continue
        assert inspect.getdoc(thing), name
        for part, what in inspect.getmembers(thing) if inspect.isclass(thing) else []:
            function = what.fget if isinstance(what, property) else getattr(what, "func", what)
            if part.startswith("_") or not inspect.isroutine(function) \
                    or part not in vars(thing) or issubclass(thing, tuple):
                continue
            assert inspect.getdoc(function), f"{name}.{part}"
            assert "return" in typing.get_type_hints(function), f"{name}.{part}"
    assert Path(sphaera.__path__[0], "py.typed").exists()
    assert sphaera.__version__ == Path(ROOT, "VERSION").read_text(encoding="utf-8").strip()


def frames():
    """Arrays, counters, hash and picture are the tool's."""
    scene = sphaera.read(PAPER5)
    assert scene.spheres == 5 and scene.facets == 0
    machine = scene.build(profile="standard", width=64, height=48, depth=1)
    assert (machine.width, machine.height, machine.profile) == (64, 48, "standard")
    frame = machine.render()
    for array, dtype in ((frame.id, np.uint32), (frame.key, np.uint64), (frame.visits, np.uint32)):
        assert array.shape == (48, 64) and array.dtype == dtype and not array.flags.writeable
    assert frame.rgb().shape == (48, 64, 3) and frame.rgb().dtype == np.uint8
    assert frame.id is frame.id and frame.rgb() is not frame.rgb()
    assert ((frame.id == sphaera.NONE) == (frame.key == 0)).all() and frame.errors == 0
    seen = set(np.unique(frame.id))
    assert seen <= {0, 1, 2, 3, 4, sphaera.NONE} and len(seen) > 2
    assert frame.visits.sum(dtype=np.uint64) == frame.counters["node_visits"] > 0
    assert (frame.rgb(2) >= frame.rgb(0)).any() and (frame.rgb(0) != frame.rgb(1)).any()
    frame.write("five.png")
    said = subprocess.run([TOOL, "render", PAPER5, "--profile", "standard", "--size", "64x48",
                           "--depth", "1", "-o", "tool.png"], check=True, text=True,
                          stdout=subprocess.PIPE).stdout
    assert f"{frame.hash:016x}" in said, (said, frame)
    subprocess.run([TOOL, "compare", "five.png", "tool.png"], check=True,
                   stdout=subprocess.DEVNULL)
    machine.write("five.sph")
    again = sphaera.Machine.read("five.sph").render(threads=1)
    pixels = again.id
    del again
    assert (pixels == frame.id).all()  # arrays live longer than their frame
    dark = scene.build(profile="standard", width=64, height=48, depth=1, shadow=False).render()
    assert dark.hash != frame.hash and dark.counters["rays_shadow"] == 0


def ray():
    """One ball in the middle: from outside, from inside, past it."""
    scene = sphaera.parse("v from 0 0 9 at 0 0 0 up 0 1 0 angle 40 resolution 64 48\nl 4 6 8\n"
                          "f 0.9 0.3 0.2 0.7 0.3 10 0 1\ns 0 0 0 1\n")
    machine = scene.build(profile="fine")
    hit = machine.trace((0, 0, 4), (0, 0, -2))
    assert hit.id == 0 and not hit.inside and abs(hit.distance - 3) < 0.01 and hit.key > 0
    assert np.allclose(hit.point, (0, 0, 1), atol=0.01)
    assert machine.trace(np.zeros(3), np.array([0, 1, 0])).inside
    assert machine.trace((0, 0, 4), (0, 1, 0)) is None
    table = sphaera.read(PAPER5).price(width=64, height=36, keep_pixels=1, keep_psnr=50)
    assert [row.name for row in table.rows] == ["draft", "standard", "fine", "reference"]
    assert table.rows[table.best].keeps and not any(row.keeps for row in table.rows[:table.best])
    assert all(row.why is None and row.pixels == 64 * 36 for row in table.rows)
    refused(sphaera.Error, "-1 dB", scene.price, keep_psnr=-1)
    refused(sphaera.Error, "outside the grid", machine.trace, (0, 0, 1e9), (0, 0, -1))
    refused(sphaera.Error, "no length", machine.trace, (0, 0, 4), (0, 0, 0))
    refused(ValueError, "three numbers", machine.trace, (0, 0), (0, 0, 1))


def errors():
    """The tool's messages; the wrong type, the wrong number."""
    scene = sphaera.read(PAPER5)
    refused(sphaera.Error, "^nowhere.nff: .*No such file", sphaera.read, "nowhere.nff")
    refused(sphaera.Error, "^memory.nff:2: ", sphaera.parse, "\ns 1 2 x 4")
    refused(sphaera.Error, "^mine:1: ", sphaera.parse, b"s 1 2 x 4", name="mine")
    refused(sphaera.Error, "'standart' is none of", scene.build, profile="standart")
    refused(sphaera.Error, "'tree', none of auto", scene.build, accel="tree")
    refused(sphaera.Error, "depth is 11", scene.build, depth=11)
    refused(sphaera.Error, "byte 0", scene.build, profile="draft\0x")
    refused(TypeError, "shadows", scene.build, shadows=True)
    refused(OverflowError, "", scene.build, width=1 << 40)
    machine = scene.build(profile="draft", width=16, height=9)
    refused(sphaera.Error, "threads is -1", machine.render, threads=-1)
    refused(sphaera.Error, "no picture is written as .xyz", machine.render().write, "five.xyz")
    refused(ValueError, "layer is 3", machine.render().rgb, 3)
    refused(sphaera.Error, "paper5.nff.*not a machine", sphaera.Machine.read, PAPER5)


def threads():
    """This thread runs while another renders; eight share a machine."""
    scene = sphaera.read(f"{ROOT}/scenes/paper100.nff")
    machine = scene.build(profile="standard", width=480, height=270)
    times, hashes, waited = [], [], 0

    def render():
        times.append(time.monotonic())
        hashes.append(machine.render(threads=1).hash)
        times.append(time.monotonic())

    thread = threading.Thread(target=render)
    last = time.monotonic()
    thread.start()
    while thread.is_alive():
        now = time.monotonic()
        waited, last = max(waited, now - last), now
    assert waited < (times[1] - times[0]) / 2, f"stood for {waited} s, {times} is the drawing"
    many = [threading.Thread(target=render) for _ in range(8)]
    machine = scene.build(profile="standard", width=96, height=54)
    for thread in many:
        thread.start()
    for thread in many:
        thread.join()
    assert len(hashes) == 9 and len(set(hashes[1:])) == 1


def strict():
    """What is not used as it stands is an error, of the scene and of its machine."""
    twice = "v from 0 0 9 at 0 0 0 up 0 1 0 angle 40 resolution 64 48\nf 1 1 1 1 0 0 0 1\n" \
            "s 0 0 0 1\ns 0 0 0 1\n"
    merged = twice.replace("s 0 0 0 1\ns 0 0 0 1", "s 0 0 0 1\ns 0 0 1e-9 1")
    records = {record.kind: record for record in sphaera.parse(twice).records}
    assert records["sphere that stands there twice"][1:] == ("left out", 1, "memory.nff", 4)
    Path("twice.nff").write_text(twice, encoding="utf-8")
    Path("merged.nff").write_text(merged, encoding="utf-8")
    refused(sphaera.Error, "^twice.nff:4: left out: sphere .*line 3", sphaera.read, "twice.nff",
            strict=True)
    refused(sphaera.Error, "^merged.nff:4: left out: .*grid",
            sphaera.read("merged.nff", strict=True).build)
    said = subprocess.run([TOOL, "info", "twice.nff", "--json", "-"], check=True, text=True,
                          stdout=subprocess.PIPE).stdout
    ours = [{**r._asdict(), "line": r.line or None} for r in sphaera.read("twice.nff").records]
    assert json.loads(said)["ledger"] == ours, (said, ours)
    machine = sphaera.parse(merged).build(profile="standard", width=64, height=48)
    machine.write("merged.sph")
    said = subprocess.run([TOOL, "info", "merged.sph", "--json", "-"], check=True, text=True,
                          stdout=subprocess.PIPE).stdout
    read = sphaera.Machine.read("merged.sph").records
    assert [r.kind for r in read] == ["sphere", "machine: registers and memory"], read
    assert json.loads(said)["ledger"] == [{**r._asdict(), "line": None} for r in read]


def pickled():
    """Machines and frames survive, with all that they tell."""
    machine = sphaera.read(PAPER5).build(width=64, height=48)
    frame = machine.render()
    again, drawn = pickle.loads(pickle.dumps((machine, frame)))
    assert (again.why, again.warning, again.records) == (machine.why, machine.warning,
                                                         machine.records) and machine.why
    assert again.render().hash == frame.hash == drawn.hash
    assert drawn.counters == frame.counters and drawn.errors == frame.errors
    assert (drawn.rgb(1) == frame.rgb(1)).all() and (drawn.key == frame.key).all()
    for name, picture in (("one", frame), ("two", drawn)):
        picture.write(f"{name}.exr")
    assert Path("one.exr").read_bytes() == Path("two.exr").read_bytes()
    data = bytearray(pickle.dumps(frame))
    data[-len(data) // 4] ^= 1  # of its pixels
    refused(sphaera.Error, "damaged", pickle.loads, bytes(data))


def children():
    """A child of any kind draws what its parent drew, before and after it, and sends it back."""
    machine = sphaera.read(PAPER5).build(width=64, height=48)
    for way in ("fork", "spawn", "forkserver"):
        context = multiprocessing.get_context(way)
        frame = machine.render()
        with context.Pool(2) as pool:
            found = pool.map(sphaera.Machine.render, [machine] * 4)
        assert [each.hash for each in found] == [frame.hash] * 4, way
        assert machine.render().hash == frame.hash, way


def interrupts():
    """Ctrl-C ends a drawing of seconds within a tenth of one; on a busy machine one of some tries
    does. What is written is there whole or not at all, with nothing beside it."""
    machine = sphaera.read(f"{ROOT}/scenes/paper100.nff").build(profile="standard", width=8000,
                                                                height=4500)
    small = sphaera.read(PAPER5).build(width=1600, height=900).render()
    folder = Path("interrupted")
    folder.mkdir()
    for what, words in ((machine.render, ()), (small.write, (folder / "a.png",))):
        late = []
        for wait in (0.2, 0.1, 0.05, 0.02, 0.01):
            sent = []
            timer = threading.Timer(wait, lambda: (sent.append(time.monotonic()),
                                                   os.kill(os.getpid(), signal.SIGINT)))
            timer.start()
            try:
                what(*words)
                timer.join()
                time.sleep(1)
                assert what == small.write, "not interrupted"
            except KeyboardInterrupt:
                late.append(time.monotonic() - sent[0])
        assert what == small.write or min(late) < 0.1, late
    assert [p.name for p in folder.iterdir()] in ([], ["a.png"]), list(folder.iterdir())
    again = sphaera.read(PAPER5).build(width=1600, height=900).render()
    again.write("whole.png")
    assert again.hash == small.hash
    for path in folder.iterdir():
        assert path.read_bytes() == Path("whole.png").read_bytes()


if __name__ == "__main__":  # a child that is spawned reads this file too
    for promise in (declarations, words, frames, ray, errors, threads, strict, pickled, children,
                    interrupts):
        promise()
