# notebook.py - runs a notebook: its outputs are what is stored, or are stored anew
# SPDX-License-Identifier: Apache-2.0
"""Without --write, exit code 1 if a cell fails or prints another text than the file has. Pictures
are not compared, which other versions of libraries draw differently, but there has to be one where
one is stored. Exit code 3: there is no nbclient here."""
import os
import sys

os.environ["PYDEVD_DISABLE_FILE_VALIDATION"] = "1"  # the kernel is not debugged
try:
    import nbclient
    import nbformat
except ImportError as missing:
    print(f"notebook: {missing}: make notebook-setup", file=sys.stderr)
    sys.exit(3)


def shown(cell):
    """What a cell printed: its texts, and the kinds of what is no text."""
    parts = []
    for output in cell.get("outputs", []):
        data = output.get("data", {"text/plain": output.get("text", "")})
        pictures = sorted(kind for kind in data if kind.startswith("image/"))
        parts.append(pictures or data["text/plain"])
    return parts


def main(name, write=False):
    stored = nbformat.read(name, as_version=4)
    fresh = nbformat.read(name, as_version=4)
    try:
        nbclient.NotebookClient(fresh, timeout=120, kernel_name="python3",
                                record_timing=False).execute()
    except nbclient.exceptions.CellExecutionError as e:
        sys.exit(f"{name}: {e}")
    if write:
        for cell in fresh.cells:  # words for people without a screen: they lag
            for output in cell.get("outputs", []):
                if "image/png" in output.get("data", {}):
                    output["data"].pop("text/plain", None)
        fresh.metadata.language_info = {"name": "python"}
        nbformat.write(fresh, name)
        return
    for number, (old, new) in enumerate(zip(stored.cells, fresh.cells)):
        if shown(old) != shown(new):
            sys.exit(f"{name}: cell {number} shows\n{shown(new)}\nand not\n{shown(old)}: "
                     "python3 -m lab notebook --write")
