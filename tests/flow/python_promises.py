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
import unittest.mock
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
    unused = {name for name in names if not re.search(rf"{name}\b", used)}
    # others do the same: with options, for all of a list
    assert unused == {"sphaera_scene_read", "sphaera_scene_parse", "sphaera_render",
                      "sphaera_frame_write",
                      "sphaera_machine_register", "sphaera_machine_line"}, unused
    lines, expected = [], []
    structs = re.findall(r"^typedef struct \w+ \{.*?^\} (\w+);", HEADER, re.M | re.S)
    assert len(structs) > 10
    for kind in structs:
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


def arrays():
    """A scene of arrays is that of a file with the same numbers; what is wrong is named."""
    balls = np.array([[0, 0, 0, 1], [1.5, 0, 0, 0.5]])
    floor = [[[-4, -1, -4], [4, -1, -4], [0, -1, 5]]]
    stuff = [[0.9, 0.3, 0.2, 0.7, 0.3, 10, 0, 1], [0.2, 0.3, 0.9, 1, 0, 0, 0, 1]]
    view = {"eye": (0, 1, 9), "angle": 40, "shift": (0.1, -0.2), "width": 64, "height": 48}
    scene = sphaera.scene_of(spheres=balls, sphere_materials=[1, 0], triangles=floor,
                             materials=stuff, planes=[[0, -2, 0, 0, 1, 0]], lights=[[4, 6, 8]],
                             background=(0.1, 0.2, 0.3), **view)
    assert (scene.spheres, scene.facets) == (2, 2)
    text = ("v from 0 1 9 at 0 0 0 up 0 1 0 angle 40 shift 0.1 -0.2 resolution 64 48\n"
            "b 0.1 0.2 0.3\nl 4 6 8\n"
            "f 0.2 0.3 0.9 1 0 0 0 1\ns 0 0 0 1\nf 0.9 0.3 0.2 0.7 0.3 10 0 1\ns 1.5 0 0 0.5\n"
            "p 3 -4 -1 -4 4 -1 -4 0 -1 5\nplane 0 -2 0 0 1 0\n")
    machine = scene.build(profile="fine")
    assert machine.render().hash == sphaera.parse(text).build(profile="fine").render().hash
    scene.write("arrays.nff")
    assert sphaera.read("arrays.nff").build(profile="fine").render().hash == machine.render().hash
    images = [f"{ROOT}/scenes/texture/{name}.png" for name in ("globe", "letter")]
    st = [[[0, 0], [1, 0], [0.5, 1]]]
    textured = sphaera.scene_of(spheres=balls, sphere_materials=[1, 0], triangles=floor, st=st,
                                materials=stuff, textures=images, triangle_textures=[1],
                                sphere_textures=[sphaera.NONE, 0], lights=[[4, 6, 8]],
                                background=(0.1, 0.2, 0.3), **view)
    corners = "".join(f"{x} {y} {z} {s} {t}\n"
                      for (x, y, z), (s, t) in zip(floor[0], st[0]))
    told = text.replace("plane 0 -2 0 0 1 0\n", "").replace(
        "s 1.5", f"texture {images[0]} 1 1\ns 1.5").replace(
            "p 3 -4 -1 -4 4 -1 -4 0 -1 5\n", f"tt {images[1]}\n{corners}")
    drawn = [each.build(profile="fine").render()
             for each in (textured, sphaera.parse(told, allow_paths=True))]
    assert drawn[0].hash == drawn[1].hash and drawn[0].counters["texels"] > 0
    textured.write("textured.nff")
    again = sphaera.read("textured.nff", allow_paths=True)
    assert again.build(profile="fine").render().hash == drawn[0].hash
    make, nan = sphaera.scene_of, float("nan")
    for pattern, words in (
            (r"triangle_textures\[0\]: 2 is none of 2 textures", {
                "triangles": floor, "textures": images, "st": st, "triangle_textures": [2]}),
            ("st is NULL", {
                "triangles": floor, "textures": images, "triangle_textures": [0]}),
            (r"st\[0\]: corner 1 s is nan", {
                "triangles": floor, "st": [[[0, 0], [nan, 0], [0, 0]]]}),
            (r"textures\[0\]: the name of the image file is empty", {"textures": [""]}),
            (r"spheres\[1\]: radius is 0", {"spheres": [[0, 0, 0, 1], [0, 0, 0, 0]]}),
            (r"spheres\[0\]: y is nan", {"spheres": [[0, nan, 0, 1]]}),
            (r"sphere_materials\[0\]: 2 is none of 2", {"spheres": balls[:1],
                                                        "sphere_materials": [2],
                                                        "materials": stuff}),
            (r"triangles\[0\]: corner 2 z is inf", {"triangles": [[[0, 0, 0], [1, 0, 0],
                                                                   [0, 1, float("inf")]]]}),
            (r"materials\[0\]: T is 2, not within", {"materials": [[0] * 6 + [2, 1]]}),
            (r"planes\[0\]: the normal is zero", {"planes": [[0] * 6]}),
            (r"lights: 9 of them", {"lights": [[0, 0, 0]] * 9}),
            (r"light_colours\[0\]: green is negative", {"lights": [[0, 0, 0]],
                                                        "light_colours": [[1, -1, 0]]}),
            (r"background: red is 7", {"background": (7, 0, 0)}),
            (r"camera: from.x is nan", {"eye": (nan, 0, 0)}),
            (r"camera: .*angle", {"angle": 0}), (r"`shift` 65 is not", {"shift": (0, 65)}),
            (r"camera: .*", {"width": 0})):
        refused(sphaera.Error, pattern, make, **words)
    refused(ValueError, r"spheres has shape \(1, 3\)", make, spheres=[[0, 0, 1]])
    refused(ValueError, "normals are not as many", make, triangles=floor,
            normals=np.zeros((2, 3, 3)))
    refused(ValueError, "sphere_materials are not whole", make, spheres=balls,
            sphere_materials=[0.5, 1])


