/* facets.c - see facets.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/facets.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "prim/triangle.h"

struct sph_ball sph_grid_whole(const struct sph_profile *profile) {
    int64_t half = 1ll << (profile->w - 1);
    return (struct sph_ball){.r = (int32_t)sph_ceil_sqrt(3 * half * half)};
}

/* A ball around three points: the smallest, up to the rounding of its centre. */
static struct sph_ball triangle_ball(const int32_t (*v)[3]) {
    static const uint32_t index[3] = {0, 1, 2};
    struct sph_ball corner[3] = {{.r = 0}}, out;
    double sphere[4];
    int64_t most = 0;
    for (int k = 0; k < 3; k++)
        memcpy(corner[k].c, v[k], sizeof corner[k].c);
    sph_enclose(corner, index, 3, sphere);
    for (int i = 0; i < 3; i++)
        out.c[i] = (int32_t)lround(sphere[i]);
    for (int k = 0; k < 3; k++) {
        int64_t sum = 0;
        for (int i = 0; i < 3; i++) {
            int64_t d = (int64_t)v[k][i] - out.c[i];
            sum += d * d;
        }
        if (sum > most) most = sum;
    }
    out.r = (int32_t)sph_ceil_sqrt(most);
    return out;
}

/* A direction in the camera's axes, its largest component as large as 24 bits allow. */
static void plane_normal(const struct sph_grid *grid, struct sph_vec n, int32_t out[3]) {
    const double *m = grid->rotation, top = (1 << (SPH_PLANE_N_X_BITS - 1)) - 1;
    double turned[3], size = fmax(fabs(n.x), fmax(fabs(n.y), fabs(n.z))), most = 0;
    for (int i = 0; i < 3; i++) {
        turned[i] =
            m[3 * i] * (n.x / size) + m[3 * i + 1] * (n.y / size) + m[3 * i + 2] * (n.z / size);
        most = fmax(most, fabs(turned[i]));
    }
    for (int i = 0; i < 3; i++)
        out[i] = (int32_t)lround(turned[i] / most * top);
}

/* One facet on the grid. 0 if it is a triangle without area there. */
static int quantise(const struct sph_grid *grid, const struct sph_scene *scene, uint32_t i,
                    const struct sph_profile *profile, struct sph_grid_facet *out) {
    const struct sph_facet *f = &scene->facets[i];
    *out = (struct sph_grid_facet){.kind = f->kind, .scene = i};
    sph_grid_point(grid, scene, f->v[0], out->v[0]);
    if (f->kind == SPH_PLANE) {
        plane_normal(grid, f->v[1], out->v[1]);
        memcpy(out->normal, out->v[1], sizeof out->normal);
        out->ball = sph_grid_whole(profile);
        return 1;
    }
    sph_grid_point(grid, scene, f->v[1], out->v[1]);
    sph_grid_point(grid, scene, f->v[2], out->v[2]);
    if (!sph_triangle_normal((const int32_t(*)[3])out->v, out->normal)) return 0;
    out->ball = triangle_ball((const int32_t(*)[3])out->v);
    return 1;
}

static int compare(const int32_t a[3], const int32_t b[3]) {
    for (int i = 0; i < 3; i++)
        if (a[i] != b[i]) return a[i] < b[i] ? -1 : 1;
    return 0;
}

/* The corners of a triangle in rising order. */
static void sorted(const struct sph_grid_facet *f, int32_t v[3][3]) {
    memcpy(v, f->v, sizeof f->v);
    for (int i = 0; i < 3; i++) {
        int a = i == 1, b = a + 1; /* 0-1, 1-2, 0-1 */
        int32_t swap[3];
        if (compare(v[a], v[b]) <= 0) continue;
        memcpy(swap, v[a], sizeof swap);
        memcpy(v[a], v[b], sizeof swap);
        memcpy(v[b], swap, sizeof swap);
    }
}

/* Whether two facets are the same set of points: triangles with the same corners, planes with
 * parallel normals, less than a grid unit apart. */
