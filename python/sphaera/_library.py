# _library.py - the shared library beside this file, called as sphaera.h declares it
# SPDX-License-Identifier: Apache-2.0
import os
import threading
from pathlib import Path
from typing import Any, Callable, NamedTuple, Union

from ._declared import ffi

lib: Any = ffi.dlopen(str(Path(__file__).resolve().with_name("libsphaera.so")))
PathLike = Union[str, os.PathLike[str]]


class Error(Exception):
    """What the library refuses; str() is its message, as the tool prints it."""


def text(pointer: Any) -> str:
    """A string of the library's."""
    return ffi.string(pointer).decode("utf-8", "replace")


def c_text(word: PathLike) -> bytes:
    """A word or a file's name as C takes it; Error if it has a byte 0, where C would end."""
    given = os.fsencode(word)
    if b"\0" in given:
        raise Error(f"{os.fspath(word)!r} has a byte 0")
    return given


def call(function: Any, *arguments: Any) -> None:
    """Calls what takes a sphaera_error * last; raises Error if it fails."""
    error = ffi.new("sphaera_error *")
    if function(*arguments, error):
        raise Error(text(error.text))


def made(function: Any, free: Any, kind: str, *arguments: Any) -> Any:
    """Calls what fills a `kind **` behind its arguments; freed with the object that is returned."""
    to = ffi.new(kind + " **")
    call(function, *arguments, to)
    return ffi.gc(to[0], free)


def until_interrupted(work: Callable[[Any], Any]) -> Any:
    """work(stop), by a thread of its own if this is the main one, which Ctrl-C would else find in
    C: then stop[0] is 1, and the work, which looks at it, ends before the exception goes on."""
    stop = ffi.new("int *")
    if threading.current_thread() is not threading.main_thread():
        return work(stop)
    done: list[Any] = []
    failed: list[BaseException] = []
    ended = threading.Event()  # join() that was interrupted takes a thread for ended

    def run() -> None:
        try:
            done.append(work(stop))
        except BaseException as e:  # pylint: disable=broad-exception-caught
            failed.append(e)
        finally:
            ended.set()

    threading.Thread(target=run).start()
    try:
        ended.wait()
    except BaseException:
        stop[0] = 1
        ended.wait()
        raise
    if failed:
        raise failed[0]
    return done[0]


class Record(NamedTuple):
    """What became of the records of one kind in a file."""

    kind: str   # such as "sphere", or "triangle or polygon without area"
    end: str    # "used", "used otherwise", "left out"
    count: int
    file: str   # of the first one
    line: int   # of the first one, 0: none


def records(function: Any, of: Any) -> list[Record]:
    """The rows of a scene or machine, by the function that gives one of them."""
    row = ffi.new("sphaera_record *")
    found: list[Record] = []
    while not function(of, len(found), row):
        found.append(Record(text(row.kind), text(row.end), row.count, text(row.file), row.line))
    return found


def version() -> str:
    """Of the library, such as "1.2.3"."""
    return text(lib.sphaera_version())
