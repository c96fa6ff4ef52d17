/* elements.c - see elements.h; reads XML with expat
 * SPDX-License-Identifier: Apache-2.0
 *
 * What is used of the file:
 *   <atom id="C"> <scalar dictRef="bo:radiusCovalent">0.77</scalar>
 *                 <scalar dictRef="bo:radiusVDW">1.7</scalar>
 *                 <array dictRef="bo:elementColor">0.50 0.50 0.50</array>
 *                 <scalar dictRef="bo:family">Non-Metal</scalar> </atom>
 */
#include "scene/elements.h"
#include "common/file.h"
#include "scene/nff_lex.h"

#include <errno.h>
#include <expat.h>
#include <string.h>
#include <strings.h>

struct parse {
    XML_Parser parser;
    const char *path;
    struct sph_elements *elements;
    struct sph_error *err;
    int in_atom;
    enum { NOTHING, RADIUS, COVALENT, COLOUR, FAMILY } field;
    char text[64]; /* of the field */
    size_t n_text;
};

static unsigned long line_of(const struct parse *p) {
#if XML_MAJOR_VERSION * 1000 + XML_MINOR_VERSION >= 2009
    return (unsigned long)XML_GetCurrentLineNumber64(p->parser);
#else
    return (unsigned long)XML_GetCurrentLineNumber(p->parser);
#endif
}

static void stop(struct parse *p, const char *what) {
    sph_fail(p->err, "%s:%lu: %s", p->path, line_of(p), what);
    XML_StopParser(p->parser, XML_FALSE);
}

static void on_start(void *data, const char *name, const char **attributes) {
    struct parse *p = data;
    const char *id = "", *ref = "";
    for (int i = 0; attributes[i]; i += 2) {
        if (!strcmp(attributes[i], "id")) id = attributes[i + 1];
        if (!strcmp(attributes[i], "dictRef")) ref = attributes[i + 1];
    }
    if (!strcmp(name, "atom")) {
        if (p->elements->n == SPH_MAX_ELEMENTS) {
            stop(p, "too many elements");
            return;
        }
        struct sph_element *e = &p->elements->list[p->elements->n++];
        memset(e, 0, sizeof *e);
        snprintf(e->symbol, sizeof e->symbol, "%s", id);
        p->in_atom = 1;
    }
    p->n_text = 0;
    p->field = !p->in_atom                         ? NOTHING
               : !strcmp(ref, "bo:radiusVDW")      ? RADIUS
               : !strcmp(ref, "bo:radiusCovalent") ? COVALENT
               : !strcmp(ref, "bo:elementColor")   ? COLOUR
               : !strcmp(ref, "bo:family")         ? FAMILY
                                                   : NOTHING;
}

static void on_text(void *data, const char *text, int n) {
    struct parse *p = data;
    size_t room = sizeof p->text - 1 - p->n_text, take = (size_t)n < room ? (size_t)n : room;
    if (p->field == NOTHING) return;
    memcpy(p->text + p->n_text, text, take);
    p->n_text += take;
}

/* Reads up to 3 numbers from the text of the field; how many. */
static int numbers(struct parse *p, double value[3]) {
    int n = 0;
    char *rest = p->text;
    for (char *word; n < 3 && (word = strtok_r(rest, " \t\r\n", &rest)) != NULL; n++)
        if (sph_parse_number(word, &value[n])) return n;
    return n;
}

/* Whether a family of elements bonds by sharing electrons. */
static int shares(const char *family) {
    return !strcmp(family, "Non-Metal") || !strcmp(family, "Halogen") ||
           !strcmp(family, "Metalloids");
}

static void take_field(struct parse *p, struct sph_element *e) {
    double value[3] = {0};
    int n = numbers(p, value);
    if (n != (p->field == COLOUR ? 3 : 1))
        stop(p, "not a radius or colour");
    else if (p->field == RADIUS)
        e->rad = value[0];
    else if (p->field == COVALENT)
        e->covalent = value[0];
    else
        memcpy(e->rgb, value, sizeof e->rgb);
}

static void on_end(void *data, const char *name) {
    struct parse *p = data;
    if (p->field != NOTHING) {
        struct sph_element *e = &p->elements->list[p->elements->n - 1];
        p->text[p->n_text] = 0;
        if (p->field == FAMILY)
            e->shares = shares(p->text);
        else
            take_field(p, e);
    }
    p->field = NOTHING;
    if (!strcmp(name, "atom")) p->in_atom = 0;
}

static int parse_file(struct parse *p, FILE *file) {
    char buf[16384];
    size_t n;
    do {
        n = fread(buf, 1, sizeof buf, file);
        if (ferror(file)) return sph_fail(p->err, "%s: cannot read: %s", p->path, strerror(errno));
        if (XML_Parse(p->parser, buf, (int)n, n == 0) != XML_STATUS_OK)
            return sph_fail(p->err, "%s:%lu: %s", p->path, line_of(p),
                            XML_ErrorString(XML_GetErrorCode(p->parser)));
    } while (n > 0);
    return p->elements->n > 1 ? 0 : sph_fail(p->err, "%s: no elements in this file", p->path);
}

int sph_elements_read(const char *path, struct sph_elements *elements, struct sph_error *err) {
    struct parse p = {.path = path, .elements = elements, .err = err};
    elements->n = 0;
    struct sph_error why = {""};
    FILE *file = sph_input_open(path, SPH_INPUT_ANY, &why);
    if (!file)
        return sph_fail(err, "%.400s; van der Waals radii are in the Debian package bodr",
                        why.text);
    p.parser = XML_ParserCreate(NULL);
    int bad = -1;
    if (!p.parser) {
        sph_fail(err, "%s: no memory to read", path);
    } else {
        XML_SetUserData(p.parser, &p);
        XML_SetElementHandler(p.parser, on_start, on_end);
        XML_SetCharacterDataHandler(p.parser, on_text);
        bad = parse_file(&p, file);
        XML_ParserFree(p.parser);
    }
    fclose(file);
    return bad;
}

int sph_elements_find(const struct sph_elements *elements, const char *symbol) {
    if (!strcasecmp(symbol, "D") || !strcasecmp(symbol, "T")) symbol = "H";
    for (int i = 0; i < elements->n; i++)
        if (!strcasecmp(symbol, elements->list[i].symbol)) return i;
    return -1;
}
