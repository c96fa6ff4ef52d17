# scenes.py - makes scenes of scenes/texture: kitchen.nff, robot.nff, museum.nff
# SPDX-License-Identifier: Apache-2.0
#
# What the BART scenes of these names show, in spheres, triangles and planes. Large faces are cut
# into pieces: a leaf is a bounding sphere, and those of long triangles cut many rays.
import os


class Scene:
    """Lines of a scene file; `f` is written when the material changes."""

    def __init__(self, name, text, view, lights):
        self.lines = [f"# {name}.nff - {text}", "# SPDX-License-Identifier: Apache-2.0",
                      "# Made by lab/textures/scenes.py; images by images.py beside it.", "v"]
        self.lines += view
        self.lines += ["hither 0.1", "resolution 480 270"] + lights + ["shading blend"]
        self.name, self.look = name, None

    def material(self, colour, kd=1.0, ks=0.0, shine=10):
        look = "f " + " ".join(f"{v:g}" for v in (*colour, kd, ks, shine, 0, 1))
        if look != self.look:
            self.lines.append(look)
        self.look = look

    def add(self, line):
        self.lines.append(line)

    def image(self, name, *numbers):
        self.add("texture none" if name is None else
                 f"texture {name}.png " + " ".join(f"{v:g}" for v in numbers))

    def sphere(self, x, y, z, radius):
        self.add(f"s {x:g} {y:g} {z:g} {radius:g}")

    def quad(self, corner, right, up, image=None, repeat=(1, 1), cut=(1, 1), shift=(0, 0)):
        """A parallelogram of cut[0] x cut[1] pairs of triangles; `repeat` images over all of it."""
        def at(i, j):
            a, b = i / cut[0], j / cut[1]
            p = [c + a * r + b * u for c, r, u in zip(corner, right, up)]
            return p + [shift[0] + a * repeat[0], shift[1] + b * repeat[1]]
        for j in range(cut[1]):
            for i in range(cut[0]):
                for turn in ((0, 0), (1, 0), (1, 1)), ((0, 0), (1, 1), (0, 1)):
                    points = [at(i + a, j + b) for a, b in turn]
                    if image:
                        self.add(f"tt {image}.png " + "  ".join(
                            " ".join(f"{v:.6g}" for v in p) for p in points))
                    else:
                        self.add("p 3 " + "  ".join(
                            " ".join(f"{v:.6g}" for v in p[:3]) for p in points))

    def box(self, low, size, image=None, scale=1.0, cut=1, faces="fblrt"):
        """Faces: front (+z), back, left, right, top, down; an image every `scale` units."""
        x, y, z = low
        w, h, d = size
        for face in faces:
            corner, right, up = {
                "f": ((x, y, z + d), (w, 0, 0), (0, h, 0)),
                "b": ((x + w, y, z), (-w, 0, 0), (0, h, 0)),
                "l": ((x, y, z), (0, 0, d), (0, h, 0)),
                "r": ((x + w, y, z + d), (0, 0, -d), (0, h, 0)),
                "t": ((x, y + h, z + d), (w, 0, 0), (0, 0, -d)),
                "d": ((x, y, z), (w, 0, 0), (0, 0, d))}[face]
            sides = [sum(abs(v) for v in side) for side in (right, up)]
            self.quad(corner, right, up, image, [s / scale for s in sides], (cut, cut))

    def write(self, folder):
        path = os.path.join(folder, self.name + ".nff")
        with open(path, "w", encoding="utf-8") as file:
            file.write("\n".join(self.lines) + "\n")


