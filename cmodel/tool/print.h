/* print.h - what commands print for people to read
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TOOL_PRINT_H
#define SPH_TOOL_PRINT_H

#include <stdio.h>

#include "core/frame.h"
#include "tool/tool.h"

/* Where a command prints: standard output, or nowhere if the JSON report goes there. May be NULL
 * for the functions below. */
FILE *print_stream(const char *json_path);

/* What build found out; warnings go to stderr. */
void print_build(FILE *to, const struct tool_built *built);

/* What was not used as it stands, a line for each kind: to stderr. */
void print_ledger(const struct sph_ledger *ledger);

/* What build left out, as no ray of the frame, or of any, meets it: effects and primitives. */
void print_left_out(FILE *to, const struct sph_build_report *report);

/* What a hierarchy is like: nodes, leaves, depth, bytes. */
void print_bih(FILE *to, const struct sph_machine *m, const struct sph_bih_stats *stats);

/* Errors by name, `picture HASH` and `frame HASH`; before them the counters if asked for. */
void print_shot(FILE *to, const struct sph_shot *shot, int counters);

#endif
