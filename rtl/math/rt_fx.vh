// rt_fx.vh - the named rounding rules, and what products cost          model: cmodel/math/fx.h
// SPDX-License-Identifier: Apache-2.0
// No include guard: Icarus 11 crashes if it keeps macros with arguments from file to file.

// floor(x / 2^n + 1/2), round half up, of net x[msb:0]; signed, msb-n+1 bits: wide enough unless
// the rounding carries out of the top, which the user excludes. 1 <= n < msb.  model: sph_round()
`define RT_ROUND(x, msb, n) ($signed(x[msb:n]) + $signed({{((msb)-(n)){1'b0}}, x[(n)-1]}))

// rt_multiply: chunks of a signed operand of w bits, clocks from operands to product.
`define RT_MUL_CHUNKS(w) (((w) + 15) / 17)
`define RT_MUL_LATENCY(w) (`RT_MUL_CHUNKS(w) == 1 ? 1 : `RT_MUL_CHUNKS(w) + 1)

// rt_product: clocks from operands to product, the wider one of w bits.
`define RT_PRODUCT_LATENCY(w) (`RT_MUL_CHUNKS(w) == 2 ? 2 : 3)

// rt_leaf over four clocks: pieces of 17 bits of a difference, a radius, a direction.
`define RT_LEAF_PIECES(w, wd) ((w) <= 16 && (wd) <= 17 ? 1 : 2)
