/* atoms.h - atoms as files have them, and what becomes of them in a scene
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_SCENE_ATOMS_H
#define SPH_SCENE_ATOMS_H

#include "scene/elements.h"
#include "scene/scene.h"

/* Texts without blanks around them; empty where the file says nothing. */
struct sph_atom {
    char element[4];  /* as a column of its own has it */
    char name[8];     /* "CA", "OP1" */
    char columns[5];  /* PDB: the name as it stands in columns 13-16; else empty */
    char residue[8];  /* "ALA", "HOH" */
    char group[24];   /* chain, number of the residue, insertion code: which residue it is */
    char place;       /* alternate location, ' ': it has but one */
    int polymer;      /* an ATOM record, of amino or nucleic acids; else HETATM */
    double at[3];     /* Angstrom */
    double occupancy; /* of its places the one with the most is used */
    uint32_t line;
};

struct sph_atoms {
    struct sph_atom *list; /* grows by sph_atoms_add() */
    uint32_t n;
};

/* Adds an atom. -1 with a message if memory is short. */
int sph_atoms_add(struct sph_atoms *atoms, const struct sph_atom *atom, const char *path,
                  struct sph_error *err);

/* Readers of whole files: append atoms, note in scene->ledger what is none. -1 with a message. */
int sph_pdb_read(FILE *file, struct sph_atoms *atoms, struct sph_scene *scene,
                 struct sph_error *err);
int sph_cif_read(FILE *file, struct sph_atoms *atoms, struct sph_scene *scene,
                 struct sph_error *err);

/* Adds a sphere for each atom but those that scene->ledger then has as left out: water, places that
 * are not the likeliest, what is no atom, unknown elements. -1 with a message if memory is short,
 * or under `strict`. */
int sph_atoms_put(const struct sph_atoms *atoms, const struct sph_elements *elements,
                  int keep_water, struct sph_scene *scene, struct sph_error *err);

/* One line of a file, ended by LF, CRLF or CR, without its end. 1, 0 at the end of the file, -1
 * with a message: a control character, more than SPH_LINE_MOST characters, a read error. */
#define SPH_LINE_MOST 4000
struct sph_lines {
    FILE *file;
    const char *path;
    uint32_t line; /* of the newest one, from 1 */
    char text[SPH_LINE_MOST + 1];
};
int sph_lines_next(struct sph_lines *lines, struct sph_error *err);

#endif
