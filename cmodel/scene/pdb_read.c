/* pdb_read.c - atoms of a file of the Protein Data Bank; see atoms.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * Columns of an ATOM or HETATM record, from 1 (PDB format 3.30, section 9):
 *   7-11 serial number   13-16 atom name   17 alternate location   18-21 residue (CHARMM has four
 *   letters)   22-27 chain, number, insertion code   31-38, 39-46, 47-54 x, y, z   55-60 occupancy
 *   73-76 segment   77-78 element, right-justified   79-80 charge
 * and of a CONECT record 7-11, 12-16, ... 27-31: an atom, and those that it is bonded to. Serial
 * numbers are words, not numbers: they may be hybrid-36, or seven digits without a blank before.
 * Files of before 1996 number their lines in columns 73-80 instead: an element counts only if
 * columns 79-80 are blank or a charge. Writers that have too little room for a number shift all
 * behind it: the points of the coordinates tell how far.
 */
#include <ctype.h>
#include <string.h>

#include "common/number.h"
#include "scene/atoms.h"

/* Columns first..last (from 1) of the line without blanks at both ends; shorter lines are as if
 * filled up with blanks. */
static void column(const char *line, int first, int last, char *out) {
    int length = (int)strlen(line), n = 0;
    for (int i = first - 1; i < last && i < length; i++)
        if (n > 0 || line[i] != ' ') out[n++] = line[i];
    while (n > 0 && out[n - 1] == ' ')
        n--;
    out[n] = 0;
}

/* The element that columns 77-78 say, or 76-77, where a writer puts it a column to the left. */
static void take_element(const char *line, char symbol[4]) {
    char charge[3];
    column(line, 77, 78, symbol);
    column(line, 79, 80, charge);
    int charged = strlen(charge) == 2 && isdigit((unsigned char)charge[0]) &&
                  (charge[1] == '+' || charge[1] == '-');
    if (charge[0] && !charged) symbol[0] = 0;
    if (strlen(line) > 76 && isalpha((unsigned char)line[75]) && line[74] == ' ' &&
        isalpha((unsigned char)line[76]) && (!line[77] || line[77] == ' '))
        column(line, 76, 77, symbol);
}

/* Whether the points of the coordinates stand where they should, `by` columns to the right. */
static int points_at(const char *line, int by) {
    int length = (int)strlen(line);
    for (int i = 0; i < 3; i++) {
        int at = 34 + 8 * i + by;
        if (at < 0 || at >= length || line[at] != '.') return 0;
    }
    return 1;
}

/* How far the columns are shifted; 0 too if that cannot be told. */
static int shift_of(const char *line) {
    static const int by[] = {0, 1, -1, 2, -2};
    for (int i = 0; i < 5; i++)
        if (points_at(line, by[i])) return by[i];
    return 0;
}

static int take_atom(const struct sph_lines *lines, struct sph_atoms *atoms,
                     struct sph_scene *scene, struct sph_error *err) {
    static const char *const names[] = {"x (columns 31-38)", "y (columns 39-46)",
                                        "z (columns 47-54)"};
    struct sph_atom a = {.line = lines->line, .polymer = lines->text[0] == 'A'};
    const char *line = lines->text;
    char text[16];
    int by = shift_of(line);
    if (strlen(line) < 54u + (unsigned)by)
        return sph_fail(err, "%s:%u: atom record of %zu characters: coordinates end in column 54",
                        lines->path, lines->line, strlen(line));
    column(line, 13 + by, 16 + by, a.name);
    memcpy(a.columns, line + 12 + by, 4);
    a.place = line[16 + by];
    column(line, 18 + by, 21 + by, a.residue);
    column(line, 22 + by, 27 + by, a.group);
    column(line, 7, 11 + by, a.serial);
    a.chain[0] = line[21 + by];
    if (a.chain[0] == ' ') column(line, 73 + by, 76 + by, a.chain);
    for (int i = 0; i < 3; i++) {
        column(line, 31 + 8 * i + by, 38 + 8 * i + by, text);
        if (sph_parse_number(text, &a.at[i]) || strpbrk(text, "eE")) /* 8.3 digits */
            return sph_fail(err, "%s:%u: %s: `%s` is not a number", lines->path, lines->line,
                            names[i], text);
    }
    column(line, 55 + by, 60 + by, text);
    if (sph_parse_number(text, &a.occupancy)) a.occupancy = 0;
    if (by >= 0 && strlen(line) > (size_t)by) take_element(line + by, a.element);
    if (by && sph_ledger_note(&scene->ledger, SPH_READ_SHIFTED, lines->path, lines->line, err))
        return -1;
    return sph_atoms_add(atoms, &a, lines->path, err);
}

