# blocks.py - parameters, ports, model and bench of modules
# SPDX-License-Identifier: Apache-2.0
import re
from itertools import groupby
from pathlib import Path

from . import definitions, markdown, verilog

EVERYWHERE = "clk", "rst"
CORE = "rt_core"


def _read(module):
    paths = verilog.files()
    if module not in paths:
        raise verilog.Bad(f"there is no module {module} in rtl/")
    return verilog.header(paths[module], verilog.defines())


def _alike(name, other):
    """x_i and y_i of one vector: names that differ in single letters alone."""
    one, two = name.split("_"), other.split("_")
    return len(one) == len(two) and all(a == b or len(a) == len(b) == 1 for a, b in zip(one, two))


def _merged(items, value=lambda item: item.bits):
    """Groups of items. One without a comment belongs to the group above if it is another component
    of the same vector, or if that group has no comment either."""
    merged = []
    for item in items:
        first = merged[-1][0] if merged else None
        if first and not item.comment and (
                not first.comment
                or _alike(item.name, first.name) and value(item) == value(first)):
            merged[-1].append(item)
        else:
            merged.append([item])
    return merged


def _rows(items, value):
    """(names, values, meaning) of each group."""
    for group in _merged(items, value):
        values = [value(item) for item in group]
        shown = values[0] if len(set(values)) == 1 else ", ".join(values)
        comment = group[0].comment
        yield ", ".join(f"`{item.name}`" for item in group), shown, "" if comment in (
            shown, "u" + shown) else comment


def parameters(module):
    """Those that effects() of definitions.py has not."""
    told = {e.core for e in definitions.definition().effects.values()}
    items = [item for item in _read(module)[0] if item.name not in told]
    return markdown.entries((f"{names} = {default}", meaning) for names, default, meaning
                            in _rows(items, lambda item: item.default))


def ports(module):
    """A list for each heading of the source: names, bits, meaning; without clock and reset."""
    items = [item for item in _read(module)[1] if item.name not in EVERYWHERE]
    told = []
    for heading, group in groupby(items, lambda item: item.heading):
        told.append(markdown.entries((names, bits + f" ({meaning})" * bool(meaning))
                                     for names, bits, meaning in _rows(group, lambda i: i.bits)))
        if heading:
            told[-1] = f"*{heading}*\n\n{told[-1]}"
    return "\n\n".join(told)


def _worth(item):
    """What is written behind a port: its bits or bundle, unless its name tells them."""
    usual = {"_slot_": "SLOTW", "_tag_": "TAG"}
    if item.bits == "1" or any(part in item.name and item.bits == bits
                               for part, bits in usual.items()):
        return ""
    return re.sub(r"bundle (\w+)", r"*\1*", item.bits)


def _said(group):
    """Ports that share a meaning: names and bits, those of a vector once, and the meaning. What is
    named as its bundle stands in italics."""
    worths = [_worth(item) for item in group]
    if len(set(worths)) == 1:
        worths[:-1] = [""] * (len(worths) - 1)
    text = ", ".join(f"*`{item.name}`*" if f"*{item.name[:-2]}*" == _worth(item)
                     else f"`{item.name}` {worth}".strip() for item, worth in zip(group, worths))
    text = re.sub(r"`(\w+_)x(_[io])`, `\1y\2`, `\1z\2`", r"`\1{x,y,z}\2`", text)
    comment = group[0].comment
    meant = comment and comment not in (group[0].bits, "u" + group[0].bits)
    return text + f" ({comment})" * bool(meant)


def _payload(group):
    """Ports besides valid, ready, slot and tag that say nothing of their own; all of a group that
    has no others; without the seven of a reader of memory."""
    memory = [item for item in group if item.name.startswith("mem_r")]
    group = [item for item in group if len(memory) != 7 or item not in memory]
    payload = [item for item in group if item.comment not in ("", "one cycle")
               or not re.search(r"_(valid|ready|slot|tag)_[io]$", item.name)]
    return payload or group, ["`mem_req_*`, `mem_rsp_*`"] * (len(memory) == 7)


def benches():
    """{module: benches} of the list in tb/."""
    found = {}
    for line in Path("tb/benches.txt").read_text().splitlines():
        word = line.split("#")[0].removeprefix("more ").split()
        if word and word[0] != "-O0":
            found.setdefault(word[1], []).append(word[2])
    return found


def _mirror(module):
    """What the header of a module says of its model, and its benches, as a list of one line."""
    text = verilog.files()[module].read_text()
    said = re.search(r"Model: ((?:(?!\.\s).)*?)(?=\.?\n(?!//)|\.\s)", text, re.S)
    model = re.sub(r"\s*\n//\s*", " ", said[1]) if said else ""
    model = re.sub(r"\w+\(\)|[\w/]+\.[ch]\b", r"`\g<0>`", model)
    own = ", ".join(f"`{bench}`" for bench in sorted(set(benches().get(module, []))))
    line = " ".join([f"Model: {model}."] * bool(model) + [f"Bench: {own}."] * bool(own))
    return [f"- {line}"] * bool(line)


def interface(*modules):
    """A list: the parameters of the modules, but for those of the core, whose page has them; then
    the ports of the first, for each heading of the source, its model and its bench."""
    core, told = {item.name for item in _read(CORE)[0]}, []
    for module in modules:
        own = [item for item in _read(module)[0] if item.name not in core]
        core.update(item.name for item in own)
        said = [f"{names} = {value}" + f" ({meaning})" * bool(meaning)
                for names, value, meaning in _rows(own, lambda item: item.default)]
        if said:
            whose = f" of {module}" * (module != modules[0])
            told.append(markdown.nested(f"- *parameters{whose}*", said))
    items = [item for item in _read(modules[0])[1] if item.name not in EVERYWHERE]
    for heading, group in groupby(items, lambda item: item.heading):
        payload, memory = _payload(list(group))
        said = [_said(ports) for ports in _merged(payload)] + memory
        told.append(markdown.nested(f"- *{heading or 'ports'}*", said))
    return "\n".join(told + _mirror(modules[0]))
