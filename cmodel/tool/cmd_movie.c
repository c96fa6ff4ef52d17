/* cmd_movie.c - `sphaera movie`: pictures of frames, such as those of a simulation, in one file
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdlib.h>

#include "tool/pictures.h"
#include "tool/tool.h"

struct arguments {
    struct tool_outputs outputs;
    const char *output;
    const char **pictures;
    int n;
    double rate;
};

static const struct argp_option options[] = {
    {"output", 'o', "FILE", 0, "to write: .gif, or .mp4, which needs ffmpeg", 0},
    {"rate", 'r', "F", 0, "frames a second (25)", 0},
    {0},
};

static error_t parse(int key, char *arg, struct argp_state *state) {
    struct arguments *a = state->input;
    switch (key) {
    case 'o':
        if (!movie_is(arg)) argp_error(state, "--output: '%s' is neither .mp4 nor .gif", arg);
        a->output = tool_output(&a->outputs, key, arg);
        return 0;
    case 'r':
        a->rate = tool_real(state, "--rate", arg, 0.1, 240);
        return 0;
    case ARGP_KEY_ARG:
        a->pictures[a->n++] = arg;
        return 0;
    case ARGP_KEY_END:
        if (!a->n) argp_error(state, "no pictures given");
        if (!a->output) argp_error(state, "no output given (-o)");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

int tool_movie(int argc, char **argv) {
    static const struct argp argp = {options,
                                     parse,
                                     "PICTURE...",
                                     "Puts pictures of one size into one file that moves, in the "
                                     "order in which they are given.",
                                     NULL,
                                     NULL,
                                     NULL};
    struct arguments a = {.rate = MOVIE_RATE, .pictures = calloc((size_t)argc + 1, sizeof(char *))};
    struct sph_error err = {""};
    int rc = a.pictures ? 0 : sph_fail(&err, "no memory for %d names", argc);
    if (!rc) tool_parse(&argp, argc, argv, 0, &a);
    for (int i = 0; i < a.n && !rc; i++)
        rc = tool_spares(&a.outputs, a.pictures[i], &err);
    if (!rc) rc = movie_write(a.output, a.pictures, a.n, a.rate, &err);
    free(a.pictures);
    return rc ? tool_failed(&err) : TOOL_GOOD;
}
