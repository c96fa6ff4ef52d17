/* file.c - the machine file, read and written; see machine.h and format.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <ctype.h>
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/file.h"
#include "machine/format.h"

/* ---- file to machine, nothing believed unchecked; see machine.h,
 * docs/reference/machine_file.md ---- */

void sph_machine_free(struct sph_machine *m) {
    free(m->mem);
    m->mem = NULL;
    m->lines = 0;
}

static double get_double(const unsigned char *from) {
    uint64_t bits = sph_get64(from);
    double v;
    memcpy(&v, &bits, sizeof v);
    return v;
}

/* Checks one header field that may have one value only. */
static int expect(const unsigned char *h, int at, uint32_t want, const char *field,
                  struct sph_error *err) {
    uint32_t is = sph_get32(h + at);
    return is == want ? 0 : sph_fail(err, "%s is %u, not %u", field, is, want);
}

/* A name is text, and zeros from its end on. */
static int check_name(const unsigned char *name, struct sph_error *err) {
    size_t n = strnlen((const char *)name, SPH_NAME_BYTES);
    if (n == SPH_NAME_BYTES) return sph_fail(err, "name: no zero at the end");
    for (size_t i = 0; i < SPH_NAME_BYTES; i++)
        if (i < n ? iscntrl(name[i]) : name[i] != 0)
            return sph_fail(err, "name: byte %zu is 0x%02x", i, name[i]);
    return 0;
}

/* Checks the header against the size of the file. */
static int check_header(const unsigned char *h, long long bytes, struct sph_error *err) {
    if (memcmp(h, SPH_MAGIC, 8) != 0) return sph_fail(err, "magic: not a machine file of Sphaera");
    if (expect(h, SPH_AT_VERSION, SPH_FILE_VERSION, "version", err) ||
        expect(h, SPH_AT_HEADER, SPH_HEADER_BYTES, "header size", err) ||
        expect(h, SPH_AT_N_REGS, SPH_N_REGS, "number of registers", err) ||
        expect(h, SPH_AT_LINE_WORDS, SPH_LINE_WORDS, "words in a line", err))
        return -1;
    long long need = SPH_HEADER_BYTES + SPH_CHECKSUM_BYTES;
    need += 4ll * SPH_LINE_WORDS * sph_get32(h + SPH_AT_LINES);
    if (bytes != need)
        return sph_fail(err, "file is %s: %lld bytes, %lld by its header",
                        bytes < need ? "truncated" : "too long", bytes, need);
    return check_name(h + SPH_AT_NAME, err);
}

/* The widths in the header must be those of register PROFILE. */
static int check_profile(const unsigned char *h, const struct sph_machine *m,
                         struct sph_error *err) {
    const struct sph_profile *p = &m->profile;
    const int widths[SPH_N_WIDTHS] = {p->w, p->wd, p->pq, p->ng, p->fw, p->pr};
    static const char *const names[SPH_N_WIDTHS] = {"profile width W",  "profile width WD",
                                                    "profile width PQ", "profile width NG",
                                                    "profile width FW", "profile width PR"};
    for (int i = 0; i < SPH_N_WIDTHS; i++)
        if (expect(h, SPH_AT_PROFILE + 4 * i, (uint32_t)widths[i], names[i], err)) return -1;
    return 0;
}

static void take_header(const unsigned char *h, struct sph_machine *m) {
    memset(m, 0, sizeof *m);
    m->lines = sph_get32(h + SPH_AT_LINES);
    m->grid_log2 = (int32_t)sph_get32(h + SPH_AT_GRID_LOG2);
    memcpy(m->name, h + SPH_AT_NAME, sizeof m->name);
    for (int i = 0; i < 3; i++)
        m->origin[i] = get_double(h + SPH_AT_ORIGIN + 8 * i);
    for (int i = 0; i < 9; i++)
        m->rotation[i] = get_double(h + SPH_AT_ROTATION + 8 * i);
    for (int i = 0; i < SPH_N_REGS; i++)
        m->regs[i] = (int32_t)sph_get32(h + SPH_AT_REGS + 4 * i);
    m->profile = sph_profile_unpack((uint32_t)m->regs[SPH_REG_PROFILE]);
}

