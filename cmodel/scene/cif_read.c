/* cif_read.c - atoms and bonds of an mmCIF file; see atoms.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * A CIF file is a sequence of words: names that begin with _, data_..., loop_, and values, which
 * may be quoted, or whole lines between lines that begin with ; (Hall, Allen and Brown 1991). Of
 * these atom_site, struct_conn and chem_comp_bond are read (PDBx/mmCIF dictionary), as loops or as
 * single items, in whatever order their names stand. Names of chains, residues and atoms are the
 * authors' (auth_), or where the file has none those of the archive (label_).
 */
#include <string.h>
#include <strings.h>

#include "common/number.h"
#include "scene/atoms.h"

struct words {
    struct sph_lines lines;
    char *at;       /* what is left of the line; NULL: a new one is wanted */
    char *word;     /* the newest one */
    int quoted;     /* it is */
    uint32_t block; /* data_ so far */
};

/* Categories, and their items that are used. */
#define ATOM "_atom_site."
#define CONN "_struct_conn."
#define BOND "_chem_comp_bond."
enum { OF_ATOM, OF_CONN, OF_BOND, OF_OTHER };
#define EACH_ITEM(X)                                                                               \
    X(SYMBOL, OF_ATOM, ATOM "type_symbol")                                                         \
    X(NAME, OF_ATOM, ATOM "label_atom_id")                                                         \
    X(NAME_AUTH, OF_ATOM, ATOM "auth_atom_id")                                                     \
    X(PLACE, OF_ATOM, ATOM "label_alt_id")                                                         \
    X(RESIDUE, OF_ATOM, ATOM "label_comp_id")                                                      \
    X(RESIDUE_AUTH, OF_ATOM, ATOM "auth_comp_id")                                                  \
    X(CHAIN, OF_ATOM, ATOM "label_asym_id")                                                        \
    X(CHAIN_AUTH, OF_ATOM, ATOM "auth_asym_id")                                                    \
    X(NUMBER, OF_ATOM, ATOM "label_seq_id")                                                        \
    X(NUMBER_AUTH, OF_ATOM, ATOM "auth_seq_id")                                                    \
    X(INSERT, OF_ATOM, ATOM "pdbx_PDB_ins_code")                                                   \
    X(AT_X, OF_ATOM, ATOM "Cartn_x")                                                               \
    X(AT_Y, OF_ATOM, ATOM "Cartn_y")                                                               \
    X(AT_Z, OF_ATOM, ATOM "Cartn_z")                                                               \
    X(OCCUPANCY, OF_ATOM, ATOM "occupancy")                                                        \
    X(MODEL, OF_ATOM, ATOM "pdbx_PDB_model_num")                                                   \
    X(GROUP, OF_ATOM, ATOM "group_PDB")                                                            \
    X(CONN_KIND, OF_CONN, CONN "conn_type_id")                                                     \
    X(CHAIN_1, OF_CONN, CONN "ptnr1_label_asym_id")                                                \
    X(CHAIN_2, OF_CONN, CONN "ptnr2_label_asym_id")                                                \
    X(CHAIN_AUTH_1, OF_CONN, CONN "ptnr1_auth_asym_id")                                            \
    X(CHAIN_AUTH_2, OF_CONN, CONN "ptnr2_auth_asym_id")                                            \
    X(NUMBER_1, OF_CONN, CONN "ptnr1_label_seq_id")                                                \
    X(NUMBER_2, OF_CONN, CONN "ptnr2_label_seq_id")                                                \
    X(NUMBER_AUTH_1, OF_CONN, CONN "ptnr1_auth_seq_id")                                            \
    X(NUMBER_AUTH_2, OF_CONN, CONN "ptnr2_auth_seq_id")                                            \
    X(INSERT_1, OF_CONN, CONN "pdbx_ptnr1_PDB_ins_code")                                           \
    X(INSERT_2, OF_CONN, CONN "pdbx_ptnr2_PDB_ins_code")                                           \
    X(NAME_1, OF_CONN, CONN "ptnr1_label_atom_id")                                                 \
    X(NAME_2, OF_CONN, CONN "ptnr2_label_atom_id")                                                 \
    X(CELL_1, OF_CONN, CONN "ptnr1_symmetry")                                                      \
    X(CELL_2, OF_CONN, CONN "ptnr2_symmetry")                                                      \
    X(COMPONENT, OF_BOND, BOND "comp_id")                                                          \
    X(ATOM_1, OF_BOND, BOND "atom_id_1")                                                           \
    X(ATOM_2, OF_BOND, BOND "atom_id_2")

enum {
#define ITEM(item, of, name) item,
    EACH_ITEM(ITEM)
#undef ITEM
        ITEMS
};

static const struct {
    const char *name;
    int of;
} items[ITEMS] = {
#define ITEM(item, of, name) {name, of},
    EACH_ITEM(ITEM)
#undef ITEM
};

static int item_of(const char *word) {
    int i = 0;
    while (i < ITEMS && strcasecmp(word, items[i].name) != 0)
        i++;
    return i;
}

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
    if (!w->quoted && !strncasecmp(w->word, "data_", 5)) w->block++;
    return 1;
}

