/* stages_text.c - the table of all stages, and their lines as text; see stages.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "core/stages.h"

#include <inttypes.h>
#include <limits.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* Kinds of numbers. */
enum {
    COUNT,  /* as it is, decimal: a number of something, a flag */
    HEX,    /* bits that are no number */
    PLAIN,  /* fixed point */
    GRID,   /* the same, in grid units */
    GRID2,  /* ... squared */
    GRID3,  /* ... cubed */
    FILTER, /* in units of the node filter, 2^(W-FW) of the grid */
    T       /* the mantissa of t; its exponent is the next word */
};

struct field {
    const char *name;
    int count;        /* 3: a vector */
    int sign, kind;   /* sign 1: two's complement */
    const char *bits; /* sums of widths and numbers, such as "2W+3" */
    const char *fraction;
};

#define U(name, kind, bits, fraction)                                                              \
    { name, 1, 0, kind, bits, fraction }
#define S(name, kind, bits, fraction)                                                              \
    { name, 1, 1, kind, bits, fraction }
#define U3(name, kind, bits, fraction)                                                             \
    { name, 3, 0, kind, bits, fraction }
#define S3(name, kind, bits, fraction)                                                             \
    { name, 3, 1, kind, bits, fraction }
#define N(name, bits)                                                                              \
    { name, 1, 0, COUNT, bits, "0" }

enum { FIELDS = 11 };

