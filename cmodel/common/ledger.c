/* ledger.c - see ledger.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "common/ledger.h"

#include <inttypes.h>

static const struct {
    enum sph_read_end end;
    const char *name;
} kinds[SPH_READS] = {
#define SPH_READ_KIND(kind, end, name) {end, name},
    SPH_EACH_READ(SPH_READ_KIND)
#undef SPH_READ_KIND
};

static const char *const ends[SPH_READ_ENDS] = {"used", "used otherwise", "left out"};

enum sph_read_end sph_read_end(enum sph_read kind) {
    return kinds[kind].end;
}

const char *sph_read_name(enum sph_read kind) {
    return kinds[kind].name;
}

const char *sph_read_end_name(enum sph_read_end end) {
    return ends[end];
}

/* "file:line: end: name" and the line that it is beside, or as much as there is of it. */
static int tell(char *text, size_t size, enum sph_read kind, const char *file, uint32_t line,
                uint32_t other) {
    char place[32] = "", beside[32] = "";
    if (line) snprintf(place, sizeof place, ":%" PRIu32, line);
    if (other) snprintf(beside, sizeof beside, ", with that of line %" PRIu32, other);
    return snprintf(text, size, "%.400s%s: %s: %s%s", file, place, ends[kinds[kind].end],
                    kinds[kind].name, beside);
}

int sph_ledger_add(struct sph_ledger *l, enum sph_read kind, uint64_t n, const char *file,
                   uint32_t line, uint32_t other, struct sph_error *err) {
    if (!l || !n) return 0;
    struct sph_ledger_row *row = &l->row[kind];
    if (!row->n) {
        snprintf(row->file, sizeof row->file, "%s", file);
        row->line = line, row->other = other;
    }
    row->n += n;
    if (!l->strict || kinds[kind].end == SPH_USED) return 0;
    char text[640];
    tell(text, sizeof text, kind, file, line, other);
    return sph_fail(err, "%s", text);
}

int sph_ledger_note(struct sph_ledger *l, enum sph_read kind, const char *file, uint32_t line,
                    struct sph_error *err) {
    return sph_ledger_add(l, kind, 1, file, line, 0, err);
}

void sph_ledger_take_back(struct sph_ledger *l, uint32_t kind) {
    if (kind && l->row[kind].n) l->row[kind].n--;
}

uint64_t sph_ledger_left_out(const struct sph_ledger *l) {
    uint64_t n = 0;
    for (int kind = 0; kind < SPH_READS; kind++)
        n += kinds[kind].end == SPH_LEFT_OUT ? l->row[kind].n : 0;
    return n;
}

void sph_ledger_print(const struct sph_ledger *l, enum sph_read_end from, const char *head,
                      FILE *to) {
    for (int end = (int)from; end < SPH_READ_ENDS; end++)
        for (int kind = 0; kind < SPH_READS; kind++) {
            const struct sph_ledger_row *row = &l->row[kind];
            char text[640];
            if (!row->n || (int)kinds[kind].end != end) continue;
            tell(text, sizeof text, (enum sph_read)kind, row->file, row->line, row->other);
            fprintf(to, "%s%s, %" PRIu64 " time%s\n", head, text, row->n, row->n > 1 ? "s" : "");
        }
}
