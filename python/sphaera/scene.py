# scene.py - scenes: read from files, from text in memory, or made of arrays
# SPDX-License-Identifier: Apache-2.0
from typing import Any, Optional, Sequence, Tuple, Union

import numpy as np

from ._library import (PathLike, Record, c_text, call, ffi, lib, made, records,
                       until_interrupted)
from ._options import Progress, Switch, Told, build_options, filled
from .machine import Machine
from .price import Price, price_of

class Scene:
    """A scene in real numbers; of read(), parse() or scene_of()."""

    def __init__(self, pointer: Any) -> None:
        self._pointer = pointer

    @property
    def spheres(self) -> int:
        """How many spheres it has."""
        return lib.sphaera_scene_spheres(self._pointer)

    @property
    def facets(self) -> int:
        """How many triangles and planes it has."""
        return lib.sphaera_scene_facets(self._pointer)

    @property
    def records(self) -> list[Record]:
        """What became of each record of its file, counted by kind."""
        return records(lib.sphaera_scene_record, self._pointer)

    def write(self, path: PathLike) -> None:
        """Writes it as NFF, whole or not at all; every number survives. Error: it cannot be
        written."""
        call(lib.sphaera_scene_write, self._pointer, c_text(path))

    def build(self, *, profile: str = "auto", accel: str = "auto", width: int = 0,
              height: int = 0, depth: int = 2, shadow: Switch = None, reflect: Switch = None,
              refract: Switch = None, specular: Switch = None, texture: Switch = None,
              progress: Optional[Progress] = None, **more: Any) -> Machine:
        """The machine: the scene quantised, with its tree; words are those of `sphaera build`.

        profile        auto, draft, standard, fine, reference, or with widths: "draft:w=14"
        accel          auto, bvh4, bih, brute, box4
        width, height  pixels, 1 to 16383; 0: as the scene says
        depth          reflections and refractions one after another, 0 to 10
        shadow ...     True, False, or None: on if the scene asks for it
        progress       called with done, all; what it returns, if true, cancels the build
        more           clear, inside, interpenetrate, smooth, spread: True, False, None
                       lights: the first 0 to 8, None: those that reach something
                       effects: "all" that the scene names, "met": those that rays of the frame meet
                       error_pixels, error_psnr: what profile auto keeps
                       tree, axes, bih, max_prims, max_tree_depth, bih_fit (may be math.inf)
                       background, bg_points, bg_border, bg_levels
                       traverse, filter, lod, lod_bits, least_weight
                       samples: N x N rays a pixel; the frame has N times the sides
                       shift: (right, up), in place of the scene's, as of scene_of()
                       eye: (right, up, back), by which the eye moves before a screen that stays
                       wall: (columns, rows, column, row) of a frame that is part of a picture
                       refit: True: the machine keeps its tree for refit()

        Error: a word or number that is none of these, an image that cannot be read, a scene that
        the profile has no room for, or "cancelled". TypeError: a keyword that is none of these."""
        def work(stop: Any) -> Any:
            with Told(progress, stop) as told:
                options, kept = build_options(dict(
                    profile=profile, accel=accel, width=width, height=height, depth=depth,
                    shadow=shadow, reflect=reflect, refract=refract, specular=specular,
                    texture=texture, progress=told.pointer, **more))
                machine = made(lib.sphaera_build, lib.sphaera_machine_free, "sphaera_machine",
                               self._pointer, options)
                del kept
            return machine
        return Machine(until_interrupted(work))

    def refit(self, machine: Machine, *, progress: Optional[Progress] = None) -> Machine:
        """The machine of this scene with the tree of another one, which was built with refit=True,
        or refitted, of the same primitives in other places, as `sphaera build --frames --refit on`
        makes it: nodes keep their children and get new bounds. All else is built by the same
        options, in the profile, tree and size that they led to.

        progress  called with done, all; what it returns, if true, cancels

        Error: the machine keeps no tree, as one that was read, made or pickled; this scene has
        other primitives; or "cancelled"."""
        tree = machine._pointer  # pylint: disable=protected-access

        def refit(stop: Any) -> Any:
            with Told(progress, stop) as told:
                moved = made(lib.sphaera_refit, lib.sphaera_machine_free, "sphaera_machine",
                             self._pointer, tree, told.pointer, ffi.NULL)
            return moved
        return Machine(until_interrupted(refit))

    def price(self, *, keep_pixels: float = 0, keep_psnr: float = 0, most: int = 0,
              progress: Optional[Progress] = None, **build: Any) -> Price:
        """What accuracy costs in time, as `sphaera price` tells: a row for each profile, or the one
        that is named; `build`: words as of build().

        keep_pixels, keep_psnr   what a row is to keep, as of --error; both 0: its default
        most                     pixels of a sample, 0: the whole frame
        progress                 called with done, all; what it returns, if true, cancels

        Error: as of build(), but a profile that has no room for the scene is a row that says so."""
        def work(stop: Any) -> Any:
            with Told(progress, stop) as told:
                options, kept = build_options(dict(build, progress=told.pointer))
                price = made(lib.sphaera_price_measure, lib.sphaera_price_free, "sphaera_price",
                             self._pointer, options, keep_pixels, keep_psnr, most)
                del kept
            return price
        return price_of(until_interrupted(work))

    def __repr__(self) -> str:
        return f"<sphaera.Scene of {self.spheres} spheres, {self.facets} triangles and planes>"


