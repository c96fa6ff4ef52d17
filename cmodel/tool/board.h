/* board.h - what a machine needs on a board: the writes of its driver, and where things stand there
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TOOL_BOARD_H
#define SPH_TOOL_BOARD_H

#include "../../driver/sphaera.h"
#include "common/error.h"

/* Places in the memory of a board: machines one after another from 0 on, three frames, lists of
 * registers for the buttons (rtl/board/rt_pick.v says what is in them). */
enum {
    BOARD_FRAMES = 0x1000000,
    BOARD_FRAME_BYTES = 0x100000, /* from a frame to the next */
    BOARD_LISTS = 0x1400000,      /* RT_BOARD_LISTS */
    BOARD_MAGIC = 0x53704c73,     /* RT_BOARD_MAGIC */
    BOARD_ITEMS = 256,            /* the most writes of a list, its end included */
    BOARD_MACHINES = 64           /* the most of a load */
};

/* A machine file as bytes, which were checked, and the display it is for. */
struct board_machine {
    uint8_t *bytes;
    uint32_t count;
    int width, height;
    struct sphaera_mode mode;
};

/* Writes to registers, in order. */
struct board_script {
    struct board_item {
        uint32_t offset, value;
    } items[BOARD_ITEMS];
    int n; /* above BOARD_ITEMS: there was no room */
};

/* The machine file at path, of any frame and without a mode. 0, or -1 with a message and nothing to
 * free. */
int board_machine_read(const char *path, struct board_machine *m, struct sph_error *err);
void board_machine_free(struct board_machine *m);

/* Its display is 640x480: the frame must be so, or 320x240, which is shown doubled. 0, or -1 with a
 * message. */
int board_machine_mode(const char *path, struct board_machine *m, struct sph_error *err);

/* All writes of the driver from its first to the frame's start, on a block that has what the
 * machine asks for; the machine's memory is at address 0 and so are the frames, each in a RAM of
 * its own. 0, or -1 with a message. */
int board_record(const struct board_machine *m, struct board_script *script, struct sph_error *err);

/* STEM.registers.hex and STEM.scene.hex for rt_ulx3s_ram, for $readmemh. 0, or -1 with a message.
 */
int board_write_rom(const struct board_machine *m, const char *stem, struct sph_error *err);

/* 1 .. BOARD_MACHINES machines of one size over the bus of a board with SDRAM: into its memory with
 * a list for each, the first one drawn, waited for and shown. *rc is what the driver said last. 0,
 * or -1 with a message if machines do not fit together; the caller looks at its bus and at *rc. */
int board_take(struct sphaera *s, const struct sphaera_bus *bus, const struct board_machine *m,
               int n, uint32_t polls, int *rc, struct sph_error *err);

/* board_take over the serial port of a board: rtl/board/rt_uart_bus.v is at the other end. baud:
 * bits a second. 0, or -1 with a message. */
int board_load(const struct board_machine *m, int n, const char *device, unsigned baud,
               struct sph_error *err);

#endif
