/* firmware.c - what VexRiscv runs beside rt_top: the driver on its own address space
 * SPDX-License-Identifier: Apache-2.0
 *
 * A machine file stands in memory where a loader put it (LiteX's own, over the serial port); three
 * frames behind it. The picture is shown on the board's display. What came of it is told over the
 * serial port; where LiteX's simulator is the board, all pixels too, then more frames are drawn
 * while the display shows some, and the simulation ends.
 */
#include <generated/csr.h>
#include <generated/mem.h>
#include <irq.h>

#include "../../driver/sphaera.h"
#include "../../driver/sphaera_file.h"
#include "../../driver/sphaera_modes.h"

enum {
    FILE_AT = 0x00040000,
    SCENE_AT = 0x00800000,
    FRAMES_AT = 0x01000000,
    APART = 0x00100000,
    STRIDE = 1280,
    POLLS = 100000000
};

static uint32_t get(void *user, uint32_t offset) {
    (void)user;
    return *(volatile uint32_t *)(SPHAERA_BASE + offset);
}

static void put(void *user, uint32_t offset, uint32_t value) {
    (void)user;
    *(volatile uint32_t *)(SPHAERA_BASE + offset) = value;
}

/* The block sees the SDRAM where the processor does; no cache of the system stands between. */
static void copy(void *user, uint64_t address, const uint8_t *bytes, uint32_t count) {
    (void)user;
    volatile uint8_t *to = (volatile uint8_t *)(uintptr_t)address;
    while (count--)
        *to++ = *bytes++;
}

static void say(const char *text) {
    for (; *text; text++) {
        while (uart_txfull_read())
            ;
        uart_rxtx_write((uint32_t)(uint8_t)*text);
    }
}

/* A number of `digits` digits, base 16. */
static void say_hex(uint32_t value, int digits) {
    char text[9];
    text[digits] = 0;
    for (; digits--; value >>= 4)
        text[digits] = "0123456789abcdef"[value & 15];
    say(text);
}

/* No interrupt is taken (the processor waits by asking), so that the start-up code has nobody to
 * call; the line is seen as a pending one. */
void isr(void) {}

static int draw(struct sphaera *s, const uint8_t *file, const uint64_t frames[3]) {
    static const struct sphaera_mode modes[] = {
#define MODE(name, khz, ...) {__VA_ARGS__, 0},
        SPHAERA_MODES(MODE)
#undef MODE
    };
    const struct sphaera_bus bus = {get, put, copy, 0};
    const uint32_t lines = sphaera_file_word(file + SPHAERA_AT_LINES);
    const uint32_t bytes = sphaera_file_word(file + SPHAERA_AT_HEADER) +
                           lines * SPHAERA_LINE_BYTES + SPHAERA_CHECKSUM_BYTES;
    int rc = sphaera_open(s, &bus);
    if (!rc) rc = sphaera_load(s, file, bytes, MAIN_RAM_BASE + SCENE_AT);
    if (!rc) rc = sphaera_store(s, frames, STRIDE, 1);
    if (!rc) sphaera_video(s, &modes[0]); /* 640x480 */
    sphaera_interrupts(s, SPHAERA_INTERRUPTS_FRAME_DONE);
    sphaera_ev_enable_write(1);
    irq_setmask(1u << SPHAERA_INTERRUPT);
    if (!rc) rc = sphaera_start(s, 0);
    if (!rc) rc = sphaera_wait(s, POLLS);
    return rc;
}

static uint64_t count(struct sphaera *s, int number) {
    uint64_t counts[SPHAERA_COUNTS];
    sphaera_counters(s, counts);
    return counts[number];
}

static void say_count(struct sphaera *s, const char *name, int number) {
    say(name);
    say(": 0x");
    say_hex((uint32_t)count(s, number), 8);
    say("\n");
}

#ifdef CSR_SIM_FINISH_BASE
/* The newest frame, a row a line, each pixel as the four digits of its RGB565. */
static void say_pixels(const struct sphaera *s, const uint8_t *file, const uint64_t frames[3]) {
    const uint8_t *registers = file + SPHAERA_HEADER_LEAST;
    const uint32_t width = sphaera_file_word(registers + 4 * SPHAERA_REG_FRAME_W);
    const uint32_t height = sphaera_file_word(registers + 4 * SPHAERA_REG_FRAME_H);
    const uint32_t status = s->bus.read(s->bus.user, SPHAERA_STATUS);
    const uint32_t newest = (status & SPHAERA_STATUS_NEWEST) >> SPHAERA_STATUS_NEWEST_LSB;
    for (uint32_t y = 0; y < height; y++) {
        const volatile uint16_t *row =
            (const volatile uint16_t *)(uintptr_t)(frames[newest] + y * STRIDE);
        say("row ");
        for (uint32_t x = 0; x < width; x++)
            say_hex(row[x], 4);
        say("\n");
    }
}
#endif

int main(void) {
    const uint8_t *file = (const uint8_t *)(MAIN_RAM_BASE + FILE_AT);
    uint64_t frames[3];
    struct sphaera s;
    for (uint32_t i = 0; i < 3; i++)
        frames[i] = MAIN_RAM_BASE + FRAMES_AT + i * APART;
    int rc = draw(&s, file, frames);
    say("sphaera: ");
    say(sphaera_text(rc));
    say(irq_pending() & 1u << SPHAERA_INTERRUPT ? ", interrupt pending\n" : ", no interrupt\n");
    uint32_t errors = sphaera_errors(&s);
    for (const char *text; (text = sphaera_error_text(&errors));) {
        say("error: ");
        say(text);
        say("\n");
    }
    say_count(&s, "clocks", SPHAERA_COUNT_CYCLES);
#ifdef CSR_SIM_FINISH_BASE
    if (!rc) say_pixels(&s, file, frames);
    uint32_t drawn = 1; /* frames behind frames, until the display has shown three */
    while (!rc && count(&s, SPHAERA_COUNT_FRAMES_SHOWN) < 3) {
        rc = sphaera_start(&s, 0);
        if (!rc) rc = sphaera_wait(&s, POLLS);
        drawn++;
    }
    say(sphaera_text(rc));
    say(", frames drawn: 0x");
    say_hex(drawn, 8);
    say("\n");
    say_count(&s, "underruns", SPHAERA_COUNT_UNDERRUNS);
    sim_finish_finish_write(1);
#endif
    return rc;
}