static const struct {
    const char *name, *number; /* what the line's number is, NULL: it has none */
    struct field field[FIELDS];
} table[SPH_STAGES] = {
    [SPH_STAGE_RAY] = {"set-up",
                       NULL,
                       {S3("org", GRID, "W", "0"), S3("dir", PLAIN, "WD", "0"),
                        U("a", PLAIN, "2WD", "0"), S3("unit", PLAIN, "18", "16"),
                        U("skip", HEX, "24", "0"), N("inside", "1")}},
    [SPH_STAGE_ACROSS] = {"across",
                          NULL,
                          {S3("org", FILTER, "FW", "0"), N("axis", "2"), N("negative", "1"),
                           S("p_a", PLAIN, "18", "17"), S("p_b", PLAIN, "18", "17"),
                           S3("q", PLAIN, "18", "17")}},
    [SPH_STAGE_NODE] = {"node",
                        NULL,
                        {N("line", "26"), U("base", HEX, "26", "0"), N("inner", "3"),
                         N("leaves", "3")}},
    [SPH_STAGE_PLANES] = {"planes",
                          NULL,
                          {N("line", "26"), N("half", "1"), N("axis", "2"),
                           S("left", GRID, "W+2", "0"), S("right", GRID, "W+2", "0"), N("fit", "1"),
                           U("child", HEX, "29", "0")}},
    [SPH_STAGE_LEAF] = {"leaf",
                        NULL,
                        {N("line", "26"), N("half", "1"), N("first", "32"), N("count", "32")}},
    [SPH_STAGE_FILTER] = {"filter",
                          "child",
                          {S3("ctr", FILTER, "14", "0"), U("rad", FILTER, "14", "0"),
                           U("oc.p", FILTER, "16", "1"), U("oc.q", FILTER, "16", "1"),
                           S("near", FILTER, "16", "0"), U("limit", FILTER, "FW+1", "0"),
                           N("pass", "1")}},
    [SPH_STAGE_BOX] = {"box",
                       "child",
                       {U3("lo", COUNT, "7", "0"), U3("hi", COUNT, "7", "0"),
                        U("near", HEX, "15", "0"), U("limit", HEX, "15", "0"), N("pass", "1")}},
    [SPH_STAGE_SPHERE] = {"sphere",
                          "id",
                          {S3("ctr", GRID, "W", "0"), U("rad", GRID, "W", "0"),
                           S("b", GRID, "W+WD+2", "0"), S("k", GRID2, "2W+3", "0"),
                           S("disc", GRID2, "2W+2WD+2", "0"), N("hit", "1"), N("far", "1")}},
    [SPH_STAGE_TRIANGLE] = {"triangle",
                            "id",
                            {S("det", GRID2, "2W+WD+2", "0"), S("num", GRID3, "3W+2", "0"),
                             S("u1", GRID2, "2W+WD+2", "0"), S("u2", GRID2, "2W+WD+2", "0")}},
    [SPH_STAGE_PLANE] = {"plane",
                         "id",
                         {S("det", PLAIN, "2W+WD+2", "0"), S("num", GRID, "3W+2", "0")}},
    [SPH_STAGE_ROOT] = {"root", "id", {U("root", GRID, "W+WD", "0"), N("inexact", "1")}},
    [SPH_STAGE_KEY] = {"key", "id", {U("key", GRID, "W+WD+2", "0"), N("far", "1")}},
    [SPH_STAGE_HIT] = {"hit",
                       NULL,
                       {N("found", "1"), U("id", HEX, "24", "0"), U("key", GRID, "W+WD+2", "0"),
                        N("far", "1")}},
    [SPH_STAGE_QUOTIENT] = {"quotient", NULL, {U("t", T, "PQ", "0"), S("exp", PLAIN, "8", "0")}},
    [SPH_STAGE_POINT] = {"point",
                         NULL,
                         {S3("guarded", GRID, "W+NG", "NG"), S3("point", GRID, "W", "0")}},
    [SPH_STAGE_NORMAL] = {"normal",
                          NULL,
                          {S3("normal", PLAIN, "WD", "0"), U("nn", PLAIN, "2WD", "0"),
                           S3("unit", PLAIN, "18", "16")}},
    [SPH_STAGE_MATERIAL] = {"material",
                            NULL,
                            {U3("rgb", PLAIN, "8", "0"), U("kr", PLAIN, "9", "8"),
                             U("kt", PLAIN, "9", "8"), N("sum", "1"), U("ka", PLAIN, "9", "8"),
                             U("kd", PLAIN, "9", "8"), U("ks", PLAIN, "8", "8"),
                             U("power", PLAIN, "12", "4"), N("index", "12")}},
    [SPH_STAGE_PATH] = {"path", NULL, {U("length", GRID, "W+8", "4")}},
    [SPH_STAGE_LEVEL] = {"level", NULL, {U("lod", PLAIN, "12", "8")}},
    [SPH_STAGE_TEXEL] = {"texel", "number", {U("word", HEX, "29", "0")}},
    [SPH_STAGE_ALBEDO] = {"albedo", NULL, {U3("rgb", PLAIN, "8", "0")}},
    [SPH_STAGE_LIGHT] = {"light",
                         "number",
                         {S3("dir", PLAIN, "WD", "0"), U("a", PLAIN, "2WD", "0"),
                          S3("unit", PLAIN, "18", "16"), U("cosine", PLAIN, "16", "15")}},
    [SPH_STAGE_HIGHLIGHT] = {"highlight", "number", {U("power", PLAIN, "16", "15")}},
    [SPH_STAGE_COLOUR] = {"colour",
                          NULL,
                          {U3("rgb", PLAIN, "16", "8"), U("weight", PLAIN, "17", "16")}},
    [SPH_STAGE_PIXEL] = {"pixel",
                         NULL,
                         {U("rendering", HEX, "24", "0"), U("l1", HEX, "24", "0"),
                          U("l2", HEX, "24", "0"), U("id", HEX, "24", "0"),
                          U("key", GRID, "W+WD+2", "0"), N("visits", "24"),
                          U("texture", HEX, "32", "0")}},
};