def kitchen():
    s = Scene("kitchen", "a room with a tiled floor, papered walls, a table and what is on it",
              ["from 0.4 1.7 3.6", "at -0.1 0.85 -0.6", "up 0 1 0", "angle 50"],
              ["b 0.5 0.6 0.7", "ambient 0.4 0.4 0.4", "l -1.6 2.6 2.4 0.5 0.5 0.45",
               "l 1.9 2.5 1.2 0.35 0.35 0.35"])
    s.material((1, 1, 1), 0.9, 0.1)
    s.quad((-3, 0, 4), (6, 0, 0), (0, 0, -7), "tiles", (4, 4.67), (8, 9))
    s.material((1, 1, 1))
    s.quad((-3, 0, -3), (6, 0, 0), (0, 2.8, 0), "wall", (6, 2.8), (6, 3))
    s.quad((-3, 0, 4), (0, 0, -7), (0, 2.8, 0), "wall", (7, 2.8), (7, 3))
    s.quad((3, 0, -3), (0, 0, 7), (0, 2.8, 0), "wall", (7, 2.8), (7, 3))
    s.material((0.9, 0.9, 0.88))
    s.quad((-3, 2.8, -3), (6, 0, 0), (0, 0, 7), cut=(4, 4))
    # table
    s.material((1, 1, 1), 0.92, 0.08, 30)
    s.box((-1, 0.72, -0.9), (2, 0.06, 1.2), "wood", 0.8, 2, "fblrtd")
    for x in (-0.9, 0.82):
        for z in (-0.8, 0.12):
            s.box((x, 0, z), (0.08, 0.72, 0.08), "wood", 0.8, 1, "fblr")
    # a cupboard, a picture
    s.box((-2.6, 0, -2.95), (1.8, 0.9, 0.6), "wood", 0.9, 2, "flrt")
    s.box((1.2, 0, -2.95), (1.2, 2, 0.6), "wood", 0.9, 2, "flrt")
    s.material((1, 1, 1))
    s.quad((-0.5, 1.3, -2.97), (1.2, 0, 0), (0, 0.8, 0), "rings")
    # on the table: a box, a tin, fruit, a kettle
    s.box((-0.75, 0.78, -0.6), (0.3, 0.45, 0.14), "letter", 0.3, 1, "flrt")
    s.box((0.5, 0.78, -0.7), (0.28, 0.28, 0.28), "blocks", 0.28, 1, "flrt")
    s.image("globe", 1, 1)
    s.sphere(-0.15, 0.93, -0.1, 0.15)
    s.image("parquet", 2, 1)
    s.sphere(0.16, 0.87, 0.05, 0.09)
    s.image(None)
    s.material((0.95, 0.95, 1), 0.2, 0.75, 100)
    s.sphere(0.3, 1, -0.42, 0.22)
    s.sphere(0.3, 1.25, -0.42, 0.04)
    s.material((0.9, 0.5, 0.1))
    s.sphere(-0.38, 0.84, 0.05, 0.06)
    s.material((0.8, 0.15, 0.1))
    s.sphere(-0.52, 0.84, -0.02, 0.06)
    return s