def batches():
    """Rays by the array are the rays one by one, and those of a frame."""
    for accel in ("bvh4", "bih", "box4", "brute"):
        machine = sphaera.read(f"{ROOT}/scenes/paper100.nff").build(
            profile="standard", accel=accel, width=48, height=32, depth=0, lights=0, inside=False)
        frame = machine.render()
        rays = [machine.primary(x, y) for y in range(32) for x in range(48)]
        org, to = (np.array(part) for part in zip(*rays))
        for threads in (1, 2):
            hits = machine.trace_rays(org, to, threads)
            assert (hits.id == frame.id.ravel()).all() and (hits.key == frame.key.ravel()).all()
            assert (hits.visits == frame.visits.ravel()).all()
            assert not hits.inside.any() and (hits.distance[hits.key > 0] > 0).all()
    rng = np.random.default_rng(1)
    org, to = rng.uniform(-2, 2, (200, 3)), rng.normal(size=(200, 3))
    first = machine.trace_rays(org, to)
    i = int(np.flatnonzero(first.key)[0])  # from within the ball that it hits
    org[0], to[0] = org[i] + to[i] / np.linalg.norm(to[i]) * (first.distance[i] + 0.01), to[i]
    hits = machine.trace_rays(org, to)
    for i, one in enumerate(map(machine.trace, org, to)):
        many = None if hits.id[i] == sphaera.NONE else (
            hits.id[i], hits.inside[i], hits.key[i], hits.distance[i], hits.visits[i])
        assert (one and (one[0], one[1], one[2], one[3], one[5])) == many, (i, one, many)
    assert hits.inside.any() and (hits.id == sphaera.NONE).any()
    assert len(machine.trace_rays(np.empty((0, 3)), np.empty((0, 3))).id) == 0
    to[7] = 0
    refused(sphaera.Error, r"directions\[7\] has no length", machine.trace_rays, org, to)
    org[5] = 1e9
    refused(sphaera.Error, r"origins\[5\] lies outside the grid", machine.trace_rays, org, to)
    refused(sphaera.Error, "threads is 2000", machine.trace_rays, org, to, 2000)
    refused(ValueError, r"\(200, 3\) and directions \(3,\)", machine.trace_rays, org, to[0])
    refused(sphaera.Error, "x is 48, not 0 to 47", machine.primary, 48, 0)


