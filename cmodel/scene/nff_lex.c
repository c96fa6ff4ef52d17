/* nff_lex.c - see nff_lex.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "scene/nff_lex.h"

#include <errno.h>
#include <locale.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "common/packed.h"

void sph_lex_begin(struct sph_lex *lex, FILE *file, const char *path) {
    struct stat st;
    lex->progress = NULL;
    lex->size = fstat(fileno(file), &st) ? 0 : (double)st.st_size;
    lex->file = file;
    lex->path = path;
    lex->pos = 0;
    lex->line = lex->token_line = 1;
    lex->ready = lex->aff = 0;
    lex->token[0] = 0;
    lex->len = fread(lex->buf, 1, sizeof lex->buf, lex->file);
    lex->taken = (double)lex->len;
    if (lex->len >= 3 && !memcmp(lex->buf, "\xef\xbb\xbf", 3)) lex->pos = 3; /* UTF-8 mark */
}

int sph_lex_open(struct sph_lex *lex, const char *path, struct sph_error *err) {
    FILE *file = sph_input_text(path, err);
    if (!file) return -1;
    sph_lex_begin(lex, file, path);
    return 0;
}

void sph_lex_close(struct sph_lex *lex) {
    fclose(lex->file);
    lex->file = NULL;
}

/* The next byte, not taken; -1 at the end of the file or after a read error. */
static inline int next_byte(struct sph_lex *lex) {
    if (lex->pos == lex->len) {
        lex->pos = 0;
        lex->len = fread(lex->buf, 1, sizeof lex->buf, lex->file);
        if (lex->len == 0) return -1;
        lex->taken += (double)lex->len;
        if (lex->taken <= lex->size && sph_progress_at(lex->progress, lex->taken / lex->size)) {
            lex->len = 0;
            return -1;
        }
    }
    return lex->buf[lex->pos];
}

static inline int is_blank(int c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

static inline int is_comment(const struct sph_lex *lex, int c) {
    return c == '#' || (lex->aff && c == '%');
}

static inline int is_brace(const struct sph_lex *lex, int c) {
    return lex->aff && (c == '{' || c == '}');
}

static inline int is_control(int c) {
    return (c < 32 && !is_blank(c)) || c == 127;
}

static int fail_control(const struct sph_lex *lex, int c, struct sph_error *err) {
    return sph_fail(err, "%s:%u: byte 0x%02x: this is not a text file", lex->path, lex->line,
                    (unsigned)c);
}

/* Passes blanks, ends of line and comments. The next byte, -1 at the end, -2 with a message. */
static int skip_blanks(struct sph_lex *lex, struct sph_error *err) {
    int comment = 0, c;
    while ((c = next_byte(lex)) >= 0) {
        if (is_control(c)) return fail_control(lex, c, err) * 2;
        if (is_comment(lex, c)) comment = 1;
        if (!comment && !is_blank(c)) return c;
        if (c == '\n') {
            lex->line++;
            comment = 0;
        }
        lex->pos++;
    }
    if (ferror(lex->file))
        return sph_fail(err, "%s:%u: cannot read: %s", lex->path, lex->line, sph_input_why()) * 2;
    return -1;
}

int sph_lex_peek(struct sph_lex *lex, struct sph_error *err) {
    if (lex->ready) return 1;
    int c = skip_blanks(lex, err);
    if (c < 0) return c == -1 ? 0 : -1;
    size_t n = 0;
    lex->token_line = lex->line;
    for (; c >= 0 && !is_blank(c) && !is_comment(lex, c); c = next_byte(lex)) {
        if (is_control(c)) return fail_control(lex, c, err);
        if (n && (is_brace(lex, c) || is_brace(lex, lex->token[0]))) break;
        if (n == SPH_LEX_TOKEN)
            return sph_fail(err, "%s:%u: a word of more than %d characters", lex->path, lex->line,
                            SPH_LEX_TOKEN);
        lex->token[n++] = (char)c;
        lex->pos++;
    }
    lex->token[n] = 0;
    lex->ready = 1;
    return 1;
}

int sph_lex_name(struct sph_lex *lex, const char *record, const char *field, char *name,
                 size_t size, struct sph_error *err) {
    int c = skip_blanks(lex, err), quoted = c == '"';
    size_t n = 0;
    if (c < -1) return -1;
    if (c < 0)
        return sph_fail(err, "%s:%u: the file ends within `%s`, before %s", lex->path,
                        lex->token_line, record, field);
    lex->token_line = lex->line;
    if (quoted) lex->pos++;
    while ((c = next_byte(lex)) >= 0) {
        if (quoted ? c == '"' : is_blank(c) || is_comment(lex, c) || is_brace(lex, c)) break;
        if (is_control(c)) return fail_control(lex, c, err);
        if (c == '\n' || c == '"')
            return sph_fail(err, "%s:%u: `%s`: %s: %s", lex->path, lex->line, record, field,
                            quoted ? "the line ends before the second quote"
                                   : "a quote within the name");
        if (n + 1 == size)
            return sph_fail(err, "%s:%u: `%s`: %s: more than %zu characters", lex->path, lex->line,
                            record, field, size - 1);
        name[n++] = (char)c;
        lex->pos++;
    }
    if (quoted && c < 0)
        return sph_fail(err, "%s:%u: `%s`: %s: the file ends before the second quote", lex->path,
                        lex->line, record, field);
    if (quoted) lex->pos++;
    name[n] = 0;
    return quoted ? SPH_NAME_QUOTED : SPH_NAME_BARE;
}

int sph_lex_numeric(const struct sph_lex *lex) {
    char c = lex->token[0];
    return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.';
}

const char *sph_lex_printable(struct sph_lex *lex) {
    for (char *c = lex->token; *c; c++)
        if (*c < 32 || *c > 126) *c = '?';
    return lex->token;
}

int sph_lex_number(struct sph_lex *lex, const char *record, const char *field, double *value,
                   struct sph_error *err) {
    int got = sph_lex_peek(lex, err);
    if (got < 0) return -1;
    if (got == 0)
        return sph_fail(err, "%s:%u: the file ends within `%s`, before %s", lex->path,
                        lex->token_line, record, field);
    int bad = sph_parse_number(lex->token, value);
    if (bad)
        return sph_fail(err, "%s:%u: `%s`: %s: `%s` is %s", lex->path, lex->token_line, record,
                        field, sph_lex_printable(lex),
                        bad == -2 ? "too large" : "not a decimal number");
    sph_lex_take(lex);
    return 0;
}
