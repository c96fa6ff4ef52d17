/* material.h - what a primitive record says of its surface           RTL: rtl/shade/rt_share.v
 * SPDX-License-Identifier: Apache-2.0
 *
 * Shares and words: docs/design/shading.md, docs/design/shading.md.
 */
#ifndef SPH_MATERIAL_H
#define SPH_MATERIAL_H

#include "core/stages.h"
#include "machine/machine.h"

struct sph_shading {
    uint32_t rgb[3];
    uint32_t kr, kt;    /* u1.8; 0 if the machine has no such rays */
    int sum;            /* the colour counts whole, what rays bring comes on top */
    uint32_t ka, kd;    /* u1.8; 256 without sum */
    uint32_t ks, power; /* u8, u8.4; 0 without highlights */
    uint32_t index;     /* of refraction, thousandths */
};

/* The mirror share of a record, u1.8. A share that is more than 1 counts as 1. */
uint32_t sph_shading_mirror(const uint32_t *prim);

/* The record as the effects of the machine let it count. */
struct sph_shading sph_shading_read(const struct sph_machine *m, const uint32_t *prim);

/* The line MATERIAL: core/stages.h. */
void sph_shading_note(struct sph_stages *s, const struct sph_shading *shading);

/* The share that counts of one whose ray would have this weight (u1.16) times it: none if that is
 * less than `least`, u1.8. */
uint32_t sph_shading_worth(uint32_t weight, uint32_t part, uint32_t least);

/* Light of a surface, u2.15: the ambient light and that of the lights, each by its share. */
uint32_t sph_shading_light(const struct sph_shading *shading, uint32_t ambient, uint32_t lights);

/* The share that is left to the surface itself, u1.8, when rays of kr and kt leave it. */
uint32_t sph_shading_own(const struct sph_shading *shading, uint32_t kr, uint32_t kt);

#endif
