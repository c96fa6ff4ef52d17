# intact.py - files that are whole or not there, whoever else writes the same one at that moment
# SPDX-License-Identifier: Apache-2.0
import contextlib
import filecmp
import os
import secrets


@contextlib.contextmanager
def beside(path, anew=False):
    """A file of this caller's own, whose name nobody else has and which is no link; what stands
    there in the end gets the name `path` when it is on the disk. anew: unless it is the same as
    what stands there, which keeps its time. OSError of each call that fails: `path` is as it was,
    and nothing is left."""
    new = f"{path}.{secrets.token_hex(8)}.tmp"
    os.close(os.open(new, os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_NOFOLLOW, 0o666))
    try:
        yield new
        if not (anew and os.path.exists(path) and filecmp.cmp(new, path, shallow=False)):
            with open(new, "rb") as whole:
                os.fsync(whole.fileno())
            os.replace(new, path)
    finally:
        with contextlib.suppress(FileNotFoundError):
            os.remove(new)


def write(path, text):
    with beside(path) as new, open(new, "w", encoding="utf-8") as f:
        f.write(text)
