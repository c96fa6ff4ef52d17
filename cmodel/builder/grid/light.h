/* light.h - lights beyond the grid: a position in steps of 2^shift grid units
 * SPDX-License-Identifier: Apache-2.0
 *
 * The machine's vector from a point P to a light is v = L - round(P / 2^shift), a word of WD bits;
 * the light stands at P + v (docs/design/builder.md). With shift 0 that is the light itself. Beyond
 * the grid v is shorter than the way to the light by about 2^shift, and nothing may stand behind P
 * + v.
 */
#ifndef SPH_GRID_LIGHT_H
#define SPH_GRID_LIGHT_H

#include "builder/grid/grid.h"

/* Grid units, rounded outwards, and the greatest radius: what has an end, and may stand in a way.
 */
struct sph_extent {
    double lo[3], hi[3], rad;
};

/* The words L of a light and its shift, 0 if it lies on the grid. */
int sph_grid_light(const struct sph_grid *grid, struct sph_vec pos, int32_t out[3]);

/* Whether a light that is not on the grid is as good as there: for every P of the extent
 *
 * - along the axis k in which L is longest, P + v lies beyond the extent. P_k - round(P_k /
 * 2^shift) rises with P_k, so the end of the extent that is farther from the light decides;
 * - rad^2 - (P + v - ctr)^2 of a sphere around P, which a shadow ray asks for, is no longer than
 * its word, s(2W+3): |P + v - ctr| <= |v| + rad, so |v|^2 + 2 |v| rad <= 2^(2W+2) does. */
int sph_light_sound(const struct sph_grid *grid, struct sph_vec pos,
                    const struct sph_extent *extent);

/* Whether a light has no colour in the machine: then it reaches nothing, and the grid need not hold
 * it. */
int sph_light_black(const struct sph_light *light);

/* How far the machine's light may be from where it stands, in units of the scene. */
double sph_light_off(const struct sph_grid *grid, struct sph_vec pos);

#endif
