/* mesh_ply.c - the records of a PLY file, text or binary; see mesh.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "common/number.h"
#include "scene/mesh.h"

enum { ELEMENTS = 16, PROPERTIES = 64, NAME = 32 };

/* Types of numbers, by both of their names. */
static const struct {
    const char *name, *other;
    size_t size;
    int real, sign;
} types[] = {{"char", "int8", 1, 0, 1},     {"uchar", "uint8", 1, 0, 0},
             {"short", "int16", 2, 0, 1},   {"ushort", "uint16", 2, 0, 0},
             {"int", "int32", 4, 0, 1},     {"uint", "uint32", 4, 0, 0},
             {"float", "float32", 4, 1, 1}, {"double", "float64", 8, 1, 1}};
enum { TYPES = sizeof types / sizeof *types };

struct property {
    char name[NAME];
    int type, length; /* index into types; that of a list's length, -1: no list */
};

struct element {
    char name[NAME];
    uint64_t count;
    int n, faces; /* properties; 1: each is a face */
    struct property property[PROPERTIES];
};

struct ply {
    struct sph_text text;
    struct sph_scene *scene;
    struct sph_mesh_lines *lines;
    enum { ASCII, LITTLE, BIG } format;
    int n;
    struct element element[ELEMENTS];
    uint64_t vertices;
};

static const char *const formats[] = {"ascii", "binary_little_endian", "binary_big_endian"};

static int note(struct ply *p, enum sph_read kind, struct sph_error *err) {
    return sph_ledger_note(&p->scene->ledger, kind, p->text.path, p->text.line, err);
}

static int fail(const struct ply *p, const char *record, const char *what, struct sph_error *err) {
    return sph_fail(err, "%s:%u: `%s`: %s", p->text.path, p->text.line, record, what);
}

/* ---- head ---- */

static int is_one_of(const char *word, const char *list) {
    size_t n = strlen(word);
    for (const char *at = list; (at = strstr(at, word)) != NULL; at += n)
        if ((at == list || at[-1] == ' ') && (at[n] == ' ' || !at[n])) return 1;
    return 0;
}

static int type_of(const char *word) {
    int t = 0;
    while (t < TYPES && (!word || (strcmp(word, types[t].name) && strcmp(word, types[t].other))))
        t++;
    return t;
}

/* Whether assimp gives what a property of a vertex or face says. */
static int is_used(const struct element *e, const char *name) {
    if (!strcmp(e->name, "vertex"))
        return is_one_of(name, "x y z nx ny nz red green blue s t u v texture_u texture_v");
    return is_one_of(name, "vertex_indices vertex_index");
}

static int take_property(struct ply *p, struct sph_error *err) {
    if (!p->n) return fail(p, "property", "no element before it", err);
    struct element *e = &p->element[p->n - 1];
    if (e->n == PROPERTIES) return fail(p, "property", "too many of one element", err);
    struct property *q = &e->property[e->n++];
    const char *word = sph_text_word(&p->text);
    q->length = -1;
    if (word && !strcmp(word, "list")) {
        q->length = type_of(sph_text_word(&p->text));
        word = sph_text_word(&p->text);
        if (q->length == TYPES || types[q->length].real)
            return fail(p, "property", "the length of a list is no whole number", err);
    }
    q->type = type_of(word);
    if (q->type == TYPES) return fail(p, "property", "unknown type of number", err);
    word = sph_text_word(&p->text);
    if (!word || strlen(word) >= NAME) return fail(p, "property", "no name, or too long", err);
    snprintf(q->name, sizeof q->name, "%s", word);
    if (!strcmp(e->name, "vertex") && !strcmp(word, "red") && !types[q->type].real)
        p->lines->srgb = 1;
    if (!strcmp(e->name, "vertex") || e->faces)
        return note(p, is_used(e, word) ? SPH_READ_WORD : SPH_READ_PROPERTY, err);
    return 0;
}

