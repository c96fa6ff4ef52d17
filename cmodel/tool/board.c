/* board.c - see board.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "tool/board.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../driver/sphaera_file.h"
#include "../../driver/sphaera_modes.h"
#include "common/file.h"
#include "machine/machine.h"
#include "validate/validate.h"

int board_machine_read(const char *path, struct board_machine *m, struct sph_error *err) {
    struct sph_machine machine;
    if (sph_machine_read(path, &machine, err)) return -1;
    *m = (struct board_machine){.width = machine.regs[SPH_REG_FRAME_W],
                                .height = machine.regs[SPH_REG_FRAME_H]};
    size_t size = SPHAERA_HEADER_LEAST + 4 * (size_t)SPH_N_REGS +
                  (size_t)machine.lines * SPHAERA_LINE_BYTES + SPHAERA_CHECKSUM_BYTES;
    sph_machine_free(&machine);
    FILE *file = fopen(path, "rb");
    m->bytes = malloc(size);
    m->count = (uint32_t)size;
    int whole = file && m->bytes && fread(m->bytes, 1, size, file) == size;
    if (file) fclose(file);
    if (whole) return 0;
    board_machine_free(m);
    return sph_fail(err, "%.200s: cannot be read twice", path);
}

void board_machine_free(struct board_machine *m) {
    free(m->bytes);
    m->bytes = NULL;
}

int board_machine_mode(const char *path, struct board_machine *m, struct sph_error *err) {
    static const struct {
        const char *name;
        struct sphaera_mode mode;
    } modes[] = {
#define MODE(name, khz, ...) {name, {__VA_ARGS__, 0}},
        SPHAERA_MODES(MODE)
#undef MODE
    };
    m->mode = modes[0].mode; /* 640x480 */
    m->mode.doubled = m->width != m->mode.h_active;
    if ((m->width == 640 && m->height == 480) || (m->width == 320 && m->height == 240)) return 0;
    return sph_fail(err, "%.200s: the frame is %d x %d; a board shows 640x480, or 320x240 doubled",
                    path, m->width, m->height);
}

/* The driver's steps on `s`, which is open: frames at these addresses, RGB565, and the display. */
static int show(struct sphaera *s, const struct board_machine *m, const uint64_t frames[3]) {
    int rc = sphaera_store(s, frames, 2 * (uint32_t)m->width, 1);
    if (rc) return rc;
    sphaera_video(s, &m->mode);
    sphaera_interrupts(s, SPHAERA_INTERRUPTS_ERROR | SPHAERA_INTERRUPTS_UNDERRUN);
    return SPHAERA_OK;
}

static void put_word(uint8_t *to, uint32_t value) {
    for (int i = 0; i < 4; i++)
        to[i] = (uint8_t)(value >> 8 * i);
}

/* ---- a block that is not there: it has what is asked for, and does nothing ---- */

struct recorder {
    struct board_script *script;
    uint32_t profile, parts;
};

static uint32_t answer(void *user, uint32_t offset) {
    const struct recorder *r = user;
    switch (offset) {
    case SPHAERA_ID:
        return SPHAERA_ID_RESET;
    case SPHAERA_VERSION:
        return SPHAERA_VERSION_RESET;
    case SPHAERA_CORE_PROFILE:
        return r->profile;
    case SPHAERA_CORE_EFFECTS:
        return UINT32_MAX;
    case SPHAERA_CORE_PARTS:
        return r->parts;
    case SPHAERA_CORE_BUS:
        return (uint32_t)32 << SPHAERA_CORE_BUS_ADDR_LSB;
    default:
        return 0;
    }
}

static void record(void *user, uint32_t offset, uint32_t value) {
    struct board_script *script = ((struct recorder *)user)->script;
    if (script->n < BOARD_ITEMS) script->items[script->n] = (struct board_item){offset, value};
    script->n++;
}

static void ignore_write(void *user, uint64_t address, const uint8_t *bytes, uint32_t count) {
    (void)user, (void)address, (void)bytes, (void)count;
}

/* A driver whose writes go to the script, open on a block that has what the machine asks for. */
static int record_open(const struct board_machine *m, struct board_script *script,
                       struct recorder *recorder, struct sphaera *s, struct sph_error *err) {
    struct sphaera_file file;
    *recorder = (struct recorder){.script = script};
    const struct sphaera_bus bus = {answer, record, ignore_write, recorder};
    script->n = 0;
    if (!sphaera_file_read(&file, m->bytes, m->count))
        return sph_fail(err, "%s", sphaera_text(SPHAERA_BAD_FILE));
    recorder->profile = sphaera_file_register(&file, SPHAERA_REG_PROFILE);
    recorder->parts = sphaera_file_asks(&file);
    int rc = sphaera_open(s, &bus);
    return rc ? sph_fail(err, "%s", sphaera_text(rc)) : 0;
}

static int recorded(int rc, const struct board_script *script, struct sph_error *err) {
    if (rc) return sph_fail(err, "%s", sphaera_text(rc));
    if (script->n >= BOARD_ITEMS)
        return sph_fail(err, "%d writes, and room for %d", script->n, BOARD_ITEMS - 1);
    return 0;
}

