/* json.h - members of JSON reports; docs/reference/tool.md
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TOOL_JSON_H
#define SPH_TOOL_JSON_H

#include <jansson.h>
#include <stdint.h>

/* The head that every report starts with. */
json_t *report_new(const char *command);

/* Whether something of a report has found no memory since the first report_new(). */
int report_lost(void);

/* Each adds one member, or nothing if report is NULL; a value that is NULL becomes null. */
void report_add(json_t *report, const char *name, json_t *value);
void report_text(json_t *report, const char *name, const char *text);
void report_number(json_t *report, const char *name, double value);
void report_count(json_t *report, const char *name, uint64_t value);

/* Array of the names of the set bits. */
json_t *report_names(uint32_t bits, const char *const *names, int n);

#endif
