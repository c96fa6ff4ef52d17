/* aff_take.c - names, counts and braces of AFF records; see aff_reader.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "scene/aff_reader.h"

#include <stdlib.h>
#include <string.h>

int sph_aff_room(struct sph_aff *a, void *list, uint32_t n, size_t element, struct sph_error *err) {
    void *room;
    if (n & (n - 1)) return 0;
    memcpy(&room, list, sizeof room);
    room = realloc(room, (n ? 2 * (size_t)n : 1) * element);
    if (!room)
        return sph_fail(err, "%s:%u: no memory for more than %u", a->r.lex.path,
                        a->r.lex.token_line, n);
    memcpy(list, &room, sizeof room);
    return 0;
}

int sph_aff_count(struct sph_aff *a, const char *record, const char *field, double min, double max,
                  uint32_t *count, struct sph_error *err) {
    double value;
    if (sph_lex_number(&a->r.lex, record, field, &value, err)) return -1;
    if (!(value >= min && value <= max && value == floor(value)))
        return sph_fail(err, "%s:%u: `%s`: %s: %g is no whole number of %.0f to %.0f",
                        a->r.lex.path, a->r.lex.token_line, record, field, value, min, max);
    *count = (uint32_t)value;
    return 0;
}

int sph_aff_name(struct sph_aff *a, const char *record, const char *field,
                 char name[SPH_LEX_TOKEN + 1], struct sph_error *err) {
    int got = sph_lex_peek(&a->r.lex, err);
    if (got < 0) return -1;
    if (!got || !strcmp(a->r.lex.token, "{") || !strcmp(a->r.lex.token, "}"))
        return sph_fail(err, "%s:%u: `%s`: no %s", a->r.lex.path, a->r.lex.token_line, record,
                        field);
    memcpy(name, a->r.lex.token, sizeof a->r.lex.token);
    sph_lex_take(&a->r.lex);
    return 0;
}

int sph_aff_brace(struct sph_aff *a, const char *record, struct sph_error *err) {
    int got = sph_lex_peek(&a->r.lex, err);
    if (got < 0) return -1;
    if (!got || strcmp(a->r.lex.token, "{") != 0)
        return sph_fail(err, "%s:%u: `%s`: { is missing", a->r.lex.path, a->r.lex.token_line,
                        record);
    sph_lex_take(&a->r.lex);
    return 0;
}
