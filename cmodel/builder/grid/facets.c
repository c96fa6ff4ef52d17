/* facets.c - see facets.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/grid/facets.h"

#include <stdlib.h>
#include <string.h>

#include "builder/prim/build.h"
#include "machine/records.h"
#include "machine/layout.h"
#include "prim/prim.h"
#include "scene/prim.h"
#include "scene/record.h"

static const struct sph_prim_build *kind_of(const struct sph_grid_facet *f) {
    return sph_prim_build_of((uint32_t)f->kind);
}

/* Facet i on the grid. 0 if nothing is left of it there. */
static int quantise(const struct sph_grid *grid, const struct sph_scene *scene, uint32_t i,
                    const struct sph_profile *profile, struct sph_grid_facet *out) {
    *out = (struct sph_grid_facet){.kind = scene->facets[i].kind, .scene = i};
    return kind_of(out)->quantise(grid, scene, profile, out);
}

/* Whether two facets are the same set of points. */
static int same(const struct sph_grid_facet *a, const struct sph_grid_facet *b) {
    return a->kind == b->kind && kind_of(a)->same(a, b);
}

/* The next finer profile that tells two facets apart, or -1. */
static int finer_apart(const struct sph_scene *scene, const struct sph_finer *finer,
                       const struct sph_grid_facet *a, const struct sph_grid_facet *b) {
    for (int i = 0; i < finer->n; i++) {
        const struct sph_profile *profile = &sph_profiles[finer->profile[i]];
        struct sph_grid_facet c, d;
        quantise(&finer->grid[i], scene, a->scene, profile, &c);
        quantise(&finer->grid[i], scene, b->scene, profile, &d);
        if (!same(&c, &d)) return finer->profile[i];
    }
    return -1;
}

static int fail_duplicate(const struct sph_scene *scene, const struct sph_profile *profile,
                          int finer, const struct sph_grid_facet *a, const struct sph_grid_facet *b,
                          struct sph_error *err) {
    const char *what = sph_kind_name((uint32_t)b->kind);
    char first[SPH_PLACE], second[SPH_PLACE];
    sph_record_line(first, scene->facets[a->scene].line, what, a->scene);
    sph_record_place(second, scene->path, scene->facets[b->scene].line, what, b->scene);
    if (finer < 0)
        return sph_fail(err, "%s: the same %s as in %s, on the grid of every profile from %s on",
                        second, what, first, profile->name);
    return sph_fail(err,
                    "%s: the grid of profile %s merges this %s with that of %s: profile %s "
                    "separates them",
                    second, profile->name, what, first, sph_profiles[finer].name);
}

/* Whether two facets that have corners have the same ones in the scene. */
static int twice(const struct sph_facet *a, const struct sph_facet *b) {
    int n = sph_prim_scene_of((uint32_t)a->kind)->points, found = 0;
    if (a->kind != b->kind || n < 3) return 0;
    for (int i = 0; i < n; i++)
        for (int k = 0; k < n; k++)
            found |= (a->v[i].x == b->v[k].x && a->v[i].y == b->v[k].y && a->v[i].z == b->v[k].z)
                     << i;
    return found == (1 << n) - 1;
}

/* Facet b is the same on the grid as facet a, but not in the scene: it is left out, and counted, if
 * it is a triangle that no finer profile tells from the other: no ray could tell which of them it
 * met. */
static int merge(const struct sph_scene *scene, const struct sph_profile *profile,
                 const struct sph_finer *finer, const struct sph_grid_facet *a,
                 const struct sph_grid_facet *b, struct sph_facets *facets, struct sph_error *err) {
    int apart = finer_apart(scene, finer, a, b);
    if (apart >= 0 || sph_kind_unbounded((uint32_t)b->kind))
        return fail_duplicate(scene, profile, apart, a, b, err);
    if (!facets->n_merged++) facets->first_merged = b->scene;
    return 0;
}

/* Looks for equal facets with an open hash table. A triangle that stands in the scene a second time
 * is left out. */
static int duplicates(const struct sph_scene *scene, const struct sph_profile *profile, int axes,
                      struct sph_facets *facets, struct sph_error *err) {
    uint64_t size = 4;
    while (size < 2ull * facets->n)
        size *= 2;
    uint32_t *table = calloc(size, sizeof *table); /* index + 1 */
    if (!table) return sph_fail(err, "out of memory for %u triangles", facets->n);
    struct sph_finer finer = {.n = -1}; /* made when it is asked for */
    int result = 0;
    uint32_t kept = 0;
    for (uint32_t i = 0; i < facets->n && !result; i++) {
        const struct sph_grid_facet *f = &facets->list[i], *old = NULL;
        uint64_t at = kind_of(f)->hash(f) & (size - 1);
        for (; table[at] && !old; at = (at + 1) & (size - 1))
            if (same(&facets->list[table[at] - 1], f)) old = &facets->list[table[at] - 1];
        if (!old) {
            facets->list[kept] = *f;
            table[at] = ++kept;
        } else if (twice(&scene->facets[old->scene], &scene->facets[f->scene])) {
            if (!facets->n_twice++) facets->first_twice = f->scene;
        } else {
            if (finer.n < 0) sph_finer_of(scene, profile, axes, &finer);
            result = merge(scene, profile, &finer, old, f, facets, err);
        }
    }
    facets->n = kept;
    free(table);
    return result;
}

int sph_grid_facets(const struct sph_grid *grid, const struct sph_scene *scene,
                    const struct sph_profile *profile, struct sph_facets *facets,
                    struct sph_error *err) {
    memset(facets, 0, sizeof *facets);
    if (!scene->n_facets) return 0;
    facets->list = malloc(scene->n_facets * sizeof *facets->list);
    if (!facets->list) return sph_fail(err, "out of memory for %u triangles", scene->n_facets);
    for (uint32_t i = 0; i < scene->n_facets; i++) {
        struct sph_grid_facet *to = &facets->list[facets->n];
        if (quantise(grid, scene, i, profile, to)) {
            facets->n++;
            facets->n_loose += (uint32_t)sph_kind_unbounded((uint32_t)to->kind);
            if (facets->n_loose > SPH_MAX_PLANES)
                return sph_fail(err, "%s:%u: more than %d planes", scene->path,
                                scene->facets[i].line, SPH_MAX_PLANES);
        } else if (!facets->n_empty++) {
            facets->first_empty = i;
        }
    }
    if (duplicates(scene, profile, grid->axes, facets, err)) return -1;
    sph_group_facets(scene, facets);
    return 0;
}

void sph_facets_free(struct sph_facets *facets) {
    free(facets->list);
    memset(facets, 0, sizeof *facets);
}

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
