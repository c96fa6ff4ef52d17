# mesh_others.py - meshes as trimesh reads them, and as the tool does; cameras of glTF computed anew
# SPDX-License-Identifier: Apache-2.0
"""usage: mesh_others.py TOOL FOLDER: writes meshes of all formats into the folder, has both read
them, and compares how many triangles, their area and bounds; then the cameras of a glTF scene whose
nodes scale, turn, mirror and move, with trimesh's transformations. TAP."""
import json
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import trimesh
from trimesh import transformations as tf

TOOL, FOLDER = sys.argv[1], Path(sys.argv[2])
CLOSE = 1e-5        # floats in files have 24 bits; areas add them up
checks = 0


def check(name, good, *shown):
    global checks
    checks += 1
    print(f"{'ok' if good else 'not ok'} {checks} - {name}")
    if not good:
        print(*(f"# {line}" for line in shown), sep="\n")


def imported(path, *options):
    """The NFF text that the tool makes of a file."""
    done = subprocess.run([TOOL, "import", path, *options], stdout=subprocess.PIPE, text=True,
                          stderr=subprocess.PIPE, check=False)
    if done.returncode:
        raise SystemExit(f"not ok - {path}: {done.stderr}")
    return done.stdout


def triangles(nff):
    """All polygons of p and pp as fans: those here are convex, or triangles."""
    found = []
    for kind, n, rest in re.findall(r"^(pp?) (\d+)\n((?:^[^a-z]*\n?)*)", nff, re.M):
        rows = np.array(rest.split(), float).reshape(int(n), -1)[:, :3]
        found += [[rows[0], rows[i], rows[i + 1]] for i in range(1, len(rows) - 1)]
        assert kind in ("p", "pp")
    return np.array(found)


def same_mesh(path):
    ours = triangles(imported(path))
    mesh = trimesh.load(path, process=False)
    if isinstance(mesh, trimesh.Scene):
        mesh = mesh.to_geometry()
    area = np.linalg.norm(np.cross(ours[:, 1] - ours[:, 0], ours[:, 2] - ours[:, 0]), axis=1) / 2
    bounds = np.array([ours.min((0, 1)), ours.max((0, 1))])
    check(f"{path.name}: {len(ours)} triangles, area {area.sum():.5f}",
          len(ours) == len(mesh.faces) and abs(area.sum() - mesh.area) <= CLOSE * mesh.area
          and np.allclose(bounds, mesh.bounds, rtol=0, atol=CLOSE * np.ptp(bounds)),
          f"trimesh: {len(mesh.faces)}, {mesh.area}, {mesh.bounds.tolist()}",
          f"tool: {len(ours)}, {area.sum()}, {bounds.tolist()}")


def write_all():
    """A file of each format, and its path."""
    ball = trimesh.creation.icosphere(subdivisions=2, radius=1.5)
    bar = trimesh.creation.box(extents=(1, 2, 3))
    bar.apply_transform(tf.rotation_matrix(0.3, (1, 2, 3), (4, 5, 6)))
    both = trimesh.util.concatenate([ball, bar])
    kinds = [("plain.obj", {}), ("text.ply", {"encoding": "ascii"}),
             ("bytes.ply", {"encoding": "binary"}), ("bytes.stl", {}),
             ("text.stl", {"file_type": "stl_ascii"})]
    for name, how in kinds:
        both.export(FOLDER / name, **how)
        yield FOLDER / name
    scene = trimesh.Scene()
    scene.add_geometry(ball, node_name="ball", transform=tf.scale_matrix(2))
    turned = tf.translation_matrix((5, 0, 1)) @ tf.rotation_matrix(1.1, (0, 1, 1))
    scene.add_geometry(bar, node_name="bar", transform=turned)
    scene.add_geometry(bar, node_name="again", transform=turned @ tf.reflection_matrix((0, 0, 0),
                                                                                    (1, 0, 0)))
    (FOLDER / "nodes.glb").write_bytes(scene.export(file_type="glb"))
    yield FOLDER / "nodes.glb"
    for name, content in trimesh.exchange.gltf.export_gltf(scene).items():
        (FOLDER / name).write_bytes(content)
    yield FOLDER / "model.gltf"


# Nodes above the camera, from the root down: scale, turn (axis, angle), move.
CAMERAS = {
    "still": [((1, 1, 1), ((0, 0, 1), 0), (0, 0, 5))],
    "turned": [((1, 1, 1), ((1, 2, 3), 0.7), (1, 2, 3))],
    "nested": [((2, 2, 2), ((0, 1, 0), 0.5), (0, 1, 0)), ((1, 1, 1), ((1, 0, 0), -0.4), (0, 0, 4))],
    "stretched": [((1, 3, 2), ((0, 0, 1), 0), (0, 0, 0)), ((1, 1, 1), ((0, 1, 1), 0.9), (1, 0, 6))],
}


def write_cameras():
    """A triangle and a chain of nodes for each camera."""
    gltf = json.loads(trimesh.exchange.gltf.export_gltf(
        trimesh.Scene(trimesh.creation.box()))["model.gltf"])
    first = len(gltf["nodes"])
    gltf["cameras"] = [{"type": "perspective", "perspective": {"yfov": 0.3 + 0.1 * i, "znear": 0.1,
                                                               "aspectRatio": 1.5}}
                       for i in range(len(CAMERAS))]
    for i, (name, chain) in enumerate(CAMERAS.items()):
        gltf["scenes"][0]["nodes"].append(len(gltf["nodes"]))
        for scale, (axis, angle), move in chain:
            w, *xyz = tf.quaternion_about_axis(angle, axis)
            gltf["nodes"].append({"scale": scale, "rotation": [*xyz, w], "translation": move,
                                  "children": [len(gltf["nodes"]) + 1]})
        del gltf["nodes"][-1]["children"]
        gltf["nodes"][-1].update(name=name, camera=i)
    assert first
    for name, content in trimesh.exchange.gltf.export_gltf(
            trimesh.Scene(trimesh.creation.box())).items():
        (FOLDER / name).write_bytes(content)
    (FOLDER / "cameras.gltf").write_text(json.dumps(gltf))


def same_camera(number, name, chain):
    matrix = np.eye(4)
    for scale, (axis, angle), move in chain:
        matrix = matrix @ tf.translation_matrix(move) @ tf.rotation_matrix(angle, axis) \
            @ np.diag([*scale, 1])
    view = matrix[:3, 3], -matrix[:3, 2], matrix[:3, 1]
    for called in (name, str(number)):
        nff = imported(FOLDER / "cameras.gltf", "--camera", called)
        eye, at, up = (np.array(re.search(rf"^{w} (.*)", nff, re.M)[1].split(), float)
                       for w in ("from", "at", "up"))
        angle = float(re.search(r"^angle (.*)", nff, re.M)[1])
        got, right = (at - eye) / np.linalg.norm(at - eye), view[1] / np.linalg.norm(view[1])
        side, wanted = np.cross(got, up), np.cross(right, view[2])
        check(f"camera {name} as {called}",
              np.allclose(eye, view[0], atol=CLOSE) and np.allclose(got, right, atol=CLOSE)
              and np.allclose(side / np.linalg.norm(side), wanted / np.linalg.norm(wanted),
                              atol=CLOSE)
              and abs(np.radians(angle) - 0.3 - 0.1 * number) < CLOSE,
              f"tool: {eye} {got} {up} {angle}", f"here: {view}")


for file in write_all():
    same_mesh(file)
write_cameras()
for at, (camera, nodes) in enumerate(CAMERAS.items()):
    same_camera(at, camera, nodes)
print(f"1..{checks}")
