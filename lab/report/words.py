# words.py - the machine of a run in words: what was built, and why
# SPDX-License-Identifier: Apache-2.0
from . import html
from .html import number, text

WIDTHS = (("W", "coordinates of {} bits"), ("WD", "directions of {}"), ("PQ", "quotients of {}"),
          ("NG", "{} guard bits of normals"), ("FW", "node filter of {} bits"),
          ("PR", "roots of {} bits"))


def several(count, name):
    return f"{number(count)} {name}{'' if count == 1 else 's'}"


def listed(parts):
    """a, b and c"""
    return " and ".join(filter(None, [", ".join(parts[:-1]), parts[-1]])) if parts else ""


def came(report):
    """When a line comes."""
    late, memory = report["latency"], report["memory"]
    if "part" not in memory:
        return f"a line comes {late} clocks after it is asked for"
    return (f"a line comes {late} clocks after {memory['name']} has it ({memory['part']}; the core "
            f"at {memory['core_mhz']} MHz)")


def lines(run):
    machine, build, report = run.machine, run.built["build"], run.report
    things = [several(machine[kind + "s"], kind) for kind in
              ("sphere", "triangle", "plane", "light") if machine[kind + "s"]]
    yield "Scene", listed(things) or "nothing"
    widths = [form.format(machine["widths"][name]) for name, form in WIDTHS
              if machine["widths"][name]]
    yield "Arithmetic", f"profile {machine['profile']}: {listed(widths)}"
    if "profile_why" in build:
        yield "", build["profile_why"]
    if "expected" in build:
        expected = build["expected"]
        yield "Expected", (f"what is seen is at most {expected['pixels']:.2g} pixels off, "
                           f"{expected['psnr']:.1f} dB against double precision, a mean")
    yield "Grid", (f"a step is {build['grid_step']:g} units of the scene, the smallest radius "
                   f"{build['smallest_radius']:.4g} steps")
    eye = ", ".join(map(str, machine["camera"]["eye"]))
    yield "Camera", (f"at ({eye}) on the grid, sees {machine['camera']['degrees_across']:.1f} "
                     f"degrees across {machine['width']} pixels, looks along -z")
    tree = (f"{machine['tree']}: {several(build['nodes'], 'node')} on "
            f"{several(build['depth'], 'level')}")
    yield "Tree", tree + (f"; {build['tree_why']}" if "tree_why" in build else "")
    yield "Memory", (f"{number(machine['memory_bytes'])} bytes, {number(machine['tree_bytes'])} of "
                     f"them tree and leaves; {came(report)}, {report['stall']} % of handshakes "
                     "are held back")
    core = run.parameters
    yield "Core", (f"{report.get('core', 'all')}; {several(core['ENGINES'], 'engine')} of "
                   f"{several(core['PIPES'], 'pipe')} with {core['SLOTS']} rays in flight, "
                   f"caches of {core['NODE_LINES']} nodes and {core['LEAF_LINES']} leaf lines")
    yield "Rays", (f"up to {several(machine['max_depth'], 'reflection')} one after another; "
                   f"background separation: {machine['background']}")
    for line in build["background"]:
        yield "", line
    for line in build["warnings"]:
        yield "Warning", line


def machine_words(run):
    rows = [[f"<b>{name}</b>", text(said)] for name, said in lines(run)]
    return "<h2>The machine</h2>" + html.table(["", ""], rows)


def effects(run):
    """What the machine has of each effect, and what build found out about it."""
    rows = [("" if e["on"] else "off",
             [text(e["name"]), text(e["on"]) if e["on"] > 1 else "on" if e["on"] else "off",
              text(e["why"])]) for e in run.built["build"]["effects"]]
    return ("<h2>Effects</h2><p>What the core is built with, and why <code>sphaera build</code> "
            "chose it.</p>" + html.table(["effect", "", "why"], rows))
