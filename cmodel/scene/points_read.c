/* points_read.c - lists of atoms (XYZ) and tables of points (CSV); see import.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "scene/points.h"

#include <string.h>
#include <strings.h>

#include "common/number.h"
#include "scene/edit.h"

/* The next word of a line, cut off at a blank, comma or semicolon; NULL: there is none. */
static char *next_field(char **rest) {
    char *at = *rest + strspn(*rest, " \t,;"), *end = at + strcspn(at, " \t,;");
    if (at == end) return NULL;
    *rest = *end ? end + 1 : end;
    *end = 0;
    return at;
}

static int take_number(const struct sph_lines *l, char **rest, const char *what, double *to,
                       struct sph_error *err) {
    const char *word = next_field(rest);
    if (!word) return sph_fail(err, "%s:%u: %s is missing", l->path, l->line, what);
    if (!sph_parse_number(word, to)) return 0;
    return sph_fail(err, "%s:%u: %s: `%.40s` is not a number", l->path, l->line, what, word);
}

enum { X, Y, Z, R, FIELDS, MOST = 256 };
static const char *const names[FIELDS] = {"x", "y", "z", "r"};

/* How many atoms, a comment, and a line for each: its symbol, x, y, z. Of several frames the first
 * is read. */
int sph_xyz_read(FILE *file, struct sph_atoms *atoms, struct sph_scene *scene,
                 struct sph_error *err) {
    struct sph_lines l = {.file = file, .path = scene->path};
    double n = 0;
    if (sph_lines_next(&l, err) < 0) return -1;
    char *rest = l.text;
    if (take_number(&l, &rest, "the number of atoms", &n, err) || sph_lines_next(&l, err) < 0)
        return -1;
    if (sph_ledger_add(&scene->ledger, SPH_READ_NO_ATOM, 2, l.path, 1, 0, err)) return -1;
    while (atoms->n < n) {
        struct sph_atom a = {.place = ' '};
        int got = sph_lines_next(&l, err);
        if (got < 0) return -1;
        if (!got)
            return sph_fail(err, "%s:%u: the file ends after %u of %.0f atoms", l.path, l.line,
                            atoms->n, n);
        rest = l.text;
        const char *word = next_field(&rest);
        if (!word) return sph_fail(err, "%s:%u: the symbol is missing", l.path, l.line);
        snprintf(a.element, sizeof a.element, "%.3s", word);
        snprintf(a.name, sizeof a.name, "%.7s", word);
        for (int i = 0; i < 3; i++)
            if (take_number(&l, &rest, names[i], &a.at[i], err)) return -1;
        a.line = l.line;
        if (sph_atoms_add(atoms, &a, l.path, err)) return -1;
    }
    for (int got; (got = sph_lines_next(&l, err)) != 0;)
        if (got < 0 || (strspn(l.text, " \t") < strlen(l.text) &&
                        sph_ledger_note(&scene->ledger, SPH_READ_MODEL, l.path, l.line, err)))
            return -1;
    return 0;
}

/* Which column is which, by the names in the first line. */
static int take_names(const struct sph_lines *l, char *rest, int column[MOST], int *n,
                      struct sph_error *err) {
    int found = 0;
    for (char *word; *n < MOST && (word = next_field(&rest)); ++*n) {
        int f = 0;
        size_t length = strcspn(word, "\"") ? strlen(word) : strlen(++word) - 1;
        while (f < FIELDS && (length != 1 || strncasecmp(word, names[f], 1) != 0) &&
               !(f == R && length == 6 && !strncasecmp(word, "radius", 6)))
            f++;
        column[*n] = f;
        found |= f < FIELDS ? 1 << f : 0;
    }
    return (found & 7) == 7
               ? 0
               : sph_fail(err, "%s:%u: the first line names no columns x, y, z", l->path, l->line);
}

int sph_csv_read(FILE *file, double radius, struct sph_scene *scene, struct sph_error *err) {
    struct sph_lines l = {.file = file, .path = scene->path};
    struct sph_material m = {{0.8, 0.8, 0.8}, 0.85, 0.15, 30, 0, 1, 0, {0}, 0};
    int column[MOST], n = 0, got = sph_lines_next(&l, err);
    if (got < 0 || take_names(&l, l.text, column, &n, err) ||
        sph_ledger_note(&scene->ledger, SPH_READ_WORD, l.path, l.line, err) ||
        sph_scene_add_material(scene, &m, err))
        return -1;
    while ((got = sph_lines_next(&l, err)) > 0) {
        double v[FIELDS] = {[R] = radius};
        char *rest = l.text;
        if (strspn(rest, " \t,;") == strlen(rest)) continue;
        for (int k = 0; k < n; k++) {
            int f = column[k];
            if (f == FIELDS ? !next_field(&rest) : take_number(&l, &rest, names[f], &v[f], err))
                return f == FIELDS
                           ? sph_fail(err, "%s:%u: column %d is missing", l.path, l.line, k + 1)
                           : -1;
        }
        if (!(v[R] > 0)) return sph_fail(err, "%s:%u: r: %g is not above 0", l.path, l.line, v[R]);
        if (sph_ledger_note(&scene->ledger, SPH_READ_SPHERE, l.path, l.line, err) ||
            sph_scene_add_sphere(scene, sph_vec_of(v[X], v[Y], v[Z]), v[R], 0, l.line, err))
            return -1;
    }
    return got;
}