def read(path: PathLike, at: int = 0, strict: bool = False, *, time: Optional[float] = None,
         round: float = 0,  # pylint: disable=redefined-builtin
         skip_unsupported: bool = False, camera: Optional[str] = None, radius: float = 0,
         up: Optional[str] = None, allow_paths: bool = False,
         progress: Optional[Progress] = None) -> Scene:
    """Reads a scene file (NFF, AFF), a molecule (PDB, mmCIF, XYZ) or points (CSV). Where there is
    no file of this name, it may be a kind of `sphaera gen`, such as "random:256".

    at                frame that moving primitives are moved to, 0 to 65535
    strict            what is not used as it stands is an Error, in build() too
    time              of AFF: the scene at this time of its own, not at a frame
    round             cones: greatest distance over the larger radius, 1e-6 to 0.5; 0: 0.005
    skip_unsupported  leave out patches instead of refusing the scene
    camera, up        of a mesh: a camera's name or number; "x", "y" or "z"
    radius            of points without one
    allow_paths       files that the scene names may lie anywhere, not only in its folder and below
    progress          called with done, all; what it returns, if true, cancels

    Error: no such file, or what the file says is no scene, with file, line and field."""
    def work(stop: Any) -> Any:
        with Told(progress, stop) as told:
            options, kept = filled("sphaera_read_options", lib.sphaera_read_init, dict(
                at=at, strict=strict, timed=time is not None, time=time, round=round,
                skip_unsupported=skip_unsupported, camera=camera, radius=radius,
                up=up.encode() if up else None, allow_paths=allow_paths, progress=told.pointer))
            scene = made(lib.sphaera_scene_read_with, lib.sphaera_scene_free, "sphaera_scene",
                         c_text(path), options)
            del kept
        return scene
    return Scene(until_interrupted(work))


def parse(text: Union[str, bytes], name: PathLike = "memory.nff", at: int = 0, *,
          allow_paths: bool = False) -> Scene:
    """The same of a text of NFF in memory. name stands in messages; its folder is where images
    are looked for."""
    data = text.encode() if isinstance(text, str) else bytes(text)
    options, kept = filled("sphaera_read_options", lib.sphaera_read_init, dict(
        at=at, allow_paths=allow_paths))
    scene = Scene(made(lib.sphaera_scene_parse_with, lib.sphaera_scene_free, "sphaera_scene",
                       data, len(data), c_text(name), options))
    del kept
    return scene


def rows(name: str, given: Any, shape: Tuple[int, ...], dtype: Any = np.float64) -> Any:
    """An array [n, *shape]; ValueError, by name, if it has another shape."""
    array = np.ascontiguousarray(given, dtype)
    if array.size == 0:
        array = array.reshape((0, *shape))
    if array.ndim != 1 + len(shape) or array.shape[1:] != shape:
        raise ValueError(f"{name} has shape {array.shape}, not {('n', *shape)}")
    return array


def numbers(name: str, given: Any, n: int) -> Any:
    """Numbers of materials or textures, [n]; ValueError, by name, if there are not so many or one
    is < 0."""
    array = np.asarray(given)
    if array.shape != (n,):
        raise ValueError(f"{name} has shape {array.shape}, not {(n,)}")
    if n and (array.dtype.kind not in "iu" or array.min() < 0 or array.max() >= 1 << 32):
        raise ValueError(f"{name} are not whole numbers of 0 or more")
    return np.ascontiguousarray(array, np.uint32)


