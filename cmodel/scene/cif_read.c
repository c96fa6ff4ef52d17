/* cif_read.c - atoms of an mmCIF file; see atoms.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * A CIF file is a sequence of words: names that begin with _, data_..., loop_, and values, which
 * may be quoted, or whole lines between lines that begin with ; (Hall, Allen and Brown 1991). Of
 * these the loop of _atom_site is read, in whatever order its names stand.
 */
#include <string.h>
#include <strings.h>

#include "common/number.h"
#include "scene/atoms.h"

struct words {
    struct sph_lines lines;
    char *at;   /* what is left of the line; NULL: a new one is wanted */
    char *word; /* the newest one */
    int quoted;
};

enum {
    SYMBOL,
    NAME,
    PLACE,
    RESIDUE,
    CHAIN,
    NUMBER,
    INSERT,
    X,
    Y,
    Z,
    OCCUPANCY,
    MODEL,
    GROUP,
    FIELDS
};

static const char *const names[FIELDS] = {
    "type_symbol", "label_atom_id",      "label_alt_id", "label_comp_id", "auth_asym_id",
    "auth_seq_id", "pdbx_PDB_ins_code",  "Cartn_x",      "Cartn_y",       "Cartn_z",
    "occupancy",   "pdbx_PDB_model_num", "group_PDB"};

/* Passes a text of whole lines; its word is empty. */
static int pass_text(struct words *w, struct sph_error *err) {
    uint32_t first = w->lines.line;
    int got;
    while ((got = sph_lines_next(&w->lines, err)) > 0 && w->lines.text[0] != ';')
        ;
    if (!got) return sph_fail(err, "%s:%u: a text without an end", w->lines.path, first);
    w->at = w->lines.text + 1;
    w->word = w->lines.text;
    w->word[0] = 0;
    w->quoted = 1;
    return got;
}

/* The next word. 1, 0 at the end of the file, -1 with a message. */
static int next_word(struct words *w, struct sph_error *err) {
    for (;;) {
        if (!w->at) {
            int got = sph_lines_next(&w->lines, err);
            if (got <= 0) return got;
            if (w->lines.text[0] == ';') return pass_text(w, err);
            w->at = w->lines.text;
        }
        w->at += strspn(w->at, " \t");
        if (*w->at && *w->at != '#') break;
        w->at = NULL;
    }
    w->quoted = *w->at == '\'' || *w->at == '"';
    if (!w->quoted) {
        w->word = w->at;
        w->at += strcspn(w->at, " \t");
    } else {
        char quote = *w->at;
        w->word = w->at + 1;
        do { /* a quote within a word ends nothing */
            w->at = strchr(w->at + 1, quote);
        } while (w->at && w->at[1] && w->at[1] != ' ' && w->at[1] != '\t');
        if (!w->at)
            return sph_fail(err, "%s:%u: the line ends before the second quote", w->lines.path,
                            w->lines.line);
    }
    if (*w->at) *w->at++ = 0;
    return 1;
}

static int is_value(const struct words *w) {
    return w->quoted ||
           (w->word[0] != '_' && strcasecmp(w->word, "loop_") != 0 &&
            strncasecmp(w->word, "data_", 5) != 0 && strncasecmp(w->word, "save_", 5) != 0);
}

/* A value's text; `.` and `?` say nothing. */
static void keep(const struct words *w, char *to, size_t size) {
    int nothing = !w->quoted && (!strcmp(w->word, ".") || !strcmp(w->word, "?"));
    snprintf(to, size, "%s", nothing ? "" : w->word);
}

struct row {
    char text[FIELDS][24];
    uint32_t line;
};

static int put_row(const struct row *r, int n, char model[24], struct sph_atoms *atoms,
                   struct sph_scene *scene, struct sph_error *err) {
    struct sph_atom a = {.line = r->line, .polymer = strcmp(r->text[GROUP], "HETATM") != 0};
    if (!atoms->n) memcpy(model, r->text[MODEL], sizeof r->text[MODEL]);
    if (strcmp(model, r->text[MODEL]) != 0)
        return sph_ledger_note(&scene->ledger, SPH_READ_MODEL, scene->path, r->line, err);
    snprintf(a.element, sizeof a.element, "%.3s", r->text[SYMBOL]);
    snprintf(a.name, sizeof a.name, "%.7s", r->text[NAME]);
    snprintf(a.residue, sizeof a.residue, "%.7s", r->text[RESIDUE]);
    snprintf(a.group, sizeof a.group, "%.9s %.9s%.3s", r->text[CHAIN], r->text[NUMBER],
             r->text[INSERT]);
    a.place = r->text[PLACE][0] ? r->text[PLACE][0] : ' ';
    for (int i = 0; i < 3; i++)
        if (sph_parse_number(r->text[X + i], &a.at[i]))
            return sph_fail(err,
                            "%s:%u: _atom_site.%s: `%s` is not a number, in a row of %d values as "
                            "the loop has names",
                            scene->path, r->line, names[X + i], r->text[X + i], n);
    if (sph_parse_number(r->text[OCCUPANCY], &a.occupancy)) a.occupancy = 0;
    return sph_atoms_add(atoms, &a, scene->path, err);
}

/* The loop whose names come next; the first of them is the newest word. What ends it is the newest
 * word then. As next_word(). */
static int take_loop(struct words *w, struct sph_atoms *atoms, struct sph_scene *scene,
                     struct sph_error *err) {
    enum { MOST = 256 };
    int field[MOST], n = 0, got = 1, found = 0;
    char model[24] = "";
    for (; got > 0 && !is_value(w) && w->word[0] == '_'; got = next_word(w, err)) {
        const char *name = !strncasecmp(w->word, "_atom_site.", 11) ? w->word + 11 : "";
        int f = 0;
        while (f < FIELDS && strcasecmp(name, names[f]) != 0)
            f++;
        if (n == MOST)
            return sph_fail(err, "%s:%u: a loop of more than %d names", w->lines.path,
                            w->lines.line, MOST);
        field[n++] = f;
        found |= f < FIELDS ? 1 << f : 0;
    }
    int atoms_here = found & 1 << X && found & 1 << Y && found & 1 << Z;
    while (got > 0 && n && is_value(w)) {
        struct row row = {.line = w->lines.line};
        for (int k = 0; k < n; k++) {
            if (got <= 0 || !is_value(w))
                return got < 0 ? -1
                               : sph_fail(err, "%s:%u: a row of the loop ends before its %d values",
                                          w->lines.path, w->lines.line, n);
            if (field[k] < FIELDS) keep(w, row.text[field[k]], sizeof row.text[0]);
            got = next_word(w, err);
        }
        if (atoms_here && put_row(&row, n, model, atoms, scene, err)) return -1;
    }
    return got;
}

int sph_cif_read(FILE *file, struct sph_atoms *atoms, struct sph_scene *scene,
                 struct sph_error *err) {
    struct words w = {.lines = {.file = file, .path = scene->path}};
    int got = next_word(&w, err);
    while (got > 0) {
        int loop = !w.quoted && !strcasecmp(w.word, "loop_");
        got = next_word(&w, err);
        if (got > 0 && loop) got = take_loop(&w, atoms, scene, err);
    }
    return got;
}
