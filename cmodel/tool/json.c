/* json.c - see json.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "tool/json.h"

#include <argp.h>
#include <math.h>
#include <stdlib.h>

/* What finds no memory leaves a value or a member out, which no caller looks at. */
static int lost;

static void *take(size_t bytes) {
    void *memory = malloc(bytes);
    if (!memory) lost = 1;
    return memory;
}

int report_lost(void) {
    return lost;
}

json_t *report_new(const char *command) {
    json_set_alloc_funcs(take, free);
    return json_pack("{s:s, s:i, s:s, s:s}", "schema", "sphaera-report", "version", 2, "program",
                     argp_program_version, "command", command);
}

void report_add(json_t *report, const char *name, json_t *value) {
    if (report)
        json_object_set_new(report, name, value ? value : json_null());
    else
        json_decref(value);
}

void report_text(json_t *report, const char *name, const char *text) {
    report_add(report, name, json_string(text)); /* null if it is not UTF-8 */
}

void report_number(json_t *report, const char *name, double value) {
    report_add(report, name, isfinite(value) ? json_real(value) : NULL);
}

void report_count(json_t *report, const char *name, uint64_t value) {
    report_add(report, name, json_integer((json_int_t)value));
}

json_t *report_names(uint32_t bits, const char *const *names, int n) {
    json_t *list = json_array();
    for (int i = 0; i < n; i++)
        if (bits >> i & 1) json_array_append_new(list, json_string(names[i]));
    return list;
}
