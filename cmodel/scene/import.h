/* import.h - scenes of what others write: molecules, points, meshes
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_SCENE_IMPORT_H
#define SPH_SCENE_IMPORT_H

#include "common/kind.h"
#include "scene/scene.h"

#define SPH_ELEMENTS_PATH "/usr/share/bodr/elements.xml" /* of Debian's package bodr */

enum sph_atom_colour { SPH_COLOUR_ELEMENT, SPH_COLOUR_RESIDUE, SPH_COLOUR_CHAIN };

struct sph_import_options {
    const char *elements_path; /* NULL: SPH_ELEMENTS_PATH */
    int keep_water;            /* 0: leave water out */
    enum sph_atom_colour colour;
    int sticks;         /* 1: balls of atoms, sticks of bonds; 0: atoms as they touch */
    double round;       /* of sticks, see frustum.h; 0: SPH_FRUSTUM_ROUND */
    double radius;      /* of points whose file has none; 0: 1, of a mesh without faces as
                           large as fits their number */
    int width, height;  /* resolution; 0 means 320 x 180 */
    const char *camera; /* of a mesh: by name or number; NULL: the first */
    char up;            /* of a mesh: 'x', 'y', 'z'; 0: as its format has it */
    int skip;           /* of a mesh: leave out images and materials that are not there */
    int strict;         /* of ledger.h */
    int allow_paths;    /* of a mesh: files that it names may lie anywhere: inside.h */
};

/* Whether a file of this kind is read by sph_import(). */
int sph_importable(enum sph_file_kind kind);

/* Reads the file at path: atoms of a Protein Data Bank file (fixed columns) or of mmCIF, first
 * model, or of XYZ, first frame; or points of a table (CSV) whose columns are named x, y, z and, if
 * wanted, r. Radii of atoms are van der Waals radii in Angstrom, a quarter of them beside
 * sticks, colours the usual ones of elements, both from the Blue Obelisk Data Repository.
 * scene->ledger tells what became of each record. The camera looks along the thinnest principal
 * axis, the longest axis across, from where all is in view; at a mesh (mesh.h) without a camera
 * from its front. options may be NULL. 0, or -1 with "file:line: message" (not readable, malformed
 * record, no atom, no elements file); then there is nothing to free. */
int sph_import(const char *path, enum sph_file_kind kind, const struct sph_import_options *options,
               struct sph_scene *scene, struct sph_error *err);

#endif
