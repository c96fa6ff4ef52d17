# machine.py - machines: all that the hardware sees; drawn whole, or one ray of them
# SPDX-License-Identifier: Apache-2.0
import tempfile
from pathlib import Path
from typing import Any, NamedTuple, Optional, Sequence, Tuple

from ._library import (PathLike, Record, c_text, call, ffi, lib, made, records, text,
                       until_interrupted)
from .frame import Frame


class Hit(NamedTuple):
    """What a ray hits first."""
    id: int                             # primitive, in the scene's order
    inside: bool                        # its far side was hit, from inside
    key: int                            # ceil(a t), exact
    distance: float                     # from the origin, in units of the scene
    point: Tuple[float, float, float]   # there, in the scene's frame
    visits: int                         # tree nodes visited


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

    def render(self, threads: int = 0) -> Frame:
        """Draws it, with so many threads, up to 1024; 0: one for every processor, or as many as
        OMP_NUM_THREADS says. Ctrl-C ends it at once. Error: another number of threads, no
        memory."""
        options = ffi.new("sphaera_render_options *")
        lib.sphaera_render_init(options)
        options.threads = threads

        def work(stop: Any) -> Any:
            options.stop = stop
            return made(lib.sphaera_render_with, lib.sphaera_frame_free, "sphaera_frame",
                        self._pointer, options)
        return Frame(until_interrupted(work), self)

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
