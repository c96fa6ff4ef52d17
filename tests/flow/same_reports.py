# same_reports.py - two folders of reports are the same, byte by byte, but for times
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 same_reports.py FOLDER OTHER
Of a JSON report the text is compared without its members *seconds, which a clock says, and with the
name of its folder taken away: neither values nor the order of what is left may differ. Prints the
first difference of each file."""
import difflib
import json
import sys
from pathlib import Path

TIMES = ("seconds",)


def timeless(node):
    if isinstance(node, dict):
        return {name: timeless(value) for name, value in node.items() if not name.endswith(TIMES)}
    return [timeless(value) for value in node] if isinstance(node, list) else node


def lines(folder, name):
    path = Path(folder, name)
    if path.suffix == ".json":
        text = json.dumps(timeless(json.loads(path.read_text("utf-8"))), indent=1,
                          ensure_ascii=False)
        return text.replace(str(Path(folder).resolve()), "").splitlines()
    return path.read_bytes().decode("latin-1").splitlines(True)


def main(folder, other):
    files = [sorted(str(p.relative_to(f)) for p in Path(f).rglob("*") if p.is_file())
             for f in (folder, other)]
    if files[0] != files[1] or not files[0]:
        sys.exit(f"{folder} has {files[0]}\n{other} has {files[1]}")
    differ = 0
    for name in files[0]:
        one, two = lines(folder, name), lines(other, name)
        if one != two:
            differ += 1
            print(name, *list(difflib.unified_diff(one, two, folder, other, n=0))[:8], sep="\n")
    sys.exit(differ > 0)


if __name__ == "__main__":
    main(*sys.argv[1:])