def scene_of(*, spheres: Any = (), triangles: Any = (), planes: Any = (), materials: Any = None,
             sphere_materials: Any = None, triangle_materials: Any = None,
             plane_materials: Any = None, normals: Any = None, lights: Any = (),
             light_colours: Any = None, textures: Sequence[PathLike] = (),
             sphere_textures: Any = None, triangle_textures: Any = None, st: Any = None,
             eye: Sequence[float] = (0, 0, 1), at: Sequence[float] = (0, 0, 0),
             up: Sequence[float] = (0, 1, 0), angle: float = 45,
             shift: Sequence[float] = (0, 0), width: int = 320, height: int = 180,
             background: Sequence[float] = (0, 0, 0), ambient: Sequence[float] = (0, 0, 0),
             name: str = "arrays") -> Scene:
    """A scene of arrays, which are copied.

    spheres    [n, 4]: centre, radius          triangles  [n, 3, 3]: corners
    planes     [n, 6]: a point, the normal     normals    [n, 3, 3] of the triangles' corners
    materials  [n, 8]: red green blue Kd Ks Shine T index, `f` of NFF; None: one, white
    ..._materials   [n]: rows of materials; None: the first
    textures   files of images, which repeat
    ..._textures    [n]: rows of textures, sphaera.NONE: none
    st         [n, 3, 2]: s, t of the triangles' corners, 0 to 1 across the image and up
    lights     [n, 3], at most 8               light_colours  [n, 3]; None: 1 / sqrt(n)
    eye, at, up, angle   the camera; angle: vertical field of view, degrees
    shift                of the picture's middle to the right and up, in its heights, -64 to 64
    width, height        pixels                background, ambient   colours, 0 to 1

    Ids are rows of the spheres, then the triangles, then the planes, less those that
    Scene.records counts as left out.

    Error: a number that no scene may have, by array, row and field. ValueError: another shape."""
    arrays = ffi.new("sphaera_arrays *")
    lib.sphaera_arrays_init(arrays)
    kept = [ffi.new("char[]", c_text(name))]
    arrays.name = kept[0]
    files = [ffi.new("char[]", c_text(file)) for file in textures]
    kept += [*files, ffi.new("char *[]", files)]
    arrays.n_textures, arrays.textures = len(files), ffi.cast("char **", kept[-1])

    def put(field: str, array: Any) -> None:
        kind = "double[]" if array.dtype == np.float64 else "uint32_t[]"
        kept.append(ffi.from_buffer(kind, array))
        setattr(arrays, field, kept[-1])

    def put_rows(field: str, given: Any, shape: Tuple[int, ...]) -> int:
        array = rows(field, given, shape)
        put(field, array)
        return len(array)

    n = {}
    for field, given, shape in (("spheres", spheres, (4,)), ("triangles", triangles, (3, 3)),
                                ("planes", planes, (6,)), ("materials", materials, (8,)),
                                ("lights", lights, (3,))):
        if given is not None:
            n[field] = put_rows(field, given, shape)
            setattr(arrays, "n_" + field, n[field])
    for field, given, of, shape in (("normals", normals, "triangles", (3, 3)),
                                    ("light_colours", light_colours, "lights", (3,)),
                                    ("st", st, "triangles", (3, 2))):
        if given is not None and put_rows(field, given, shape) != n[of]:
            raise ValueError(f"{field} are not as many as {of}")
    for field, given, of in (("sphere_materials", sphere_materials, "spheres"),
                             ("triangle_materials", triangle_materials, "triangles"),
                             ("plane_materials", plane_materials, "planes"),
                             ("sphere_textures", sphere_textures, "spheres"),
                             ("triangle_textures", triangle_textures, "triangles")):
        if given is not None:
            put(field, numbers(field, given, n[of]))
    for field, given in (("from", eye), ("at", at), ("up", up), ("background", background),
                         ("ambient", ambient)):
        setattr(arrays, field, [float(x) for x in rows(field, [given], (3,))[0]])
    arrays.shift = [float(x) for x in rows("shift", [shift], (2,))[0]]
    arrays.angle, arrays.width, arrays.height = angle, width, height
    scene = made(lib.sphaera_scene_make, lib.sphaera_scene_free, "sphaera_scene", arrays)
    del kept
    return Scene(scene)
