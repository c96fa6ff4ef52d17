/* ledger.h - what became of each record that a reader met: used, used otherwise, or left out
 * SPDX-License-Identifier: Apache-2.0
 *
 * One list for every reader and for the builder. A record that is used as its file says counts as
 * used, also where the file itself asks for less (`shading blend`, `texture ... linear`).
 */
#ifndef SPH_LEDGER_H
#define SPH_LEDGER_H

#include <stdint.h>
#include <stdio.h>

#ifdef __cplusplus
extern "C" {
#endif

#include "common/error.h"

enum sph_read_end { SPH_USED, SPH_USED_OTHERWISE, SPH_LEFT_OUT, SPH_READ_ENDS };

/* Kind, how it ends, and its name: what stands in the file, and what was done with it. */
#define SPH_EACH_READ(X)                                                                           \
    X(CAMERA, SPH_USED, "camera")                                                                  \
    X(LIGHT, SPH_USED, "light")                                                                    \
    X(COLOUR, SPH_USED, "background or ambient colour")                                            \
    X(MATERIAL, SPH_USED, "material")                                                              \
    X(BLEND, SPH_USED, "material whose Shine or T does not count, as `shading blend` says")        \
    X(WORD, SPH_USED, "word that says how the following is read")                                  \
    X(HIDDEN, SPH_USED, "primitive that is not there now, as its keys say")                        \
    X(DETAIL, SPH_USED, "file above the level of detail that `d` says")                            \
    X(SPHERE, SPH_USED, "sphere")                                                                  \
    X(POLYGON, SPH_USED, "polygon")                                                                \
    X(TRIANGLE, SPH_USED, "triangle")                                                              \
    X(CONE, SPH_USED, "cone")                                                                      \
    X(PLANE, SPH_USED, "plane")                                                                    \
    X(MESH, SPH_USED, "mesh")                                                                      \
    X(ATOM, SPH_USED, "atom")                                                                      \
    X(NO_ATOM, SPH_USED, "record of no atom")                                                      \
    X(BONDS, SPH_USED, "record of bonds")                                                          \
    X(BOND_GIVEN, SPH_USED, "bond, as the file gives it")                                          \
    X(BOND_TOLD, SPH_USED, "bond, as its atoms' distance tells")                                   \
    X(MACHINE, SPH_USED, "machine: registers and memory")                                          \
    X(IMAGE, SPH_USED, "image")                                                                    \
    X(CORNER, SPH_USED, "corner, normal or texture coordinate of a mesh (glTF: list of them)")     \
    X(PART, SPH_USED, "number or image of a mesh's material")                                      \
    X(NODE, SPH_USED, "node of a glTF scene")                                                      \
    X(SHINE_NONE, SPH_USED_OTHERWISE, "material with Ks but Shine 0: mirrors, no highlight")       \
    X(SHINE_LIMITED, SPH_USED_OTHERWISE, "Shine limited to 1..255")                                \
    X(INDEX_LIMITED, SPH_USED_OTHERWISE, "index of refraction limited to 0.25..4; 0 counts as 1")  \
    X(FM_MEAN, SPH_USED_OTHERWISE, "`fm`: ambient colour not used, specular colour averaged")      \
    X(LIGHT_LIMITED, SPH_USED_OTHERWISE, "light or ambient colour limited")                        \
    X(BENT, SPH_USED_OTHERWISE, "polygon that is not flat, cut into triangles that are")           \
    X(GLASS_MEETS, SPH_USED_OTHERWISE,                                                             \
      "glass that cuts the surface of other glass: drawn as if each stood in air")                 \
    X(SRGB, SPH_USED_OTHERWISE, "image decoded from sRGB (`srgb` behind it says so)")              \
    X(ALTERNATE, SPH_USED_OTHERWISE, "atom of several places: the likeliest one is used")          \
    X(ELEMENT, SPH_USED_OTHERWISE, "atom whose element is told by its name")                       \
    X(SHIFTED, SPH_USED_OTHERWISE, "atom record out of its columns, read by its words")            \
    X(ROW_LONG, SPH_USED_OTHERWISE,                                                                \
      "row of more values than its loop has names: those that are named are used")                 \
    X(FLAT, SPH_USED_OTHERWISE, "smoothing group of a mesh without normals: drawn flat")           \
    X(CORNER_COLOURS, SPH_USED_OTHERWISE, "face with colours at its corners: it has their mean")   \
    X(PART_MEAN, SPH_USED_OTHERWISE, "material with coloured highlights or glass: their mean")     \
    X(PART_LIMITED, SPH_USED_OTHERWISE, "material of a mesh whose colours are limited to 0..1")    \
    X(ROUGH, SPH_USED_OTHERWISE, "rough metal or glass: what mirrors or passes is sharp")          \
    X(CUTOUT, SPH_USED_OTHERWISE, "material that the alpha of its image cuts out: drawn whole")    \
    X(WRAP, SPH_USED_OTHERWISE, "image that ends or is mirrored at its edge: it repeats")          \
    X(LIGHT_PLAIN, SPH_USED_OTHERWISE,                                                             \
      "light of a glTF scene: it shines to all sides and does not weaken by distance")             \
    X(NO_AREA, SPH_LEFT_OUT, "triangle or polygon without area")                                   \
    X(NO_AREA_GRID, SPH_LEFT_OUT,                                                                  \
      "triangle without area on the grid of every profile that may be")                            \
    X(TRIANGLE_TWICE, SPH_LEFT_OUT, "triangle that stands there twice")                            \
    X(TRIANGLE_GRID, SPH_LEFT_OUT, "triangle that every grid merges with another one")             \
    X(SPHERE_TWICE, SPH_LEFT_OUT, "sphere that stands there twice")                                \
    X(SPHERE_GRID, SPH_LEFT_OUT, "sphere that every grid merges with another one")                 \
    X(SPHERE_SMALL, SPH_LEFT_OUT, "sphere too small for every grid")                               \
    X(NO_SIZE, SPH_LEFT_OUT, "primitive scaled to nothing")                                        \
    X(UNSUPPORTED, SPH_LEFT_OUT, "record that is not supported")                                   \
    X(WATER, SPH_LEFT_OUT, "atom of water")                                                        \
    X(OTHER_PLACE, SPH_LEFT_OUT, "atom at one of its less likely places")                          \
    X(SAME_PLACE, SPH_LEFT_OUT, "atom at the place of another one")                                \
    X(NO_ELEMENT, SPH_LEFT_OUT, "atom that is none: lone pair, dummy, virtual site")               \
    X(UNKNOWN, SPH_LEFT_OUT, "atom of no known element or radius")                                 \
    X(MODEL, SPH_LEFT_OUT, "atom of a later model")                                                \
    X(BOND_NONE, SPH_LEFT_OUT, "bond whose two atoms are not there, or at one place")              \
    X(BOND_WEAK, SPH_LEFT_OUT,                                                                     \
      "bond that is none of electrons shared: hydrogen bond, salt bridge")                         \
    X(BOND_FAR, SPH_LEFT_OUT, "bond to an atom of another cell of the crystal")                    \
    X(LINE, SPH_LEFT_OUT, "line or point of a mesh")                                               \
    X(PROPERTY, SPH_LEFT_OUT, "property of a PLY file that nothing here corresponds to")           \
    X(PART_OTHER, SPH_LEFT_OUT, "part of a mesh's material that nothing here corresponds to")      \
    X(MISSING, SPH_LEFT_OUT, "material library or image that cannot be read")                      \
    X(IMAGE_INSIDE, SPH_LEFT_OUT, "image that a glTF file holds as text")                          \
    X(CAMERA_OTHER, SPH_LEFT_OUT, "camera that is not chosen, or without perspective")             \
    X(LIGHT_OTHER, SPH_LEFT_OUT, "light that is dark, or beyond the eight brightest")              \
    X(ANIMATION, SPH_LEFT_OUT, "animation, skin or shape of a mesh: it is drawn at rest")          \
    X(EXTENSION, SPH_LEFT_OUT, "extension of glTF that is not known here")

enum sph_read {
#define SPH_READ_KIND(kind, end, name) SPH_READ_##kind,
    SPH_EACH_READ(SPH_READ_KIND)
#undef SPH_READ_KIND
        SPH_READS
};

struct sph_ledger {
    int strict; /* what is not used as it stands is an error */
    struct sph_ledger_row {
        uint64_t n;
        uint32_t line, other; /* of the first; of what it is beside: 0 if there is none */
        char file[512];       /* of the first */
    } row[SPH_READS];
};

/* Counts a record of file:line (0: no line). 0, or -1 with "file:line: what" under `strict` if it
 * is not used as it stands. ledger may be NULL. */
int sph_ledger_note(struct sph_ledger *ledger, enum sph_read kind, const char *file, uint32_t line,
                    struct sph_error *err);

/* The same of n records at once, and of one beside that of line `other`. */
int sph_ledger_add(struct sph_ledger *ledger, enum sph_read kind, uint64_t n, const char *file,
                   uint32_t line, uint32_t other, struct sph_error *err);

/* A record that was counted ended otherwise after all, and has been noted so. 0: not known which.
 */
void sph_ledger_take_back(struct sph_ledger *ledger, uint32_t kind);

enum sph_read_end sph_read_end(enum sph_read kind);
const char *sph_read_name(enum sph_read kind);        /* as above */
const char *sph_read_end_name(enum sph_read_end end); /* "used", "used otherwise", "left out" */
uint64_t sph_ledger_left_out(const struct sph_ledger *ledger);

/* Prints a line for each kind from an end on: "HEADfile:line: left out: triangle..., 3 times". */
void sph_ledger_print(const struct sph_ledger *ledger, enum sph_read_end from, const char *head,
                      FILE *to);

#ifdef __cplusplus
}
#endif

#endif
