/* harness_pdb.c - molecules (PDB, mmCIF, XYZ), as they are or packed, and tables of points (CSV)
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdio.h>

#include "fuzz.h"
#include "scene/frustum.h"
#include "scene/import.h"

static char elements[4096];

void fuzz_begin(const char *root) {
    snprintf(elements, sizeof elements, "%s/elements.xml", root);
}

/* What a file is read as: by its first byte. */
static enum sph_file_kind kind_of(const uint8_t *data, size_t size) {
    char first = (char)(size ? data[0] : 0);
    return first == 'd' || first == '#'   ? SPH_FILE_CIF
           : first >= '0' && first <= '9' ? SPH_FILE_XYZ
           : first == 'x'                 ? SPH_FILE_CSV
                                          : SPH_FILE_PDB;
}

void fuzz_one(const uint8_t *data, size_t size) {
    struct sph_scene scene;
    struct sph_error err = {""};
    uint64_t choice = fuzz_hash(data, size);
    struct sph_import_options o = {.elements_path = elements,
                                   .keep_water = choice >> 60 & 1,
                                   .sticks = choice >> 58 & 1,
                                   .colour = (enum sph_atom_colour)((choice >> 50 & 0xff) % 3),
                                   .round = SPH_FRUSTUM_ROUND_MAX};
    fuzz_write("atoms.pdb", data, size);
    if (sph_import("atoms.pdb", kind_of(data, size), &o, &scene, &err)) {
        fuzz_message(&err, "atoms.pdb", 1);
        return;
    }
    fuzz_scene(&scene, choice);
    sph_scene_free(&scene);
}
