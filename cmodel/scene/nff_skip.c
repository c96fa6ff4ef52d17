/* nff_skip.c - see nff_skip.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * Words of extended formats (AFF, ENFF), whose records hold names as well: the rest of the line
 * belongs to the record, and every line after it that starts with a number.
 */
#include "scene/nff_skip.h"

#include <string.h>
#include <strings.h>

static const struct {
    const char *word, *what;
} words[] = {
    {"t", "triangle"},
    {"tpp", "textured triangle with normals"},
    {"pb", "Bezier patch"},
};

enum { N_WORDS = sizeof words / sizeof words[0] };

/* Whether a word ends as the name of an image does. */
static int is_image(const char *word) {
    static const char *const endings[] = {"png", "jpg", "jpeg", "ppm", "pgm", "pnm",  "bmp", "tga",
                                          "gif", "tif", "tiff", "exr", "hdr", "webp", "rgb", "pic"};
    const char *dot = strrchr(word, '.');
    for (size_t i = 0; dot && i < sizeof endings / sizeof *endings; i++)
        if (!strcasecmp(dot + 1, endings[i])) return 1;
    return 0;
}

/* What is said of a word of no format that is known here. */
static int unknown(struct sph_reader *r, struct sph_error *err) {
    struct sph_lex *lex = &r->lex;
    const char *word = sph_lex_printable(lex);
    if (is_image(word))
        return sph_fail(err,
                        "%s:%u: `%s` seems to be an image behind `f`, which has none: write "
                        "`texture %s su sv` before spheres or planes, `tt %s` for a triangle",
                        lex->path, lex->token_line, word, word, word);
    if (!strcasecmp(word, "nff") || !strcmp(word, "version"))
        return sph_fail(err,
                        "%s:%u: `%s`: this is the Neutral File Format of Sense8 (WorldToolKit), "
                        "another one than Haines' NFF that is read here; convert its polygons to "
                        "`p` records",
                        lex->path, lex->token_line, word);
    return sph_fail(err, "%s:%u: unknown word `%s`%s", lex->path, lex->token_line, word,
                    sph_lex_numeric(lex) ? ": a number where a record should begin; is there one "
                                           "too many in the record before?"
                    : word[1] == 0       ? ": no record of NFF or AFF begins so; those are v, b, "
                                           "l, f, fm, s, p, pp, tt, ttp, c, plane"
                                         : "");
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

int sph_nff_skip(struct sph_reader *r, struct sph_error *err) {
    struct sph_lex *lex = &r->lex;
    uint32_t line = lex->token_line;
    int i = 0;
    while (i < N_WORDS && strcmp(lex->token, words[i].word) != 0)
        i++;
    if (i == N_WORDS) return unknown(r, err);
    if (!r->skip)
        return sph_fail(err,
                        "%s:%u: `%s` (%s) is not supported; spheres (`s`), polygons (`p`, `pp`, "
                        "`tt`), cones (`c`) and planes (`plane`) are; --skip-unsupported leaves it "
                        "out",
                        lex->path, line, words[i].word, words[i].what);
    return skip_lines(lex, err) || sph_nff_note(r, SPH_READ_UNSUPPORTED, line, err) ? -1 : 0;
}
