/* gates.h - a netlist of standard cells, compiled: what a harness asks of it
 * SPDX-License-Identifier: Apache-2.0
 *
 * lab/silicon/program.py writes tables and a kernel for each kind of cell; gates.c is compiled with
 * them to a library that has the functions below. One netlist, one clock, two states: no delays, so
 * nothing glitches.
 */
#ifndef TB_GATES_H
#define TB_GATES_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Flip-flops, read registers and memories without an initial value: noise of the seed, not 0. */
void gates_start(uint64_t seed);
/* Bits of a port; 0: there is none. */
size_t gates_bits(const char *port);
/* Up to 64 bits of an input, from bit lsb on. */
void gates_set(const char *port, uint64_t value, size_t lsb);
/* Up to 64 bits of a port, from bit lsb on; of one that there is not 0. */
uint64_t gates_get(const char *port, size_t lsb);
/* All that follows from inputs and state. */
void gates_settle(void);
/* A rising edge, of settled nets. */
void gates_edge(void);
/* Settled nets that differ from those of the call before, accesses of memories and clocks that get
 * through gates are added to the sums of a phase; -1: to none. */
enum { GATES_PHASES = 2 };
void gates_count(int phase);
/* The sums as text: `clocks A B`; then `A B` in a line for each net, port of a memory, gate of the
 * clock. */
void gates_write(FILE *f);

#ifdef __cplusplus
}
#endif
#endif