/* Where the grid stands in the scene. Its step is a power of two that a double holds, and half its
 * side is, as build has it. The rows of the rotation are x, z cross x, and z, of length 1; build
 * takes x of a cross product of length 1e-10 at least, so that roundings of 2^-53 turn it by less
 * than 2^-16. */
static int check_place(const struct sph_machine *m, struct sph_error *err) {
    const double *x = m->rotation, *y = x + 3, *z = x + 6, most = 0x1p-16;
    int least = DBL_MIN_EXP - DBL_MANT_DIG, end = DBL_MAX_EXP - m->profile.w;
    if (m->grid_log2 < least || m->grid_log2 > end)
        return sph_fail(err, "grid step is 2^%d, not 2^%d to 2^%d", m->grid_log2, least, end);
    for (int i = 0; i < 3; i++)
        if (!isfinite(m->origin[i]))
            return sph_fail(err, "origin: %c is %g", "xyz"[i], m -> origin[i]);
    double xx = 0, xz = 0, zz = 0, off = 0;
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        xx += x[i] * x[i], xz += x[i] * z[i], zz += z[i] * z[i];
        off += fabs(z[j] * x[k] - z[k] * x[j] - y[i]);
    }
    if (fabs(xx - 1) <= most && fabs(xz) <= most && fabs(zz - 1) <= most && off <= most) return 0;
    return sph_fail(err, "rotation: its rows are not three axes at right angles, of length 1");
}

/* Reads memory and checksum behind a checked header. */
static int take_memory(FILE *file, const unsigned char *header, struct sph_machine *m,
                       struct sph_error *err) {
    unsigned char line[4 * SPH_LINE_WORDS], tail[SPH_CHECKSUM_BYTES];
    uint64_t sum = sph_fnv_bytes(SPH_FNV_START, header, SPH_HEADER_BYTES);
    m->mem = malloc(((size_t)m->lines + 1) * SPH_LINE_WORDS * sizeof *m->mem);
    if (!m->mem) return sph_fail(err, "out of memory for %u lines", m->lines);
    for (uint32_t i = 0; i < m->lines; i++) {
        if (fread(line, 1, sizeof line, file) != sizeof line)
            return sph_fail(err, "cannot be read at line %u", i);
        sum = sph_fnv_bytes(sum, line, sizeof line);
        for (uint32_t w = 0; w < SPH_LINE_WORDS; w++)
            m->mem[(size_t)i * SPH_LINE_WORDS + w] = sph_get32(line + 4 * w);
    }
    if (fread(tail, 1, sizeof tail, file) != sizeof tail)
        return sph_fail(err, "checksum cannot be read");
    if (sph_get64(tail) != sum)
        return sph_fail(err, "checksum is %016llx, not %016llx: the file is damaged",
                        (unsigned long long)sph_get64(tail), (unsigned long long)sum);
    return 0;
}

/* The work of sph_machine_load() on an open file; messages without the path. */
static int take_file(FILE *file, struct sph_machine *m, struct sph_error *err) {
    unsigned char header[SPH_HEADER_BYTES];
    long bytes = -1;
    if (!fseek(file, 0, SEEK_END)) bytes = ftell(file);
    if (bytes < 0 || fseek(file, 0, SEEK_SET)) return sph_fail(err, "cannot be read");
    if (bytes < 8 || fread(header, 1, 8, file) != 8 || memcmp(header, SPH_MAGIC, 8) != 0)
        return sph_fail(err, "magic: not a machine file of Sphaera");
    if (fread(header + 8, 1, sizeof header - 8, file) != sizeof header - 8)
        return sph_fail(err, "file is truncated: %ld bytes, the header has %d", bytes,
                        SPH_HEADER_BYTES);
    if (check_header(header, bytes, err)) return -1;
    take_header(header, m);
    return take_memory(file, header, m, err) || check_profile(header, m, err) || check_place(m, err)
               ? -1
               : 0;
}

int sph_machine_load(const char *path, struct sph_machine *m, struct sph_error *err) {
    struct sph_error why = {{0}};
    memset(m, 0, sizeof *m);
    FILE *file = sph_input_open(path, SPH_INPUT_ANY, err);
    if (!file) return -1;
    int result = take_file(file, m, &why);
    fclose(file);
    if (!result) return 0;
    sph_machine_free(m);
    return sph_fail(err, "%s: %.400s", path, why.text);
}

/* ---- machine to file; see machine.h, docs/reference/machine_file.md ---- */

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
