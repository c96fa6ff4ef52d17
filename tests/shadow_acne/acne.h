/* acne.h - a machine's facets as real numbers: which of their points have light
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef ACNE_H
#define ACNE_H

#include "builder/build.h"
#include "prim/facet.h"
#include "prim/prim.h"
#include "trace/traverse.h"

/* Where a ray to a light starts: at the nearest point of the grid; at the next one outwards; there
 * too, but as the machine's do it meets no facet that the guarded point may have behind it. */
enum { NEAREST, OUTWARDS, GUARDED, RULES };

struct acne_facet {
    struct sph_facet_leaf leaf;
    long double n[3]; /* N */
};

struct acne {
    struct sph_machine m;
    const struct sph_profile *p;
    struct acne_facet *facet;
    long double (*sphere)[4]; /* centre, radius */
    uint32_t n_facets, n_spheres;
};

/* Reads and builds a scene. 0, or -1 with a message: as sph_scene_read() and sph_build() say, no
 * such profile, no memory. */
int acne_open(struct acne *w, const char *path, const char *profile, struct sph_error *err);
void acne_close(struct acne *w);

/* Where light l is, grid units; 0 if it is too far away for 64-bit numbers. */
int acne_light(const struct acne *w, int l, long double at[3]);

/* Distance of a point from a facet's plane, to the side of N. */
long double acne_height(const struct acne_facet *f, const long double at[3]);

/* Corners that two triangles have in common. */
int acne_common(const struct acne_facet *a, const struct acne_facet *b);

/* Whether anything lies between a point of a facet and a light. */
int acne_dark(const struct acne *w, const struct acne_facet *own, const long double at[3],
              const long double light[3]);

/* Whether some point of the facet within 4 units of `at` is dark or not, as `dark` says. */
int acne_explained(const struct acne *w, const struct acne_facet *own, const long double at[3],
                   const long double light[3], int dark);

#endif