def options():
    """Every option of build does something or is refused by name; calls are watched, cancelled."""
    scene = sphaera.read(PAPER5)
    size = {"profile": "standard", "width": 64, "height": 48}
    plain = scene.build(**size)
    for words in ({"background": "spans", "bg_points": 32, "bg_border": 2},
                  {"background": "exact", "bg_levels": 1}, {"tree": "paper"}, {"lights": 0},
                  {"accel": "bih", "max_prims": 1, "max_tree_depth": 8, "bih": "listing"},
                  {"accel": "box4", "axes": "scene"}, {"least_weight": 0.5}, {"inside": True},
                  {"traverse": "first", "inside": True, "interpenetrate": True},
                  {"accel": "bih", "bih_fit": float("inf")}, {"samples": 2},
                  {"shift": (0.1, 0)}, {"eye": (0.5, 0, 0)}, {"wall": (2, 2, 0, 1)}):
        other = scene.build(**size, **words)
        assert other.registers.tolist() != plain.registers.tolist() or \
            other.memory.tolist() != plain.memory.tolist(), words
    assert scene.build(**size, samples=2).width == 128
    aimed = scene.build(**size, shift=(0.1, 0), eye=(0.5, 0.2, 0.1), wall=(2, 2, 1, 0)).render()
    said = subprocess.run([TOOL, "render", PAPER5, "--profile", "standard", "--size", "64x48",
                           "--shift", "0.1,0", "--eye-shift", "0.5,0.2,0.1", "--wall", "2x2:1,0",
                           "--json", "-"], check=True, text=True, stdout=subprocess.PIPE).stdout
    assert json.loads(said)["frame"]["hash"] == f"{aimed.hash:016x}"
    ball = sphaera.scene_of(spheres=[[0, 0, 0, 1], [0, 0, -4, 1]], lights=[[0, 0, 9]],
                            eye=(0, 0, 5))  # whose shadow nobody sees
    assert ball.build().parameters["SHADOW"] == 1
    assert ball.build(effects="met").parameters["SHADOW"] == 0
    for pattern, words in (("bg_points is for background 'spans'", {"bg_points": 16}),
                           ("bg_points is 3, not 4 to 4096", {"background": "spans",
                                                              "bg_points": 3}),
                           ("bg_levels is for", {"bg_levels": 1}),
                           ("tree is 'oak'", {"tree": "oak"}),
                           ("max_prims is for accel 'bih'", {"max_prims": 2}),
                           ("filter is 'x', none of nearest, bilinear", {"filter": "x"}),
                           ("lights is 9, not -1 to 8", {"lights": 9}),
                           ("least_weight is nan", {"least_weight": float("nan")}),
                           ("wall is 2, not 0 to 1", {"wall": (2, 2, 2, 0)}),
                           ("wall is 0, not 1 to", {"wall": (2, 0, 0, 0)}),
                           ("shift is nan", {"shift": (0, float("nan"))}),
                           ("eye is inf", {"eye": (0, float("inf"), 0)}),
                           ("the eye cannot move", {"eye": (0, 0, -1e6)}),
                           ("samples is 17", {"samples": 17}), ("clear is 3", {"clear": 3}),
                           ("error_pixels is -1", {"error_pixels": -1}),
                           ("lod_bits is 9", {"lod_bits": 9}),
                           ("interpenetrate on: ", {"interpenetrate": True})):
        refused(sphaera.Error, pattern, scene.build, **words)
    refused(TypeError, "shades is none of accel, ", scene.build, shades=1)
    told = []
    machine = scene.build(**size, progress=lambda done, all_: told.append((done, all_)))
    machine.render(progress=lambda done, all_: told.append((done, all_)))
    assert len(told) > 3 and all(0 <= done <= all_ for done, all_ in told)
    refused(sphaera.Error, "^cancelled$", scene.build, progress=lambda *_: True)
    refused(sphaera.Error, "^cancelled$", machine.render, progress=lambda *_: True)
    sphaera.read("random:3000").write("long.nff")
    refused(sphaera.Error, "^cancelled$", sphaera.read, "long.nff", progress=lambda *_: True)
    refused(ZeroDivisionError, "", machine.render, progress=lambda *_: 1 / 0)
    frames = {way: machine.render(traverse=way) for way in ("fast", "literal", "brute", "packets")}
    assert frames["literal"].hash == frames["fast"].hash == machine.render().hash
    assert all((f.rgb() == frames["fast"].rgb()).all() for f in frames.values())
    refused(sphaera.Error, "traverse is 'slow'", machine.render, traverse="slow")
    refused(sphaera.Error, "time is for AFF", sphaera.read, PAPER5, time=1.0)
    refused(sphaera.Error, "round is 2", sphaera.read, PAPER5, round=2)
    refused(sphaera.Error, "up is 'w'", sphaera.read, PAPER5, up="w")
    refused(sphaera.Error, "radius is -1", sphaera.read, PAPER5, radius=-1)


