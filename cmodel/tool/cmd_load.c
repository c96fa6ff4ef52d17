/* cmd_load.c - `sphaera load`: a machine file to a board
 * SPDX-License-Identifier: Apache-2.0
 */
#include "tool/board.h"
#include "tool/tool.h"

struct arguments {
    const char *input, *rom;
};

enum { KEY_ROM = 512 };

static const struct argp_option options[] = {
    {"rom", KEY_ROM, "STEM", 0,
     "STEM.registers.hex and STEM.scene.hex, of which `make board` makes a board that draws this "
     "machine alone",
     0},
    {0},
};

static error_t parse(int key, char *arg, struct argp_state *state) {
    struct arguments *a = state->input;
    switch (key) {
    case KEY_ROM:
        a->rom = arg;
        return 0;
    case ARGP_KEY_ARG:
        if (a->input) argp_error(state, "one file at a time: '%s' is one too many", arg);
        a->input = arg;
        return 0;
    case ARGP_KEY_END:
        if (!a->input) argp_error(state, "no machine file given");
        if (!a->rom) argp_error(state, "--rom STEM says where to");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

int tool_load_board(int argc, char **argv) {
    static const struct argp argp = {options, parse, "MACHINE.sph", "Takes a machine to a board.",
                                     NULL,    NULL,  NULL};
    struct arguments a = {0};
    struct board_machine machine;
    struct sph_error err = {""};
    argp_parse(&argp, argc, argv, 0, NULL, &a);
    if (board_machine_read(a.input, &machine, &err)) return tool_failed(&err);
    int rc = board_write_rom(&machine, a.rom, &err);
    board_machine_free(&machine);
    return rc ? tool_failed(&err) : TOOL_GOOD;
}
