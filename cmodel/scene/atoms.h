/* atoms.h - atoms as files have them, and what becomes of them in a scene
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_SCENE_ATOMS_H
#define SPH_SCENE_ATOMS_H

#include "scene/elements.h"
#include "scene/import.h"
#include "scene/scene.h"

/* Texts without blanks around them; empty where the file says nothing. */
struct sph_atom {
    char element[4]; /* as a column of its own has it */
    char name[8];    /* "CA", "OP1" */
    char columns[5]; /* PDB: the name as it stands in columns 13-16; else empty */
    char residue[8]; /* "ALA", "HOH" */
    char chain[12];
    char group[24];   /* chain, number of the residue, insertion code: which residue it is */
    char serial[12];  /* as CONECT names it: "17", "A0000" of hybrid-36 */
    char place;       /* alternate location, ' ': it has but one */
    int polymer;      /* an ATOM record, of amino or nucleic acids; else HETATM */
    double at[3];     /* Angstrom */
    double occupancy; /* of its places the one with the most is used */
    uint32_t line;
};

/* A bond that the file gives, between two atoms, or of every residue of a name. */
enum sph_bond_of { SPH_BOND_SERIALS, SPH_BOND_ATOMS, SPH_BOND_RESIDUES };
struct sph_bond {
    enum sph_bond_of of;
    char group[2][24]; /* of SPH_BOND_ATOMS; of residues [0] is their name, "ALA" */
    char atom[2][12];  /* serials; names of atoms */
    uint32_t line;
};

struct sph_atoms {
    struct sph_atom *list; /* grows by sph_atoms_add() */
    uint32_t n;
    struct sph_bond *bonds; /* grows by sph_atoms_bond() */
    uint32_t n_bonds;
};

/* Adds an atom, a bond. -1 with a message if memory is short. */
int sph_atoms_add(struct sph_atoms *atoms, const struct sph_atom *atom, const char *path,
                  struct sph_error *err);
int sph_atoms_bond(struct sph_atoms *atoms, const struct sph_bond *bond, const char *path,
                   struct sph_error *err);
void sph_atoms_free(struct sph_atoms *atoms);

/* Readers of whole files: append atoms and bonds, note in scene->ledger what is none. -1 with a
 * message. */
int sph_pdb_read(FILE *file, struct sph_atoms *atoms, struct sph_scene *scene,
                 struct sph_error *err);
int sph_cif_read(FILE *file, struct sph_atoms *atoms, struct sph_scene *scene,
                 struct sph_error *err);

/* Adds a sphere for each atom but those that scene->ledger then has as left out: water, places that
 * are not the likeliest, what is no atom, unknown elements, places of another atom; and sticks for
 * bonds, if options ask for them. -1 with a message if memory is short, there is no atom, or under
 * `strict`. */
int sph_atoms_put(const struct sph_atoms *atoms, const struct sph_elements *elements,
                  const struct sph_import_options *options, struct sph_scene *scene,
                  struct sph_error *err);

/* An atom that a scene has, by its number in the list. */
struct sph_placed {
    uint32_t atom;
    int element;       /* in the list of elements */
    uint32_t material; /* of the scene */
};

/* The material of an atom: of its element, residue or chain. colours starts as all zero bytes and
 * is freed by sph_atom_colours_free(). -1 with a message if memory is short. */
struct sph_atom_colours {
    enum sph_atom_colour by;
    uint32_t material[SPH_MAX_ELEMENTS]; /* of element, residue or chain: index + 1, 0: none yet */
    void *chains;                        /* tree of those that there are */
    uint32_t n_chains;
};
int sph_atom_material(struct sph_atom_colours *colours, const struct sph_atom *atom,
                      const struct sph_element *element, int number, struct sph_scene *scene,
                      uint32_t *material, struct sph_error *err);
void sph_atom_colours_free(struct sph_atom_colours *colours);

/* Adds a stick for every bond of the n placed atoms: those that the file gives, and between
 * non-metals those that their distance tells: no more than the sum of the covalent radii and 0.4
 * Angstrom (Meng and Lewis 1991). -1 with a message. */
int sph_bonds_put(const struct sph_atoms *atoms, const struct sph_elements *elements,
                  const struct sph_placed *placed, uint32_t n, double round,
                  struct sph_scene *scene, struct sph_error *err);

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
