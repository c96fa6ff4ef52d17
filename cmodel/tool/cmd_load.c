/* cmd_load.c - `sphaera load`: a machine file to a board
 * SPDX-License-Identifier: Apache-2.0
 */
#include "tool/board.h"
#include "tool/tool.h"

struct arguments {
    const char *input, *device, *rom;
    unsigned baud;
};

enum { KEY_ROM = 512, KEY_BAUD };

static const struct argp_option options[] = {
    {"rom", KEY_ROM, "STEM", 0,
     "STEM.registers.hex and STEM.scene.hex, of which `make board` makes a board that draws this "
     "machine alone",
     0},
    {"baud", KEY_BAUD, "N", 0, "bits a second of the serial port (1000000)", 0},
    {0},
};

static error_t parse(int key, char *arg, struct argp_state *state) {
    struct arguments *a = state->input;
    switch (key) {
    case KEY_ROM:
        a->rom = arg;
        return 0;
    case KEY_BAUD:
        a->baud = (unsigned)tool_number(state, "baud", arg, 9600, 4000000);
        return 0;
    case ARGP_KEY_ARG:
        if (a->input && a->device)
            argp_error(state, "one device and one file: '%s' is one too many", arg);
        a->device = a->input;
        a->input = arg;
        return 0;
    case ARGP_KEY_END:
        if (!a->input) argp_error(state, "no machine file given");
        if (!a->rom == !a->device)
            argp_error(state, "a serial device before the machine file, or --rom STEM, says "
                              "where to");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

int tool_load_board(int argc, char **argv) {
    static const struct argp argp = {
        options, parse, "[DEVICE] MACHINE.sph", "Takes a machine to a board.", NULL, NULL, NULL};
    struct arguments a = {.baud = 1000000};
    struct board_machine machine;
    struct sph_error err = {""};
    argp_parse(&argp, argc, argv, 0, NULL, &a);
    if (board_machine_read(a.input, &machine, &err)) return tool_failed(&err);
    int rc = a.rom ? board_write_rom(&machine, a.rom, &err)
                   : board_load(&machine, a.device, a.baud, &err);
    board_machine_free(&machine);
    return rc ? tool_failed(&err) : TOOL_GOOD;
}
