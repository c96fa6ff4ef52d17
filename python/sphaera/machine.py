# machine.py - machines: all that the hardware sees; drawn whole, or one ray of them
# SPDX-License-Identifier: Apache-2.0
import tempfile
from functools import cached_property
from itertools import count, takewhile
from pathlib import Path
from typing import Any, Dict, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

from ._library import (Error, PathLike, Record, c_text, call, ffi, lib, made, records, text,
                       until_interrupted)
from ._options import Progress, Told, filled
from .frame import Frame
from .pixel import Pixel, pixel_of

AT_ONCE = 1 << 18  # rays between two looks for Ctrl-C


class Hit(NamedTuple):
    """What a ray hits first."""
    id: int                             # primitive, in the scene's order
    inside: bool                        # its far side was hit, from inside
    key: int                            # ceil(a t), exact
    distance: float                     # from the origin, in units of the scene
    point: Tuple[float, float, float]   # there, in the scene's frame
    visits: int                         # tree nodes visited


class Hits(NamedTuple):
    """What n rays hit, arrays [n]."""
    id: NDArray[np.uint32]         # primitive; NONE: nothing was hit, and the rest but visits is 0
    key: NDArray[np.uint64]
    inside: NDArray[np.bool_]
    distance: NDArray[np.float64]  # units of the scene
    visits: NDArray[np.uint32]


