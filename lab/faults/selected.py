# selected.py - a module with many edits in its text, one of which a number selects when it runs
# SPDX-License-Identifier: Apache-2.0
"""What an edit lies in stands there once more for each edit: a statement behind `always` or of a
function, the right side of an assign or a wire, what a port is connected to. Other places, such as
parameters, cannot be chosen while a simulation runs."""
import re

from .records import place

HEAD = """
    import "DPI-C" function int mutant_number();
    reg [31:0] chosen_fault;
    initial chosen_fault = mutant_number();
"""
WORD = re.compile(r"\s*([A-Za-z_]\w*|.)", re.S)


def code(text):
    """The text with blanks for comments and strings."""
    return re.sub(r'//[^\n]*|/\*.*?\*/|"[^"\n]*"', lambda m: re.sub(r"[^\n]", " ", m[0]), text,
                  flags=re.S)


def closed(text, at):
    """Behind the bracket that closes the one at `at`."""
    depth = 0
    while True:
        depth += (text[at] in "([{") - (text[at] in ")]}")
        at += 1
        if not depth:
            return at


def nested_braces(text):
    """[(begin, end)] of all braces that lie in no others."""
    found, at = [], 0
    while (at := text.find("{", at)) >= 0:
        found.append((at, closed(text, at)))
        at = found[-1][1]
    return found


def until(text, at, ends):
    """Where one of some characters stands outside of brackets."""
    while text[at] not in ends:
        at = closed(text, at) if text[at] in "([{" else at + 1
    return at


def nested(text, at, begin, end):
    """Behind the word that ends what began in front of `at`."""
    depth = 1
    for m in re.compile(rf"\b(?:({begin})|({end}))\b").finditer(text, at):
        depth += 1 if m[1] else -1
        if not depth:
            return m.end()
    raise ValueError(f"no {end}")


def statement(text, at):
    """Behind the statement at `at`."""
    m = WORD.match(text, at)
    if m[1] == "begin":
        return nested(text, m.end(), "begin", "end")
    if m[1] in ("case", "casez"):
        return nested(text, m.end(), "casez?", "endcase")
    if m[1] in ("if", "for"):
        at = statement(text, closed(text, text.index("(", m.end())))
        other = WORD.match(text, at)
        return statement(text, other.end()) if m[1] == "if" and other[1] == "else" else at
    return until(text, at, ";") + 1


def units(text):
    """[(kind, begin, end, what stands in front of the `=`)] of a module's code."""
    found = []
    for m in re.finditer(r"\balways\s*@\s*(?:\*|\(\*\)|\([^)]*\))", text):
        found.append(("statement", m.end(), statement(text, m.end()), ""))
    for m in re.finditer(r"\bfunction\b", text):
        at = until(text, m.end(), ";") + 1
        while (word := WORD.match(text, at))[1] in ("input", "integer", "reg"):
            at = until(text, word.end(), ";") + 1
        found.append(("statement", at, statement(text, at), ""))
    for m in re.finditer(r"\b(assign|wire)\b([^;=]*)=(?!=)", text):
        found.append((m[1], m.start(), until(text, m.end(), ";") + 1, m[2]))
    constants = [(m.end() - 1, closed(text, m.end() - 1)) for m in re.finditer(r"#\s*\(", text)]
    for m in re.finditer(r"\.\w+\s*\(", text):
        if not any(begin <= m.start() < end for begin, end in constants):
            found.append(("port", m.end(), closed(text, m.end() - 1) - 1, ""))
    return found


def chosen(kind, front, texts, mark):
    """The text of a unit that is each of {number: text}, 0: as it was."""
    def named(number, body):
        return re.sub(r"\b(begin\s*:\s*\w+)", rf"\1_{number}", body)
    other = sorted(texts, reverse=True)[:-1]
    if kind == "statement":
        return " begin " + " ".join(f"if (chosen_fault == {n}) begin {named(n, texts[n])} end else"
                                    for n in other) + f" begin {texts[0]} end end"
    if kind == "port":
        return "".join(f"chosen_fault == {n} ? ({texts[n]}) : " for n in other) + f"({texts[0]})"
    front = front.strip()
    head = f"wire {front}" if kind == "wire" else f"wire [$bits({front})-1:0] selected"
    name = re.search(r"\w+$", head)

    def value(number):
        return f"{name[0]}_{mark}_{number}"
    made = "".join(f"{head[:name.start()]}{value(n)} ={texts[n].partition('=')[2]} "
                   for n in texts)
    return made + f"{kind} {front} = " + "".join(
        f"chosen_fault == {n} ? {value(n)} : " for n in other) + f"{value(0)};"


def apart(text, code_of, edits):
    """[(edit, its unit or None)]"""
    known, found = units(code_of), []
    for edit in edits:
        begin, end = place(text, edit.old)[0]
        inside = [u for u in known if u[1] <= begin and end <= u[2]
                  and (u[0] in ("statement", "port") or begin > u[1] + len(u[0] + u[3]))]
        found.append((edit, begin, end, min(inside, key=lambda u: u[2] - u[1], default=None)))
    return found


def made(text, faults):
    """(text with all faults in it, numbers of those that cannot be selected) of
    {number: edits of the file}."""
    clean, by_unit, alone = code(text), {}, set()
    for number, edits in faults.items():
        lie = apart(text, clean, edits)
        if any(unit is None for *_, unit in lie):
            alone.add(number)
            continue
        for edit, begin, end, unit in lie:
            by_unit.setdefault(unit, {}).setdefault(number, []).append((begin, end, edit.new))
    whole = {u: u for u in by_unit}
    for unit in by_unit:        # a port lies in no other; a unit within another one goes with it
        for other in by_unit:
            if other != unit and other[1] <= unit[1] and unit[2] <= other[2]:
                whole[unit] = other
    joined = {}
    for unit, edits in by_unit.items():
        for number, places in edits.items():
            joined.setdefault(whole[unit], {}).setdefault(number, []).extend(places)
    for unit in sorted(joined, key=lambda u: -u[1]):
        kind, begin, end, front = unit
        texts = {}
        for number, places in [(0, []), *joined[unit].items()]:
            body = text[begin:end]
            for first, last, new in sorted(places, reverse=True):
                body = body[:first - begin] + new + body[last - begin:]
            texts[number] = re.sub(r"//[^\n]*", "", body)
        text = text[:begin] + chosen(kind, front, texts, begin) + text[end:]
    at = re.search(r"\bmodule\s+\w+\s*", clean).end()
    if clean[at] == "#":
        at = closed(clean, clean.index("(", at))
    at = until(clean, at, ";") + 1
    return text[:at] + HEAD + text[at:], alone

