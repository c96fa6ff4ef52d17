# _options.py - options of the library from keywords, and progress told to a Python function
# SPDX-License-Identifier: Apache-2.0
from typing import Any, Callable, Dict, List, Optional, Tuple

import numpy as np

from ._library import c_text, ffi, lib

Switch = Optional[bool]                  # None: as the scene asks for
Progress = Callable[[int, int], object]  # done, all; what is true cancels the call


class Told:
    """Calls a Python function, if there is one, as a sphaera_progress, which also cancels when
    stop[0] is not 0. What the function raises cancels the call and is raised again behind it."""

    def __init__(self, function: Optional[Progress], stop: Any) -> None:
        self.raised: Optional[BaseException] = None

        def told(_user: Any, done: int, all_: int) -> int:
            try:
                return bool(stop[0] or function and function(done, all_))
            except BaseException as e:  # pylint: disable=broad-exception-caught
                self.raised = e
                return 1
        self.pointer = ffi.callback("sphaera_progress", told)

    def __enter__(self) -> "Told":
        return self

    def __exit__(self, kind: Any, value: Any, trace: Any) -> None:
        if self.raised is not None:
            raise self.raised


def filled(kind: str, init: Any, words: Dict[str, Any]) -> Tuple[Any, List[Any]]:
    """A struct of options: defaults, then the keywords; and what it points to, which must live as
    long. None leaves a default; True and False are 1 and 0. TypeError: a keyword that is none."""
    options = ffi.new(kind + " *")
    init(options)
    fields = dict(ffi.typeof(kind).fields)
    kept = []
    for name, value in words.items():
        if name not in fields or name in ("size", "user"):
            known = ", ".join(sorted(set(fields) - {"size", "user"}))
            raise TypeError(f"{name} is none of {known}")
        if value is None:
            continue
        if fields[name].type.kind == "pointer" and fields[name].type.item.cname == "char":
            value = ffi.new("char[]", c_text(value))
            kept.append(value)
        setattr(options, name, int(value) if isinstance(value, (bool, np.bool_)) else value)
    return options, kept


def build_options(words: Dict[str, Any]) -> Tuple[Any, List[Any]]:
    """Of Scene.build() and Scene.price(); max_prims and max_tree_depth may be infinite."""
    if "shift" in words:
        words = {**words, "shifted": words["shift"] is not None}
    for name in ("max_prims", "max_tree_depth"):
        if words.get(name) == float("inf"):
            words = {**words, name: lib.SPHAERA_INFINITY}
    return filled("sphaera_build_options", lib.sphaera_build_init, words)
