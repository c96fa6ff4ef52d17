# scene.py - scenes: read from files or from text in memory
# SPDX-License-Identifier: Apache-2.0
from typing import Any, Optional, Union

from ._library import PathLike, Record, c_text, ffi, lib, made, records
from .machine import Machine
from .price import Price, price_of

Switch = Optional[bool]  # None: as the scene asks for


def options_of(profile: str, accel: str, width: int, height: int, depth: int) -> Any:
    """Options of build; and the words that they point to, which must live as long."""
    options = ffi.new("sphaera_build_options *")
    lib.sphaera_build_init(options)
    words = [ffi.new("char[]", c_text(word)) for word in (profile, accel)]
    options.profile, options.accel = words
    options.width, options.height, options.depth = width, height, depth
    return options, words


class Scene:
    """A scene in real numbers; of read() or parse()."""

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

    def build(self, *, profile: str = "auto", accel: str = "auto", width: int = 0,
              height: int = 0, depth: int = 2, shadow: Switch = None, reflect: Switch = None,
              refract: Switch = None, specular: Switch = None, texture: Switch = None) -> Machine:
        """The machine: the scene quantised, with its tree; words are those of `sphaera build`.

        profile        auto, draft, standard, fine, reference, or with widths: "draft:w=14"
        accel          auto, bvh4, bih, brute, box4
        width, height  pixels, 1 to 16383; 0: as the scene says
        depth          reflections and refractions one after another, 0 to 10
        shadow ...     True, False, or None: on if the scene asks for it

        Error: a word or number that is none of these, an image that cannot be read, a scene that
        the profile has no room for."""
        options, words = options_of(profile, accel, width, height, depth)
        for name, on in (("shadow", shadow), ("reflect", reflect), ("refract", refract),
                         ("specular", specular), ("texture", texture)):
            if on is not None:
                setattr(options, name, lib.SPHAERA_ON if on else lib.SPHAERA_OFF)
        machine = made(lib.sphaera_build, lib.sphaera_machine_free, "sphaera_machine",
                       self._pointer, options)
        del words
        return Machine(machine)

    def price(self, *, profile: str = "auto", accel: str = "auto", width: int = 0, height: int = 0,
              depth: int = 2, keep_pixels: float = 0, keep_psnr: float = 0, most: int = 0) -> Price:
        """What accuracy costs in time, as `sphaera price` tells: a row for each profile, or the one
        that is named; words as of build().

        keep_pixels, keep_psnr   what a row is to keep, as of --error; both 0: its default
        most                     pixels of a sample, 0: the whole frame

        Error: as of build(), but a profile that has no room for the scene is a row that says so."""
        options, words = options_of(profile, accel, width, height, depth)
        found = price_of(made(lib.sphaera_price_measure, lib.sphaera_price_free, "sphaera_price",
                              self._pointer, options, keep_pixels, keep_psnr, most))
        del words
        return found

    def __repr__(self) -> str:
        return f"<sphaera.Scene of {self.spheres} spheres, {self.facets} triangles and planes>"


def read(path: PathLike, at: int = 0, strict: bool = False) -> Scene:
    """Reads a scene file (NFF, AFF), a molecule (PDB, mmCIF, XYZ) or points (CSV). at: frame that
    moving primitives are moved to, 0 to 65535. strict: what is not used as it stands is an Error,
    in build() too.
    Where there is no file of this name, it may be a kind of `sphaera gen`, such as "random:256".

    Error: no such file, or what the file says is no scene, with file, line and field."""
    options = ffi.new("sphaera_read_options *")
    lib.sphaera_read_init(options)
    options.at, options.strict = at, strict
    return Scene(made(lib.sphaera_scene_read_with, lib.sphaera_scene_free, "sphaera_scene",
                      c_text(path), options))


def parse(text: Union[str, bytes], name: PathLike = "memory.nff", at: int = 0) -> Scene:
    """The same of a text of NFF in memory. name stands in messages; its folder is where images
    are looked for."""
    data = text.encode() if isinstance(text, str) else bytes(text)
    return Scene(made(lib.sphaera_scene_parse, lib.sphaera_scene_free, "sphaera_scene",
                      data, len(data), c_text(name), at))
