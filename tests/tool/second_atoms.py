# second_atoms.py - molecules by gemmi, against what the tool has read
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 second_atoms.py TOOL FOLDER MOLECULE...

Each file (PDB or mmCIF, packed or not) is read by gemmi and by the tool (import --water); then what
gemmi writes of it, as mmCIF, packed mmCIF, and as PDB, twenty times over, so that serial numbers
are hybrid-36. Places of the first model and their elements have to be the same: of alternates the
likeliest, of one place the first. FOLDER is for what is written. A line for each file; exit code 1
if anything differs, 3 if there is no gemmi."""
import collections
import gzip
import re
import shutil
import subprocess
import sys
from pathlib import Path

try:
    import gemmi
except ImportError:
    print("there is no gemmi")
    sys.exit(3)

ELEMENTS = "/usr/share/bodr/elements.xml"
COPIES = 20


def colours():
    """{colour: symbols} of the Blue Obelisk's elements."""
    found = collections.defaultdict(set)
    text = Path(ELEMENTS).read_text(encoding="utf-8")
    for symbol, body in re.findall(r'<atom id="(\w+)">(.*?)</atom>', text, re.S):
        colour = re.search(r'bo:elementColor"[^>]*>([^<]+)<', body)
        found[tuple(map(float, colour[1].split()))].add(symbol.upper())
    return found


def by_gemmi(structure):
    """{place: element} of its first model."""
    best, found = {}, {}
    for chain in structure[0]:
        for residue in chain:
            for atom in residue:
                key = (chain.name, str(residue.seqid), atom.name) if atom.has_altloc() \
                    else (chain.name, str(residue.seqid), atom.name, atom.serial, len(best))
                if key not in best or atom.occ > best[key].occ:
                    best[key] = atom
    for atom in best.values():
        if atom.element.name != "X":
            place = tuple(round(x, 3) for x in (atom.pos.x, atom.pos.y, atom.pos.z))
            found.setdefault(place, "H" if atom.element.name == "D" else atom.element.name.upper())
    return found


def by_tool(tool, path, known, folder):
    """{place: symbols that have its colour}."""
    scene = Path(folder, "scene.nff")
    subprocess.run([tool, "import", path, "--water", "-o", scene], check=True,
                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    found, colour = {}, None
    for line in scene.read_text(encoding="utf-8").splitlines():
        words = line.split()
        if words[0] == "f":
            colour = tuple(map(float, words[1:4]))
        elif words[0] == "s":
            found[tuple(round(float(x), 3) for x in words[1:4])] = known[colour]
    return found


def differ(mine, tools):
    if mine.keys() != tools.keys():
        return f"{len(mine.keys() - tools.keys())} places are gemmi's alone, " \
               f"{len(tools.keys() - mine.keys())} the tool's, such as " \
               f"{sorted(mine.keys() ^ tools.keys())[0]}"
    wrong = [place for place, element in mine.items() if element not in tools[place]]
    return f"{len(wrong)} elements, such as {mine[wrong[0]]} at {wrong[0]} as " \
           f"{tools[wrong[0]]}" if wrong else None


def copies(structure):
    """Its first model so often, each beside the last, as one of more than 99 999 atoms."""
    many, first = gemmi.Structure(), structure[0]
    model = gemmi.Model("1")
    for number in range(COPIES):
        for chain in first:
            copy = chain.clone()
            copy.name = chr(ord("A") + number)
            for residue in copy:
                for atom in residue:
                    atom.pos = gemmi.Position(atom.pos.x + 150 * number, atom.pos.y, atom.pos.z)
            model.add_chain(copy)
    many.add_model(model)
    return many


def written(structure, folder):
    """Files of it that gemmi writes."""
    cif, packed, pdb = (Path(folder, name) for name in ("a.cif", "a.cif.gz", "many.pdb"))
    structure.make_mmcif_document().write_file(str(cif))
    with open(cif, "rb") as whole, gzip.open(packed, "wb") as to:
        shutil.copyfileobj(whole, to)
    found = [(str(cif), structure), (str(packed), structure)]
    many = copies(structure)
    if many[0].count_atom_sites() > 99999:
        many.write_pdb(str(pdb))
        assert "\nATOM  A0000" in pdb.read_text(encoding="ascii"), "no hybrid-36"
        found.append((str(pdb), many))
    return found


def main(tool, folder, *paths):
    known, bad = colours(), 0
    for path in paths:
        try:
            structure = gemmi.read_structure(path)
        except (RuntimeError, ValueError) as e:  # columns of before 1996, rows that are too long
            print(f"{path}: gemmi refuses it: {e}")
            continue
        for file, as_gemmi in [(path, structure)] + written(structure, folder):
            mine = by_gemmi(as_gemmi)
            wrong = differ(mine, by_tool(tool, file, known, folder))
            bad |= wrong is not None
            print(f"{path}, {Path(file).name}: {len(mine)} atoms: {wrong or 'the same'}")
    return bad


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
