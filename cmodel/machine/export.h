/* export.h - a machine as text that other programs read: $readmemh of Verilog, C compilers
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_EXPORT_H
#define SPH_EXPORT_H

#include "machine/machine.h"

/* Writes STEM.regs.hex, all registers by number, 32 bits a line, and STEM.mem.hex, memory, a line
 * of 256 bits each. Comments say how many, and the parameters of a core that draws the machine.
 * 0, or -1 with a message; then neither file is new. */
int sph_machine_write_hex(const struct sph_machine *m, const char *stem, struct sph_error *err);

/* Writes a C header with the constants NAME_LINES and NAME_REGISTERS and the arrays NAME_regs and
 * NAME_mem, words of 32 bits; NAME is that of the file without folder and ending, with _ for what
 * C does not allow in names. Path "-" is standard output, and NAME then `machine`. 0, or -1 with a
 * message. */
int sph_machine_write_c(const struct sph_machine *m, const char *path, struct sph_error *err);

#endif
