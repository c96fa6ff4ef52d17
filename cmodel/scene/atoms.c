/* atoms.c - see atoms.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "scene/atoms.h"

#include <ctype.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "common/packed.h"
#include "scene/edit.h"

int sph_lines_next(struct sph_lines *l, struct sph_error *err) {
    size_t n = 0;
    int c = 0;
    l->line++;
    while ((c = getc(l->file)) != EOF && c != '\n' && c != '\r') {
        if ((c < 32 && c != '\t') || c == 127)
            return sph_fail(err, "%s:%u: byte 0x%02x: this is not a text file", l->path, l->line,
                            (unsigned)c);
        if (n == SPH_LINE_MOST)
            return sph_fail(err, "%s:%u: a line of more than %d characters", l->path, l->line,
                            SPH_LINE_MOST);
        l->text[n++] = (char)c;
    }
    if (c == '\r' && (c = getc(l->file)) != '\n' && c != EOF) ungetc(c, l->file);
    if (ferror(l->file))
        return sph_fail(err, "%s:%u: cannot read: %s", l->path, l->line, sph_input_why());
    l->text[n] = 0;
    return n || c != EOF;
}

/* The list with room behind its n entries, of so many bytes each; NULL: no memory. */
static void *with_room(void *list, uint32_t n, size_t size) {
    return n & (n - 1) ? list : realloc(list, (n ? 2 * (size_t)n : 1) * size);
}

int sph_atoms_add(struct sph_atoms *atoms, const struct sph_atom *atom, const char *path,
                  struct sph_error *err) {
    struct sph_atom *room = with_room(atoms->list, atoms->n, sizeof *room);
    if (!room)
        return sph_fail(err, "%s:%u: no memory for more than %u atoms", path, atom->line, atoms->n);
    atoms->list = room;
    atoms->list[atoms->n++] = *atom;
    return 0;
}

int sph_atoms_bond(struct sph_atoms *atoms, const struct sph_bond *bond, const char *path,
                   struct sph_error *err) {
    struct sph_bond *room = with_room(atoms->bonds, atoms->n_bonds, sizeof *room);
    if (!room)
        return sph_fail(err, "%s:%u: no memory for more than %u bonds", path, bond->line,
                        atoms->n_bonds);
    atoms->bonds = room;
    atoms->bonds[atoms->n_bonds++] = *bond;
    return 0;
}

void sph_atoms_free(struct sph_atoms *atoms) {
    free(atoms->list);
    free(atoms->bonds);
}

/* Whether a word is one of a list of words between blanks. */
static int among(const char *word, const char *list) {
    size_t n = strlen(word);
    for (const char *at = list; n && (at = strcasestr(at, word)) != NULL; at++)
        if ((at == list || at[-1] == ' ') && (at[n] == ' ' || !at[n])) return 1;
    return 0;
}

/* Names of water's residue in the PDB, CHARMM, GROMACS, AMBER. */
static const char waters[] =
    "HOH WAT DOD H2O SOL TIP TIP2 TIP3 TIP4 TIP5 TP3 TP4 TP5 T3P T4P SPC SPCE";

/* What stands where atoms do and is none: lone pairs, dummies, virtual sites of water. */
static const char dummies[] = "EP EPW EP1 EP2 LP LP1 LP2 LP3 LPA LPB MW MW1 MW2 DU DUM X XX VS";

/* Residues that have no elements but H, C, N, O, P and S: a name's first letter is its element. */
static const char plain[] =
    "ALA ARG ASN ASP CYS GLN GLU GLY HIS ILE LEU LYS MET PHE PRO SER THR TRP TYR VAL HID HIE HIP "
    "HSD HSE HSP CYX ASH GLH LYN A C G T U I DA DC DG DT DU DI DA5 DC5 DG5 DT5 DA3 DC3 DG3 DT3";

/* Ions of CHARMM, whose residues have the name of the atom. */
static const struct {
    const char *name, *symbol;
} ions[] = {{"SOD", "Na"}, {"CLA", "Cl"}, {"POT", "K"},  {"CAL", "Ca"}, {"CES", "Cs"},
            {"LIT", "Li"}, {"RUB", "Rb"}, {"BAR", "Ba"}, {"CAD", "Cd"}};

