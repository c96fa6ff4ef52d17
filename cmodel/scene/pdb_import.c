/* pdb_import.c - see pdb_import.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * Columns of an ATOM or HETATM record, from 1 (PDB format 3.30, section 9):
 *   13-16 atom name   17 alternate location   18-20 residue   31-38, 39-46, 47-54 x, y, z
 *   77-78 element, right-justified   79-80 charge
 * Files of before 1996 number their lines in columns 73-80 instead: an element counts only if
 * columns 79-80 are blank or a charge.
 */
#include "scene/pdb_import.h"
#include "common/file.h"
#include "scene/edit.h"
#include "scene/elements.h"
#include "scene/nff_lex.h"
#include "scene/pdb_frame.h"

#include <ctype.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum { LINE_MOST = 1000 }; /* characters; the format has 80 */

struct import {
    struct sph_scene *scene;
    struct sph_elements elements;
    int material[SPH_MAX_ELEMENTS]; /* of the element, -1: not used yet */
    struct sph_import_counts counts;
    int keep_water;
    uint32_t line;
};

/* Columns first..last (from 1) of the line without blanks at both ends; shorter lines are as
 * if filled up with blanks. */
static void column(const char *line, int first, int last, char *out) {
    int length = (int)strlen(line), n = 0;
    for (int i = first - 1; i < last && i < length; i++)
        if (n > 0 || line[i] != ' ') out[n++] = line[i];
    while (n > 0 && out[n - 1] == ' ')
        n--;
    out[n] = 0;
}

/* The element as columns 77-78 say, -1 if they do not. */
static int element_of_columns(const struct import *im, const char *line) {
    char symbol[3], charge[3];
    column(line, 77, 78, symbol);
    column(line, 79, 80, charge);
    int charged = strlen(charge) == 2 && isdigit((unsigned char)charge[0]) &&
                  (charge[1] == '+' || charge[1] == '-');
    if (charge[0] && !charged) return -1;
    return symbol[0] ? sph_elements_find(&im->elements, symbol) : -1;
}

/* Takes the charge off the name of an ion: Na+, Cl-, MG2, Fe3+. Whether it had a sign. */
static int cut_charge(char *name) {
    size_t n = strlen(name), letters = 0;
    int sign = n > 1 && strchr("+-", name[n - 1]) != NULL;
    while (isalpha((unsigned char)name[letters]))
        letters++;
    if (letters > 0 && strspn(name + letters, "0123456789+-") == n - letters) name[letters] = 0;
    return sign;
}

/* The element as the atom's name says. In ATOM records (amino and nucleic acids) it is the
 * first letter. In others, and where the residue has the name of the atom or the name ends with the
 * sign of a charge (ions), columns 13-14 hold the symbol, right-justified; four-character names
 * that start with H are hydrogen all the same. -1 if the name says nothing. */
static int element_of_name(const struct import *im, const char *line) {
    char name[5], residue[4], symbol[3] = "", letter[2] = "";
    column(line, 13, 16, name);
    column(line, 18, 20, residue);
    for (const char *c = name; *c && !letter[0]; c++)
        if (isalpha((unsigned char)*c)) letter[0] = *c;
    int ion = !strcasecmp(name, residue), charged = cut_charge(name);
    if (cut_charge(residue) && !strcasecmp(name, residue)) charged = 1;
    int plain = !strncmp(line, "ATOM", 4) && letter[0] && strchr("HCNOSP", letter[0]);
    if (ion || charged) return sph_elements_find(&im->elements, name);
    if (!plain && isalpha((unsigned char)line[12]) && !(letter[0] == 'H' && strlen(name) == 4)) {
        column(line, 13, 14, symbol);
        int found = sph_elements_find(&im->elements, symbol);
        if (found >= 0) return found;
    }
    return sph_elements_find(&im->elements, letter);
}

/* The material of the element; makes it on first use. -1 with a message. */
static int material_of(struct import *im, int element, struct sph_error *err) {
    const struct sph_element *e = &im->elements.list[element];
    if (im->material[element] >= 0) return im->material[element];
    struct sph_material m = {{e->rgb[0], e->rgb[1], e->rgb[2]}, 0.85, 0.15, 30, 0, 1, 0, {0}, 0};
    if (sph_scene_add_material(im->scene, &m, err)) return -1;
    return im->material[element] = (int)im->scene->n_materials - 1;
}

