/* kind.h - what kind of file it is: by its content, then by its name
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_KIND_H
#define SPH_KIND_H

#include "common/error.h"

enum sph_file_kind {
    SPH_FILE_OTHER, /* none that is read */
    SPH_FILE_MACHINE,
    SPH_FILE_NFF, /* also what is not known for anything else, but text */
    SPH_FILE_AFF,
    SPH_FILE_PDB,
    SPH_FILE_CIF,
    SPH_FILE_XYZ,
    SPH_FILE_CSV,
    SPH_FILE_OBJ,
    SPH_FILE_PLY,
    SPH_FILE_STL,
    SPH_FILE_GLTF,
    SPH_FILE_GLB, /* glTF in one binary file */
    SPH_FILE_IMAGE
};

/* The kind of the file at path, of which no more than its first kilobytes are read. A file that
 * cannot be read is of the kind that its name says. *looks, unless NULL: what it looks like, in
 * words, such as "a Wavefront OBJ mesh". Of a text that gzip has packed, what is in it. */
enum sph_file_kind sph_file_kind(const char *path, const char **looks);

#endif