/* Takes the charge off the name of an ion: Na+, Cl-, MG2, Fe3+. Whether it had a sign. */
static int cut_charge(char *name) {
    size_t n = strlen(name), letters = 0;
    int sign = n > 1 && strchr("+-", name[n - 1]) != NULL;
    while (isalpha((unsigned char)name[letters]))
        letters++;
    if (letters > 0 && strspn(name + letters, "0123456789+-") == n - letters) name[letters] = 0;
    return sign;
}

/* The element of an ion: of a name with a charge, or that its residue has too; -1: it is none. */
static int element_of_ion(const struct sph_elements *elements, const struct sph_atom *a) {
    char name[sizeof a->name], residue[sizeof a->residue];
    memcpy(name, a->name, sizeof name);
    memcpy(residue, a->residue, sizeof residue);
    int ion = !strcasecmp(name, residue), charged = cut_charge(name);
    if (cut_charge(residue) && !strcasecmp(name, residue)) charged = 1;
    for (size_t i = 0; ion && i < sizeof ions / sizeof *ions; i++)
        if (!strcasecmp(name, ions[i].name)) return sph_elements_find(elements, ions[i].symbol);
    return ion || charged ? sph_elements_find(elements, name) : -1;
}

/* The element as the atom's name says; -1 if it says nothing. Amino and nucleic acids have elements
 * of one letter. In others columns 13-14 hold the symbol, right-justified; names of four characters
 * that start with H are hydrogen all the same. Where every name of the file starts in column 13
 * (`left`), or it has no columns, two letters are an element if they are a common one. */
static int element_of_name(const struct sph_elements *elements, const struct sph_atom *a,
                           int left) {
    static const char common[] = "CL BR SE ZN FE MG MN SI LI CU NI";
    char symbol[3] = "", letter[2] = "";
    const char *name = a->name + strcspn(a->name, "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstu"
                                                  "vwxyz");
    int ion = element_of_ion(elements, a);
    if (ion >= 0) return ion;
    letter[0] = *name;
    if (!among(a->residue, plain) && !(toupper(*name) == 'H' && strlen(a->name) == 4)) {
        memcpy(symbol, name, strnlen(name, 2));
        int aligned = a->columns[0] && !left && isalpha((unsigned char)a->columns[0]);
        if (aligned && !(a->polymer && !isalpha((unsigned char)a->columns[1]))) {
            int found = sph_elements_find(elements, symbol);
            if (found >= 0) return found;
        }
        if ((left || !a->columns[0]) && among(symbol, common))
            return sph_elements_find(elements, symbol);
    }
    return sph_elements_find(elements, letter);
}

struct place {
    const struct sph_atom *atom;
};

/* Orders places of one atom beside one another, the likeliest first, else as in the file. */
static int by_atom(const void *p, const void *q) {
    const struct sph_atom *a = ((const struct place *)p)->atom;
    const struct sph_atom *b = ((const struct place *)q)->atom;
    int d = strcmp(a->group, b->group);
    if (!d) d = strcmp(a->name, b->name);
    if (!d && a->occupancy != b->occupancy) d = a->occupancy > b->occupancy ? -1 : 1;
    return d ? d : a < b ? -1 : 1;
}

enum { ALONE, CHOSEN, OTHER }; /* an atom of one place; the place that is used; another one */

/* Says of each atom which of these it is. -1: no memory. */
static int choose_places(const struct sph_atoms *atoms, uint8_t *is) {
    uint32_t n = 0;
    struct place *sorted = malloc(((size_t)atoms->n + 1) * sizeof *sorted);
    if (!sorted) return -1;
    for (uint32_t i = 0; i < atoms->n; i++)
        if (atoms->list[i].place != ' ') sorted[n++].atom = &atoms->list[i];
    qsort(sorted, n, sizeof *sorted, by_atom);
    for (uint32_t i = 1; i < n; i++) {
        const struct sph_atom *a = sorted[i - 1].atom, *b = sorted[i].atom;
        if (strcmp(a->group, b->group) || strcmp(a->name, b->name) || a->place == b->place)
            continue;
        if (is[a - atoms->list] == ALONE) is[a - atoms->list] = CHOSEN;
        is[b - atoms->list] = OTHER;
    }
    free(sorted);
    return 0;
}