def robot():
    s = Scene("robot", "a robot walks over slabs, between towers",
              ["from 1.4 1.5 6.2", "at -0.2 1.15 0", "up 0 1 0", "angle 42"],
              ["b 0.55 0.68 0.8", "ambient 0.38 0.38 0.38", "l -6 9 8 0.8 0.8 0.75"])
    s.material((1, 1, 1))
    s.image("ground", 4, 4)
    s.add("plane 0 0 0 0 1 0")
    s.image(None)
    for x, z, wide, high in ((-6, -6, 2.4, 5), (-2.6, -9, 2.2, 3.4), (2.2, -8, 2.6, 6),
                             (5.6, -5, 2, 3.6)):
        s.box((x, 0, z), (wide, high, wide), "metal", 1.6, 3, "flrt")
    # far away, so that the grid is wide and the ground goes to a horizon
    s.material((0.8, 0.5, 0.3))
    s.sphere(8, 1, -40, 1)
    # all of the robot walks, and the lamp on its head grows
    s.add("move 0.03 0 0.05")
    s.material((1, 1, 1), 0.85, 0.15, 40)
    s.image("face", 1, 1)
    s.sphere(0, 2.02, 0, 0.3)
    s.image(None)
    s.box((-0.42, 1.02, -0.22), (0.84, 0.66, 0.44), "metal", 0.9, 1, "fblrtd")
    s.box((-0.3, 0.82, -0.16), (0.6, 0.2, 0.32), "ground", 0.8, 1, "fblr")
    for side in (-1, 1):
        swing = 0.18 * side
        s.box((side * 0.2 - 0.09, 0.44, swing - 0.09), (0.18, 0.4, 0.18), "metal", 0.5, 1, "fblr")
        s.box((side * 0.2 - 0.1, 0.08, 1.6 * swing - 0.1), (0.2, 0.36, 0.2), "metal", 0.5, 1,
              "fblr")
        s.box((side * 0.2 - 0.13, 0, 1.6 * swing - 0.14), (0.26, 0.09, 0.4), "letter", 0.3)
    s.image("metal", 3, 2)
    for side in (-1, 1):
        for i in range(4):  # arms
            s.sphere(side * (0.53 + 0.06 * i), 1.58 - 0.17 * i, -side * 0.09 * i, 0.11 - 0.008 * i)
    s.image(None)
    s.material((0.9, 0.95, 1), 0.25, 0.7, 100)
    for side in (-1, 1):
        s.sphere(side * 0.78, 0.9, -side * 0.36, 0.13)
        s.sphere(side * 0.2, 0.43, side * 0.24, 0.11)
    s.sphere(0, 1.72, 0, 0.1)
    s.add("move 0.03 0 0.05 0.04 0 2.42 0")
    s.material((0.9, 0.2, 0.15))
    s.sphere(0, 2.42, 0, 0.07)
    s.sphere(0, 2.34, 0, 0.03)
    return s


def museum():
    s = Scene("museum", "a long hall with pictures, a mirror at its end and mirror balls",
              ["from 0.5 1.65 9.2", "at -0.1 1.35 0", "up 0 1 0", "angle 52"],
              ["b 0 0 0", "ambient 0.45 0.45 0.45", "l 0 3.2 6 0.4 0.4 0.38",
               "l 0 3.2 -4 0.35 0.35 0.35"])
    s.material((1, 1, 1), 0.88, 0.12)
    s.quad((-3, 0, 10), (6, 0, 0), (0, 0, -20), "parquet", (5, 16.67), (6, 18))
    s.material((0.86, 0.84, 0.8))
    s.quad((-3, 0, 10), (0, 0, -20), (0, 3.6, 0), cut=(12, 3))
    s.quad((3, 0, -10), (0, 0, 20), (0, 3.6, 0), cut=(12, 3))
    s.quad((-3, 3.6, -10), (6, 0, 0), (0, 0, 20), cut=(4, 12))
    s.quad((3, 0, 10), (-6, 0, 0), (0, 3.6, 0), cut=(4, 3))
    s.material((0.9, 0.95, 1), 0.1, 0.85, 100)
    s.quad((-3, 0, -10), (6, 0, 0), (0, 3.6, 0), cut=(4, 3))  # the mirror
    s.material((1, 1, 1))
    shown = ("rings", "script", "blocks", "threads", "tiles", "globe", "wall")
    for i in range(9):
        z = 8.4 - 2.1 * i
        s.quad((-2.98, 1, z + 0.75), (0, 0, -1.5), (0, 1.1, 0), shown[i % 7], cut=(2, 1))
        s.quad((2.98, 1, z - 0.75), (0, 0, 1.5), (0, 1.1, 0), shown[(i + 3) % 7], cut=(2, 1))
    for z in (4, -1, -6):  # plinths
        side = 1 if z == -1 else -1
        s.box((side * 1.2 - 0.3, 0, z - 0.3), (0.6, 0.8, 0.6), "ground", 0.8, 1)
    s.image("globe", 1, 1)
    s.sphere(1.2, 1.2, -1, 0.4)
    s.image("face", 1, 1)
    s.sphere(-1.2, 1.15, -6, 0.35)
    s.image(None)
    s.material((0.92, 0.95, 1), 0.15, 0.8, 100)
    s.sphere(-1.2, 1.22, 4, 0.42)
    s.sphere(0.9, 0.5, 2.6, 0.5)
    return s


def main(folder="scenes/texture"):
    for make in kitchen, robot, museum:
        make().write(folder)
