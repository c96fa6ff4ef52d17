#!/usr/bin/env python3
# reset.py - one clock of reset makes every module quiet, whatever it did before
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.reset BUILD [MODULE...]

Yosys simulates each module of rtl/ that has a reset in three values. All registers, all words of
memories and all inputs are x, each 0 or 1 by itself. rst is 1 for one clock and then 0; from that
clock on the inputs that say that something comes in are 0. Then the outputs that say that something
goes out must be 0, not x, in every clock until two are alike: as nothing else changes, for ever.
x never stands for less than what can be, so a pass is a proof; a failure may be a false alarm.

What says so is told by names (SAYS) and by the fields of bundles. formal/reset.txt has what is
an exception, each with its reason, and parameters of modules that are tried in other ways too."""
import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from .pages import verilog

CLOCK = re.compile(r"(\w+_)?clk(_i)?$")
RESET = re.compile(r"(\w+_)?rst(_i)?$")
SAYS = re.compile(r"(\w+_)?([a-z]*valid|busy|done|start|irq|again|go|read|take|push|fault|event"
                  r"|bad)(_[io])?$|next_light_i")
LOW = {"HIT": 3, "RAY": 3}      # bits at the low end of a bundle that say so; else its VALID
CLOCKS = 200                    # of a simulation


class Bad(Exception):
    """A module that cannot be tried."""


def bundle_fields():
    """{bundle: low bits of it that say that something comes or goes}"""
    text = Path("rtl/engine/rt_bundles.vh").read_text()
    return {**dict.fromkeys(re.findall(r"^`define RT_(\w+)_VALID 0 \+: 1$", text, re.M), 1), **LOW}


def exceptions():
    """{module: {port or word: what is said of it}}, {module: [parameters]} of formal/reset.txt."""
    said, ways = {}, {}
    for line in Path("formal/reset.txt").read_text().splitlines():
        if not line.startswith(("#", " ")) and line:
            module, what, rest = (line + " ").split(" ", 2)
            if what == "with":
                ways.setdefault(module, []).append(rest.strip())
            else:
                said.setdefault(module, {})[what] = rest.strip()
    return said, ways


def harness(path, said, fields):
    """Verilog of a module `quiet` around the one of a file, and the outputs that it looks at; none
    if that has no reset."""
    text = re.sub(r"//.*", "", "\n".join(line for _, _, line in verilog.lines(path)))
    head = re.search(r"^module \w+\s*(#\s*\(.*?\)\s*)?\(\s*$.*?^\);", text, re.S | re.M)
    if not head:
        raise Bad("no header")
    parameters = re.findall(r"parameter\s+(?:\[[^]]*\]\s*)?(\w+)", head[1] or "")
    ports, links, looked = [], [], []
    for line in head[0][head.end(1) - head.start() if head[1] else 0:].splitlines():
        port = verilog.PORT.match(line.strip())
        if not port:
            continue
        way, name, size = port["way"], port["name"], port["range"] or ""
        bundle = re.match(r"\[(?:\w+\*)?\(?`RT_((?!\w*EVENT)\w+?)_BITS", size)
        low = fields.get(bundle[1]) if bundle else 0
        says = bool(SAYS.match(name)) and not bundle and name not in said
        if CLOCK.match(name) or RESET.match(name):
            links.append(f".{name}({'clk' if CLOCK.match(name) else 'rst'})")
        elif way == "input":
            ports.append(f"input wire {size} {name}")
            value = "0" if says else f"({name} >> {low}) << {low}" if low else name
            if said.get(name, "").startswith("="):
                value = said[name][1:].split()[0]
            links.append(f".{name}({value})")
        else:
            ports.append(f"output wire {size} {name}")
            links.append(f".{name}({name})")
            if (says or low) and name not in said:
                looked.append((name, f"|{name}[{low - 1}:0]" if low else f"|{name}"))
    if not any("rst" in link for link in links) or not looked:
        return None, []
    includes = "\n".join(re.findall(r"^`include.*$", text, re.M))
    return f"""{includes}
module quiet {head[1] or ''} (input wire clk, input wire rst, {', '.join(ports)},
    output wire [{len(looked) - 1}:0] look);
    {path.stem} {"#(" + ", ".join(f".{p}({p})" for p in parameters) + ")" if parameters else ""}
        u (
        {', '.join(links)});
    assign look = {{{', '.join(what for _, what in looked)}}};