static int take_element(struct ply *p, struct sph_error *err) {
    if (p->n == ELEMENTS) return fail(p, "element", "too many", err);
    struct element *e = &p->element[p->n++];
    const char *word = sph_text_word(&p->text), *count = sph_text_word(&p->text);
    if (!word || strlen(word) >= NAME) return fail(p, "element", "no name, or too long", err);
    snprintf(e->name, sizeof e->name, "%s", word);
    e->faces = !strcmp(word, "face");
    if (!count || sph_parse_count(count, 0, UINT32_MAX, &e->count))
        return fail(p, "element", "the number of elements is none", err);
    if (!strcmp(word, "vertex")) p->vertices = e->count;
    if (e->faces || !strcmp(word, "vertex")) return note(p, SPH_READ_WORD, err);
    return sph_ledger_add(&p->scene->ledger, SPH_READ_UNSUPPORTED, e->count, p->text.path,
                          p->text.line, 0, err);
}

static int take_format(struct ply *p, struct sph_error *err) {
    const char *word = sph_text_word(&p->text);
    int f = 0;
    while (f <= BIG && (!word || strcmp(word, formats[f]) != 0))
        f++;
    if (f > BIG) return fail(p, "format", "none of ascii, binary_little_endian and so on", err);
    p->format = f;
    return 0;
}

/* Up to end_header. */
static int take_head(struct ply *p, struct sph_error *err) {
    int formatted = 0, bad = 0;
    while (!bad && sph_text_line(&p->text)) {
        const char *word = sph_text_word(&p->text);
        if (!word || !strcmp(word, "comment") || !strcmp(word, "obj_info")) continue;
        if (p->text.line == 1) {
            if (strcmp(word, "ply") != 0) return fail(p, "ply", "is not the first word", err);
        } else if (!strcmp(word, "end_header")) {
            return formatted ? 0 : fail(p, "format", "is missing", err);
        } else if (!strcmp(word, "format")) {
            bad = take_format(p, err);
            formatted = 1;
        } else if (!strcmp(word, "element")) {
            bad = take_element(p, err);
        } else if (!strcmp(word, "property")) {
            bad = take_property(p, err);
        } else {
            bad = fail(p, "ply", "unknown word in the head", err);
        }
    }
    return bad ? -1 : fail(p, "ply", "the file ends before end_header", err);
}

/* ---- numbers ---- */

/* The number of a binary file at that place. */
static double number_at(const struct ply *p, int type, const char *at) {
    uint64_t bits = 0;
    size_t size = types[type].size;
    for (size_t i = 0; i < size; i++) {
        size_t from = p->format == BIG ? i : size - 1 - i;
        bits = bits << 8 | (uint8_t)at[from];
    }
    if (types[type].real) {
        float f;
        double d;
        uint32_t low = (uint32_t)bits;
        memcpy(&f, &low, sizeof f);
        memcpy(&d, &bits, sizeof d);
        return size == 4 ? (double)f : d;
    }
    if (!types[type].sign) return (double)bits;
    return size == 1 ? (int8_t)bits : size == 2 ? (int16_t)bits : (int32_t)bits;
}

/* The next number of element `which`. Of text a line has one element, which has begun. */
static int take_number(struct ply *p, const struct element *e, uint64_t which, const char *name,
                       int type, double *value, struct sph_error *err) {
    if (p->format == ASCII) {
        if (sph_text_number(&p->text, e->name, name, value, err)) return -1;
        if (types[type].real || *value == floor(*value)) return 0;
        return fail(p, e->name, "not a whole number", err);
    }
    size_t size = types[type].size;
    if ((size_t)(p->text.end - p->text.at) < size)
        return sph_fail(err, "%s: the file ends within %s %" PRIu64 " of %" PRIu64, p->text.path,
                        e->name, which, e->count);
    *value = number_at(p, type, p->text.at);
    p->text.at += size;
    if (fabs(*value) <= SPH_NUMBER_MAX) return 0; /* not if it is no number */
    return sph_fail(err, "%s: %s %" PRIu64 ": %s is not a number, or too large", p->text.path,
                    e->name, which, name);
}