/* "2W+2WD+2" with the widths of p. */
static int width(const char *text, const struct sph_profile *p) {
    const struct {
        const char *name;
        int bits;
    } names[] = {{"WD", p->wd}, {"W", p->w}, {"NG", p->ng}, {"FW", p->fw}, {"PQ", p->pq}};
    int sum = 0;
    while (*text) {
        int n = 0, digits = 0;
        for (; *text >= '0' && *text <= '9'; text++, digits++)
            n = 10 * n + (*text - '0');
        for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
            size_t length = strlen(names[i].name);
            if (strncmp(text, names[i].name, length) != 0) continue;
            n = (digits ? n : 1) * names[i].bits;
            text += length;
            break;
        }
        sum += n;
        text += *text == '+';
    }
    return sum;
}

static void append(char *text, const char *format, ...) __attribute__((format(printf, 2, 3)));
static void append(char *text, const char *format, ...) {
    size_t used = strlen(text);
    va_list ap;
    va_start(ap, format);
    vsnprintf(text + used, SPH_STAGE_TEXT - used, format, ap);
    va_end(ap);
}

static sph_u128 low(sph_u128 word, int bits) {
    return bits < 128 ? word & (((sph_u128)1 << bits) - 1) : word;
}

/* The word as the number that it stands for. */
static double real(const struct sph_machine *m, const struct field *f, sph_u128 word, int bits) {
    const struct sph_profile *p = sph_machine_profile(m);
    double value = (double)low(word, bits);
    if (f->sign && word >> (bits - 1) & 1) value -= ldexp(1, bits);
    int step = m->grid_log2;
    int scale = f->kind == GRID     ? step
                : f->kind == GRID2  ? 2 * step
                : f->kind == GRID3  ? 3 * step
                : f->kind == FILTER ? step + p->w - p->fw
                                    : 0;
    return ldexp(value, scale - width(f->fraction, p));
}

static void digits(char *text, sph_u128 word, int bits) {
    append(text, "0x");
    for (int at = (bits - 1) / 4; at >= 0; at--)
        append(text, "%x", (unsigned)(low(word, bits) >> 4 * at & 15));
}

static struct sph_operand operand(const struct sph_machine *m, const struct field *f,
                                  const sph_u128 *word) {
    int bits = width(f->bits, sph_machine_profile(m));
    double value = real(m, f, *word, bits);
    if (f->kind == T) value = ldexp(value, -(int8_t)word[1]);
    return (struct sph_operand){f->name, bits, f->sign, low(*word, bits), value};
}

static void number(const struct sph_machine *m, const struct field *f, const sph_u128 *word,
                   char *text) {
    struct sph_operand o = operand(m, f, word);
    if (f->kind == COUNT) {
        append(text, "%" PRIu64, (uint64_t)o.word);
        return;
    }
    digits(text, o.word, o.bits);
    if (f->kind != HEX) append(text, " (=%.6g)", o.value);
}

int sph_stages_operand(const struct sph_machine *m, const struct sph_stage_line *line, int k,
                       struct sph_operand *to) {
    const struct field *f = table[line->stage].field, *end = f + FIELDS;
    if (k < 0) return -1;
    for (int first = 0; f < end && f->name; first += f++->count)
        if (k < first + f->count) {
            *to = operand(m, f, &line->word[k]);
            return 0;
        }
    return -1;
}

const char *sph_stages_name(int stage) {
    return table[stage].name;
}

void sph_stages_text(const struct sph_machine *m, const struct sph_stage_line *line,
                     char text[SPH_STAGE_TEXT]) {
    static const char *const kinds[] = {"primary", "shadow", "reflected", "refracted"};
    const sph_u128 *word = line->word;
    *text = 0;
    if (line->ray < INT_MAX) append(text, "ray %d %s | ", line->ray, kinds[line->kind]);
    append(text, "%s", table[line->stage].name);
    if (line->visit) append(text, " visit %u", line->visit);
    if (table[line->stage].number) append(text, " %s %u", table[line->stage].number, line->number);
    for (int i = 0; i < FIELDS && table[line->stage].field[i].name; i++) {
        const struct field *f = &table[line->stage].field[i];
        append(text, "  %s ", f->name);
        for (int k = 0; k < f->count; k++) {
            if (k) append(text, ", ");
            number(m, f, word++, text);
        }
    }
}
