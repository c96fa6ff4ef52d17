# store.py - results of jobs: one file each, whole or not there
# SPDX-License-Identifier: Apache-2.0
"""A job is known by its key, a text. Its result is FOLDER/<hash of key>.json:

  key       the text
  sources   patterns of the files that the result depends on, and tools, as tool:NAME
  digest    of these files, and of the versions of these tools
  result    what was measured: plain values
  seconds   that it took
  files     names of files that were made beside it, with their digests; none if it is missing
  check     of all the above

It is written beside its name and then renamed, so jobs may run at once, on several machines with
one folder or with folders put together later, and be interrupted. A result counts if it is whole,
its sources are the same, and its files are as they were; whatever does not count is made anew."""
import functools
import glob
import hashlib
import json
import os
import subprocess

from .. import intact

TOOL = "tool:"


def path(folder, key):
    return os.path.join(folder, hashlib.sha256(key.encode()).hexdigest()[:20] + ".json")


def of_file(name):
    """Digest of a file's bytes, "" if there is none."""
    try:
        with open(name, "rb") as f:
            return hashlib.sha256(f.read()).hexdigest()
    except OSError:
        return ""


@functools.cache
def version(tool):
    """What sim/version.sh says of it."""
    return subprocess.run(["sh", "sim/version.sh", tool], check=True, stdout=subprocess.PIPE).stdout


def digest(patterns):
    """Of names and contents of all files that the patterns find, and of versions of tools."""
    total = hashlib.sha256()
    for tool in sorted(p[len(TOOL):] for p in patterns if p.startswith(TOOL)):
        total.update(version(tool))
    for name in sorted({n for p in patterns for n in glob.glob(p, recursive=True)}):
        with open(name, "rb") as f:
            total.update(f"{name}\0".encode() + hashlib.sha256(f.read()).digest())
    return total.hexdigest()


def _check(document):
    text = json.dumps({k: v for k, v in document.items() if k != "check"}, sort_keys=True)
    return hashlib.sha256(text.encode()).hexdigest()


def _read(folder, key):
    """The document; None: there is no file; ValueError: it is not whole."""
    try:
        with open(path(folder, key), encoding="utf-8") as f:
            document = json.load(f)
        if document["check"] != _check(document) or document["key"] != key:
            raise ValueError("check")
        return dict(document, sources=tuple(document["sources"]))
    except FileNotFoundError:
        return None
    except (OSError, KeyError, TypeError, AttributeError) as e:
        raise ValueError(str(e)) from None


def look(folder, key, digests=None):
    """(result, None), or (None, why it does not count). digests remembers what was read."""
    try:
        document = _read(folder, key)
    except ValueError:
        return None, f"{path(folder, key)} is damaged"
    if document is None:
        return None, "never run"
    digests = {} if digests is None else digests
    sources = document["sources"]
    if sources not in digests:
        digests[sources] = digest(sources)
    if digests[sources] != document["digest"]:
        return None, "sources changed"
    for name, was in document.get("files", {}).items():
        if of_file(name) != was:
            return None, f"{name} is damaged"
    return document["result"], None


def seconds(folder, key, guess):
    """What the job took when it was last run, whatever its sources were; guess if it never was."""
    try:
        document = _read(folder, key)
    except ValueError:
        return guess
    return document.get("seconds", guess) if document else guess


def save(folder, key, sources, result, seconds=None, files=()):
    """Writes the result under a temporary name, then renames it."""
    document = {"key": key, "sources": sorted(sources), "digest": digest(sources),
                "result": result}
    if seconds is not None:
        document["seconds"] = round(seconds, 3)
    if files:
        document["files"] = {name: of_file(name) for name in files}
    document["check"] = _check(document)
    os.makedirs(folder, exist_ok=True)
    with intact.beside(path(folder, key)) as new, open(new, "w", encoding="utf-8") as f:
        json.dump(document, f, indent=1)
        f.write("\n")
        f.flush()
        os.fsync(f.fileno())
