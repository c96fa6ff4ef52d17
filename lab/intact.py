# intact.py - files that are whole or not there, whoever else writes the same one at that moment
# SPDX-License-Identifier: Apache-2.0
import contextlib
import os
import socket


@contextlib.contextmanager
def beside(path):
    """A name of this process's own; what stands there in the end gets the name `path`."""
    new = f"{path}.{socket.gethostname()}.{os.getpid()}.tmp"  # a folder may be shared
    try:
        yield new
        os.replace(new, path)
    finally:
        with contextlib.suppress(FileNotFoundError):
            os.remove(new)


def write(path, text):
    with beside(path) as new, open(new, "w", encoding="utf-8") as f:
        f.write(text)
