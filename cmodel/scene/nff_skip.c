/* nff_skip.c - see nff_skip.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * p n, pp n and c are NFF; their length is known. The others come from extended formats (AFF,
 * ENFF), whose records hold names as well: there the rest of the line belongs to the record,
 * and every line after it that starts with a number.
 */
#include "scene/nff_skip.h"

#include <math.h>
#include <string.h>

static const struct {
    const char *word, *what;
    int counted; /* a number of vertices follows */
    int numbers; /* of one vertex, or of the record; 0: by lines */
} words[] = {
    {"p", "polygon", 1, 3},
    {"pp", "polygon with normals", 1, 6},
    {"c", "cone or cylinder", 0, 8},
    {"t", "triangle", 0, 0},
    {"tt", "textured triangle", 0, 0},
    {"tpp", "textured triangle with normals", 0, 0},
    {"fm", "extended material", 0, 0},
    {"pb", "Bezier patch", 0, 0},
};

enum { N_WORDS = sizeof words / sizeof words[0], MAX_VERTICES = 1000000 };

static int skip_numbers(struct sph_lex *lex, const char *word, int n, struct sph_error *err) {
    double value;
    for (int i = 0; i < n; i++)
        if (sph_lex_number(lex, word, "its last number", &value, err)) return -1;
    return 0;
}

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
                        "%s:%u: `%s` (%s) is not supported, only spheres are; "
                        "--skip-unsupported leaves it out",
                        lex->path, lex->token_line, words[i].word, words[i].what);
    double count = 1;
    if (words[i].counted) {
        if (sph_lex_number(lex, words[i].word, "number of vertices", &count, err)) return -1;
        if (!(count >= 1 && count <= MAX_VERTICES && count == floor(count)))
            return sph_fail(err, "%s:%u: `%s`: %g is not a number of vertices", lex->path,
                            lex->token_line, words[i].word, count);
    }
    if (words[i].numbers > 0 ? skip_numbers(lex, words[i].word, (int)count * words[i].numbers, err)
                             : skip_lines(lex, err))
        return -1;
    ++*n_skipped;
    return 0;
}