static int take_atom(struct import *im, const char *line, struct sph_error *err) {
    static const char *const names[] = {"x (columns 31-38)", "y (columns 39-46)",
                                        "z (columns 47-54)"};
    const char *path = im->scene->path;
    char text[9];
    double at[3];
    if (strlen(line) < 54)
        return sph_fail(err, "%s:%u: atom record of %zu characters: coordinates end in column 54",
                        path, im->line, strlen(line));
    column(line, 18, 20, text);
    if (!im->keep_water && (!strcmp(text, "HOH") || !strcmp(text, "WAT") || !strcmp(text, "DOD"))) {
        im->counts.waters++;
        return 0;
    }
    if (line[16] != ' ' && line[16] != 'A') {
        im->counts.alternates++;
        return 0;
    }
    for (int i = 0; i < 3; i++) {
        column(line, 31 + 8 * i, 38 + 8 * i, text);
        if (sph_parse_number(text, &at[i]) || strpbrk(text, "eE")) /* 8.3 digits */
            return sph_fail(err, "%s:%u: %s: `%s` is not a number", path, im->line, names[i], text);
    }
    int element = element_of_columns(im, line);
    if (element < 0) element = element_of_name(im, line);
    column(line, 13, 16, text);
    if (element < 0)
        return sph_fail(err, "%s:%u: no element known for atom `%s`", path, im->line, text);
    if (!(im->elements.list[element].rad > 0))
        return sph_fail(err, "%s:%u: no van der Waals radius known for element %s", path, im->line,
                        im->elements.list[element].symbol);
    int material = material_of(im, element, err);
    if (material < 0) return -1;
    return sph_scene_add_sphere(im->scene, sph_vec_of(at[0], at[1], at[2]),
                                im->elements.list[element].rad, (uint32_t)material, im->line, err);
}

/* The next line, without its end. 1, 0 at the end of the file, -1 with a message. */
static int next_line(struct import *im, FILE *file, char line[LINE_MOST + 1],
                     struct sph_error *err) {
    const char *path = im->scene->path;
    size_t n = 0;
    int c;
    errno = 0;
    im->line++;
    while ((c = getc(file)) != EOF && c != '\n') {
        if (!c) return sph_fail(err, "%s:%u: byte 0x00: this is not a text file", path, im->line);
        if (n == LINE_MOST)
            return sph_fail(err, "%s:%u: a line of more than %d characters", path, im->line,
                            LINE_MOST);
        line[n++] = (char)c;
    }
    if (ferror(file)) return sph_fail(err, "%s: cannot read: %s", path, strerror(errno));
    if (c == EOF && n == 0) return 0;
    while (n > 0 && line[n - 1] == '\r')
        n--;
    line[n] = 0;
    return 1;
}

/* Takes the lines up to the end of the first model. */
static int take_lines(struct import *im, FILE *file, struct sph_error *err) {
    char line[LINE_MOST + 1] = "";
    int got, bad = 0;
    while (!bad && (got = next_line(im, file, line, err)) > 0) {
        if (!strncmp(line, "ENDMDL", 6) || !strcmp(line, "END")) break;
        if (!strncmp(line, "ATOM ", 5) || !strncmp(line, "HETATM", 6))
            bad = take_atom(im, line, err);
    }
    return bad || got < 0 ? -1 : 0;
}

/* Everything but the elements and the camera. */
static int take_file(struct import *im, const char *path, struct sph_error *err) {
    FILE *file = sph_input_open(path, SPH_INPUT_ANY, err);
    if (!file) return -1;
    int bad = take_lines(im, file, err);
    fclose(file);
    if (!bad && im->scene->n_spheres == 0)
        bad = sph_fail(err, "%s: no atoms (ATOM or HETATM records) other than %u of water", path,
                       im->counts.waters);
    if (!bad) bad = sph_scene_drop_coincident(im->scene, &im->counts.duplicates, err);
    im->counts.atoms = im->scene->n_spheres;
    return bad;
}

int sph_import_pdb(const char *path, const struct sph_import_options *options,
                   struct sph_scene *scene, struct sph_error *err) {
    struct sph_import_options o = {0};
    struct import im = {.scene = scene};
    if (options) o = *options;
    memset(scene, 0, sizeof *scene);
    im.keep_water = o.keep_water;
    for (int i = 0; i < SPH_MAX_ELEMENTS; i++)
        im.material[i] = -1;
    if (sph_elements_read(o.elements_path ? o.elements_path : SPH_ELEMENTS_PATH, &im.elements, err))
        return -1;
    sph_scene_set_path(scene, path);
    scene->camera.width = o.width || o.height ? o.width : 320;
    scene->camera.height = o.width || o.height ? o.height : 180;
    int bad = take_file(&im, path, err);
    if (!bad && (scene->camera.width < 1 || scene->camera.height < 1))
        bad = sph_fail(err, "%s: resolution %d x %d", path, scene->camera.width,
                       scene->camera.height);
    if (!bad) {
        sph_scene_frame(scene);
        bad = sph_camera_check(&scene->camera, path, err);
    }
    if (bad) sph_scene_free(scene);
    if (o.counts) *o.counts = im.counts;
    return bad;
}