def refitted():
    """A tree that is refitted gives the frames of the tool's sequences."""
    robot, words = f"{ROOT}/scenes/texture/robot.nff", {"profile": "fine", "accel": "bvh4",
                                                        "width": 32, "height": 18}
    said = subprocess.run([TOOL, "render", robot, "--profile", "fine", "--accel", "bvh4", "--size",
                           "32x18", "--effects", "all", "--frames", "0..3", "--refit", "on",
                           "-o", "robot.png", "--json", "-"], check=True, text=True,
                          stdout=subprocess.PIPE).stdout
    machine, frames = sphaera.read(robot).build(refit=True, **words), json.loads(said)["frames"]
    anew = sphaera.read(robot, at=3).build(**words).render()
    for at, frame in enumerate(frames):
        if at:
            machine = sphaera.read(robot, at=at).refit(machine)
        drawn = machine.render()
        assert f"{drawn.hash:016x}" == frame["frame"]["hash"], (at, frame)
        assert machine.tree_cost == frame["tree_cost"]
    assert (drawn.key == anew.key).all() and (drawn.rgb() == anew.rgb()).all()
    assert drawn.hash != anew.hash
    refused(sphaera.Error, "5 spheres, 0 triangles and planes", sphaera.read(PAPER5).refit, machine)
    refused(sphaera.Error, "^cancelled$", sphaera.read(robot).refit, machine,
            progress=lambda *_: True)
    refused(sphaera.Error, "keeps no tree", sphaera.read(robot).refit,
            pickle.loads(pickle.dumps(machine)))


def core():
    """Registers, memory and parameters are those of the files that the tool exports."""
    machine = sphaera.read(PAPER5).build(profile="draft", width=32, height=20)
    machine.export("hex", "five")
    words = [int(line, 16) for line in Path("five.regs.hex").read_text().splitlines()
             if not line.startswith("//")]
    assert words == [int(w) & 0xffffffff for w in machine.registers]
    lines = [line for line in Path("five.mem.hex").read_text().splitlines()
             if not line.startswith("//")]
    assert lines == ["".join(f"{w:08x}" for w in line[::-1]) for line in machine.memory]
    head = Path("five.mem.hex").read_text().splitlines()[2:4]
    said = {k: int(v) for line in head for k, v in re.findall(r"(\w+)=(\d+)", line)}
    assert said == {k: v for k, v in machine.parameters.items() if v or k in said}
    assert machine.core.startswith("shadow+") and machine.parameters["SHADOW"] == 1
    again = sphaera.Machine.make(machine.registers, machine.memory)
    assert again.render().hash == machine.render().hash
    names = sphaera.register_names()
    assert names[0] == "EFFECTS" and names[32] == "LIGHT0_X" and names[40] == "LIGHT1_X"
    broken = machine.registers.copy()
    broken[names.index("FRAME_W")] = 0
    refused(sphaera.Error, "register FRAME_W", sphaera.Machine.make, broken, machine.memory)
    refused(sphaera.Error, "n_registers is 3", sphaera.Machine.make, [1, 2, 3], machine.memory)
    assert "node_visits" in sphaera.exact_counters() and \
        "cycles" not in sphaera.exact_counters()
    refused(sphaera.Error, "format is 'b'", machine.export, "b", "x")


