/* main.c - the sphaera command-line tool: finds the command and runs it
 * SPDX-License-Identifier: Apache-2.0
 */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sphaera/sphaera.h"
#include "tool/guard.h"
#include "tool/tool.h"

static const struct {
    const char *name;
    int (*run)(int argc, char **argv);
} commands[] = {
    {"build", tool_build},           {"render", tool_render}, {"info", tool_info},
    {"compare", tool_compare},       {"gen", tool_gen},       {"import", tool_import},
    {"background", tool_background}, {"texels", tool_texels}, {"accuracy", tool_accuracy},
    {"reference", tool_reference},   {"export", tool_export}, {"operations", tool_operations},
    {"load", tool_load_board},       {"view", tool_view},     {"movie", tool_movie},
    {"trees", tool_trees},           {"price", tool_price},   {"floats", tool_floats},
    {"sweep", tool_sweep},
};
enum { N_COMMANDS = sizeof commands / sizeof *commands };

static const char doc[] =
    "Scenes of spheres, triangles and planes into the memory image of a hardware ray tracer, and "
    "through its bit-accurate model.\v"
    "Commands:\n"
    "  build    scene file (.nff) to machine file (.sph)\n"
    "  render   machine or scene through the golden model: picture, counters, hash\n"
    "  info     what a machine file holds\n"
    "  compare  two pictures or two frame files, exactly\n"
    "  gen      scenes made by formula\n"
    "  import   molecules (PDB) and animated scenes (AFF) as scenes\n"
    "  background   the ways of background separation, compared on a scene\n"
    "  texels   orders of texels in memory, compared by the hits of caches\n"
    "  accuracy     a scene through model and double reference: what the arithmetic costs\n"
    "  price    what accuracy costs in time: profiles of a scene beside each other\n"
    "  reference    the double reference alone: picture, frame file\n"
    "  export   scene file for POV-Ray\n"
    "  operations   arithmetic of the test of ray and sphere, as four texts have it\n"
    "  floats   the tests of a scene's rays in float32 and float64: what these get wrong\n"
    "  trees    kinds of trees, compared by what the rays of a scene do in them\n"
    "  sweep    every value of some axes with every other: model, RTL, synthesis; tables, plots\n"
    "  load     a machine file to a board\n"
    "  view     the golden model's picture in a window, in which one moves\n"
    "  movie    pictures of frames into one file that moves\n\n"
    "`sphaera COMMAND --help` explains a command. Exit code: 0 good, 1 failed or different, "
    "2 wrong usage.";

struct choice {
    int command, at; /* index of commands; of argv */
};

static error_t parse(int key, char *arg, struct argp_state *state) {
    struct choice *choice = state->input;
    switch (key) {
    case ARGP_KEY_ARG:
        for (int i = 0; i < N_COMMANDS; i++)
            if (!strcmp(arg, commands[i].name)) {
                *choice = (struct choice){i, state->next - 1};
                state->next = state->argc; /* the rest belongs to the command */
                return 0;
            }
        argp_error(state, "no command '%s'", arg);
        return EINVAL;
    case ARGP_KEY_NO_ARGS:
        argp_error(state, "no command given");
        return EINVAL;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

/* glibc's argp takes an option of byte 0xff, which no text has, for --help. */
static void check_bytes(int argc, char **argv) {
    for (int i = 1; i < argc; i++)
        if (argv[i][0] == '-' && strchr(argv[i], 0xff)) {
            fprintf(stderr, "sphaera: word %d begins with - and has byte 0xff\n", i);
            exit(TOOL_USAGE);
        }
}

int main(int argc, char **argv) {
    static const struct argp argp = {NULL, parse, "COMMAND [OPTION...]", doc, NULL, NULL, NULL};
    static char self[] = "sphaera", name[64];
    struct choice choice = {-1, 0};
    char version[64];
    snprintf(version, sizeof version, "sphaera %s", sphaera_version());
    argp_program_version = version;
    argp_err_exit_status = TOOL_USAGE;
    check_bytes(argc, argv);
    if (argc > 1 && !strcmp(argv[1], "sweep")) return tool_sweep(argc - 1, argv + 1);
    if (guard_start()) return TOOL_USAGE;
    if (argc > 0) argv[0] = self;
    tool_parse(&argp, argc, argv, ARGP_IN_ORDER, &choice);

    snprintf(name, sizeof name, "sphaera %s", commands[choice.command].name);
    argv[choice.at] = name;
    int code = commands[choice.command].run(argc - choice.at, argv + choice.at);
    errno = 0;
    if (fflush(stdout) || ferror(stdout)) {
        fprintf(stderr, "sphaera: standard output: %s\n", errno ? strerror(errno) : "write error");
        code = TOOL_FAILED;
    }
    return code;
}
