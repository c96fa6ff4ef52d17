/* report.h - JSON reports of the commands; docs/use/report_schema.md
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TOOL_REPORT_H
#define SPH_TOOL_REPORT_H

#include <jansson.h>

#include "core/frame_file.h"
#include "tool/tool.h"

/* The head that every report starts with. */
json_t *report_new(const char *command);

/* Each adds one member, or nothing if report is NULL. */
void report_text(json_t *report, const char *name, const char *text);
void report_number(json_t *report, const char *name, double value);
void report_count(json_t *report, const char *name, uint64_t value);
void report_machine(json_t *report, const struct sph_machine *machine);
void report_build(json_t *report, const struct tool_built *built);
void report_bih(json_t *report, const struct sph_machine *m, const struct sph_bih_stats *stats);
void report_shot(json_t *report, const struct sph_shot *shot);

/* Array of the names of the set bits. */
json_t *report_names(uint32_t bits, const char *const *names, int n);

/* Writes the report to path ("-": standard output), whole or not at all, and releases it.
 * 0 (also if path is NULL), or -1 with a message. */
int report_write(json_t *report, const char *path, struct sph_error *err);

#endif
