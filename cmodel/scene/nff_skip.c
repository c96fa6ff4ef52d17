/* nff_skip.c - see nff_skip.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * Words of extended formats (AFF, ENFF), whose records hold names as well: the rest of the line
 * belongs to the record, and every line after it that starts with a number.
 */
#include "scene/nff_skip.h"

#include <string.h>

static const struct {
    const char *word, *what;
} words[] = {
    {"t", "triangle"},
    {"tpp", "textured triangle with normals"},
    {"pb", "Bezier patch"},
};

enum { N_WORDS = sizeof words / sizeof words[0] };

/* Passes the rest of the line and the lines after it that start with a number. */
static int skip_lines(struct sph_lex *lex, struct sph_error *err) {
    uint32_t line = lex->token_line;
    int got;
    while ((got = sph_lex_peek(lex, err)) > 0) {
        if (lex->token_line != line && !sph_lex_numeric(lex)) return 0;
        line = lex->token_line;
        sph_lex_take(lex);
    }
    return got;
}

int sph_nff_skip(struct sph_lex *lex, int skip, uint32_t *n_skipped, struct sph_error *err) {
    int i = 0;
    while (i < N_WORDS && strcmp(lex->token, words[i].word) != 0)
        i++;
    if (i == N_WORDS)
        return sph_fail(err, "%s:%u: unknown word `%s`", lex->path, lex->token_line,
                        sph_lex_printable(lex));
    if (!skip)
        return sph_fail(err,
                        "%s:%u: `%s` (%s) is not supported; spheres (`s`), polygons (`p`, `pp`, "
                        "`tt`), cones (`c`) and planes (`plane`) are; --skip-unsupported leaves it "
                        "out",
                        lex->path, lex->token_line, words[i].word, words[i].what);
    if (skip_lines(lex, err)) return -1;
    ++*n_skipped;
    return 0;
}
