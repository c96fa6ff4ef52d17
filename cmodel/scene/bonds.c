/* bonds.c - sticks between atoms: bonds that the file gives, and those that distance tells
 * SPDX-License-Identifier: Apache-2.0
 *
 * Distances are measured in cells of the longest bond that there may be, so that only atoms of
 * cells that touch are looked at. Cells are numbered in a torus: of what lies far apart two may
 * share a number, which the distance itself tells.
 */
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "scene/atoms.h"
#include "scene/edit.h"
#include "scene/frustum.h"

#define TOLERANCE 0.4 /* Angstrom beyond the covalent radii: Meng and Lewis 1991 */
#define NEAREST 0.4   /* Angstrom: what is closer is no bond but one atom at two places */
#define STICK 0.15    /* Angstrom, radius */

enum { CELL_BITS = 21 };

/* An atom by its place in `placed`, under what it is looked for by. */
struct entry {
    uint64_t cell;
    const struct sph_atom *atom;
    uint32_t i;
};

struct pair {
    uint32_t a, b; /* places in `placed`, a < b */
    uint32_t line; /* that gives the bond, 0: distance tells it */
};

struct bonds {
    const struct sph_atoms *atoms;
    const struct sph_elements *elements;
    const struct sph_placed *placed;
    uint32_t n;
    struct sph_scene *scene;
    struct entry *entries; /* sorted by what is looked for */
    struct pair *pairs;    /* grows */
    uint32_t n_pairs;
};

static const struct sph_atom *atom_of(const struct bonds *b, uint32_t i) {
    return &b->atoms->list[b->placed[i].atom];
}

static double distance(const struct bonds *b, uint32_t i, uint32_t k) {
    const double *p = atom_of(b, i)->at, *q = atom_of(b, k)->at;
    return hypot(hypot(p[0] - q[0], p[1] - q[1]), p[2] - q[2]);
}

static int add_pair(struct bonds *b, uint32_t i, uint32_t k, uint32_t line, struct sph_error *err) {
    uint32_t n = b->n_pairs;
    if (!(n & (n - 1))) {
        struct pair *room = realloc(b->pairs, (n ? 2 * (size_t)n : 1) * sizeof *room);
        if (!room) return sph_fail(err, "%s: no memory for more than %u bonds", b->scene->path, n);
        b->pairs = room;
    }
    b->pairs[b->n_pairs++] = (struct pair){i < k ? i : k, i < k ? k : i, line};
    return 0;
}

/* ---- bonds that the file gives ---- */

static int by_serial(const void *p, const void *q) {
    return strcmp(((const struct entry *)p)->atom->serial, ((const struct entry *)q)->atom->serial);
}

static int by_group(const void *p, const void *q) {
    const struct sph_atom *a = ((const struct entry *)p)->atom;
    const struct sph_atom *b = ((const struct entry *)q)->atom;
    int d = strcmp(a->group, b->group);
    return d ? d : strcmp(a->name, b->name);
}

static void sort(struct bonds *b, int (*by)(const void *, const void *)) {
    for (uint32_t i = 0; i < b->n; i++)
        b->entries[i] = (struct entry){.atom = atom_of(b, i), .i = i};
    qsort(b->entries, b->n, sizeof *b->entries, by);
}

/* The atom that is equal to one asked for; NULL: there is none. */
static const struct entry *find(const struct bonds *b, const struct sph_atom *asked,
                                int (*by)(const void *, const void *)) {
    struct entry key = {.atom = asked};
    return bsearch(&key, b->entries, b->n, sizeof key, by);
}

/* The pair of one bond between two atoms that are asked for. */
static int give(struct bonds *b, const struct sph_bond *bond, const struct sph_atom asked[2],
                int (*by)(const void *, const void *), struct sph_error *err) {
    const struct entry *a = find(b, &asked[0], by), *c = find(b, &asked[1], by);
    if (!a || !c || distance(b, a->i, c->i) < NEAREST)
        return sph_ledger_note(&b->scene->ledger, SPH_READ_BOND_NONE, b->scene->path, bond->line,
                               err);
    return add_pair(b, a->i, c->i, bond->line, err);
}

