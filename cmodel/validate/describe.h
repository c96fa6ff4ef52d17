/* describe.h - a machine in words, for `sphaera info`
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_DESCRIBE_H
#define SPH_DESCRIBE_H

#include <stddef.h>
#include <stdio.h>

#include "common/ledger.h"
#include "machine/machine.h"

/* Prints profile, sizes, shape of the tree and all registers by name. The machine must be valid
 * (sph_machine_validate). */
void sph_machine_describe(const struct sph_machine *m, FILE *file);

/* Notes in a ledger what a machine file has, all of which is used: registers and memory, primitives
 * of each kind, lights. The machine must be valid. */
void sph_machine_note(const struct sph_machine *m, const char *path, struct sph_ledger *ledger);

/* The part of it on a tree of four children a node: nodes, levels, children and leaves. */
void sph_machine_describe_tree(const struct sph_machine *m, FILE *file);

/* What a core must be elaborated with to render the machine: names joined by '+' as
 * sim/cores.py takes them, such as "shadow+reflect2+lights1+rect"; "none" if nothing. */
void sph_machine_core(const struct sph_machine *m, char *text, size_t size);

#endif
