/* write.c - machine to file; see machine.h, docs/reference/machine_file.md
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdio.h>
#include <string.h>

#include "machine/format.h"
#include "common/output.h"

static void put_double(unsigned char *to, double v) {
    uint64_t bits;
    memcpy(&bits, &v, sizeof bits);
    sph_put64(to, bits);
}

static void fill_header(const struct sph_machine *m, unsigned char *h) {
    const struct sph_profile *p = sph_machine_profile(m);
    const int widths[SPH_N_WIDTHS] = {p->w, p->wd, p->pq, p->ng, p->fw, p->pr};
    memset(h, 0, SPH_HEADER_BYTES);
    for (int i = 0; i < 8; i++)
        h[SPH_AT_MAGIC + i] = (unsigned char)SPH_MAGIC[i];
    sph_put32(h + SPH_AT_VERSION, SPH_FILE_VERSION);
    sph_put32(h + SPH_AT_HEADER, SPH_HEADER_BYTES);
    sph_put32(h + SPH_AT_N_REGS, SPH_N_REGS);
    sph_put32(h + SPH_AT_LINE_WORDS, SPH_LINE_WORDS);
    sph_put32(h + SPH_AT_LINES, m->lines);
    sph_put32(h + SPH_AT_GRID_LOG2, (uint32_t)m->grid_log2);
    for (int i = 0; i < SPH_N_WIDTHS; i++)
        sph_put32(h + SPH_AT_PROFILE + 4 * i, (uint32_t)widths[i]);
    for (size_t i = 0; i < sizeof m->name - 1 && m->name[i]; i++)
        h[SPH_AT_NAME + i] = (unsigned char)m->name[i];
    for (int i = 0; i < 3; i++)
        put_double(h + SPH_AT_ORIGIN + 8 * i, m->origin[i]);
    for (int i = 0; i < 9; i++)
        put_double(h + SPH_AT_ROTATION + 8 * i, m->rotation[i]);
    for (int i = 0; i < SPH_N_REGS; i++)
        sph_put32(h + SPH_AT_REGS + 4 * i, (uint32_t)m->regs[i]);
}

/* Writes n bytes and adds them to the checksum; the stream remembers errors. */
static void write_bytes(FILE *file, const unsigned char *bytes, size_t n, uint64_t *sum) {
    *sum = sph_fnv_bytes(*sum, bytes, n);
    fwrite(bytes, 1, n, file);
}

static void put_all(FILE *file, const struct sph_machine *m) {
    unsigned char header[SPH_HEADER_BYTES], line[4 * SPH_LINE_WORDS], tail[SPH_CHECKSUM_BYTES];
    uint64_t sum = SPH_FNV_START;
    fill_header(m, header);
    write_bytes(file, header, sizeof header, &sum);
    for (uint32_t i = 0; i < m->lines; i++) {
        for (uint32_t w = 0; w < SPH_LINE_WORDS; w++)
            sph_put32(line + 4 * w, m->mem[(size_t)i * SPH_LINE_WORDS + w]);
        write_bytes(file, line, sizeof line, &sum);
    }
    sph_put64(tail, sum);
    fwrite(tail, 1, sizeof tail, file);
}

int sph_machine_write(const struct sph_machine *m, const char *path, struct sph_error *err) {
    struct sph_output out;
    if (sph_output_open(&out, path, err)) return -1;
    put_all(out.file, m);
    return sph_output_close(&out, 0, err);
}
