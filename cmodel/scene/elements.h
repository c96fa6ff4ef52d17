/* elements.h - van der Waals radii and colours of the chemical elements
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_SCENE_ELEMENTS_H
#define SPH_SCENE_ELEMENTS_H

#include "common/error.h"

#define SPH_MAX_ELEMENTS 128

struct sph_element {
    char symbol[4];  /* "C", "Zn" */
    double rad;      /* van der Waals radius, Angstrom; 0: not known */
    double covalent; /* radius, Angstrom; 0: not known */
    int shares;      /* non-metals: bonds are told by covalent radii */
    double rgb[3];   /* 0..1 */
};

struct sph_elements {
    int n;
    struct sph_element list[SPH_MAX_ELEMENTS];
};

/* Reads elements.xml of the Blue Obelisk Data Repository (Debian package bodr). 0, or -1 with a
 * message that names the package if the file is missing, or the line that is wrong. */
int sph_elements_read(const char *path, struct sph_elements *elements, struct sph_error *err);

/* The number of the element in the list, whatever the case of the symbol; D and T are hydrogen.
 * -1 if there is none. */
int sph_elements_find(const struct sph_elements *elements, const char *symbol);

#endif