static int same(const struct sph_grid_facet *a, const struct sph_grid_facet *b) {
    int32_t p[3][3], q[3][3];
    if (a->kind != b->kind) return 0;
    if (a->kind == SPH_TRIANGLE) {
        sorted(a, p), sorted(b, q);
        return !memcmp(p, q, sizeof p);
    }
    int64_t off = 0, square = 0;
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3;
        if ((int64_t)a->v[1][i] * b->v[1][j] != (int64_t)a->v[1][j] * b->v[1][i]) return 0;
        off += (int64_t)a->v[1][i] * (b->v[0][i] - a->v[0][i]);
        square += (int64_t)a->v[1][i] * a->v[1][i];
    }
    return (__int128)off * off < square;
}

static int fail_duplicate(const struct sph_scene *scene, const struct sph_profile *profile,
                          const struct sph_grid_facet *a, const struct sph_grid_facet *b,
                          struct sph_error *err) {
    const char *what = b->kind == SPH_PLANE ? "plane" : "triangle";
    uint32_t first = scene->facets[a->scene].line, second = scene->facets[b->scene].line;
    for (int p = 0; p < SPH_PROFILES; p++) {
        struct sph_grid grid;
        struct sph_grid_facet c, d;
        if (sph_profiles[p].w <= profile->w || sph_grid_fit(scene, sph_profiles[p].w, &grid, NULL))
            continue;
        quantise(&grid, scene, a->scene, &sph_profiles[p], &c);
        quantise(&grid, scene, b->scene, &sph_profiles[p], &d);
        if (!same(&c, &d))
            return sph_fail(err,
                            "%s:%u: the grid of profile %s merges this %s with that of line %u: "
                            "profile %s separates them",
                            scene->path, second, profile->name, what, first, sph_profiles[p].name);
    }
    return sph_fail(err,
                    "%s:%u: the same %s as in line %u, on the grid of every profile from %s on",
                    scene->path, second, what, first, profile->name);
}

/* Mixes the corners of a triangle; 0 for every plane. */
static uint64_t hash(const struct sph_grid_facet *f) {
    int32_t v[3][3];
    uint64_t h = 0;
    if (f->kind == SPH_PLANE) return 0;
    sorted(f, v);
    for (int i = 0; i < 9; i++) {
        h = (h ^ (uint32_t)v[i / 3][i % 3]) * 0xbf58476d1ce4e5b9u;
        h ^= h >> 29;
    }
    return h * 0x94d049bb133111ebu >> 20;
}

/* Looks for equal facets with an open hash table. */
static int duplicates(const struct sph_scene *scene, const struct sph_profile *profile,
                      const struct sph_facets *facets, struct sph_error *err) {
    uint64_t size = 4;
    while (size < 2ull * facets->n)
        size *= 2;
    uint32_t *table = calloc(size, sizeof *table); /* index + 1 */
    if (!table) return sph_fail(err, "out of memory for %u triangles", facets->n);
    int result = 0;
    for (uint32_t i = 0; i < facets->n && !result; i++) {
        uint64_t at = hash(&facets->list[i]) & (size - 1);
        for (; table[at] && !result; at = (at + 1) & (size - 1))
            if (same(&facets->list[table[at] - 1], &facets->list[i]))
                result = fail_duplicate(scene, profile, &facets->list[table[at] - 1],
                                        &facets->list[i], err);
        table[at] = i + 1;
    }
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
            facets->n_planes += to->kind == SPH_PLANE;
            if (facets->n_planes > SPH_MAX_PLANES)
                return sph_fail(err, "%s:%u: more than %d planes", scene->path,
                                scene->facets[i].line, SPH_MAX_PLANES);
        } else if (!facets->n_empty++) {
            facets->first_empty = i;
        }
    }
    sph_group_facets(scene, facets);
    return duplicates(scene, profile, facets, err);
}

void sph_facets_free(struct sph_facets *facets) {
    free(facets->list);
    memset(facets, 0, sizeof *facets);
}
