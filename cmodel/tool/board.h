/* board.h - what a machine needs on a board: the writes of its driver, and where things stand there
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TOOL_BOARD_H
#define SPH_TOOL_BOARD_H

#include "../../driver/sphaera.h"
#include "common/error.h"

/* Places in the memory of a board: the machine's lines from 0 on, behind them three frames. */
enum {
    BOARD_FRAMES = 0x1000000,
    BOARD_FRAME_BYTES = 0x100000, /* from a frame to the next */
    BOARD_ITEMS = 256             /* the most writes of a list, its end included */
};

/* A machine file as bytes, which were checked. */
struct board_machine {
    uint8_t *bytes;
    uint32_t count;
    int width, height;
};

/* Writes to registers, in order. */
struct board_script {
    struct board_item {
        uint32_t offset, value;
    } items[BOARD_ITEMS];
    int n; /* above BOARD_ITEMS: there was no room */
};

/* The machine file at path; its frame must be 640x480, or 320x240, which is shown doubled. 0, or
 * -1 with a message and nothing to free. */
int board_machine_read(const char *path, struct board_machine *m, struct sph_error *err);
void board_machine_free(struct board_machine *m);

/* The driver's steps on `s`, which is open: frames at these addresses, RGB565, and a display of
 * 640x480. A result of the driver. */
int board_show(struct sphaera *s, const struct board_machine *m, const uint32_t frames[3]);

/* All writes of the driver from its first to the frame's start, on a block that has what the
 * machine asks for; the machine's memory is at address 0 and so are the frames, each in a RAM of
 * its own. 0, or -1 with a message. */
int board_record(const struct board_machine *m, struct board_script *script, struct sph_error *err);

/* STEM.registers.hex and STEM.scene.hex for rt_ulx3s_ram, for $readmemh. 0, or -1 with a message.
 */
int board_write_rom(const struct board_machine *m, const char *stem, struct sph_error *err);

/* The machine over the serial port of a board, drawn and shown: rtl/board/rt_uart_bus.v is at the
 * other end. baud: bits a second. 0, or -1 with a message. */
int board_load(const struct board_machine *m, const char *device, unsigned baud,
               struct sph_error *err);

#endif