def stages():
    """A pixel's rays and stages are what `sphaera info` prints; layers are the frame's."""
    machine = sphaera.read(PAPER5).build(profile="standard", width=64, height=48)
    machine.write("pixel.sph")
    said = subprocess.run([TOOL, "info", "pixel.sph", "--pixel", "30,24", "--stages"], check=True,
                          text=True, stdout=subprocess.PIPE).stdout
    pixel = machine.pixel(30, 24)
    assert "\n".join(stage.text for stage in pixel.stages) in said
    frame, primary = machine.render(), pixel.rays[0]
    assert primary.kind == "primary" and primary.parent is None
    assert primary.id == frame.id[24, 30] and primary.key == frame.key[24, 30]
    key = next(o for s in pixel.stages if s.name == "hit" and s.ray == 0 for o in s.operands
               if o.name == "key")
    assert key.word == primary.key and key.bits == 35 and key.value > 0
    refused(sphaera.Error, "y is 48, not 0 to 47", machine.pixel, 0, 48)
    layers = frame.layers()
    none = frame.id == sphaera.NONE
    assert np.isinf(layers.distance[none]).all() and (layers.normal[none] == 0).all()
    assert np.allclose(np.linalg.norm(layers.normal[~none], axis=1), 1, atol=1e-5)
    assert (layers.distance >= layers.depth)[~none].all() and (layers.level == -1).all()
    ball = sphaera.scene_of(spheres=[[0, 0, 0, 1]], eye=(0, 0, 5), angle=20, width=9, height=9)
    middle = ball.build(profile="fine").render().layers()
    assert abs(middle.distance[4, 4] - 4) < 0.01 and middle.normal[4, 4][2] > 0.99
    assert (middle.albedo[4, 4] == 1).all() and (middle.texture[4, 4] >> 20) == 4095


def verify():
    """A scoreboard takes the model's own pixels, and names whatever differs."""
    machine = sphaera.read(PAPER5).build(profile="draft", width=8, height=6)
    frame, texture = machine.render(), machine.render().layers().texture
    colours = [frame.rgb(layer).astype(int) @ [1, 1 << 8, 1 << 16] for layer in range(3)]
    places = [(x, y) for y in range(6) for x in range(8)][::-1]

    def show(board, x, y, **changed):
        fields = {"colours": [int(c[y, x]) for c in colours], "id": int(frame.id[y, x]),
                  "key": int(frame.key[y, x]), "visits": int(frame.visits[y, x]),
                  "texture": int(texture[y, x]), **changed}
        return board.pixel(x, y, **fields)
    board = sphaera.Scoreboard(machine)
    for _ in range(2):  # frames
        assert all(show(board, x, y) for x, y in places)
        assert board.counters(frame.counters) and board.errors(0)
        assert board.end() == 0 and board.text == ""
    assert all(board.colour(x, y, int(colours[2][y, x])) for x, y in places) and board.end() == 0
    hit = next((x, y) for x, y in places if frame.key[y, x])
    for pattern, tell in (
            ("key .*<--(.|\n)*primary [|] set-up", lambda: show(board, *hit, key=1)),
            ("rendering .*<--", lambda: show(board, *hit, colours=[1, 2, 3])),
            ("comes a second time", lambda: show(board, 0, 0) and show(board, 0, 0)),
            ("9,0 lies outside the window", lambda: board.colour(9, 0, 0)),
            ("counter node_visits: 1, expected", lambda: board.counters({"node_visits": 1})),
            ("sticky errors: 4, expected 0", lambda: board.errors(4)),
            ("48 of 48 pixels did not come, the first of them is 0,0", lambda: False)):
        assert not tell()
        assert board.end() >= 1 and re.search(pattern, board.text), board.text
    assert board.counters({"cycles": 5})
    refused(KeyError, "nosuch", board.counters, {"nosuch": 1})
    v = sphaera.verify
    assert v.root(10) == (3, True) and v.root(1 << 100) == (1 << 50, False)
    u = v.unit_vector(17, (3, 0, 4))[0]
    assert abs(u[0] / 65536 - 0.6) < 1e-4 and u[1] == 0 and abs(u[2] / 65536 - 0.8) < 1e-4
    mant, exp = v.quotient(3, 8, 2, 8, 12)
    assert mant * 2.0 ** -exp == 1.5
    hit = v.leaf((0, 0, 0), (0, 0, -100), (0, 0, -50), 10)
    assert hit.hit and not hit.far and hit.key == 4000
    assert v.texel([0x102030] * 4, [0x102030] * 4, (7, 9), (1, 2), 77) == 0x102030
    assert v.node_filter(origin=(0, 0, 0), least=0, p_a=0, p_b=0, q=(0, 0, 0), axis=2, negative=1,
                         depth_max=1000, centre=(0, 0, -100), radius=9)[0]
    refused(sphaera.Error, "bits is 8, not 9 to 32", v.unit_vector, 8, (1, 2, 3))
    refused(sphaera.Error, "v is 256, not -256 to 255", v.unit_vector, 9, (256, 2, 3))
    refused(sphaera.Error, "high has more than 60 bits", v.root, 1 << 124)
    refused(sphaera.Error, "a is 0", v.quotient, 1, 8, 0, 8, 12)
    refused(sphaera.Error, "radius is -1", v.leaf, (0, 0, 0), (0, 0, 1), (0, 0, 0), -1)
    refused(sphaera.Error, "least is 3", v.node_filter, least=3)
    refused(sphaera.Error, "level is 256", v.texel, [0] * 4, [0] * 4, (0, 0), (0, 0), 256)


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
    Path("apart").mkdir()
    Path("apart/away.nff").write_text(twice + "texture ../a.png 1 1\ns 1 0 0 1\n", encoding="utf-8")
    refused(sphaera.Error, "^apart/away.nff:5: .*a.png is outside the folder", sphaera.read,
            "apart/away.nff")
    assert sphaera.read("apart/away.nff", allow_paths=True).spheres == 2
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
            begun = False
            try:
                timer.start()
                begun = True
                what(*words)
                timer.join()
                time.sleep(1)
                assert what == small.write, "not interrupted"
            except KeyboardInterrupt:
                if begun:
                    late.append(time.monotonic() - sent[0])
        assert what == small.write or min(late) < 0.1, late
    assert [p.name for p in folder.iterdir()] in ([], ["a.png"]), list(folder.iterdir())
    again = sphaera.read(PAPER5).build(width=1600, height=900).render()
    again.write("whole.png")
    assert again.hash == small.hash
    for path in folder.iterdir():
        assert path.read_bytes() == Path("whole.png").read_bytes()