int board_record(const struct board_machine *m, struct board_script *script,
                 struct sph_error *err) {
    static const uint64_t frames[3] = {0, 0, 0};
    struct recorder recorder;
    struct sphaera s;
    if (record_open(m, script, &recorder, &s, err)) return -1;
    int rc = sphaera_load(&s, m->bytes, m->count, 0);
    if (!rc) rc = show(&s, m, frames);
    if (!rc) rc = sphaera_start(&s, 0);
    return recorded(rc, script, err);
}

/* ---- machines and their lists into the memory of a board ---- */

/* The list of a machine at `base`: its registers and the start, into memory as number k. */
static int put_list(const struct sphaera_bus *bus, const struct board_machine *m, uint32_t base,
                    int k, struct sph_error *err) {
    struct board_script script;
    struct recorder recorder;
    struct sphaera s;
    uint8_t bytes[8 * BOARD_ITEMS];
    if (record_open(m, &script, &recorder, &s, err)) return -1;
    script.n = 0; /* what opens the block is not of the list */
    int rc = sphaera_load(&s, m->bytes, m->count, base);
    if (!rc) rc = sphaera_start(&s, 0);
    if (recorded(rc, &script, err)) return -1;
    script.items[script.n++] = (struct board_item){0xfff, 0};
    for (int i = 0; i < script.n; i++) {
        put_word(bytes + 8 * i, script.items[i].value);
        put_word(bytes + 8 * i + 4, script.items[i].offset);
    }
    bus->put(bus->user, BOARD_LISTS + 8 * BOARD_ITEMS * (uint32_t)(k + 1), bytes,
             8 * (uint32_t)script.n);
    return 0;
}

static void put_header(const struct sphaera_bus *bus, int n) {
    uint8_t bytes[8];
    put_word(bytes, (uint32_t)n);
    put_word(bytes + 4, BOARD_MAGIC);
    bus->put(bus->user, BOARD_LISTS, bytes, sizeof bytes);
}

/* Where each machine's memory begins: one behind another, on pages. */
static int places(const struct board_machine *m, int n, uint32_t *bases, struct sph_error *err) {
    struct sphaera_file file;
    uint64_t at = 0;
    for (int k = 0; k < n; k++) {
        if (m[k].width != m->width || m[k].height != m->height)
            return sph_fail(err, "a frame of %d x %d beside one of %d x %d", m[k].width,
                            m[k].height, m->width, m->height);
        if (!sphaera_file_read(&file, m[k].bytes, m[k].count))
            return sph_fail(err, "%s", sphaera_text(SPHAERA_BAD_FILE));
        bases[k] = (uint32_t)at;
        at += (file.memory_bytes + 4095) & ~(uint64_t)4095;
        if (at > BOARD_FRAMES)
            return sph_fail(err, "%d machines want more than %d bytes", n, BOARD_FRAMES);
    }
    return 0;
}

int board_take(struct sphaera *s, const struct sphaera_bus *bus, const struct board_machine *m,
               int n, uint32_t polls, int *rc, struct sph_error *err) {
    uint32_t bases[BOARD_MACHINES];
    uint64_t frames[3];
    for (uint32_t i = 0; i < 3; i++)
        frames[i] = BOARD_FRAMES + i * BOARD_FRAME_BYTES;
    if (places(m, n, bases, err)) return -1;
    *rc = sphaera_open(s, bus);
    if (!*rc) put_header(bus, 0);              /* buttons do nothing meanwhile */
    for (int k = n - 1; k >= 0 && !*rc; k--) { /* registers stay those of the first */
        *rc = sphaera_load(s, m[k].bytes, m[k].count, bases[k]);
        if (!*rc && put_list(bus, &m[k], bases[k], k, err)) return -1;
    }
    if (!*rc) *rc = show(s, m, frames);
    if (!*rc) *rc = sphaera_start(s, 0);
    if (!*rc) *rc = sphaera_wait(s, polls);
    if (!*rc) put_header(bus, n);
    return 0;
}

/* ---- files for a board without SDRAM ---- */

static int put_file(const char *stem, const char *name, const struct board_script *script,
                    const struct sphaera_file *file, struct sph_error *err) {
    char path[sizeof((struct sph_output){0}.path)];
    struct sph_output out;
    if ((size_t)snprintf(path, sizeof path, "%s.%s.hex", stem, name) >= sizeof path)
        return sph_fail(err, "%.200s...: name is too long", stem);
    if (sph_output_open(&out, path, err)) return -1;
    for (int i = 0; script && i < script->n; i++)
        fprintf(out.file, "%03" PRIx32 "%08" PRIx32 "\n", script->items[i].offset,
                script->items[i].value);
    if (script) fprintf(out.file, "fff00000000\n");
    for (uint32_t at = 0; file && at < file->memory_bytes; at += 8)
        fprintf(out.file, "%08" PRIx32 "%08" PRIx32 "\n", sphaera_file_word(file->memory + at + 4),
                sphaera_file_word(file->memory + at));
    return sph_output_close(&out, 0, err);
}

int board_write_rom(const struct board_machine *m, const char *stem, struct sph_error *err) {
    struct board_script script;
    struct sphaera_file file;
    if (board_record(m, &script, err) || !sphaera_file_read(&file, m->bytes, m->count)) return -1;
    if (put_file(stem, "registers", &script, NULL, err)) return -1;
    return put_file(stem, "scene", NULL, &file, err);
}
