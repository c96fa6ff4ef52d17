# plots.py - plots of sweeps, drawn by gnuplot as SVG: small multiples, heat maps side by side
# SPDX-License-Identifier: Apache-2.0
"""All panels of a plot have the same scales. Figures of others are dashed lines, or maps of their
own beside ours."""
import itertools
import subprocess

from .. import intact
from ..study.plots import COLOURS
from .table import number

WIDTH, HEIGHT, ACROSS = 420, 320, 3  # of a panel, pixels; panels in a row
HEAD = """set terminal svg noenhanced size {width},{height} font "sans,12" background "white"
set output "{out}"
set multiplot layout {down},{across} title "{title}"
set grid lt 1 lc rgb "#dddddd"
"""


def quoted(text):
    return str(text).replace('"', "'").replace("\\", "/")


def placed(values):
    """{value: its place on an axis}, whether the places are the numbers themselves, logarithmic"""
    numbers = [number(value) for value in values]
    if None in numbers:
        return {value: i for i, value in enumerate(values)}, False, False
    log = min(numbers) > 0 and max(numbers) / min(numbers) >= 8
    return dict(zip(values, numbers)), True, log


def tics(name, at, log):
    """Ticks of an axis: each value of the sweep."""
    words = ", ".join(f'"{quoted(value)}" {x}' for value, x in at.items())
    return (f"set {name}tics ({words}) rotate by -30\n" if name == "x" else
            f"set {name}tics ({words})\n") + (f"set logscale {name}\n" if log else "")


def panels(spec, used):
    """(title, points) of each combination of the panel's axes; all varied axes but those used."""
    names = spec.said.get("panel") or [n for n in spec.varied if n not in used]
    for chosen in itertools.product(*(spec.varied[name] for name in names)):
        mine = dict(zip(names, chosen))
        if any(all(point.get(n) == v for n, v in mine.items()) for point in spec.points):
            yield ", ".join(f"{n} {v}" for n, v in mine.items()), mine


def draw(out, title, plots, more, across=ACROSS):
    """plots: gnuplot text of each panel."""
    across = min(across, len(plots))
    down = -(-len(plots) // across)
    with intact.beside(out) as new:
        text = HEAD.format(out=quoted(new), width=WIDTH * across, height=HEIGHT * down + 30,
                           title=quoted(title), down=down, across=across) + more + "".join(plots)
        subprocess.run(["gnuplot"], input=(text + "unset multiplot\n").encode(), check=True)


def chosen_axes(spec):
    """(x, lines): as asked, else the axis of most numbers, then the axis of most values."""
    free = [n for n in spec.varied if n not in spec.said.get("panel", [])]
    told = {word: spec.said.get(word, [""])[0] for word in ("x", "lines")}
    by = sorted(free, key=lambda n: (number(spec.varied[n][0]) is None, -len(spec.varied[n])))
    x = told["x"] or next((n for n in by if n != told["lines"]), "")
    by = sorted(free, key=lambda n: (n == "scene", -len(spec.varied[n])))
    return x, told["lines"] or next((n for n in by if n != x), "")


def values(made, figure, mine):
    """Rows of a panel that have a number."""
    return [row for row in made if number(row.get(figure)) is not None
            and all(row.get(n) == v for n, v in mine.items())]


def multiples(out, spec, made, figure):
    """Lines of a figure over x. False: nothing to draw."""
    x, line = chosen_axes(spec)
    rows = values(made, figure, {})
    if not x or not rows:
        return False
    at, _, log = placed(spec.varied[x])
    ys = [number(row[f]) for row in rows for f in (figure, f"{figure}_beside")
          if number(row.get(f)) is not None]
    more = tics("x", at, log) + f'set xlabel "{x}"\n'
    more += f"set yrange [{min(0, 1.1 * min(ys)):.9g}:{1.1 * max(ys) or 1:.9g}]\n"
    spread = [at[v] for v in spec.varied[x]]
    more += (f"set xrange [{min(spread) / 1.3:.9g}:{max(spread) * 1.3:.9g}]\n" if log else
             f"set xrange [{min(spread) - 0.3:.9g}:{max(spread) + 0.3:.9g}]\n")
    plots = []
    for p, (name, mine) in enumerate(panels(spec, {x, line})):
        blocks, parts = "", []
        for i, of in enumerate(spec.varied[line] if line else [None]):
            for kind, dash in (figure, 1), (f"{figure}_beside", 2):
                some = values(made, kind, {**mine, **({line: of} if line else {})})
                dots = sorted((at[row[x]], number(row[kind])) for row in some)
                if not dots:
                    continue
                data = f"$p{p}l{i}d{dash}"
                blocks += f"{data} << EOD\n" + "".join(f"{a:.9g} {b:.9g}\n" for a, b in dots)
                blocks += "EOD\n"
                label = quoted(f"{line} {of}" if line else figure) + " beside" * (dash == 2)
                parts.append(f'{data} with linespoints pt 7 ps 0.6 lw 2 dt {dash} lc rgb '
                             f'"{COLOURS[i % len(COLOURS)]}" title "{label}"')
        if parts:
            key = "set key top right\n" if p == 0 else "unset key\n"
            plots.append(f'{blocks}{key}set title "{quoted(name)}"\n'
                         f'plot {", ".join(parts)}\n')
    draw(out, figure, plots, more)
    return True


def heat(out, spec, made, figure):
    """Maps of a figure over the two axes of `heat`, and of `beside` next to each."""
    x, y = spec.said["heat"]
    kinds = [kind for kind in (figure, f"{figure}_beside") if values(made, kind, {})]
    if not kinds:
        return False
    places = {name: {v: i for i, v in enumerate(spec.varied[name])} for name in (x, y)}
    every = [number(row[kind]) for kind in kinds for row in values(made, kind, {})]
    low, high = min(every), max(every)
    more = "unset grid\nunset key\n" + tics("x", places[x], False) + tics("y", places[y], False)
    more += f'set xlabel "{x}"\nset ylabel "{y}"\n'
    more += f"set cbrange [{low:.9g}:{high if high > low else low + 1:.9g}]\n"
    more += 'set palette defined (0 "#f7fbff", 0.5 "#6baed6", 1 "#08306b")\n'
    more += "".join(f"set {n}range [-0.5:{len(places[a]) - 0.5}]\n"
                    for n, a in (("x", x), ("y", y)))
    plots = []
    for p, (name, mine) in enumerate(panels(spec, {x, y})):
        for kind in kinds:
            some = values(made, kind, mine)
            if not some:
                continue
            data = "".join(f"{places[x][r[x]]} {places[y][r[y]]} {number(r[kind]):.9g}\n"
                           for r in some)
            block = f"$h{p}{kind} << EOD\n{data}EOD\n"
            # a value is dark on light, light on dark
            middle = (low + high) / 2
            title = ", ".join(filter(None, [name, "beside" * (kind != figure)]))
            plots.append(
                f'{block}set title "{quoted(title)}"\nplot $h{p}{kind} using 1:2:3 with image, '
                f'"" using 1:2:(sprintf("%.4g", $3)):($3 > {middle:.9g} ? 0xffffff : 0) '
                'with labels tc rgb variable\n')
    draw(out, figure, plots, more, ACROSS - ACROSS % len(kinds))  # of ours and theirs, a pair
    return True


def everything(folder, spec, made, figures):
    """Draws each figure that has numbers; the files."""
    drawn = []
    for figure in figures:
        out = f"{folder}/{figure}.svg"
        if (heat if "heat" in spec.said else multiples)(out, spec, made, figure):
            drawn.append(out)
    return drawn