def builds():
    """A build that is cancelled, by its function or by Ctrl-C, asks hardly once more whether it
    goes on: in a BIH, and while profile and tree are measured; a price and many rays likewise."""
    for name, words in (("random:30000", {"profile": "standard", "accel": "bih"}),
                        ("random:1000", {"width": 160, "height": 90})):
        scene, calls, after = sphaera.read(name), [], 5

        def asked(*_, calls=calls):
            calls.append(0)
            return len(calls) == after

        def interrupts_itself(*_, calls=calls):
            calls.append(0)
            if len(calls) == after:
                os.kill(os.getpid(), signal.SIGINT)
            if len(calls) >= after:
                time.sleep(0.1)

        scene.build(progress=lambda *_, calls=calls: calls.append(0), **words)
        assert len(calls) > 4 * after, (name, len(calls))
        calls.clear()
        refused(sphaera.Error, "^cancelled$", scene.build, progress=asked, **words)
        assert len(calls) <= after + 2, (name, len(calls))
        calls.clear()
        refused(KeyboardInterrupt, "", scene.build, progress=interrupts_itself, **words)
        assert len(calls) <= after + 2, (name, len(calls))
    calls.clear()
    scene.price(width=320, height=180, progress=lambda *_: calls.append(0))
    assert len(calls) > 2 * after, len(calls)
    calls.clear()
    refused(sphaera.Error, "^cancelled$", scene.price, width=320, height=180, progress=asked)
    assert len(calls) <= after + 2, len(calls)
    calls.clear()
    refused(KeyboardInterrupt, "", scene.price, width=320, height=180, progress=interrupts_itself)
    assert len(calls) <= after + 2, len(calls)
    calls.clear()
    rays, traces = np.ones((1 << 22, 3), np.int32), sphaera.machine.call

    def traced(*words):
        interrupts_itself()
        traces(*words)

    with unittest.mock.patch("sphaera.machine.call", traced):
        refused(KeyboardInterrupt, "", scene.build(profile="draft").trace_rays, rays, rays)
    assert len(calls) <= after + 2, len(calls)


if __name__ == "__main__":  # a child that is spawned reads this file too
    for promise in (declarations, words, frames, ray, arrays, batches, options, refitted, core,
                    stages, verify, errors, threads, strict, pickled, children, interrupts,
                    builds):
        promise()
