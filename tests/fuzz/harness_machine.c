/* harness_machine.c - machine files; the checksum at their end is made right first
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"
#include "machine/bih_stats.h"
#include "machine/format.h"
#include "validate/describe.h"
#include "validate/validate.h"

/* Pixels of a frame that is drawn. */
enum { PIXELS = 4096, WINDOW = 6 };

static FILE *nowhere;

void fuzz_begin(const char *root) {
    (void)root;
    nowhere = fopen("/dev/null", "w");
    if (!nowhere) exit(2);
}

/* What `sphaera info` says of it. */
static void describe(const struct sph_machine *m) {
    struct sph_bih_stats stats;
    sph_machine_describe(m, nowhere);
    if (sph_machine_bih(m)) sph_bih_measure(m, &stats);
}

/* A part of the window that is drawn in a moment. */
static int narrow(struct sph_machine *m) {
    int32_t *r = m->regs;
    if ((int64_t)r[SPH_REG_FRAME_W] * r[SPH_REG_FRAME_H] > PIXELS) return 0;
    if (r[SPH_REG_WIN_X1] > r[SPH_REG_WIN_X0] + WINDOW)
        r[SPH_REG_WIN_X1] = r[SPH_REG_WIN_X0] + WINDOW;
    if (r[SPH_REG_WIN_Y1] > r[SPH_REG_WIN_Y0] + WINDOW)
        r[SPH_REG_WIN_Y1] = r[SPH_REG_WIN_Y0] + WINDOW;
    return 1;
}

void fuzz_one(const uint8_t *data, size_t size) {
    struct sph_machine m;
    struct sph_error err = {""};
    uint8_t *bytes = malloc(size + 1);
    if (!bytes) exit(2);
    memcpy(bytes, data, size);
    if (size > SPH_CHECKSUM_BYTES)
        sph_put64(bytes + size - SPH_CHECKSUM_BYTES,
                  sph_fnv_bytes(SPH_FNV_START, bytes, size - SPH_CHECKSUM_BYTES));
    fuzz_write("in.sph", bytes, size);
    if (sph_machine_read("in.sph", &m, &err)) {
        fuzz_message(&err, "in.sph", 0);
    } else {
        if (sph_machine_write(&m, "out.sph", &err)) fuzz_fail("not written: %s", err.text);
        fuzz_same("out.sph", bytes, size);
        fuzz_no_rest();
        describe(&m);
        if (narrow(&m)) fuzz_draw(&m);
        sph_machine_free(&m);
    }
    free(bytes);
}
