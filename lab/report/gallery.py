# gallery.py - all scenes on one page
# SPDX-License-Identifier: Apache-2.0
"""FOLDER has NAME.png and NAME.json, of `sphaera render`, for each scene scenes/NAME.nff."""
import base64
import json
from pathlib import Path

from .. import intact
from . import html
from .html import number, text
from .words import listed, several

GROUPS = {"": "Scenes", "facets": "Triangles and planes", "refraction": "Refraction",
          "texture": "Textures", "views": "Views", "effects": "An effect or two"}


def about(scene):
    """What its file says of it: the comment at its head, without name and licence."""
    said = []
    for line in scene.read_text("utf-8").splitlines():
        if not line.startswith("#") or line.startswith("# Sphaera scene"):
            break
        if "SPDX" not in line:
            said.append(line.lstrip("# "))
    text_of = " ".join(said)
    return text_of.removeprefix(f"{scene.name} - ")


def card(folder, name):
    scene = Path("scenes", name + ".nff")
    report = json.loads((folder / f"{name}.json").read_text("utf-8"))
    machine, count = report["machine"], report["counters"]
    things = listed([several(machine[kind + "s"], kind) for kind in
                     ("sphere", "triangle", "plane", "light") if machine[kind + "s"]])
    effects = ", ".join(machine["effects"]) or "no effects"
    file = base64.b64encode(scene.read_bytes()).decode()
    return (f'<figure id="{text(name)}">{html.picture(folder / f"{name}.png", name)}'
            f'<figcaption><b>{text(name)}</b><span class="soft">{text(about(scene))}</span>'
            f'<p class="soft">{things or "nothing"}; {effects}; profile {machine["profile"]}, tree '
            f'{machine["tree"]}; {number(machine["memory_bytes"])} bytes, '
            f'{count["node_visits"] / max(count["rays_primary"], 1):.1f} visits a ray of the eye'
            f'</p><code>make sim SCENE={text(name)}</code> '
            f'<a download="{text(scene.name)}" href="data:text/plain;base64,{file}">scene</a>'
            "</figcaption></figure>")


def page(folder):
    names = sorted(str(path.relative_to(folder).with_suffix("")) for path in folder.rglob("*.json"))
    groups = sorted({name.rpartition("/")[0] for name in names},
                    key=lambda group: (list(GROUPS) + [group]).index(group))
    size = json.loads((folder / f"{names[0]}.json").read_text("utf-8"))["machine"]
    body = ("<h1>Scenes of Sphaera</h1><p>Each as the golden model draws it, which is bit by bit "
            f"what the hardware draws: {size['width']} x {size['height']} rays, "
            "four of them a pixel.</p>")
    for group in groups:
        cards = "".join(card(folder, name) for name in names if name.rpartition("/")[0] == group)
        body += f'<h2>{text(GROUPS.get(group, group))}</h2><div class="maps">{cards}</div>'
    return html.whole("Scenes of Sphaera", body, script=False)


def main(folder, name):
    intact.write(name, page(Path(folder)))
