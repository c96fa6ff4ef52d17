/* options_effects.c - options of build: an effect each, from the list of machine.def
 * SPDX-License-Identifier: Apache-2.0
 */
#include <string.h>

#include "tool/tool.h"

enum { KEY_EFFECT = 512 }; /* and its number */

/* The option of an effect by its kind, SPH_OPTION_*. */
#define LINE_SPH_OPTION_WHEN(name, word, about)                                                    \
    {#word,                                                                                        \
     KEY_EFFECT + SPH_REPORT_##name,                                                               \
     "WHEN",                                                                                       \
     0,                                                                                            \
     about ": auto (default: as the scene calls for), on or off",                                  \
     1},
#define LINE_SPH_OPTION_COUNT(name, word, about)                                                   \
    {#word,                                                                                        \
     KEY_EFFECT + SPH_REPORT_##name,                                                               \
     "N",                                                                                          \
     0,                                                                                            \
     about ": auto (default: those that reach something), or the first N",                         \
     1},
#define LINE_SPH_OPTION_OFF(name, word, about)                                                     \
    {#word,                                                                                        \
     KEY_EFFECT + SPH_REPORT_##name,                                                               \
     "WHEN",                                                                                       \
     0,                                                                                            \
     about ": auto (default: as the scene calls for) or off",                                      \
     1},
#define LINE_SPH_OPTION_NONE(name, word, about)
#define LINE(name, word, core, bit, most, all, option, needs, excludes, when, low, high, count,    \
             about)                                                                                \
    LINE_##option(name, word, about)
static const struct argp_option options[] = {SPH_EACH_EFFECT(LINE){0}};

static error_t parse(int key, char *arg, struct argp_state *state) {
    static const char *const whens[] = {"auto", "off", "on", NULL};
    static const char *const offs[] = {"auto", "off", NULL};
    struct tool_source *s = state->input;
    int effect = key - KEY_EFFECT;
    char option[32];
    if (effect < 0 || effect >= SPH_REPORTS) return ARGP_ERR_UNKNOWN;
    const struct sph_part *part = &sph_parts[effect];
    snprintf(option, sizeof option, "--%s", part->word);
    const char *const *choices = part->option == SPH_OPTION_OFF ? offs : whens;
    if (part->option != SPH_OPTION_COUNT)
        s->build.asked[effect] = SPH_AUTO + tool_choice(state, option, arg, choices);
    else if (!strcmp(arg, "auto"))
        s->build.asked[effect] = SPH_AUTO;
    else
        s->build.asked[effect] =
            (int)tool_number(state, option, arg, 0, (unsigned long long)part->most);
    s->option = part->word;
    return 0;
}

const struct argp tool_effects_argp = {options, parse, NULL, NULL, NULL, NULL, NULL};
