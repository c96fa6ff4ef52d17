# placed.awk - writes the registers that a core is placed between, from the ports of its netlist
# SPDX-License-Identifier: Apache-2.0
#
# usage: awk -f synth/placed.awk netlist.il       (RTLIL of core.sh, of which the top is placed)
# A package has fewer pins than the core has. So its inputs come from a shift register behind one
# pin, and its outputs are registered and folded into another (each bit xor its neighbour) that ends
# at one pin. Every path of the core then begins and ends in a register, nothing of it can be left
# out, and the pins set no limit. A clock beside clk, such as pix_clk, has a pin of its own.
$1 == "attribute" && $2 == "\\top" { is_top = 1 }
$1 == "module" {
    in_core = is_top
    is_top = 0
    if (in_core) top = substr($2, 2)
}
in_core && $1 == "wire" && match($0, / (input|output) [0-9]+ /) {
    width = $2 == "width" ? $3 : 1
    name = substr($NF, 2)
    if (name == "clk") next
    if (name ~ /_clk$/) {
        clocks = clocks ", input wire " name
        ports = ports sprintf(",\n        .%s(%s)", name, name)
        next
    }
    if (/ input /) {
        ports = ports sprintf(",\n        .%s(in_q[%d +: %d])", name, inputs, width)
        inputs += width
    } else {
        ports = ports sprintf(",\n        .%s(core[%d +: %d])", name, outputs, width)
        outputs += width
    }
}
END {
    if (!inputs || !outputs) {
        print "placed: no ports of a top" > "/dev/stderr"
        exit 1
    }
    print "module placed (input wire clk" clocks ", input wire in, output wire out);"
    printf "    reg  [%d:0] in_q;\n", inputs - 1
    printf "    reg  [%d:0] out_q, fold_q;\n", outputs - 1
    printf "    wire [%d:0] core;\n", outputs - 1
    printf "    %s u_core (\n        .clk(clk)%s\n    );\n", top, ports
    print "    always @(posedge clk) begin"
    printf "        in_q   <= {in_q[%d:0], in};\n", inputs - 2
    print "        out_q  <= core;"
    printf "        fold_q <= {fold_q[%d:0], fold_q[%d]} ^ out_q;\n", outputs - 2, outputs - 1
    print "    end"
    printf "    assign out = fold_q[%d];\n", outputs - 1
    print "endmodule"
}
