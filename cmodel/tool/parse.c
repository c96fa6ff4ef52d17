/* parse.c - options of a command; see tool.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <errno.h>

#include "tool/tool.h"

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
    argp_parse(&whole, argc, argv, flags, NULL, input);
}