endmodule
""", [name for name, _ in looked]


def simulate(folder, way, names, length):
    """Outputs that are not quiet, and in which clock first; whether it goes on for ever."""
    include = " ".join(f"-I{d}" for d in sorted({str(p.parent) for p in Path("rtl").rglob("*.v")}))
    libraries = " ".join(f"-libdir {d}" for d in sorted(
        {str(p.parent) for p in Path("rtl").rglob("*.v")}))
    values = " ".join(f"-chparam {w.replace('=', ' ')}" for w in way.split())
    vcd = folder / "quiet.vcd"
    # memories give anything: x; what they are written with is forgotten
    script = f"""verilog_defaults -add {include} -DSYNTHESIS
        read_verilog {folder}/quiet.v
        hierarchy -check {libraries} -top quiet {values}
        proc -norom
        flatten
        opt_clean
        memory_dff
        memory_collect
        delete t:$mem*
        dffunmap
        setattr -unset init
        sim -q -clock clk -reset rst -rstlen {length} -n {CLOCKS + length} -vcd {vcd}"""
    (folder / "quiet.ys").write_text("\n".join(line.strip() for line in script.splitlines()))
    ran = subprocess.run(["yosys", "-q", "-s", f"{folder}/quiet.ys"], check=False, text=True,
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if ran.returncode:
        raise Bad(ran.stdout[-600:])
    return judge(vcd, names, length)


def judge(vcd, names, length):
    """{output: clock after reset in which it is first not 0}, and the last clock that something
    changes in but clocks."""
    loud, clocks, look, now, last, value = {}, set(), None, -length, 0, "x"
    for line in [*vcd.read_text().splitlines(), "#0"]:
        word = line.split()
        if line.startswith("$var"):
            if word[4] == "look":
                look = word[3]
            if CLOCK.match(word[4].split(".")[-1]):
                clocks.add(word[3])
        elif line.startswith("#"):              # what stands is that of the time before
            if now >= 0:
                for name, bit in zip(names, value.rjust(len(names), value[0])):
                    if bit != "0":
                        loud.setdefault(name, (now, bit))
            now = int(line[1:]) // 10 - length  # the edge that ends the reset begins clock 0
        elif line.startswith("b"):
            if word[1] not in clocks and now >= 0:
                last = now
            if word[1] == look:
                value = word[0][1:]
    return loud, last


def one(build, module, path, way, said, fields):
    """Of one module in one way: (outputs looked at, those that are loud, last clock)."""
    text, names = harness(path, said, fields)
    if text is None:
        return None
    folder = Path(build) / "reset" / re.sub(r"\W+", "_", f"{module} {way}".strip())
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "quiet.v").write_text(text)
    return names, *simulate(folder, way, names, int(said.get("reset", "1").split()[0]))


def main(build, *wanted):
    said, ways = exceptions()
    fields, files = bundle_fields(), verilog.files()
    jobs = [(module, way) for module in (wanted or files) for way in ["", *ways.get(module, ())]]

    def work(job):
        module, way = job
        try:
            return one(build, module, files[module], way, said.get(module, {}), fields)
        except Bad as e:
            return str(e)

    tried = failed = outputs = 0
    bounded = []
    with ThreadPoolExecutor(int(os.environ.get("JOBS", "2"))) as pool:
        for (module, way), result in zip(jobs, pool.map(work, jobs)):
            name = f"{module} {way}".strip()
            if result is None:
                continue
            tried += 1
            if isinstance(result, str):
                failed += 1
                print(f"not ok {name}: {result}")
                continue
            names, loud, last = result
            outputs += len(names)
            wrong = [f"{n} is {bit} in clock {clock}" for n, (clock, bit) in loud.items()]
            settled = f"settled in clock {last}"
            if last >= CLOCKS - 2:
                bounded.append(module)
                settled = f"for {CLOCKS} clocks"
            failed += bool(wrong)
            print(f"{'not ok' if wrong else 'ok'} {name}: {len(names)} outputs, " +
                  (", ".join(wrong) if wrong else settled))
    print(f"{tried - failed} of {tried} modules are quiet after one clock of reset, "
          f"{outputs} outputs; for ever but {len(bounded)}, which count on for {CLOCKS} clocks")
    sys.exit(failed > 0 or tried == 0)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(*sys.argv[1:])
