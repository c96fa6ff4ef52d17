/* nff_lex.h - cuts a text file into tokens with line numbers; checks and reads numbers
 * SPDX-License-Identifier: Apache-2.0
 *
 * A token is a run of characters other than blanks, ends of line and `#`; `#` starts a comment
 * that runs to the end of the line. In AFF `%` does so too, and { and } are tokens of their own.
 * The file is read in pieces, so its size does not matter. Numbers do not depend on the locale.
 */
#ifndef SPH_SCENE_NFF_LEX_H
#define SPH_SCENE_NFF_LEX_H

#include <stdint.h>
#include <stdio.h>

#include "common/error.h"
#include "common/number.h"
#include "common/parallel.h"

#define SPH_LEX_TOKEN 63 /* characters of the longest token */

struct sph_lex {
    FILE *file;
    const char *path;
    size_t pos, len; /* next byte and end of the piece in buf */
    uint32_t line;   /* of the next byte, from 1 */
    int aff;         /* see above; set after sph_lex_open() */
    int ready;       /* token[] holds a token that was not taken yet */
    uint32_t token_line;
    char token[SPH_LEX_TOKEN + 1];
    unsigned char buf[65536];
    const struct sph_progress *progress; /* NULL, or set after sph_lex_open() */
    double size, taken;                  /* bytes of the file; of it, in pieces so far */
};

/* Opens path (kept, not copied). 0, or -1 with a message: as of sph_input_open(). */
int sph_lex_open(struct sph_lex *lex, const char *path, struct sph_error *err);

/* The same of an open file, which sph_lex_close() closes; path: for messages, kept too. */
void sph_lex_begin(struct sph_lex *lex, FILE *file, const char *path);

void sph_lex_close(struct sph_lex *lex);

/* Makes lex->token the next token, without taking it. 1, 0 at the end of the file, -1 with a
 * message: a control character, a token that is too long, a read error. */
int sph_lex_peek(struct sph_lex *lex, struct sph_error *err);

/* Takes the token that sph_lex_peek showed. */
static inline void sph_lex_take(struct sph_lex *lex) {
    lex->ready = 0;
}

/* Does the token look like a number (starts with a digit, sign or point)? */
int sph_lex_numeric(const struct sph_lex *lex);

/* Takes a number. record and field name what it is for. 0, or -1 with a message: end of file,
 * not a number, NaN, infinity, larger than SPH_NUMBER_MAX. */
int sph_lex_number(struct sph_lex *lex, const char *record, const char *field, double *value,
                   struct sph_error *err);

/* Takes a name: the characters up to the next blank or `#`, or all between two quotes ("). `size`
 * is that of name, with the zero at the end. SPH_NAME_BARE or SPH_NAME_QUOTED, or -1 with a
 * message: end of file, end of line within quotes, a quote within a bare name, too long. No token
 * may have been peeked at and not taken. */
enum { SPH_NAME_BARE = 1, SPH_NAME_QUOTED = 2 };
int sph_lex_name(struct sph_lex *lex, const char *record, const char *field, char *name,
                 size_t size, struct sph_error *err);

/* The token for messages: characters that would not print become `?`. Changes the token. */
const char *sph_lex_printable(struct sph_lex *lex);

#endif
