#!/usr/bin/python3 -ES
# tool_help.py - manual pages and completion of the tool, made of what --help prints
# SPDX-License-Identifier: Apache-2.0
"""usage: sim/tool_help.py man TOOL FOLDER
       sim/tool_help.py bash|zsh TOOL

Commands and options come from the tables that the tool itself parses with. Of completion a word
that is no option is a file, and so is the value of one."""
import re
import subprocess
import sys

BASH = """# completion of sphaera for bash, made of its tables of options
_sphaera() {{
    local word=${{COMP_WORDS[COMP_CWORD]}} words
    if [ "$COMP_CWORD" -eq 1 ]; then
        words='{commands} --help --version'
    else
        case ${{COMP_WORDS[1]}} in
{cases}
        esac
    fi
    case $word in
    -*) ;;
    *) [ "$COMP_CWORD" -eq 1 ] || words= ;;
    esac
    compopt +o nospace 2>/dev/null
    if [ -n "$words" ]; then
        COMPREPLY=($(compgen -W "$words" -- "$word"))
        case ${{COMPREPLY[0]}} in *=) compopt -o nospace 2>/dev/null ;; esac
    else
        COMPREPLY=($(compgen -f -- "$word"))
    fi
}}
complete -o filenames -F _sphaera sphaera"""
ZSH = """#compdef sphaera
# completion of sphaera for zsh, made of its tables of options
local -a commands options
commands=(
{commands}
)
if (( CURRENT == 2 )); then
    _describe 'command' commands
    return
fi
case $words[2] in
{cases}
esac
if [[ $PREFIX == -* ]]; then
    compadd -S '' -- ${{(M)options:#*=}}
    compadd -- ${{options:#*=}}
else
    _files
fi"""


def said(tool, *words):
    return subprocess.run([tool, *words], check=True, text=True, stdout=subprocess.PIPE).stdout


def commands(tool):
    """{name: what it does}"""
    listed = said(tool, "--help").partition("\nCommands:\n")[2].partition("\n\n")[0]
    return dict(re.findall("^  ([a-z]+) +(.*)", listed, re.M))


def options(tool, command):
    """--name or --name= each."""
    found = re.findall(r"^ {1,6}(?:-[A-Za-z?], )?(--[a-z-]*)\[?(=?)",
                       said(tool, command, "--help"), re.M)
    return sorted({name + value for name, value in found})


def bash(tool):
    there = commands(tool)
    print(BASH.format(commands=" ".join(there), cases="\n".join(
        f"        {name}) words='{' '.join(options(tool, name))} ' ;;" for name in there)))


def zsh(tool):
    there = commands(tool)
    described = (f"{name}:{text}".replace("'", "'\\''") for name, text in there.items())
    print(ZSH.format(commands="\n".join(f"    '{text}'" for text in described), cases="\n".join(
        f"    {name}) options=({' '.join(map(repr, options(tool, name)))} ) ;;" for name in there)))


# ---- manual pages: the first line is the usage, the next paragraph what the command is for ----
def roff(text):
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return "\\&" + text if text[:1] in (".", "'") else text


def body(lines):
    """Option lines start with blanks and a dash, text of an option from column 29 on."""
    section = None
    for line in lines:
        blanks, text = len(line) - len(line.lstrip(" ")), line.lstrip(" ")
        if 1 <= blanks <= 6 and text.startswith("-"):
            if section != "OPTIONS":
                section = "OPTIONS"
                yield ".SH OPTIONS"
            option, _, meaning = text.partition("   ")
            yield ".TP\n.B " + roff(option)
            if meaning:
                yield roff(meaning.lstrip(" "))
        elif section == "OPTIONS" and blanks > 19:
            yield roff(text)
        elif section == "OPTIONS" and blanks == 1:
            yield ".SS " + roff(text)
        elif not line:
            yield "" if section == "OPTIONS" else ".PP"
        elif blanks:
            yield ".br\n" + roff(line)
        else:
            if section == "OPTIONS" and line[0].isupper():
                section = "NOTES"
                yield ".SH NOTES"
            yield roff(line)


def page(name, version, text):
    usage, *lines = text.splitlines()
    about = []
    while lines and lines[0].strip() and not re.match(" *-", lines[0]):
        about.append(lines.pop(0))
    about = " ".join(about)
    short = re.sub("[.:].*", "", about)
    head = [f'.TH {name.upper()} 1 "" "{version}" "User commands"', ".SH NAME",
            f"{roff(name)} \\- {roff(short[:1].lower() + short[1:])}",
            ".SH SYNOPSIS\n.B " + roff(usage.removeprefix("Usage: ")),
            ".SH DESCRIPTION\n" + roff(about)]
    return "\n".join([*head, *body(lines)]) + "\n"


def man(tool, folder):
    version = said(tool, "--version").rstrip("\n")
    for words in [], *([name] for name in commands(tool)):
        name = "-".join(["sphaera", *words])
        with open(f"{folder}/{name}.1", "w", encoding="utf-8") as f:
            f.write(page(name, version, said(tool, *words, "--help")))


if __name__ == "__main__":
    making = {"man": man, "bash": bash, "zsh": zsh}.get(sys.argv[1] if sys.argv[1:] else "")
    if not making or len(sys.argv) != 3 + (making is man):
        sys.exit(__doc__.partition("\n\n")[0])
    making(*sys.argv[2:])
