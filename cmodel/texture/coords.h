/* coords.h - texture coordinates of a hit
 * SPDX-License-Identifier: Apache-2.0
 *
 * Both kinds of mapping record, drawn in machine.def; formats: docs/design/textures.md.
 */
#ifndef SPH_COORDS_H
#define SPH_COORDS_H

#include <stdint.h>

/* ---- longitude and latitude by shift and add (RTL: rtl/texture/rt_longitude.v) ---- */
/* Two rotations by CORDIC: (z, x) gives the longitude and the distance from the axis, which with y
 * gives the latitude. Formats, bounds, poles and seam: docs/design/textures.md. */

struct sph_longitude {
    uint32_t around; /* u0.18 turns, 1/2 + atan2(x, z): 0 towards -z, rises towards -x, +z, +x */
    uint32_t down;   /* u1.17, 0 at +y, 1 at -y: acos(y) over half a turn */
};

/* Of v, s2.16 each; only its direction counts, best at a length of 1. On the axis (x = z = 0)
 * around is 1/2; a vector of zeros has down = 1/2. */
struct sph_longitude sph_longitude(const int32_t v[3]);

enum { SPH_ST_FRACTION = 20, SPH_ST_BITS = 40 };

/* One repeat of the image is 1; s to the right, t down. */
struct sph_st {
    int64_t at[2]; /* s19.20, modulo 2^20 repeats */
};

/* What a textured surface knows of the hit. */
struct sph_textured {
    int64_t guarded[3]; /* s(W+NG), hit point */
    int32_t unit[3];    /* s1.16, normal towards the ray's side */
    int far;            /* hit from inside: the normal is turned */
    uint64_t path;      /* u(W+4).4, from the eye to the hit */
};

/* A facet's s and t are linear in the hit point: s_0 + (s_x s_y s_z).point * 2^-s_e, half up. */
struct sph_st sph_coords_facet(const uint32_t *map, const int64_t guarded[3]);

/* A sphere's are its longitude and latitude, scaled and moved. The nine turns of the record bring
 * the normal into the frame of the texture. */
struct sph_st sph_coords_sphere(const uint32_t *map, const int32_t unit[3], int far);

/* By the kind of the record; bit 0 of it decides. */
struct sph_st sph_coords(const uint32_t *map, const struct sph_textured *where);

#endif
