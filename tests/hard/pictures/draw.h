/* draw.h - frames of a machine's spheres: exactly, and in floating point
 * SPDX-License-Identifier: Apache-2.0
 *
 * All take the quantised scene out of the machine: its grid points are the numbers that the floats
 * start from, without error. Surfaces are matt; there are no mirror rays.
 */
#ifndef HARD_DRAW_H
#define HARD_DRAW_H

#include "../hard.h"
#include "machine/machine.h"

struct draw_scene {
    const struct sph_machine *m;
    uint32_t n;
    struct sph_leaf *spheres;
};

struct draw_pixel {
    uint32_t id; /* sphere seen, SPH_ID_NONE: background */
    uint8_t rgb[3];
};

/* A way to draw: one of SPH_F32_TEXTBOOK to SPH_F64_TEXTBOOK, every step rounded to its type; of
 * a shadow ray what lies nearer than epsilon, in grid units, does not count. */
struct draw_way {
    int formula;
    double epsilon;
};

/* Takes the spheres of a machine without facets; the caller frees spheres. Ends the program if
 * memory does not do. */
struct draw_scene draw_scene(const struct sph_machine *m);

struct draw_pixel draw_float(const struct draw_scene *s, struct draw_way way, int x, int y);

/* The sphere by exact integers (exact.h), the rest in long double; no ray hits the sphere that it
 * leaves. */
struct draw_pixel draw_exact(const struct draw_scene *s, int x, int y);

#endif
