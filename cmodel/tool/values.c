/* values.c - values of options, and what a command says when it fails; see tool.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/number.h"
#include "tool/guard.h"
#include "tool/tool.h"

int tool_failed(const struct sph_error *err) {
    fprintf(stderr, "sphaera: %s\n", err->text[0] ? err->text : "failed");
    if (strstr(err->text, "memory")) guard_say_memory();
    return TOOL_FAILED;
}

int tool_choice(const struct argp_state *state, const char *option, const char *arg,
                const char *const *choices) {
    char list[256] = "";
    for (int i = 0; choices[i]; i++) {
        if (!strcmp(arg, choices[i])) return i;
        size_t used = strlen(list);
        snprintf(list + used, sizeof list - used, "%s%s", i ? ", " : "", choices[i]);
    }
    argp_error(state, "%s: '%s' is none of %s", option, arg, list);
    return -1;
}

unsigned long long tool_number(const struct argp_state *state, const char *option, const char *arg,
                               unsigned long long min, unsigned long long max) {
    uint64_t value = 0;
    if (sph_parse_count(arg, min, max, &value))
        argp_error(state, "%s: '%s' is no number from %llu to %llu", option, arg, min, max);
    return value;
}

double tool_real(const struct argp_state *state, const char *option, const char *arg, double min,
                 double max) {
    double value = 0;
    if (sph_parse_number(arg, &value) || !(value >= min && value <= max))
        argp_error(state, "%s: '%s' is no number from %g to %g", option, arg, min, max);
    return value;
}

void tool_reals(const struct argp_state *state, const char *option, const char *arg, double limit,
                int least, int most, double *values) {
    int n = 0, bad = 0;
    for (const char *at = arg; n < most && !bad; n++) {
        char number[64] = "";
        size_t length = strcspn(at, ",");
        if (length < sizeof number) memcpy(number, at, length);
        bad = sph_parse_number(number, &values[n]) || !(fabs(values[n]) <= limit);
        at += length;
        if (!*at) {
            bad |= n + 1 < least;
            for (int i = n + 1; i < most; i++)
                values[i] = 0;
            if (!bad) return;
        }
        at++;
    }
    argp_error(state, "%s: '%s' is not %d%s numbers from %g to %g with commas between", option, arg,
               least, least < most ? " or more" : "", -limit, limit);
}

void tool_size(const struct argp_state *state, const char *option, const char *arg, int *width,
               int *height) {
    const char *at = arg;
    uint64_t w = 0, h = 0;
    if (sph_take_count(&at, 1, SPH_MAX_SIDE, &w) || sph_take_char(&at, 'x') ||
        sph_parse_count(at, 1, SPH_MAX_SIDE, &h))
        argp_error(state, "%s: '%s' is no size such as 640x480, up to %dx%d", option, arg,
                   SPH_MAX_SIDE, SPH_MAX_SIDE);
    *width = (int)w;
    *height = (int)h;
}

error_t tool_one_scene(const struct argp_state *state, int key, char *arg, const char **input,
                       const char *missing) {
    if (key == ARGP_KEY_ARG) {
        if (*input) argp_error(state, "one scene at a time: '%s' is one too many", arg);
        *input = arg;
        return 0;
    }
    if (key != ARGP_KEY_END) return ARGP_ERR_UNKNOWN;
    if (!*input) argp_error(state, "%s", missing);
    return 0;
}

enum { KEY_JSON = 512 };

const struct argp_option tool_report_options[] = {
    {"json", KEY_JSON, "FILE", 0, "report as JSON (- : on standard output instead of text)", 0},
    {0},
};

error_t tool_report_key(int key, char *arg, struct argp_state *state, const char *missing) {
    struct tool_report_arguments *a = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &a->source;
        return 0;
    case KEY_JSON:
        a->json = tool_output(&a->source.outputs, key, arg);
        return 0;
    default:
        return tool_one_scene(state, key, arg, &a->input, missing);
    }
}

/* What glibc's argp takes without a word in its help: --HANG waits for an hour, --program-name
 * changes what messages begin with. Who is asked first has them. */
static const struct argp_option unsaid[] = {
    {"HANG", 256, "", OPTION_HIDDEN | OPTION_ARG_OPTIONAL, NULL, 0},
    {"program-name", 256, "", OPTION_HIDDEN | OPTION_ARG_OPTIONAL, NULL, 0},
    {0},
};

static error_t refuse(int key, char *arg, struct argp_state *state) {
    (void)arg;
    if (key != 256) return ARGP_ERR_UNKNOWN;
    argp_error(state, "unrecognized option '%s'", state->argv[state->next - 1]);
    return EINVAL;
}

void tool_parse(const struct argp *argp, int argc, char **argv, unsigned flags, void *input) {
    static const struct argp refused = {unsaid, refuse, NULL, NULL, NULL, NULL, NULL};
    struct argp_child children[8] = {{0}};
    struct argp whole = *argp;
    int n = 0;
    for (const struct argp_child *child = argp->children; child && child->argp; child++)
        children[n++] = *child;
    children[n].argp = &refused;
    whole.children = children;
    error_t wrong = argp_parse(&whole, argc, argv, flags, NULL, input);
    if (!wrong) return;
    fprintf(stderr, "%s: %s\n", argv[0], strerror(wrong));
    exit(TOOL_FAILED);
}
