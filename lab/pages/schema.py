# schema.py - the members of a JSON report, from its schema docs/reference/NAME.schema.json
# SPDX-License-Identifier: Apache-2.0
"""A list of the members of the whole, with the commands that write them (dependentSchemas), and a
paragraph for each object of $defs. A $ref and what it refers to both may have a description."""
import json
import textwrap
from pathlib import Path


def read(name):
    return json.loads(Path(f"docs/reference/{name}.schema.json").read_text("utf-8"))


def wrapped(text, indent=""):
    return textwrap.fill(text, 100, subsequent_indent=indent, break_long_words=False,
                         break_on_hyphens=False)


def words(member):
    return ", ".join(f"`{json.dumps(word)}`" for word in member.get("enum", []))


def named(member, key="$ref"):
    """The object of $defs that a member is, or is an array of."""
    inner = member if key in member else member.get("items", member.get("additionalProperties"))
    return inner[key].split("/")[-1] if isinstance(inner, dict) and key in inner else None


def told_below(of):
    """Whether an object of $defs has a paragraph of its own."""
    return "properties" in of or "propertyNames" in of and "enum" in of["propertyNames"]


def said(member, defs):
    """What is to be said of a member besides its name."""
    text = [member.get("description"), words(member)]
    if "const" in member:
        text.append(f"`{json.dumps(member['const'])}`")
    ref = named(member)
    if ref and not told_below(defs[ref]):
        text.append(defs[ref]["description"])
    elif ref:
        article = "an" if ref[0] in "aeiou" else "a"
        text.append(f"{'each ' if 'items' in member else ''}{article} **{ref}**")
    elif "properties" in member and "description" not in member:
        text.append(", ".join(f"`{name}`" for name in member["properties"]))
    return "; ".join(filter(None, text))


def paragraph(name, of, defs):
    parts = []  # [names, what is said of them]
    for key, member in of.get("properties", {}).items():
        text = said(member, defs)
        if parts and parts[-1][1] in ("", text):
            parts[-1] = [f"{parts[-1][0]}, `{key}`", text]
        else:
            parts.append([f"`{key}`", text])
    parts = [names + (f" ({text})" if text else "") for names, text in parts]
    about = f", {of['description']}" if "description" in of else ""
    return wrapped(f"**{name}**{about}" + (f": {', '.join(parts)}." if parts else "."))


def members(name):
    """The region of a page."""
    schema = read(name)
    defs, of = schema["$defs"], schema.get("dependentSchemas", {})
    lines, bare = [], []
    items = [(key, said(member, defs),
              ", ".join(of[key]["properties"]["command"]["enum"]) if key in of else "")
             for key, member in schema["properties"].items()]
    for at, (key, text, commands) in enumerate(items):
        bare.append(f"`{key}`")
        more = at + 1 < len(items) and not items[at + 1][1] and items[at + 1][2] == commands
        if not text and more:
            continue
        line = f"- {', '.join(bare)}" + (f" ({commands})" if commands else "")
        lines.append(wrapped(line + (f": {text}" if text else ""), "  "))
        bare = []
    objects = [paragraph(key, member, defs) for key, member in defs.items()
               if told_below(member)]
    return "\n".join(lines) + "\n\n" + "\n\n".join(objects)