/* A list of corners. */
static int take_corners(struct ply *p, const struct element *e, uint64_t which,
                        const struct property *q, uint64_t n, struct sph_error *err) {
    for (uint64_t i = 0; i < n; i++) {
        double v = 0;
        if (take_number(p, e, which, q->name, q->type, &v, err)) return -1;
        if (!(v >= 0 && v < (double)p->vertices))
            return p->format == ASCII
                       ? sph_fail(err, "%s:%u: `face`: vertex %g is none of 0 to %" PRId64,
                                  p->text.path, p->text.line, v, (int64_t)p->vertices - 1)
                       : sph_fail(err, "%s: face %" PRIu64 ": vertex %g is none of 0 to %" PRId64,
                                  p->text.path, which, v, (int64_t)p->vertices - 1);
    }
    if (n < 3) {
        if (!p->lines->part) p->lines->part = p->format == ASCII ? p->text.line : 0;
        return 0;
    }
    return p->format == ASCII ? sph_mesh_lines_add(p->lines, p->text.line, err) : 0;
}

static int take_row(struct ply *p, const struct element *e, uint64_t which, struct sph_error *err) {
    double value = 0;
    for (int i = 0; i < e->n; i++) {
        const struct property *q = &e->property[i];
        if (q->length < 0) {
            if (take_number(p, e, which, q->name, q->type, &value, err)) return -1;
            continue;
        }
        if (take_number(p, e, which, "the length of the list", q->length, &value, err)) return -1;
        if (!(value >= 0)) return fail(p, e->name, "the length of the list is negative", err);
        uint64_t n = (uint64_t)value;
        if (e->faces && is_used(e, q->name)) {
            if (take_corners(p, e, which, q, n, err)) return -1;
            continue;
        }
        while (n--)
            if (take_number(p, e, which, q->name, q->type, &value, err)) return -1;
    }
    return 0;
}

/* The line of the next element, past empty ones. */
static int next_row(struct ply *p, const struct element *e, uint64_t which, struct sph_error *err) {
    do
        if (!sph_text_line(&p->text))
            return sph_fail(err, "%s:%u: the file ends after %" PRIu64 " of %" PRIu64 " %s",
                            p->text.path, p->text.line, which, e->count, e->name);
    while (!p->text.rest[strspn(p->text.rest, " \t")]);
    return 0;
}

static int take_rows(struct ply *p, const struct element *e, struct sph_error *err) {
    for (uint64_t i = 0; i < e->count && e->n; i++) {
        if ((p->format == ASCII && next_row(p, e, i, err)) || take_row(p, e, i, err)) return -1;
        if (p->format == ASCII && sph_text_word(&p->text))
            return fail(p, e->name, "more numbers than properties", err);
        if (!strcmp(e->name, "vertex") && note(p, SPH_READ_CORNER, err)) return -1;
    }
    return 0;
}

int sph_ply_check(const char *path, struct sph_scene *scene, struct sph_mesh_lines *lines,
                  struct sph_error *err) {
    static const char *const axes[] = {"x", "y", "z"};
    struct ply p = {.scene = scene, .lines = lines};
    if (sph_text_open(&p.text, path, err)) return -1;
    int bad = take_head(&p, err), found = 0;
    for (int i = 0; i < p.n && !bad; i++) {
        for (int k = 0; k < p.element[i].n && !strcmp(p.element[i].name, "vertex"); k++)
            for (int a = 0; a < 3; a++)
                found += !strcmp(p.element[i].property[k].name, axes[a]);
        bad = take_rows(&p, &p.element[i], err);
    }
    if (!bad && found != 3) bad = sph_fail(err, "%s: no element vertex with x, y, z", path);
    sph_text_close(&p.text);
    return bad ? -1 : 0;
}
