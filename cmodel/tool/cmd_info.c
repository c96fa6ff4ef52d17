/* cmd_info.c - `sphaera info`: what a machine file holds
 * SPDX-License-Identifier: Apache-2.0
 */
#include "machine/describe.h"
#include "tool/print.h"
#include "tool/report.h"

struct arguments {
    const char *input, *json;
    struct tool_outputs outputs;
};

enum { KEY_JSON = 512 };

static const struct argp_option options[] = {
    {"json", KEY_JSON, "FILE", 0, "report as JSON (- : on standard output instead of text)", 0},
    {0},
};

static error_t parse(int key, char *arg, struct argp_state *state) {
    struct arguments *a = state->input;
    switch (key) {
    case KEY_JSON:
        a->json = tool_output(&a->outputs, arg);
        return 0;
    case ARGP_KEY_ARG:
        if (a->input) argp_error(state, "one file at a time: '%s' is one too many", arg);
        a->input = arg;
        return 0;
    case ARGP_KEY_END:
        if (!a->input) argp_error(state, "no machine file given");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

int tool_info(int argc, char **argv) {
    static const struct argp argp = {
        options, parse, "MACHINE.sph", "Checks a machine file and describes it.", NULL, NULL, NULL};
    struct arguments a = {0};
    struct sph_machine machine;
    struct sph_error err = {""};
    argp_parse(&argp, argc, argv, 0, NULL, &a);

    if (tool_spares(&a.outputs, a.input, &err)) return tool_failed(&err);
    if (sph_machine_read(a.input, &machine, &err)) return tool_failed(&err);
    FILE *to = print_stream(a.json);
    if (to) sph_machine_describe(&machine, to);
    struct sph_bih_stats stats;
    if (sph_machine_bih(&machine))
        sph_bih_measure(&machine, &stats), print_bih(to, &machine, &stats);
    json_t *report = report_new("info");
    report_text(report, "input", a.input);
    report_machine(report, &machine);
    if (sph_machine_bih(&machine)) report_bih(report, &machine, &stats);
    int rc = report_write(report, a.json, &err);
    sph_machine_free(&machine);
    return rc ? tool_failed(&err) : TOOL_GOOD;
}
