/* points.h - lists of atoms (XYZ) and tables of points (CSV)
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_SCENE_POINTS_H
#define SPH_SCENE_POINTS_H

#include "scene/atoms.h"

/* Appends the atoms of an XYZ file's first frame. -1 with a message. */
int sph_xyz_read(FILE *file, struct sph_atoms *atoms, struct sph_scene *scene,
                 struct sph_error *err);

/* Adds a sphere for each row of a table whose first line names columns x, y, z and, if wanted, r or
 * radius; they are separated by commas, semicolons or blanks. radius: where there is no r. -1 with
 * a message. */
int sph_csv_read(FILE *file, double radius, struct sph_scene *scene, struct sph_error *err);

#endif
