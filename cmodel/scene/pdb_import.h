/* pdb_import.h - molecules: atoms of a Protein Data Bank file become spheres
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_SCENE_PDB_IMPORT_H
#define SPH_SCENE_PDB_IMPORT_H

#include "scene/scene.h"

#define SPH_ELEMENTS_PATH "/usr/share/bodr/elements.xml" /* of Debian's package bodr */

struct sph_import_counts {
    uint32_t atoms;      /* that became spheres */
    uint32_t waters;     /* left out: HOH, WAT, DOD */
    uint32_t alternates; /* left out: alternate location neither blank nor A */
    uint32_t duplicates; /* left out: at the very place of an atom before */
};

struct sph_import_options {
    const char *elements_path;        /* NULL: SPH_ELEMENTS_PATH */
    int keep_water;                   /* 0: leave water out */
    int width, height;                /* resolution; 0 means 320 x 180 */
    struct sph_import_counts *counts; /* NULL, or where to store the counts */
};

/* Reads the ATOM and HETATM records of the first model of the PDB file (fixed columns). Radii
 * are van der Waals radii in Angstrom, colours the usual ones, both from the Blue Obelisk Data
 * Repository. The element is that of columns 77-78, or else follows from the atom's name. The
 * camera looks along the thinnest principal axis of the molecule, its longest axis across, from
 * where all of it is in view. options may be NULL. 0, or -1 with "file:line: message" (not
 * readable, malformed record, unknown element, no atom, no elements file); then there is
 * nothing to free. Coordinates are in Angstrom. */
int sph_import_pdb(const char *path, const struct sph_import_options *options,
                   struct sph_scene *scene, struct sph_error *err);

#endif
