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
#include "common/output.h"
#include "machine/machine.h"

int board_machine_read(const char *path, struct board_machine *m, struct sph_error *err) {
    struct sph_machine machine;
    if (sph_machine_read(path, &machine, err)) return -1;
    *m = (struct board_machine){NULL, 0, machine.regs[SPH_REG_FRAME_W],
                                machine.regs[SPH_REG_FRAME_H]};
    size_t size = SPHAERA_HEADER_LEAST + 4 * (size_t)SPH_N_REGS +
                  (size_t)machine.lines * SPHAERA_LINE_BYTES + SPHAERA_CHECKSUM_BYTES;
    sph_machine_free(&machine);
    if (!(m->width == 640 && m->height == 480) && !(m->width == 320 && m->height == 240))
        return sph_fail(err,
                        "%.200s: the frame is %d x %d; a board shows 640x480, or 320x240 doubled",
                        path, m->width, m->height);
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

int board_show(struct sphaera *s, const struct board_machine *m, const uint32_t frames[3]) {
    static const struct {
        const char *name;
        struct sphaera_mode mode;
    } modes[] = {
#define MODE(name, khz, ...) {name, {__VA_ARGS__, 0}},
        SPHAERA_MODES(MODE)
#undef MODE
    };
    struct sphaera_mode mode = modes[0].mode; /* 640x480 */
    mode.doubled = m->width != mode.h_active;
    int rc = sphaera_store(s, frames, 2 * (uint32_t)m->width, 1);
    if (!rc) sphaera_video(s, &mode);
    return rc;
}

/* ---- a block that is not there: it has what is asked for, and does nothing ---- */

struct recorder {
    struct board_script *script;
    uint32_t profile;
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
    default:
        return 0;
    }
}

static void record(void *user, uint32_t offset, uint32_t value) {
    struct board_script *script = ((struct recorder *)user)->script;
    if (script->n < BOARD_ITEMS) script->items[script->n] = (struct board_item){offset, value};
    script->n++;
}

static void leave(void *user, uint32_t address, const uint8_t *bytes, uint32_t count) {
    (void)user, (void)address, (void)bytes, (void)count;
}

int board_record(const struct board_machine *m, struct board_script *script,
                 struct sph_error *err) {
    static const uint32_t frames[3] = {0, 0, 0};
    struct sphaera_file file;
    struct recorder recorder = {script, 0};
    struct sphaera_bus bus = {answer, record, leave, &recorder};
    struct sphaera s;
    script->n = 0;
    if (!sphaera_file_read(&file, m->bytes, m->count))
        return sph_fail(err, "%s", sphaera_text(SPHAERA_BAD_FILE));
    recorder.profile = sphaera_file_register(&file, SPHAERA_REG_PROFILE);
    int rc = sphaera_open(&s, &bus);
    if (!rc) rc = sphaera_load(&s, m->bytes, m->count, 0);
    if (!rc) rc = board_show(&s, m, frames);
    if (!rc) sphaera_interrupts(&s, SPHAERA_INTERRUPTS_ERROR | SPHAERA_INTERRUPTS_UNDERRUN);
    if (!rc) rc = sphaera_start(&s, 0);
    if (rc) return sph_fail(err, "%s", sphaera_text(rc));
    if (script->n >= BOARD_ITEMS)
        return sph_fail(err, "%d writes, and room for %d", script->n, BOARD_ITEMS - 1);
    return 0;
}

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