class Machine:
    """A machine; of Scene.build() or Machine.read()."""

    def __init__(self, pointer: Any, told: Optional[Tuple[str, str, list[Record]]] = None) -> None:
        self._pointer = pointer
        self._told = told or (text(lib.sphaera_machine_warning(pointer)),
                              text(lib.sphaera_machine_why(pointer)),
                              records(lib.sphaera_machine_record, pointer))

    def __reduce__(self) -> Tuple[Any, Tuple[Any, ...]]:
        """Pickles it as its machine file, and what build told."""
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "machine.sph")
            self.write(file)
            return _unpacked, (file.read_bytes(), self._told)

    @classmethod
    def read(cls, path: PathLike) -> "Machine":
        """Reads and checks a machine file. Error: there is none, or it is damaged."""
        return cls(made(lib.sphaera_machine_read, lib.sphaera_machine_free, "sphaera_machine",
                        c_text(path)))

    def write(self, path: PathLike) -> None:
        """Writes a machine file, whole or not at all. Error: it cannot be written."""
        call(lib.sphaera_machine_write, self._pointer, c_text(path))

    @property
    def width(self) -> int:
        """Of the frame, in pixels."""
        return lib.sphaera_machine_width(self._pointer)

    @property
    def height(self) -> int:
        """Of the frame, in pixels."""
        return lib.sphaera_machine_height(self._pointer)

    @property
    def profile(self) -> str:
        """Name of its widths."""
        return text(lib.sphaera_machine_profile(self._pointer))

    @property
    def warning(self) -> str:
        """What build warned of, lines of text; empty if nothing, or if it was read from a file."""
        return self._told[0]

    @property
    def why(self) -> str:
        """Why "auto" took its profile, and what was measured of the picture; empty if a profile was
        asked for, or if it was read from a file."""
        return self._told[1]

    @property
    def records(self) -> list[Record]:
        """What became of each record of the scene's file, and what the grid left out; or what the
        machine file has."""
        return list(self._told[2])

    @classmethod
    def make(cls, registers: Any, memory: Any, name: str = "memory") -> "Machine":
        """Of registers, int32 [n], and lines of memory, uint32 [lines, 8], as the properties have
        them. Its grid is not known: points are in grid units.

        Error: they are not sound, by register or record. ValueError: another shape."""
        words = np.ascontiguousarray(registers, np.int32)
        lines = np.ascontiguousarray(memory, np.uint32)
        if words.ndim != 1 or lines.ndim != 2 or lines.shape[1] != 8:
            raise ValueError("registers are [n], memory is [lines, 8]")
        return cls(made(lib.sphaera_machine_make, lib.sphaera_machine_free, "sphaera_machine",
                        ffi.from_buffer("int32_t[]", words), len(words),
                        ffi.from_buffer("uint32_t[]", lines), len(lines), c_text(name)))

    @property
    def tree_cost(self) -> float:
        """Of a tree that was refitted: the visits expected of a ray, over those of the tree when it
        was built; 1 of any other."""
        return lib.sphaera_machine_tree_cost(self._pointer)

    def export(self, format: str, path: PathLike) -> None:  # pylint: disable=redefined-builtin
        """Writes what `sphaera export` does: "hex": path.regs.hex and path.mem.hex for $readmemh;
        "c": path, arrays of C. Error: another format, or it cannot be written."""
        call(lib.sphaera_machine_export, self._pointer, c_text(format), c_text(path))

    @cached_property
    def registers(self) -> NDArray[np.int32]:
        """int32 [n]: words of all registers, by number; read-only."""
        words = np.array(ffi.unpack(lib.sphaera_machine_registers(self._pointer),
                                    lib.sphaera_registers()), np.int32)
        words.flags.writeable = False
        return words

    @cached_property
    def memory(self) -> NDArray[np.uint32]:
        """uint32 [lines, 8]: memory, 256 bits a line, low bits first; read-only."""
        lines = ffi.new("uint32_t *")
        words = lib.sphaera_machine_memory(self._pointer, lines)
        memory = np.frombuffer(ffi.buffer(words, 32 * lines[0]), np.uint32).reshape(-1, 8).copy()
        memory.flags.writeable = False
        return memory

    @cached_property
    def parameters(self) -> Dict[str, int]:
        """Of rt_core that draws it: widths, and the least of each effect."""
        row, found = ffi.new("sphaera_parameter *"), {}
        while not lib.sphaera_machine_parameter(self._pointer, len(found), row):
            found[text(row.name)] = row.value
        return found

    @property
    def core(self) -> str:
        """The same effects in words of sim/cores.py: "shadow+reflect2+lights1"; "none"."""
        return text(lib.sphaera_machine_core(self._pointer))

    def render(self, threads: int = 0, *, traverse: str = "fast",
               progress: Optional[Progress] = None) -> Frame:
        """Draws it.

        threads   up to 1024; 0: one for every processor, or as many as OMP_NUM_THREADS says
        traverse  "fast"; "literal": the text beside the RTL; "brute": without tree; "packets":
                  faster, but visits and counters of the tree are 0
        progress  called with done, all, rows; what it returns, if true, cancels

        Ctrl-C ends it at once. Error: another number of threads, another word, no memory, or
        "cancelled"."""
        def work(stop: Any) -> Any:
            with Told(progress, stop) as told:
                options, kept = filled("sphaera_render_options", lib.sphaera_render_init, dict(
                    threads=threads, traverse=traverse, progress=told.pointer, stop=stop))
                pointer = made(lib.sphaera_render_with, lib.sphaera_frame_free, "sphaera_frame",
                               self._pointer, options)
                del kept
            return pointer
        return Frame(until_interrupted(work), self)

    def trace_rays(self, origins: Any, directions: Any, threads: int = 0) -> Hits:
        """The nearest hits on n rays at once; as trace() of each, by so many threads, 0: one for
        every processor. origins and directions are [n, 3]: float64 in the scene's frame, or, if
        both are whole numbers, int32 as hardware has them (see primary()).

        Ctrl-C ends it within some 100 000 rays. Error: as of trace(), by number of the ray.
        ValueError: another shape."""
        org, to = np.asarray(origins), np.asarray(directions)
        if org.ndim != 2 or org.shape[1] != 3 or org.shape != to.shape:
            raise ValueError(f"origins {org.shape} and directions {to.shape} are not both (n, 3)")
        whole = org.dtype.kind in "iu" and to.dtype.kind in "iu"
        if whole and len(org):
            for name, a in (("origins", org), ("directions", to)):
                if a.min() < -1 << 31 or a.max() >= 1 << 31:
                    raise ValueError(f"{name}: whole numbers are of 32 bits")
        kind, dtype, function = ("int32_t[]", np.int32, lib.sphaera_trace_grid) if whole else \
                                ("double[]", np.float64, lib.sphaera_trace_rays)
        org, to = np.ascontiguousarray(org, dtype), np.ascontiguousarray(to, dtype)
        n = len(org)
        hits = Hits(np.empty(n, np.uint32), np.empty(n, np.uint64), np.empty(n, np.bool_),
                    np.empty(n, np.float64), np.empty(n, np.uint32))
        kinds = ("uint32_t[]", "uint64_t[]", "uint8_t[]", "double[]", "uint32_t[]")

        def trace(first: int, end: int) -> None:
            into = {name: ffi.from_buffer(of, array[first:end])
                    for name, of, array in zip(Hits._fields, kinds, hits)}
            call(function, self._pointer, end - first, ffi.from_buffer(kind, org[first:end]),
                 ffi.from_buffer(kind, to[first:end]), threads, ffi.new("sphaera_hits *", into))

        def work(stop: Any) -> None:
            for first in range(0, n, AT_ONCE):
                try:
                    trace(first, min(first + AT_ONCE, n))
                except Error:
                    trace(0, n)  # says the number of the ray
                if stop[0]:
                    return

        if n > AT_ONCE:
            until_interrupted(work)
        else:
            trace(0, n)
        return hits

    def primary(self, x: int, y: int) -> Tuple[NDArray[np.int32], NDArray[np.int32]]:
        """The primary ray of a pixel, origin and direction, int32 [3] as hardware has them. Error:
        it lies outside the frame."""
        org, to = np.empty(3, np.int32), np.empty(3, np.int32)
        call(lib.sphaera_primary, self._pointer, x, y, ffi.from_buffer("int32_t[]", org),
             ffi.from_buffer("int32_t[]", to))
        return org, to

    def pixel(self, x: int, y: int) -> Pixel:
        """The rays of a pixel and each of their stages, with operands, as `sphaera info --pixel X,Y
        --stages` prints them. Error: it lies outside the frame."""
        return pixel_of(made(lib.sphaera_pixel_trace, lib.sphaera_pixel_free, "sphaera_pixel",
                             self._pointer, x, y))

    def trace(self, origin: Sequence[float], direction: Sequence[float]) -> Optional[Hit]:
        """The nearest hit on a ray, None if there is none. Both have three numbers and are in the
        scene's frame; the length of direction does not count. The origin is rounded to the
        machine's grid, the direction to its width.

        Error: the origin lies outside the grid, or direction is zero or not finite."""
        org, to = [float(x) for x in origin], [float(x) for x in direction]
        if len(org) != 3 or len(to) != 3:
            raise ValueError("origin and direction have three numbers each")
        hit = ffi.new("sphaera_hit *")
        call(lib.sphaera_trace, self._pointer, org, to, hit)
        if hit.id == lib.SPHAERA_NONE:
            return None
        return Hit(hit.id, bool(hit.inside), hit.key, hit.distance, tuple(hit.point), hit.visits)

    def __repr__(self) -> str:
        return f"<sphaera.Machine {self.profile}, {self.width}x{self.height}>"


def _unpacked(data: bytes, told: Tuple[str, str, list[Record]]) -> Machine:
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "machine.sph")
        file.write_bytes(data)
        pointer = made(lib.sphaera_machine_read, lib.sphaera_machine_free, "sphaera_machine",
                       c_text(file))
    return Machine(pointer, told)


def register_names() -> List[Optional[str]]:
    """Of every register, by number; None: there is none."""
    names = (lib.sphaera_register_name(i) for i in range(lib.sphaera_registers()))
    return [text(name) if name else None for name in names]


def counter_names() -> List[str]:
    """Of every counter, by number."""
    return [text(name) for name in takewhile(bool, map(lib.sphaera_counter_name, count()))]


def exact_counters() -> List[str]:
    """The counters that hardware must count as the model does."""
    return [name for i, name in enumerate(counter_names()) if lib.sphaera_counter_exact(i)]
