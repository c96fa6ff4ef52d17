/* nff_take.c - numbers and vectors of records, and what is said of wrong ones; see nff_reader.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "scene/nff_reader.h"

const char *const sph_nff_point[3] = {"x", "y", "z"};
const char *const sph_nff_colour[3] = {"red", "green", "blue"};

int sph_nff_numbers(struct sph_reader *r, const char *record, const char *const *names, int n,
                    double *values, struct sph_error *err) {
    for (int i = 0; i < n; i++)
        if (sph_lex_number(&r->lex, record, names[i], &values[i], err)) return -1;
    return 0;
}

int sph_nff_fail(struct sph_reader *r, struct sph_error *err, const char *record,
                 const char *what) {
    return sph_fail(err, "%s:%u: `%s`: %s", r->lex.path, r->lex.token_line, record, what);
}

int sph_nff_note(struct sph_reader *r, enum sph_read kind, uint32_t line, struct sph_error *err) {
    r->ended = 1, r->kind = kind;
    return sph_ledger_note(&r->scene->ledger, kind, r->lex.path, line, err);
}

void sph_nff_mark(struct sph_reader *r, uint32_t facets, enum sph_read kind) {
    for (; facets < r->scene->n_facets; facets++)
        r->scene->facets[facets].read = kind;
}

int sph_nff_vec(struct sph_reader *r, const char *record, struct sph_vec *v,
                struct sph_error *err) {
    double value[3];
    if (sph_nff_numbers(r, record, sph_nff_point, 3, value, err)) return -1;
    *v = sph_vec_of(value[0], value[1], value[2]);
    return 0;
}

int sph_nff_check_unit(struct sph_reader *r, const char *record, const char *const *names, int n,
                       const double *values, struct sph_error *err) {
    for (int i = 0; i < n; i++)
        if (!(values[i] >= 0 && values[i] <= 1))
            return sph_fail(err, "%s:%u: `%s`: %s %g is not within 0 to 1", r->lex.path,
                            r->lex.token_line, record, names[i], values[i]);
    return 0;
}

int sph_nff_more(struct sph_reader *r, const char *record, const char *const *names, int n,
                 double *values, struct sph_error *err) {
    int got = sph_lex_peek(&r->lex, err);
    if (got <= 0 || !sph_lex_numeric(&r->lex)) return got < 0 ? -1 : 0;
    return sph_nff_numbers(r, record, names, n, values, err) ? -1 : 1;
}
