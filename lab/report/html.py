# html.py - parts of a page that needs no other file
# SPDX-License-Identifier: Apache-2.0
import base64
from html import escape
from pathlib import Path

HERE = Path(__file__).parent


def text(value):
    return escape(str(value))


def number(value, digits=0):
    """1234567 as 1 234 567."""
    return f"{value:,.{digits}f}".replace(",", "\u202f")


def picture(path, name, css=""):
    data = base64.b64encode(Path(path).read_bytes()).decode()
    return f'<img src="data:image/png;base64,{data}" alt="{text(name)}" class="{css}">'


def table(head, rows, numbers=()):
    """Rows of cells, or of (class, cells)."""
    def line(tag, cells):
        return "".join(f'<{tag}{" class=n" if i in numbers else ""}>{cell}</{tag}>'
                       for i, cell in enumerate(cells))
    body = ""
    for row in rows:
        css, cells = row if isinstance(row[1], list) else ("", row)
        body += f'<tr class="{css}">{line("td", cells)}</tr>'
    return f'<div class="scroll"><table><tr>{line("th", head)}</tr>{body}</table></div>'


def bar(name, share, value, note, css=""):
    """A share of 1 as a bar, with its value in words and a note."""
    return (f'<div class="bar {css}"><span>{text(name)}</span><span class="track">'
            f'<i style="width:{min(share, 1):.1%}"></i></span><span class="n">{value}</span>'
            f"<small>{text(note)}</small></div>")


def command(name, line):
    return f'<pre id="{name}">{text(line)}</pre><button data-copies="{name}">copy</button>'


def whole(title, body, script=True):
    """The page, with its style and, if it moves, its script."""
    css = (HERE / "page.css").read_text("utf-8")
    js = (HERE / "page.js").read_text("utf-8")
    return ('<!doctype html><html lang="en"><meta charset="utf-8">'
            '<meta name="viewport" content="width=device-width, initial-scale=1">'
            f'<link rel="icon" href="data:,"><title>{text(title)}</title><style>{css}</style>'
            f"<body><main>{body}</main>" + (f"<script>{js}</script>" if script else "")
            + "</body></html>\n")
