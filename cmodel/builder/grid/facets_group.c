/* facets_group.c - which triangles are one polygon; see facets.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <string.h>

#include "builder/grid/facets.h"
#include "machine/layout.h"
#include "builder/prim/build.h"

/* Six times the volume that p spans with a triangle: 0 if p lies in its plane. At most 49 + 26
 * bits. */
static __int128 volume(const struct sph_grid_facet *f, const int32_t p[3]) {
    int64_t e[3][3];
    __int128 sum = 0;
    for (int i = 0; i < 3; i++) {
        e[0][i] = (int64_t)f->v[1][i] - f->v[0][i];
        e[1][i] = (int64_t)f->v[2][i] - f->v[0][i];
        e[2][i] = (int64_t)p[i] - f->v[0][i];
    }
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        sum += (__int128)(e[0][j] * e[1][k] - e[0][k] * e[1][j]) * e[2][i];
    }
    return sum;
}

static int coplanar(const struct sph_grid_facet *a, const struct sph_grid_facet *b) {
    for (int k = 0; k < 3; k++)
        if (volume(a, b->v[k]) != 0) return 0;
    return 1;
}

/* Whether two triangles have two corners in common. */
static int share_edge(const struct sph_grid_facet *a, const struct sph_grid_facet *b) {
    int common = 0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            common += !memcmp(a->v[i], b->v[j], sizeof a->v[i]);
    return common >= 2;
}

static int may_join(const struct sph_grid_facet *f) {
    return sph_prim_build_of((uint32_t)f->kind)->joins;
}

/* Whether facet i belongs to the polygon of facet i - 1, whose first facet is `first` and which is
 * exactly flat or not. A polygon of the file belongs to no other one: it may be bent a little. */
static int joins(const struct sph_scene *scene, const struct sph_facets *facets, uint32_t i,
                 uint32_t first, int flat) {
    const struct sph_grid_facet *f = facets->list;
    uint32_t group = scene->facets[f[i].scene].group;
    if (group == scene->facets[f[i - 1].scene].group) return 1;
    if (i + 1 < facets->n && group == scene->facets[f[i + 1].scene].group) return 0;
    return flat && may_join(&f[i]) && may_join(&f[i - 1]) && coplanar(&f[first], &f[i]) &&
           share_edge(&f[i - 1], &f[i]);
}

void sph_group_facets(const struct sph_scene *scene, struct sph_facets *facets) {
    struct sph_grid_facet *f = facets->list;
    for (uint32_t first = 0, end; first < facets->n; first = end) {
        int flat = 1;
        for (end = first + 1; end < facets->n && end - first < SPH_MAX_GROUP; end++) {
            if (!joins(scene, facets, end, first, flat)) break;
            flat = flat && coplanar(&f[first], &f[end]);
        }
        for (uint32_t i = first; i < end; i++) {
            f[i].before = (uint8_t)(i - first);
            f[i].after = (uint8_t)(end - 1 - i);
        }
    }
}
