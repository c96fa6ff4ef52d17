# jobs.py - jobs of a study and their results: one file each, whole or not there
# SPDX-License-Identifier: Apache-2.0
"""A job is a key, words NAME=VALUE in the order of FIELDS; its result FOLDER/<hash of key>.json:

  key       the words
  sources   patterns of the files that the result depends on, scene included
  digest    of these files
  result    what was measured: plain values
  check     of all the above

It is written beside its name and then renamed, so jobs may run at once, on several machines with
folders put together later, and be interrupted. A result counts if it is whole and its sources are
the same; whatever does not count is made anew."""
import glob
import hashlib
import json
import os
import sys

# kind: words of its key, each with what it is if not given; tree: as `sphaera build` has it, the
# one that it takes by itself, or bih
COMMON = {"profile": "standard", "scene": None, "size": None, "tree": "default",
          "traverse": "nearest", "background": "none", "depth": "2"}
CORE = {"profile": "standard", "core": None, "engines": "1", "root": "2", "quotient": "2"}
FIELDS = {
    "accuracy": dict(COMMON, truth="2"),
    "cycles": dict(COMMON, **CORE),
    "cells": CORE,
    "fmax": dict(CORE, route="1"),
}
MODEL = [f"cmodel/{d}/*.[ch]" for d in (
    "builder", "common", "core", "engine", "machine", "math", "memory", "pixel", "prim",
    "reference", "scene", "shade", "texture", "trace")]
BUILD = [f"cmodel/{d}/*.[ch]" for d in ("builder", "scene")] + ["cmodel/machine/machine.def"]
RTL = ["rtl/*/*.v", "rtl/*/*.vh"]
PROTEIN = "/usr/share/pymol/data/demo/1tii.pdb"


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


def path(folder, key):
    return os.path.join(folder, hashlib.sha256(key.encode()).hexdigest()[:20] + ".json")


def scene_files(scene):
    """Files that a scene is made from."""
    kind = scene.split(":")[0]
    if kind == "protein":
        return [PROTEIN]
    return [] if ":" in scene else [f"scenes/{scene}.nff"]


def digest(patterns):
    """Of names and contents of all files that the patterns find."""
    total = hashlib.sha256()
    for name in sorted({n for p in patterns for n in glob.glob(p)}):
        with open(name, "rb") as f:
            total.update(f"{name}\0".encode() + hashlib.sha256(f.read()).digest())
    return total.hexdigest()


def _check(document):
    text = json.dumps({k: v for k, v in document.items() if k != "check"}, sort_keys=True)
    return hashlib.sha256(text.encode()).hexdigest()


def look(folder, key, digests=None):
    """(result, None), or (None, why it does not count). digests remembers what was read."""
    name = path(folder, key)
    try:
        with open(name, encoding="utf-8") as f:
            document = json.load(f)
        if document["check"] != _check(document) or document["key"] != key:
            return None, f"{name} is damaged"
        sources = tuple(document["sources"])
    except FileNotFoundError:
        return None, "never run"
    except (OSError, ValueError, KeyError, TypeError):
        return None, f"{name} is damaged"
    digests = {} if digests is None else digests
    if sources not in digests:
        digests[sources] = digest(sources)
    if digests[sources] != document["digest"]:
        return None, "sources changed"
    return document["result"], None


def save(folder, key, sources, result):
    """Writes the result under a temporary name, then renames it."""
    document = {"key": key, "sources": sorted(sources), "digest": digest(sources),
                "result": result}
    document["check"] = _check(document)
    os.makedirs(folder, exist_ok=True)
    name = path(folder, key)
    beside = f"{name}.{os.getpid()}.tmp"
    try:
        with open(beside, "w", encoding="utf-8") as f:
            json.dump(document, f, indent=1)
            f.write("\n")
            f.flush()
            os.fsync(f.fileno())
        os.replace(beside, name)
    finally:
        if os.path.exists(beside):
            os.remove(beside)
