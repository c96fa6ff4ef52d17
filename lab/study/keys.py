# keys.py - keys of the study's jobs
# SPDX-License-Identifier: Apache-2.0
"""A key is words NAME=VALUE in the order of FIELDS; lab/jobs/store.py keeps what came of it."""
import sys

from ..runner import PROTEIN

# kind: words of its key, each with what it is if not given; tree: as `sphaera build` has it, the
# one that it takes by itself, or bih
COMMON = {"profile": "standard", "scene": None, "size": None, "tree": "default",
          "traverse": "nearest", "background": "none", "depth": "2"}
CORE = {"profile": "standard", "core": None, "engines": "1", "root": "1", "quotient": "2"}
FIELDS = {
    "accuracy": dict(COMMON, truth="2"),
    "cycles": dict(COMMON, **CORE),
    "cells": CORE,
    "price": {"scene": None, "size": None, "accel": "auto", "inside": "auto"},
}
MODEL = [f"cmodel/{d}/*.[ch]" for d in (
    "builder", "common", "core", "engine", "machine", "math", "memory", "pixel", "prim",
    "reference", "scene", "shade", "texture", "trace")] + ["cmodel/trial/*.c"]
BUILD = [f"cmodel/{d}/*.[ch]" for d in ("builder", "scene")] + ["cmodel/machine/machine.def"]
RTL = ["rtl/*/*.v", "rtl/*/*.vh"]


def job(kind, **words):
    """The key of a job; words that are not given are as in FIELDS."""
    unknown = set(words) - set(FIELDS[kind])
    if unknown:
        raise ValueError(f"{kind}: no {', '.join(sorted(unknown))}")
    full = dict(FIELDS[kind], **{k: str(v) for k, v in words.items()})
    missing = [k for k, v in full.items() if v is None]
    if missing:
        raise ValueError(f"{kind}: {', '.join(missing)} is needed")
    return " ".join([f"kind={kind}"] + [f"{k}={v}" for k, v in full.items()])


def words(key):
    """A key as a dictionary, checked."""
    pairs = [w.split("=", 1) for w in key.split()]
    if any(len(p) != 2 for p in pairs) or not pairs or pairs[0][0] != "kind" \
            or pairs[0][1] not in FIELDS:
        sys.exit(f"study: '{key}' is no job: kind= one of {', '.join(FIELDS)}, then NAME=VALUE")
    given = dict(pairs[1:])
    try:
        if job(pairs[0][1], **given) != key:
            sys.exit(f"study: '{key}' is not written as its kind wants it")
    except ValueError as e:
        sys.exit(f"study: '{key}': {e}")
    return dict(pairs)


def scene_files(scene):
    """Files that a scene is made from."""
    kind = scene.split(":")[0]
    if kind == "protein":
        return [PROTEIN]
    return [] if ":" in scene else [f"scenes/{scene}.nff"]
