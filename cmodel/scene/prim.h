/* prim.h - what a scene of real numbers asks of a primitive, of whatever kind it is
 * SPDX-License-Identifier: Apache-2.0
 *
 * scene/prim_NAME.c has the operations of each kind.
 */
#ifndef SPH_PRIM_SCENE_H
#define SPH_PRIM_SCENE_H

#include "scene/nff_reader.h"
#include "scene/nff_writer.h"

/* A record of a scene file; take: its first word is taken. */
struct sph_nff_word {
    const char *word;
    int (*take)(struct sph_reader *r, struct sph_error *err);
    enum sph_read kind; /* in the ledger */
};

struct sph_prim_scene {
    const struct sph_nff_word *words; /* that add such primitives, up to one of NULL */
    /* Writes sphere or facet i and those that the same record holds: how many. */
    uint32_t (*write)(struct sph_nff_writer *w, uint32_t i);
    /* Of a facet: so many of its vectors are points, the others directions, the first of them not
     * zero; what to ask for where they are not. */
    int points;
    const char *wants;
    /* Multiplies sizes that hang on no point; may be NULL. */
    void (*grow)(struct sph_facet *facet, double by);
};

/* The operations of a kind, SPH_SPHERE and so on. */
const struct sph_prim_scene *sph_prim_scene_of(uint32_t kind);

/* The record of any kind that begins with a word; NULL if there is none. */
const struct sph_nff_word *sph_prim_word(const char *word);

#endif