/* How an atom ends; *element: which one it is, if it is used. */
static enum sph_read end_of(const struct sph_elements *elements, const struct sph_atom *a, int is,
                            int keep_water, int left, int *element) {
    if (!keep_water && among(a->residue, waters)) return SPH_READ_WATER;
    if (is == OTHER) return SPH_READ_OTHER_PLACE;
    *element = a->element[0] ? sph_elements_find(elements, a->element) : -1;
    int told = *element >= 0;
    if (!told && element_of_ion(elements, a) < 0 &&
        (among(a->name, dummies) || among(a->element, dummies)))
        return SPH_READ_NO_ELEMENT;
    if (!told) *element = element_of_name(elements, a, left);
    if (*element < 0 || !(elements->list[*element].rad > 0)) return SPH_READ_UNKNOWN;
    return is == CHOSEN ? SPH_READ_ALTERNATE : told ? SPH_READ_ATOM : SPH_READ_ELEMENT;
}

enum { BALL_PART = 4 }; /* of the radius that atoms have, where bonds are drawn */

static int put(const struct sph_atoms *atoms, const struct sph_elements *elements,
               const struct sph_import_options *o, const uint8_t *is, struct sph_placed *placed,
               uint32_t *n, struct sph_scene *scene, struct sph_error *err) {
    struct sph_atom_colours colours = {.by = o->colour};
    int left = 1, bad = 0;
    for (uint32_t i = 0; i < atoms->n; i++)
        left = left && atoms->list[i].columns[0] != ' ';
    for (uint32_t i = 0; i < atoms->n && !bad; i++) {
        const struct sph_atom *a = &atoms->list[i];
        struct sph_placed p = {.atom = i, .element = -1};
        enum sph_read end = end_of(elements, a, is[i], o->keep_water, left, &p.element);
        bad = sph_ledger_note(&scene->ledger, end, scene->path, a->line, err);
        if (bad || sph_read_end(end) == SPH_LEFT_OUT) continue;
        const struct sph_element *e = &elements->list[p.element];
        bad =
            sph_atom_material(&colours, a, e, p.element, scene, &p.material, err) ||
            sph_scene_add_sphere(scene, sph_vec_of(a->at[0], a->at[1], a->at[2]),
                                 o->sticks ? e->rad / BALL_PART : e->rad, p.material, a->line, err);
        placed[(*n)++] = p;
    }
    sph_atom_colours_free(&colours);
    return bad;
}

/* No sphere came of the file: what became of its atoms. */
static int fail_empty(const struct sph_scene *scene, struct sph_error *err) {
    const struct sph_ledger_row *row = scene->ledger.row;
    return sph_fail(err,
                    "%s: no atoms other than %" PRIu64 " of water (kept by --water), %" PRIu64
                    " of no known element and %" PRIu64 " that are none",
                    scene->path, row[SPH_READ_WATER].n, row[SPH_READ_UNKNOWN].n,
                    row[SPH_READ_NO_ELEMENT].n);
}

/* Takes those whose sphere was dropped off the list: no two spheres have one centre any more. */
static void keep_placed(const struct sph_atoms *atoms, const struct sph_scene *scene,
                        struct sph_placed *placed, uint32_t *n) {
    uint32_t kept = 0;
    for (uint32_t i = 0; i < *n && kept < scene->n_spheres; i++) {
        const double *at = atoms->list[placed[i].atom].at;
        const struct sph_vec ctr = scene->spheres[kept].ctr;
        if (at[0] == ctr.x && at[1] == ctr.y && at[2] == ctr.z) placed[kept++] = placed[i];
    }
    *n = kept;
}

int sph_atoms_put(const struct sph_atoms *atoms, const struct sph_elements *elements,
                  const struct sph_import_options *options, struct sph_scene *scene,
                  struct sph_error *err) {
    uint8_t *is = calloc((size_t)atoms->n + 1, 1);
    struct sph_placed *placed = malloc(((size_t)atoms->n + 1) * sizeof *placed);
    uint32_t n = 0;
    int rc = !is || !placed || choose_places(atoms, is)
                 ? sph_fail(err, "%s: no memory for %u atoms", scene->path, atoms->n)
                 : put(atoms, elements, options, is, placed, &n, scene, err);
    if (!rc && !scene->n_spheres) rc = fail_empty(scene, err);
    if (!rc) rc = sph_scene_drop_twice(scene, SPH_READ_SAME_PLACE, err);
    if (!rc && options->sticks) {
        keep_placed(atoms, scene, placed, &n);
        rc = sph_bonds_put(atoms, elements, placed, n, options->round, scene, err);
    }
    free(placed);
    free(is);
    return rc;
}