/* Whether a line starts with this word, and a blank or a digit follows. */
static int is_record(const char *line, const char *word) {
    size_t n = strlen(word);
    return !strncmp(line, word, n) &&
           (line[n] == ' ' || isdigit((unsigned char)line[n]) || (n == 6 && line[n]));
}

/* The words of a CONECT record: five columns each, or between blanks where one has more. How many,
 * and no more than there are bonds of shared electrons. */
enum { CONECT_MOST = 5 };
static int conect_words(const char *line, char words[CONECT_MOST][12]) {
    int n = 0, wide = 0;
    for (int i = 0; i < CONECT_MOST; i++) {
        column(line, 7 + 5 * i, 11 + 5 * i, words[i]);
        wide |= strchr(words[i], ' ') != NULL;
        if (words[i][0]) n = i + 1;
    }
    const char *at = line + 6;
    for (n = wide ? 0 : n; wide && n < CONECT_MOST; n++) {
        at += strspn(at, " ");
        size_t length = strcspn(at, " ");
        if (!length) break;
        snprintf(words[n], sizeof words[n], "%.*s", (int)length, at);
        at += length;
    }
    return n;
}

static int take_bonds(const struct sph_lines *lines, struct sph_atoms *atoms,
                      struct sph_scene *scene, struct sph_error *err) {
    enum { LAST = 31, WEAK_LAST = 61 }; /* hydrogen bonds and salt bridges, before 2007 */
    char words[CONECT_MOST][12], weak[WEAK_LAST - LAST + 1];
    int n = conect_words(lines->text, words);
    column(lines->text, LAST + 1, WEAK_LAST, weak);
    if (weak[0] &&
        sph_ledger_note(&scene->ledger, SPH_READ_BOND_WEAK, lines->path, lines->line, err))
        return -1;
    for (int i = 1; i < n; i++) {
        struct sph_bond bond = {.of = SPH_BOND_SERIALS, .line = lines->line};
        memcpy(bond.atom[0], words[0], sizeof bond.atom[0]);
        memcpy(bond.atom[1], words[i], sizeof bond.atom[1]);
        if (words[i][0] && sph_atoms_bond(atoms, &bond, lines->path, err)) return -1;
    }
    return sph_ledger_note(&scene->ledger, SPH_READ_BONDS, lines->path, lines->line, err);
}

/* Whether a line ends the first model: ENDMDL, or END and blanks. */
static int is_end(const char *line) {
    return !strncmp(line, "ENDMDL", 6) ||
           (!strncmp(line, "END", 3) && strspn(line + 3, " \t") == strlen(line + 3));
}

int sph_pdb_read(FILE *file, struct sph_atoms *atoms, struct sph_scene *scene,
                 struct sph_error *err) {
    struct sph_lines lines = {.file = file, .path = scene->path};
    int got, bad = 0, ended = 0;
    while (!bad && (got = sph_lines_next(&lines, err)) > 0) {
        int atom = is_record(lines.text, "ATOM") || is_record(lines.text, "HETATM");
        ended |= is_end(lines.text) && atoms->n;
        if (atom && !ended)
            bad = take_atom(&lines, atoms, scene, err);
        else if (is_record(lines.text, "CONECT"))
            bad = take_bonds(&lines, atoms, scene, err);
        else
            bad = sph_ledger_note(&scene->ledger, atom ? SPH_READ_MODEL : SPH_READ_NO_ATOM,
                                  scene->path, lines.line, err);
    }
    return bad || got < 0 ? -1 : 0;
}
