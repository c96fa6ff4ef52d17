# plan.py - whether tb/top/top_plan.txt has each sentence of the pages of rt_top and rt_video
# SPDX-License-Identifier: Apache-2.0
"""Compares the sentences of each section that the plan lists with its lines, and looks whether
the benches, proofs and tests that judge them exist; exits with 1 if something is missing. The
points that tb_shell must meet, it reads itself."""
import glob
import re
from pathlib import Path

PLAN = "tb/top/top_plan.txt"


def sentences(text):
    """{section: its sentences}, without tables, lists made by `make pages`, drawings, commands."""
    text = re.sub(r"<!-- begin: (?!clock|frames).*?<!-- end -->|```.*?```", "\n\n", text,
                  flags=re.S)
    text = re.sub(r"<!--.*?-->", "", text)
    found, section = {}, ""
    for block in re.split(r"\n\s*\n|\n(?=(?:- |\d+\. |\|))", text):
        block = block.lstrip("\n")
        if block.startswith("#"):
            section, _, block = block.lstrip("# ").partition("\n")
            found[section] = []
        if not block or block[0] == "|" or block.startswith("    "):
            continue
        plain = re.sub(r"^(- |\d+\. )?(\*\*[^*]+\.\*\* )?", "", " ".join(block.split()))
        plain = re.sub(r"[*`]", "", re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", plain))
        found[section] += re.split(r"(?<=\.) (?=[A-Za-z])", plain) if section else []
    return found


def exists(kind, name):
    if kind == "proof":
        proofs = Path("formal/proofs.txt").read_text(encoding="utf-8")
        return re.search(rf"^{re.escape(name)} *\|", proofs, re.M) is not None
    return bool(glob.glob(f"tests/*/{name}.*" if kind == "test" else f"tb/*/{name}.cpp"))


def wrong():
    """What the plan lacks, or has too much."""
    with open(PLAN, encoding="utf-8") as f:
        text = f.read().replace("\\\n", "")
    pages, listed, page, section = {}, {}, "", ""
    for line in text.splitlines():
        if not line or line[0] == "#":
            continue
        parts = [part.strip() for part in line.split("|")]
        if line[0] in "=-":
            page, section = parts[0][1:].strip(), parts[1]
            pages.setdefault(page, set()).add(section)
            if line[0] == "=":
                listed[page, section] = []
            continue
        kind, _, name = parts[-1].partition(" ")
        listed[page, section].append(" | ".join(parts[:-1]))
        if kind not in ("met", "check", "waived") and not exists(kind, name):
            yield f"{PLAN}: there is no {kind} {name}"
    for page, sections in pages.items():
        found = sentences(Path("docs", page).read_text(encoding="utf-8"))
        yield from (f"docs/{page}: the plan has no section {name!r}"
                    for name in found if name not in sections and found[name])
        yield from (f"{PLAN}: docs/{page} has no section {name!r}"
                    for name in sections - set(found))
        for name in sections & set(found):
            lines = listed.get((page, name))
            if lines is None:
                continue
            yield from (f"docs/{page}, {name}: nothing in the plan judges {s!r}"
                        for s in found[name] if sum(map(s.startswith, lines)) != 1)
            yield from (f"{PLAN}: no sentence of docs/{page}, {name}, begins with {line!r}"
                        for line in lines if sum(s.startswith(line) for s in found[name]) != 1)


def main():
    said = list(wrong())
    print("\n".join(said or ["each sentence has a judge, or is waived by name"]))
    return bool(said)