static int is_name(const struct words *w) {
    return !w->quoted && w->word[0] == '_';
}

static int is_value(const struct words *w) {
    return w->quoted ||
           (w->word[0] != '_' && strcasecmp(w->word, "loop_") != 0 &&
            strncasecmp(w->word, "data_", 5) != 0 && strncasecmp(w->word, "save_", 5) != 0);
}

/* Values of one row of a category; of an item that is not there, or of which `.` or `?` says that
 * nothing is known, it is empty. */
struct row {
    char text[ITEMS][64];
    int of, n;      /* category; values */
    uint32_t line;  /* where it starts, 0: there is none */
    uint32_t block; /* that it stands in */
};

struct cif {
    struct words words;
    struct sph_atoms *atoms;
    struct sph_scene *scene;
    char model[64]; /* of the first atom, and its block */
    uint32_t block;
};

static void keep(const struct words *w, struct row *row, int item) {
    int nothing = !w->quoted && (!strcmp(w->word, ".") || !strcmp(w->word, "?"));
    if (item < ITEMS)
        snprintf(row->text[item], sizeof row->text[item], "%s", nothing ? "" : w->word);
}

static const char *either(const struct row *r, int first, int second) {
    return r->text[first][0] ? r->text[first] : r->text[second];
}

/* Which residue: as of an atom, or of an end of a bond. */
static void group_of(char group[24], const char *chain, const char *number, const char *insert) {
    snprintf(group, 24, "%.9s %.9s%.3s", chain, number, insert);
}

/* A number, of which the last digits' error may stand behind in brackets: 1.234(5). */
static int parse_number(const char *text, double *to) {
    char bare[sizeof((struct row *)0)->text[0]];
    size_t n = strcspn(text, "("), digits = strspn(text + n + (text[n] == '('), "0123456789");
    int error = text[n] == '(' && digits && !strcmp(text + n + 1 + digits, ")");
    snprintf(bare, sizeof bare, "%.*s", (int)(error ? n : strlen(text)), text);
    return strlen(text) + 1 < sizeof bare ? sph_parse_number(bare, to) : -1;
}

static int put_atom(struct cif *c, const struct row *r, struct sph_error *err) {
    const char *path = c->scene->path;
    struct sph_atom a = {.line = r->line, .polymer = strcmp(r->text[GROUP], "HETATM") != 0};
    if (!c->atoms->n) memcpy(c->model, r->text[MODEL], sizeof c->model), c->block = r->block;
    if (strcmp(c->model, r->text[MODEL]) != 0 || c->block != r->block)
        return sph_ledger_note(&c->scene->ledger, SPH_READ_MODEL, path, r->line, err);
    const char *chain = either(r, CHAIN_AUTH, CHAIN);
    snprintf(a.element, sizeof a.element, "%.3s", r->text[SYMBOL]);
    snprintf(a.name, sizeof a.name, "%.7s", either(r, NAME, NAME_AUTH));
    snprintf(a.residue, sizeof a.residue, "%.7s", either(r, RESIDUE, RESIDUE_AUTH));
    snprintf(a.chain, sizeof a.chain, "%.11s", chain);
    group_of(a.group, chain, either(r, NUMBER_AUTH, NUMBER), r->text[INSERT]);
    a.place = r->text[PLACE][0] ? r->text[PLACE][0] : ' ';
    for (int i = 0; i < 3; i++)
        if (parse_number(r->text[AT_X + i], &a.at[i]))
            return sph_fail(err, "%s:%u: %s: `%.60s` is not a number, in a row of %d values", path,
                            r->line, items[AT_X + i].name, r->text[AT_X + i], r->n);
    if (parse_number(r->text[OCCUPANCY], &a.occupancy)) a.occupancy = 0;
    return sph_atoms_add(c->atoms, &a, path, err);
}

/* Bonds of shared electrons, and of metals, which the file says; hydrogen bonds are none. */
static int put_conn(struct cif *c, const struct row *r, struct sph_error *err) {
    static const char *const kinds[] = {"covale", "disulf", "metalc", "modres"};
    struct sph_bond bond = {.of = SPH_BOND_ATOMS, .line = r->line};
    int known = !r->text[CONN_KIND][0];
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        known |= !strncasecmp(r->text[CONN_KIND], kinds[i], strlen(kinds[i]));
    enum sph_read none = !known                                          ? SPH_READ_BOND_WEAK
                         : strcmp(r->text[CELL_1], r->text[CELL_2]) != 0 ? SPH_READ_BOND_FAR
                                                                         : SPH_READS;
    if (none != SPH_READS)
        return sph_ledger_note(&c->scene->ledger, none, c->scene->path, r->line, err);
    for (int i = 0; i < 2; i++) {
        group_of(bond.group[i], either(r, CHAIN_AUTH_1 + i, CHAIN_1 + i),
                 either(r, NUMBER_AUTH_1 + i, NUMBER_1 + i), r->text[INSERT_1 + i]);
        snprintf(bond.atom[i], sizeof bond.atom[i], "%.11s", r->text[NAME_1 + i]);
    }
    return sph_ledger_note(&c->scene->ledger, SPH_READ_BONDS, c->scene->path, r->line, err) ||
                   sph_atoms_bond(c->atoms, &bond, c->scene->path, err)
               ? -1
               : 0;
}

