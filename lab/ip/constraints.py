# constraints.py - the crossings of clocks that the sources have by their modules, as XDC and SDC
# SPDX-License-Identifier: Apache-2.0
"""Four modules may hold one: rt_sync (two flip-flops; pointers of rt_async_fifo are in Gray code),
rt_async_fifo (words, which its pointers keep apart), rt_video (its mode, which stands still while
the display is on), rt_serialise (clocks of one PLL, edges together). Names are looked up in the
netlist; check_crossings.py finds what has none."""
from collections import namedtuple

# from: cells, or empty for the clock; gray: bits that must arrive within one clock of each other
Crossing = namedtuple("Crossing", "what at cells to cells_to gray")


def synchronises(state):
    return state.name.endswith("/meta_q") and "/rt_sync.v:" in state.src


def crossing(source, state):
    """Of what is allowed to cross, or None; the name by which it is sorted."""
    place, _, name = state.name.rpartition("/")
    ends = source.clock, [], state.clock, [state.name]
    if synchronises(state):
        gray = "/rt_async_fifo.v:" in state.src
        return state.name, Crossing("a pointer in Gray code" if gray else "bits, each by itself",
                                    *ends[:3], [state.name, f"{place}/settled_q"], gray)
    if name == "rd_data_o" and "/rt_dual_ram.v:" in state.src:
        return state.name, Crossing("words; a block RAM has no such path", source.clock,
                                    [f"{place}/mem"], *ends[2:], False)
    if source.name.endswith("/mode_q") and "/rt_video.v:" in source.src:
        return source.name, Crossing("stands still while the display is on", source.clock,
                                     [source.name], state.clock, [], False)
    if "/rt_serialise.v:" in state.src:
        return state.name, Crossing("clocks of one PLL, edges together", source.clock,
                                    [source.name], *ends[2:], False)
    return None


def crossings(netlist):
    found = {}
    for source, state, _ in netlist.crossings():
        named = crossing(source, state)
        if named and named[1] not in found.values():
            found[named[0], source.name] = named[1]
    return [found[key] for key in sorted(found)]


def pattern(name):
    return f"*{name}_reg*"


HEAD = """\
# sphaera.{kind} - crossings of clocks in rt_top, each by its registers
# SPDX-License-Identifier: Apache-2.0
"""
XDC = """\
# read_xdc -ref rt_top sphaera.xdc, behind the constraints that make the clocks.
"""
SDC = """\
# rt_top as the top; inside another one: change what get_ports finds, names of cells match anywhere.
"""


def xdc(found):
    def clock(name):
        return f"[get_clocks -of_objects [get_ports {name}]]"

    def cells(names):
        return ("[get_cells -hierarchical -filter {"
                + " || ".join(f"NAME =~ {pattern(n)}" for n in names) + "}]")
    lines = []
    for c in found:
        start = cells(c.cells) if c.cells else clock(c.at)
        end = cells(c.cells_to[:1]) if c.cells_to else clock(c.to)
        period = f"[get_property PERIOD {clock(c.at)}]"
        lines.append(f"# {c.what}")
        if not c.cells:
            lines.append(f"set_property ASYNC_REG TRUE {cells(c.cells_to)}")
        lines.append(f"set_max_delay -datapath_only -from {start} -to {end} {period}")
        if c.gray:
            lines.append(f"set_bus_skew -from {start} -to {end} {period}")
    return "\n".join([HEAD.format(kind="xdc") + XDC + NONE * (not found), *lines, ""])


MHZ = 125       # that a clock is given, until somebody changes it
NONE = "# There is one clock, and no crossing.\n"


def sdc(found, clocks):
    def cells(names):
        return f"[get_cells {{{' '.join(map(pattern, names))}}}]"
    lines = []
    for name in clocks:
        lines += [f"set {name}_period {1000 / MHZ:.3f}",
                  f"create_clock -name {name} -period ${name}_period [get_ports {name}]"]
    for c in found:
        start = cells(c.cells) if c.cells else f"[get_clocks {c.at}]"
        end = cells(c.cells_to[:1]) if c.cells_to else f"[get_clocks {c.to}]"
        lines += [f"# {c.what}", f"set_max_delay ${c.at}_period -from {start} -to {end}",
                  f"set_false_path -hold -from {start} -to {end}"]
    return "\n".join([HEAD.format(kind="sdc") + SDC + NONE * (not found), *lines, ""])
