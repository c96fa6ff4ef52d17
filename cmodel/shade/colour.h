/* colour.h - light, surface colour and the blend of reflection depths
 * SPDX-License-Identifier: Apache-2.0
 *
 * RTL: rtl/shade/rt_light_add.v, rtl/shade/rt_blend.v
 */
#ifndef SPH_COLOUR_H
#define SPH_COLOUR_H

#include <stdint.h>

#include "core/frame.h"
#include "math/arith.h"

/* Lambert's cosine of two unit vectors (Borodavka et al. VI.C), u1.15 0..32768, 0 if facing away.
 */
uint32_t sph_lambert(const struct sph_unit *normal, const struct sph_unit *to_light);

/* sum + cosine * intensity: u2.15 + u1.15 * u1.15, limited to 2^17-1. */
uint32_t sph_light_add(uint32_t sum, uint32_t cosine, uint32_t intensity);

/* albedo (0..255) * light (u2.15) as u8.8, limited to 255.0. */
uint32_t sph_surface_colour(uint32_t albedo, uint32_t light);

/* The pixel's frames as sums of shares, whatever the order of the surfaces
 * (docs/design/shading.md): colours at depth 0, 1 and the deepest, u8.8, limited to 2^16-1. */
struct sph_shares {
    uint32_t sum[SPH_FRAMES][3];
};

/* Adds the colour (u8.8) of a surface at depth: whole, u1.16, is the weight of the ray that found
 * it, own the part of it that is left to the surface itself. */
void sph_shares_add(struct sph_shares *s, int depth, uint32_t whole, uint32_t own,
                    const uint32_t colour[3]);

/* A frame, 0xBBGGRR. */
uint32_t sph_shares_colour(const struct sph_shares *s, int frame);

/* weight * part: u1.16 * u1.8, of 0..256. */
uint32_t sph_share(uint32_t weight, uint32_t part);

/* One ray after another, as rt_blend does it; sph_shares gives the same frames.
 * Col = (1-A)*C_F + A*C_R (Borodavka et al. VI.B), front to back: what is in front takes its share
 * first. colour: u8.8; kr: A as u1.8, 0..256. */
struct sph_blend {
    uint32_t sum[3]; /* u8.8 */
    uint32_t weight; /* u1.16 of all that lies behind */
    int depth;
    uint32_t colour[SPH_FRAMES]; /* 0xBBGGRR */
};

void sph_blend_start(struct sph_blend *b);

/* The colour seen at b->depth: closes the frames of this depth. last: nothing lies behind, closes
 * the deeper frames too. Otherwise moves on by one depth. */
void sph_blend_add(struct sph_blend *b, const uint32_t colour[3], uint32_t kr, int last);

/* ---- highlights: Phong's cosine and its power (RTL: rtl/shade/rt_specular.v) ---- */
/* Formats and bounds: docs/design/shading.md. */

/* R.V = L.D - 2 (N.L) (N.D), limited to 0..65536, u1.16: cosine between the mirror direction of the
 * light and the way back along the ray. Unit vectors of the normal, to the light, of the ray. */
uint32_t sph_specular_cosine(const struct sph_unit *normal, const struct sph_unit *to_light,
                             const struct sph_unit *dir);

/* -log2(c), u5.16, of c = 1..65536 (u1.16): by straight lines through the ends of 256 intervals, of
 * which sph_log2_table has the upper eight bits. */
uint32_t sph_specular_log2(uint32_t c);

/* c^power, u1.15 0..32768: c u1.16 up to 1, power u8.4. 2^-(power * -log2(c)). */
uint32_t sph_power(uint32_t c, uint32_t power);

#endif
