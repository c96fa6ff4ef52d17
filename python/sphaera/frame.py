# frame.py - frames: pixels as NumPy arrays, counters
# SPDX-License-Identifier: Apache-2.0
from functools import cached_property
from itertools import count, takewhile
from typing import Any, Dict, NamedTuple, Tuple

import numpy as np
from numpy.typing import NDArray

from ._library import PathLike, c_text, call, ffi, lib, made, text
from ._options import filled


class Layers(NamedTuple):
    """Arrays [height, width]; of vectors and colours [height, width, 3]."""
    texture: NDArray[np.uint32]     # {lod u4.8, 4095: none; sum of texel addresses u20}
    level: NDArray[np.float32]      # of the image seen first, 0: whole size; -1: none
    normal: NDArray[np.float32]     # of length 1, in the scene's frame, towards the eye; 0: no hit
    depth: NDArray[np.float32]      # along the view, units of the scene; infinite: no hit
    distance: NDArray[np.float32]   # from the eye, the same
    albedo: NDArray[np.float32]     # of the material, without its image


class Frame:
    """What the model draws of a machine; of Machine.render().

    Arrays have shape [height, width], row 0 on top, and are filled by the library itself, without
    a copy between. id, key and visits are made when they are first asked for, and read-only."""

    NONE: int = lib.SPHAERA_NONE  # id of no primitive

    def __init__(self, pointer: Any, machine: Any) -> None:
        self._pointer = pointer
        self._machine = machine

    @property
    def width(self) -> int:
        """In pixels."""
        return lib.sphaera_frame_width(self._pointer)

    @property
    def height(self) -> int:
        """In pixels."""
        return lib.sphaera_frame_height(self._pointer)

    def _array(self, fill: Any, dtype: type, kind: str) -> Any:
        pixels = np.empty((self.height, self.width), dtype)
        fill(self._pointer, ffi.from_buffer(kind, pixels))
        pixels.flags.writeable = False
        return pixels

    def rgb(self, layer: int = 2) -> NDArray[np.uint8]:
        """uint8 [height, width, 3]: red, green, blue, linear light, 255 is white; of your own.
        layer: 0 without reflections, 1 with one, 2 all. ValueError: another layer."""
        pixels = np.empty((self.height, self.width, 3), np.uint8)
        if lib.sphaera_frame_rgb(self._pointer, layer, ffi.from_buffer("uint8_t[]", pixels)):
            raise ValueError(f"layer is {layer}, not 0 to 2")
        return pixels

    @cached_property
    def id(self) -> NDArray[np.uint32]:
        """uint32: primitive that the primary ray hit, in the scene's order; NONE: none."""
        return self._array(lib.sphaera_frame_id, np.uint32, "uint32_t[]")

    @cached_property
    def key(self) -> NDArray[np.uint64]:
        """uint64: ceil(a t) of that hit, which orders hits on one ray; 0: none."""
        return self._array(lib.sphaera_frame_key, np.uint64, "uint64_t[]")

    @cached_property
    def visits(self) -> NDArray[np.uint32]:
        """uint32: tree nodes that all rays of the pixel visited."""
        return self._array(lib.sphaera_frame_visits, np.uint32, "uint32_t[]")

    @cached_property
    def counters(self) -> Dict[str, int]:
        """All counters by name (docs/reference/core.md); 0 where the hardware alone counts."""
        names = takewhile(bool, map(lib.sphaera_counter_name, count()))
        return {text(name): lib.sphaera_frame_counter(self._pointer, i)
                for i, name in enumerate(names)}

    @property
    def hash(self) -> int:
        """Equal frames have equal hashes; `sphaera render` prints it."""
        return lib.sphaera_frame_hash(self._pointer)

    @property
    def errors(self) -> int:
        """Sticky errors of the drawing, a bit each (docs/reference/core.md); 0: none."""
        return lib.sphaera_frame_errors(self._pointer)

    def layers(self) -> "Layers":
        """What compositing programs ask for, of the primary hit of each pixel."""
        shape = (self.height, self.width)
        layers = Layers(np.empty(shape, np.uint32), np.empty(shape, np.float32),
                        np.empty((*shape, 3), np.float32), np.empty(shape, np.float32),
                        np.empty(shape, np.float32), np.empty((*shape, 3), np.float32))
        to = {name: ffi.from_buffer("float[]" if name != "texture" else "uint32_t[]", array)
              for name, array in zip(Layers._fields, layers)}
        call(lib.sphaera_frame_layers, self._pointer, ffi.new("sphaera_layers *", to))
        return layers

    def write(self, path: PathLike, *, layer: int = 2, transfer: str = "srgb",
              depths: bool = False, samples: int = 0) -> None:
        """Writes a picture in the format of the name's ending: 8 bits, or OpenEXR, linear, with all
        layers.

        layer     0 without reflections, 1 with one, 2 all
        transfer  how bytes stand for light: "srgb", "linear"
        depths    colours tell how many surfaces one behind another made a pixel
        samples   a pixel is the mean of N x N; 0: those of build()

        Error: another ending or number, or it cannot be written."""
        options, kept = filled("sphaera_picture_options", lib.sphaera_picture_init, dict(
            layer=layer, transfer=transfer, depths=depths, samples=samples))
        call(lib.sphaera_frame_write_with, self._pointer, c_text(path), options)
        del kept

    def __reduce__(self) -> Tuple[Any, Tuple[Any, bytes]]:
        """Pickles it and its machine, for the same version of the library."""
        data = bytearray(lib.sphaera_frame_size(self._pointer))
        lib.sphaera_frame_pack(self._pointer, ffi.from_buffer("uint8_t[]", data))
        return _unpacked, (self._machine, bytes(data))

    def __repr__(self) -> str:
        return f"<sphaera.Frame {self.width}x{self.height}, hash {self.hash:016x}>"


def _unpacked(machine: Any, data: bytes) -> Frame:
    pointer = machine._pointer  # pylint: disable=protected-access
    return Frame(made(lib.sphaera_frame_unpack, lib.sphaera_frame_free, "sphaera_frame", pointer,
                      ffi.from_buffer("uint8_t[]", data), len(data)), machine)
