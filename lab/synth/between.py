# between.py - the registers that a core is placed between, from the ports of its netlist
# SPDX-License-Identifier: Apache-2.0
"""Reads RTLIL of synth/core.sh, of which the top is placed, and prints Verilog. A package has fewer
pins than the core has. So its inputs come from a shift register behind one pin, and its outputs are
registered and folded into another (each bit xor its neighbour) that ends at one pin. Every path of
the core then begins and ends in a register, nothing of it can be left out, and the pins set no
limit. A clock beside clk, such as pix_clk, has a pin of its own."""
import re
import sys

TOP = """\
module placed (input wire clk{clocks}, input wire in, output wire out);
    reg  [{ins}:0] in_q;
    reg  [{outs}:0] out_q, fold_q;
    wire [{outs}:0] core;
    {top} u_core (
        .clk(clk){ports}
    );
    always @(posedge clk) begin
        in_q   <= {{in_q[{ins_less}:0], in}};
        out_q  <= core;
        fold_q <= {{fold_q[{outs_less}:0], fold_q[{outs}]}} ^ out_q;
    end
    assign out = fold_q[{outs}];
endmodule"""
PORT = re.compile(r"\s*wire (?:width (\d+) )?.*\b(input|output) \d+ .*\\(\S+)$")


def ports(netlist):
    """The name of the top, and (bits, input or output, name) of each of its ports."""
    is_top, name, found = False, None, []
    for line in netlist:
        if line.startswith("attribute \\top "):
            is_top = True
        elif line.startswith("module "):
            if name:
                break
            name = line.split()[1][1:] if is_top else None
            is_top = False
        elif name and "wire" in line and (port := PORT.match(line.rstrip())):
            found.append((int(port[1] or 1), port[2], port[3]))
    return name, found


def main(netlist):
    with open(netlist, encoding="utf-8") as f:
        top, found = ports(f)
    at, given, clocks = {"input": 0, "output": 0}, "", ""
    for bits, way, name in found:
        if name == "clk":
            continue
        if name.endswith("_clk"):
            clocks += f", input wire {name}"
            source = name
        else:
            source = f"{'in_q' if way == 'input' else 'core'}[{at[way]} +: {bits}]"
            at[way] += bits
        given += f",\n        .{name}({source})"
    ins, outs = at.values()
    if not ins or not outs:
        sys.exit(f"{netlist}: no ports of a top")
    print(TOP.format(clocks=clocks, top=top, ports=given, ins=ins - 1, outs=outs - 1,
                     ins_less=ins - 2, outs_less=outs - 2))
