/* firmware.c - what VexRiscv runs beside rt_top: the driver on its own address space
 * SPDX-License-Identifier: Apache-2.0
 *
 * A machine file stands in memory where a loader put it (LiteX's own, over the serial port); three
 * frames behind it. The picture is shown on the board's display.
 */
#include <generated/mem.h>

#include "../../driver/sphaera.h"
#include "../../driver/sphaera_file.h"
#include "../../driver/sphaera_modes.h"

enum { FILE_AT = 0x00400000, SCENE_AT = 0x00800000, FRAMES_AT = 0x01000000, APART = 0x00100000 };

static uint32_t get(void *user, uint32_t offset) {
    (void)user;
    return *(volatile uint32_t *)(SPHAERA_BASE + offset);
}

static void put(void *user, uint32_t offset, uint32_t value) {
    (void)user;
    *(volatile uint32_t *)(SPHAERA_BASE + offset) = value;
}

/* The block sees the SDRAM where the processor does; no cache of the system stands between. */
static void copy(void *user, uint32_t address, const uint8_t *bytes, uint32_t count) {
    (void)user;
    volatile uint8_t *to = (volatile uint8_t *)address;
    while (count--)
        *to++ = *bytes++;
}

int main(void) {
    static const struct sphaera_mode modes[] = {
#define MODE(name, khz, ...) {__VA_ARGS__, 0},
        SPHAERA_MODES(MODE)
#undef MODE
    };
    const struct sphaera_bus bus = {get, put, copy, 0};
    const uint8_t *file = (const uint8_t *)(MAIN_RAM_BASE + FILE_AT);
    const uint32_t lines = sphaera_file_word(file + SPHAERA_AT_LINES);
    const uint32_t bytes = sphaera_file_word(file + SPHAERA_AT_HEADER) +
                           lines * SPHAERA_LINE_BYTES + SPHAERA_CHECKSUM_BYTES;
    uint32_t frames[3];
    struct sphaera s;
    for (uint32_t i = 0; i < 3; i++)
        frames[i] = MAIN_RAM_BASE + FRAMES_AT + i * APART;
    int rc = sphaera_open(&s, &bus);
    if (!rc) rc = sphaera_load(&s, file, bytes, MAIN_RAM_BASE + SCENE_AT);
    if (!rc) rc = sphaera_store(&s, frames, 1280, 1);
    if (!rc) sphaera_video(&s, &modes[0]); /* 640x480 */
    if (!rc) rc = sphaera_start(&s, 0);
    if (!rc) rc = sphaera_wait(&s, 100000000);
    return rc;
}