static int given(struct bonds *b, enum sph_bond_of of, struct sph_error *err) {
    int (*const by)(const void *, const void *) = of == SPH_BOND_SERIALS ? by_serial : by_group;
    sort(b, by);
    for (uint32_t k = 0; k < b->atoms->n_bonds; k++) {
        const struct sph_bond *bond = &b->atoms->bonds[k];
        struct sph_atom asked[2] = {{.line = 0}, {.line = 0}};
        if (bond->of != of) continue;
        for (int i = 0; i < 2; i++) {
            memcpy(asked[i].serial, bond->atom[i], sizeof asked[i].serial);
            memcpy(asked[i].name, bond->atom[i], sizeof asked[i].name);
            asked[i].name[sizeof asked[i].name - 1] = 0;
            memcpy(asked[i].group, bond->group[i], sizeof asked[i].group);
        }
        if (give(b, bond, asked, by, err)) return -1;
    }
    return 0;
}

static int by_residue(const void *p, const void *q) {
    const struct sph_bond *a = p, *b = q;
    return strcmp(a->group[0], b->group[0]);
}

/* Bonds of every residue of a name, in each group of atoms that has it; the groups are sorted. A
 * residue may lack atoms, which is no loss: nothing is noted. */
static int given_residues(struct bonds *b, struct sph_error *err) {
    struct sph_bond *known = malloc(((size_t)b->atoms->n_bonds + 1) * sizeof *known);
    uint32_t n = 0;
    int bad = known ? 0 : sph_fail(err, "%s: no memory for its bonds", b->scene->path);
    for (uint32_t k = 0; known && k < b->atoms->n_bonds; k++)
        if (b->atoms->bonds[k].of == SPH_BOND_RESIDUES) known[n++] = b->atoms->bonds[k];
    if (n) qsort(known, n, sizeof *known, by_residue);
    for (uint32_t first = 0, end; n && first < b->n && !bad; first = end) {
        const struct sph_atom *a = b->entries[first].atom;
        struct sph_bond key = {.line = 0};
        for (end = first; end < b->n && !strcmp(b->entries[end].atom->group, a->group);)
            end++;
        memcpy(key.group[0], a->residue, sizeof a->residue);
        const struct sph_bond *one = bsearch(&key, known, n, sizeof *known, by_residue);
        while (one && one > known && !by_residue(one - 1, &key))
            one--;
        for (; one && one < known + n && !by_residue(one, &key) && !bad; one++) {
            struct sph_atom asked[2] = {*a, *a};
            const struct entry *found[2];
            for (int i = 0; i < 2; i++) {
                snprintf(asked[i].name, sizeof asked[i].name, "%.7s", one->atom[i]);
                found[i] = find(b, &asked[i], by_group);
            }
            if (found[0] && found[1] && distance(b, found[0]->i, found[1]->i) >= NEAREST)
                bad = add_pair(b, found[0]->i, found[1]->i, one->line, err);
        }
    }
    free(known);
    return bad;
}

/* ---- bonds that distance tells ---- */

static int by_cell(const void *p, const void *q) {
    uint64_t a = ((const struct entry *)p)->cell, b = ((const struct entry *)q)->cell;
    return a < b ? -1 : a > b;
}

static double reach(const struct bonds *b, uint32_t i) {
    const struct sph_element *e = &b->elements->list[b->placed[i].element];
    return e->shares ? e->covalent : 0;
}

/* The cell of an atom, or one that touches it. */
static uint64_t cell_of(const struct sph_atom *atom, double size, const int by[3]) {
    uint64_t cell = 0;
    for (int i = 0; i < 3; i++) {
        double at = fmod(floor(atom->at[i] / size), 1 << CELL_BITS);
        uint64_t number = (uint64_t)((int64_t)at + by[i]) & ((1u << CELL_BITS) - 1);
        cell = cell << CELL_BITS | number;
    }
    return cell;
}

/* Pairs of the atom of entry i and those behind it in a cell. */
static int look_into(struct bonds *b, uint32_t n, uint32_t i, uint64_t cell,
                     struct sph_error *err) {
    struct entry key = {.cell = cell};
    const struct entry *me = &b->entries[i],
                       *one = bsearch(&key, b->entries, n, sizeof key, by_cell);
    while (one && one > b->entries && one[-1].cell == cell)
        one--;
    for (; one && one < b->entries + n && one->cell == cell; one++) {
        if (one->i <= me->i) continue;
        double d = distance(b, me->i, one->i);
        if (d >= NEAREST && d <= reach(b, me->i) + reach(b, one->i) + TOLERANCE &&
            add_pair(b, me->i, one->i, 0, err))
            return -1;
    }
    return 0;
}