static int put_component(struct cif *c, const struct row *r, struct sph_error *err) {
    struct sph_bond bond = {.of = SPH_BOND_RESIDUES, .line = r->line};
    snprintf(bond.group[0], sizeof bond.group[0], "%.7s", r->text[COMPONENT]);
    snprintf(bond.atom[0], sizeof bond.atom[0], "%.11s", r->text[ATOM_1]);
    snprintf(bond.atom[1], sizeof bond.atom[1], "%.11s", r->text[ATOM_2]);
    return sph_ledger_note(&c->scene->ledger, SPH_READ_BONDS, c->scene->path, r->line, err) ||
                   sph_atoms_bond(c->atoms, &bond, c->scene->path, err)
               ? -1
               : 0;
}

/* A row ends; it is empty then. */
static int put_row(struct cif *c, struct row *r, struct sph_error *err) {
    if (!r->line) return 0;
    int bad = r->of == OF_ATOM   ? put_atom(c, r, err)
              : r->of == OF_CONN ? put_conn(c, r, err)
              : r->of == OF_BOND ? put_component(c, r, err)
                                 : sph_ledger_note(&c->scene->ledger, SPH_READ_NO_ATOM,
                                                   c->scene->path, r->line, err);
    memset(r, 0, sizeof *r);
    return bad;
}

/* Passes values behind a row of atoms on its own line, which no name is left for: the next row says
 * ATOM or HETATM first. As next_word(). */
static int pass_rest(struct cif *c, uint32_t line, struct sph_error *err) {
    struct words *w = &c->words;
    int got = 1, rest = 0;
    while (got > 0 && w->lines.line == line && is_value(w) && strcmp(w->word, "ATOM") != 0 &&
           strcmp(w->word, "HETATM") != 0)
        rest = 1, got = next_word(w, err);
    if (rest && sph_ledger_note(&c->scene->ledger, SPH_READ_ROW_LONG, c->scene->path, line, err))
        return -1;
    return got;
}

/* The loop whose names come next; the first of them is the newest word. What ends it is the newest
 * word then. As next_word(). */
static int take_loop(struct cif *c, struct sph_error *err) {
    enum { MOST = 256 };
    struct words *w = &c->words;
    struct row row = {.line = 0};
    int item[MOST], n = 0, got = 1, of = OF_OTHER;
    for (; got > 0 && is_name(w); got = next_word(w, err)) {
        if (n == MOST)
            return sph_fail(err, "%s:%u: a loop of more than %d names", w->lines.path,
                            w->lines.line, MOST);
        item[n] = item_of(w->word);
        if (item[n] < ITEMS) of = items[item[n]].of;
        n++;
    }
    while (got > 0 && n && is_value(w)) {
        uint32_t line = w->lines.line;
        row.of = of, row.line = line, row.n = n, row.block = w->block;
        for (int k = 0; k < n; k++) {
            if (got <= 0 || !is_value(w))
                return got < 0 ? -1
                               : sph_fail(err, "%s:%u: a row of the loop ends before its %d values",
                                          w->lines.path, w->lines.line, n);
            keep(w, &row, item[k]);
            got = next_word(w, err);
        }
        if (put_row(c, &row, err)) return -1;
        if (got > 0 && item[0] == GROUP) got = pass_rest(c, line, err);
    }
    return got;
}

/* A single item, whose name is the newest word: it belongs to a row with others of its category. */
static int take_item(struct cif *c, struct row *row, struct sph_error *err) {
    struct words *w = &c->words;
    int item = item_of(w->word), of = item < ITEMS ? items[item].of : OF_OTHER;
    if ((of != row->of || of == OF_OTHER) && put_row(c, row, err)) return -1;
    if (!row->line) row->line = w->lines.line;
    row->of = of, row->block = w->block, row->n++;
    int got = next_word(w, err);
    if (got <= 0 || !is_value(w)) return got;
    keep(w, row, item);
    return next_word(w, err);
}

int sph_cif_read(FILE *file, struct sph_atoms *atoms, struct sph_scene *scene,
                 struct sph_error *err) {
    struct cif c = {.words = {.lines = {.file = file, .path = scene->path}}, atoms, scene, "", 0};
    struct row row = {.line = 0};
    int got = next_word(&c.words, err);
    while (got > 0) {
        if (is_name(&c.words)) {
            got = take_item(&c, &row, err);
            continue;
        }
        int loop = !c.words.quoted && !strcasecmp(c.words.word, "loop_");
        if (put_row(&c, &row, err)) return -1;
        got = next_word(&c.words, err);
        if (got > 0 && loop) got = take_loop(&c, err);
    }
    return got < 0 || put_row(&c, &row, err) ? -1 : 0;
}
