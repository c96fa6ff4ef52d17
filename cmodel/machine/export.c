/* export.c - see export.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "machine/export.h"

#include <ctype.h>
#include <inttypes.h>
#include <string.h>

#include "common/file.h"
#include "machine/parts.h"

/* What the hardware must be told of the machine, as comments. */
static void put_core(const struct sph_machine *m, FILE *file) {
    const struct sph_profile *p = sph_machine_profile(m);
    fprintf(file, "// scene %s, %d x %d pixels\n", m->name, m->regs[SPH_REG_FRAME_W],
            m->regs[SPH_REG_FRAME_H]);
    fprintf(file, "// rt_core with W=%d WD=%d PQ=%d NG=%d FW=%d PR=%d and at least\n", p->w, p->wd,
            p->pq, p->ng, p->fw, p->pr);
    fprintf(file, "//");
    for (int i = 0; i < SPH_PARTS; i++) {
        int asked = sph_part_asked(m, i);
        if (asked) fprintf(file, " %s=%d", sph_parts[i].core, asked);
    }
    fprintf(file, "\n");
}

static void put_hex(const struct sph_machine *m, FILE *regs, FILE *mem) {
    fprintf(regs, "// registers 0 .. %d of a machine, 32 bits each\n", SPH_N_REGS - 1);
    put_core(m, regs);
    for (int i = 0; i < SPH_N_REGS; i++)
        fprintf(regs, "%08" PRIx32 "\n", (uint32_t)m->regs[i]);
    fprintf(mem, "// %" PRIu32 " lines of memory of a machine, %d bits each\n", m->lines,
            32 * SPH_LINE_WORDS);
    put_core(m, mem);
    for (uint32_t line = 0; line < m->lines; line++)
        for (int word = SPH_LINE_WORDS; word-- > 0;)
            fprintf(mem, "%08" PRIx32 "%s", sph_line(m, line)[word], word ? "" : "\n");
}

int sph_machine_write_hex(const struct sph_machine *m, const char *stem, struct sph_error *err) {
    char path[sizeof((struct sph_output){0}.path)];
    struct sph_output regs, mem;
    const size_t longest = sizeof path - sizeof ".regs.hex";
    if (strlen(stem) > longest) return sph_fail(err, "%.200s...: name is too long", stem);
    snprintf(path, sizeof path, "%.*s.regs.hex", (int)longest, stem);
    if (sph_output_open(&regs, path, err)) return -1;
    snprintf(path, sizeof path, "%.*s.mem.hex", (int)longest, stem);
    if (sph_output_open(&mem, path, err)) {
        sph_output_close(&regs, 1, err);
        return -1;
    }
    put_hex(m, regs.file, mem.file);
    int failed = sph_output_close(&mem, 0, err);
    return sph_output_close(&regs, failed, err);
}

static void put_words(FILE *file, const uint32_t *words, size_t n) {
    for (size_t i = 0; i < n; i++)
        fprintf(file, "%s0x%08" PRIx32 ",%s", i % 8 ? " " : "    ", words[i],
                i % 8 == 7 || i + 1 == n ? "\n" : "");
}

int sph_machine_write_c(const struct sph_machine *m, const char *path, struct sph_error *err) {
    char name[64] = "machine";
    const char *slash = strrchr(path, '/'), *base = slash ? slash + 1 : path;
    struct sph_output out;
    if (strcmp(path, "-")) snprintf(name, sizeof name, "%.*s", (int)strcspn(base, "."), base);
    for (char *c = name; *c; c++)
        if (!isalnum((unsigned char)*c)) *c = '_';
    if (!name[0] || isdigit((unsigned char)name[0]))
        return sph_fail(err, "%.200s: its name does not begin as a name of C does", path);
    if (sph_output_open(&out, path, err)) return -1;
    fprintf(out.file, "// registers, and memory in lines of %d words, low bits first\n",
            SPH_LINE_WORDS);
    put_core(m, out.file);
    fprintf(out.file,
            "#include <stdint.h>\n\nenum { %s_REGISTERS = %d, %s_LINES = %" PRIu32 " };\n", name,
            SPH_N_REGS, name, m->lines);
    fprintf(out.file, "static const uint32_t %s_regs[%d] = {\n", name, SPH_N_REGS);
    uint32_t words[SPH_N_REGS];
    memcpy(words, m->regs, sizeof words);
    put_words(out.file, words, SPH_N_REGS);
    fprintf(out.file, "};\nstatic const uint32_t %s_mem[%" PRIu32 "] = {\n", name,
            m->lines * SPH_LINE_WORDS);
    put_words(out.file, m->mem, (size_t)m->lines * SPH_LINE_WORDS);
    fprintf(out.file, "};\n");
    return sph_output_close(&out, 0, err);
}