static int told(struct bonds *b, struct sph_error *err) {
    enum { CELLS = 27 };
    double longest = 0;
    uint32_t n = 0;
    for (uint32_t i = 0; i < b->n; i++)
        longest = fmax(longest, reach(b, i));
    for (uint32_t i = 0; i < b->n; i++)
        if (reach(b, i) > 0)
            b->entries[n++] = (struct entry){
                cell_of(atom_of(b, i), 2 * longest + TOLERANCE, (int[3]){0, 0, 0}), NULL, i};
    qsort(b->entries, n, sizeof *b->entries, by_cell);
    for (uint32_t i = 0; i < n; i++)
        for (int k = 0; k < CELLS; k++) {
            const int by[3] = {k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1};
            uint64_t cell = cell_of(atom_of(b, b->entries[i].i), 2 * longest + TOLERANCE, by);
            if (look_into(b, n, i, cell, err)) return -1;
        }
    return 0;
}

/* ---- sticks ---- */

/* The same pair beside itself, first as the file gives it, if it does. */
static int by_ends(const void *p, const void *q) {
    const struct pair *a = p, *b = q;
    if (a->a != b->a) return a->a < b->a ? -1 : 1;
    if (a->b != b->b) return a->b < b->b ? -1 : 1;
    if (!a->line != !b->line) return a->line ? -1 : 1;
    return a->line < b->line ? -1 : a->line > b->line;
}

static int same(struct sph_vec a, struct sph_vec b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

/* A stick, half of it in each atom's colour, unless there is no point between them. */
static int put_stick(struct bonds *b, const struct pair *p, double round, uint32_t *n_groups,
                     struct sph_error *err) {
    const struct sph_placed *end[2] = {&b->placed[p->a], &b->placed[p->b]};
    struct sph_vec at[3];
    for (int i = 0; i < 2; i++) {
        const double *v = b->atoms->list[end[i]->atom].at;
        at[2 * i] = sph_vec_of(v[0], v[1], v[2]);
    }
    at[1] = sph_vec_of((at[0].x + at[2].x) / 2, (at[0].y + at[2].y) / 2, (at[0].z + at[2].z) / 2);
    int halves =
        end[0]->material == end[1]->material || same(at[1], at[0]) || same(at[1], at[2]) ? 1 : 2;
    uint32_t line = b->atoms->list[end[0]->atom].line;
    for (int i = 0; i < halves; i++) {
        const struct sph_facet look = {.material = end[i]->material, .line = line};
        const struct sph_frustum stick = {at[i], at[i + 3 - halves], STICK, STICK, line};
        if (sph_scene_add_frustum(b->scene, &stick, round, &look, n_groups, err)) return -1;
    }
    return 0;
}

static int put_sticks(struct bonds *b, double round, struct sph_error *err) {
    uint32_t n_groups = 0;
    if (b->n_pairs) qsort(b->pairs, b->n_pairs, sizeof *b->pairs, by_ends);
    for (uint32_t k = 0; k < b->n_pairs; k++) {
        const struct pair *p = &b->pairs[k];
        if (k && p->a == p[-1].a && p->b == p[-1].b) continue;
        uint32_t line = p->line ? p->line : atom_of(b, p->a)->line;
        enum sph_read kind = p->line ? SPH_READ_BOND_GIVEN : SPH_READ_BOND_TOLD;
        if (sph_ledger_note(&b->scene->ledger, kind, b->scene->path, line, err) ||
            put_stick(b, p, round, &n_groups, err))
            return -1;
    }
    return 0;
}

int sph_bonds_put(const struct sph_atoms *atoms, const struct sph_elements *elements,
                  const struct sph_placed *placed, uint32_t n, double round,
                  struct sph_scene *scene, struct sph_error *err) {
    struct bonds b = {.atoms = atoms, .elements = elements, .placed = placed, .n = n};
    b.scene = scene;
    b.entries = malloc(((size_t)n + 1) * sizeof *b.entries);
    int bad = b.entries ? 0 : sph_fail(err, "%s: no memory for bonds", scene->path);
    bad = bad || given(&b, SPH_BOND_SERIALS, err) || given(&b, SPH_BOND_ATOMS, err) ||
          given_residues(&b, err) || told(&b, err) ||
          put_sticks(&b, round > 0 ? round : SPH_FRUSTUM_ROUND, err);
    free(b.entries);
    free(b.pairs);
    return bad ? -1 : 0;
}
