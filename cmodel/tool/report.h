/* report.h - JSON reports of the commands; docs/reference/tool.md
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TOOL_REPORT_H
#define SPH_TOOL_REPORT_H

#include "core/frame.h"
#include "tool/json.h"
#include "tool/tool.h"

/* Each adds one member, or nothing if report is NULL. */
void report_machine(json_t *report, const struct sph_machine *machine);
void report_build(json_t *report, const struct tool_built *built);
void report_ledger(json_t *report, const struct sph_ledger *ledger);
void report_bih(json_t *report, const struct sph_machine *m, const struct sph_bih_stats *stats);
void report_shot(json_t *report, const struct sph_shot *shot);

/* Writes the report to path ("-": standard output), whole or not at all, and releases it.
 * 0 (also if path is NULL), or -1 with a message. */
int report_write(json_t *report, const char *path, struct sph_error *err);

#endif
