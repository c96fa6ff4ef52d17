/* cmd_load.c - `sphaera load`: a machine file to a board
 * SPDX-License-Identifier: Apache-2.0
 */
#include "tool/board.h"
#include "tool/tool.h"

struct arguments {
    const char *names[BOARD_MACHINES + 1], *rom; /* a device before the machine files */
    int n;
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
        if (a->n == BOARD_MACHINES + 1)
            argp_error(state, "a device and %d files: '%s' is one too many", BOARD_MACHINES, arg);
        a->names[a->n++] = arg;
        return 0;
    case ARGP_KEY_END:
        if (!a->n) argp_error(state, "no machine file given");
        if (a->rom && a->n > 1)
            argp_error(state, "--rom STEM is for one machine: '%s' is one too many", a->names[1]);
        if (!a->rom && a->n < 2)
            argp_error(state, "a serial device before the machine file, or --rom STEM, says "
                              "where to");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static int read_all(const struct arguments *a, int device, struct board_machine *machines, int *n,
                    struct sph_error *err) {
    for (int i = device; i < a->n; i++) {
        if (tool_wants_machine(a->names[i], err) ||
            board_machine_read(a->names[i], &machines[*n], err))
            return -1;
        if (board_machine_mode(a->names[i], &machines[(*n)++], err)) return -1;
    }
    return 0;
}

int tool_load_board(int argc, char **argv) {
    static const struct argp argp = {options,
                                     parse,
                                     "[DEVICE] MACHINE.sph...",
                                     "Takes machines to a board: the first one is shown, buttons "
                                     "choose the others.",
                                     NULL,
                                     NULL,
                                     NULL};
    struct arguments a = {.baud = 1000000};
    struct board_machine machines[BOARD_MACHINES];
    struct sph_error err = {""};
    int n = 0;
    tool_parse(&argp, argc, argv, 0, &a);
    int rc = read_all(&a, !a.rom, machines, &n, &err);
    if (!rc)
        rc = a.rom ? board_write_rom(machines, a.rom, &err)
                   : board_load(machines, n, a.names[0], a.baud, &err);
    while (n > 0)
        board_machine_free(&machines[--n]);
    return rc ? tool_failed(&err) : TOOL_GOOD;
}
