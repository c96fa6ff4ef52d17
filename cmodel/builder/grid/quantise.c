/* quantise.c - spheres on the grid: zero radii and duplicates refused; see grid.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "builder/grid/grid.h"

void sph_finer_of(const struct sph_scene *scene, const struct sph_profile *profile, int axes,
                  struct sph_finer *finer) {
    finer->n = 0;
    for (int p = 0; p < SPH_PROFILES; p++)
        if (sph_profiles[p].w > profile->w &&
            !sph_grid_fit(scene, sph_profiles[p].w, axes, &finer->grid[finer->n], NULL))
            finer->profile[finer->n++] = p;
}

int sph_grid_finer(const struct sph_scene *scene, const struct sph_profile *profile, int axes,
                   double rad, double units) {
    struct sph_finer finer;
    sph_finer_of(scene, profile, axes, &finer);
    for (int i = 0; i < finer.n; i++)
        if (rad / finer.grid[i].step >= units) return finer.profile[i];
    return -1;
}

static int same(const struct sph_ball *a, const struct sph_ball *b) {
    return a->c[0] == b->c[0] && a->c[1] == b->c[1] && a->c[2] == b->c[2] && a->r == b->r;
}

/* The next finer profile that tells two spheres apart, or -1. */
static int finer_apart(const struct sph_scene *scene, const struct sph_profile *profile, int axes,
                       uint32_t i, uint32_t j) {
    struct sph_finer finer;
    sph_finer_of(scene, profile, axes, &finer);
    for (int k = 0; k < finer.n; k++) {
        struct sph_ball a = sph_grid_ball(&finer.grid[k], &scene->spheres[i]);
        struct sph_ball b = sph_grid_ball(&finer.grid[k], &scene->spheres[j]);
        if (!same(&a, &b)) return finer.profile[k];
    }
    return -1;
}

static int fail_duplicate(const struct sph_scene *scene, const struct sph_profile *profile,
                          int axes, uint32_t i, uint32_t j, struct sph_error *err) {
    const struct sph_sphere *a = &scene->spheres[i], *b = &scene->spheres[j];
    if (a->ctr.x == b->ctr.x && a->ctr.y == b->ctr.y && a->ctr.z == b->ctr.z && a->rad == b->rad)
        return sph_fail(err, "%s:%u: the same sphere as in line %u: remove one", scene->path,
                        b->line, a->line);
    int finer = finer_apart(scene, profile, axes, i, j);
    if (finer < 0)
        return sph_fail(err,
                        "%s:%u: the grid of profile %s merges this sphere with that of line %u, "
                        "and no finer profile separates them",
                        scene->path, b->line, profile->name, a->line);
    return sph_fail(err,
                    "%s:%u: the grid of profile %s merges this sphere with that of line %u: "
                    "profile %s separates them",
                    scene->path, b->line, profile->name, a->line, sph_profiles[finer].name);
}

static int fail_zero(const struct sph_scene *scene, const struct sph_profile *profile, uint32_t i,
                     const struct sph_grid *grid, struct sph_error *err) {
    const struct sph_sphere *s = &scene->spheres[i];
    int finer = sph_grid_finer(scene, profile, grid->axes, s->rad, 0.5);
    if (finer < 0)
        return sph_fail(err,
                        "%s:%u: radius %g is nothing on the grid of profile %s (step %g), and no "
                        "finer profile would do",
                        scene->path, s->line, s->rad, profile->name, grid->step);
    return sph_fail(err,
                    "%s:%u: radius %g is nothing on the grid of profile %s (step %g): profile %s "
                    "would do",
                    scene->path, s->line, s->rad, profile->name, grid->step,
                    sph_profiles[finer].name);
}

/* Mixes a ball's numbers (splitmix64 finaliser per word). */
static uint64_t hash(const struct sph_ball *b) {
    uint64_t h = (uint32_t)b->r;
    for (int i = 0; i < 3; i++) {
        h = (h ^ (uint32_t)b->c[i]) * 0xbf58476d1ce4e5b9u;
        h ^= h >> 29;
    }
    return h * 0x94d049bb133111ebu >> 20;
}

/* Looks for equal balls with an open hash table. */
static int duplicates(const struct sph_scene *scene, const struct sph_profile *profile, int axes,
                      const struct sph_ball *balls, struct sph_error *err) {
    uint64_t size = 4;
    while (size < 2ull * scene->n_spheres)
        size *= 2;
    uint32_t *table = calloc(size, sizeof *table); /* index + 1 */
    if (!table) return sph_fail(err, "out of memory for %u spheres", scene->n_spheres);
    int result = 0;
    for (uint32_t i = 0; i < scene->n_spheres && !result; i++) {
        uint64_t at = hash(&balls[i]) & (size - 1);
        for (; table[at] && !result; at = (at + 1) & (size - 1))
            if (same(&balls[table[at] - 1], &balls[i]))
                result = fail_duplicate(scene, profile, axes, table[at] - 1, i, err);
        table[at] = i + 1;
    }
    free(table);
    return result;
}

int sph_grid_spheres(const struct sph_grid *grid, const struct sph_scene *scene,
                     const struct sph_profile *profile, struct sph_ball *balls, double *smallest,
                     struct sph_error *err) {
    *smallest = scene->n_spheres ? INFINITY : 0;
    for (uint32_t i = 0; i < scene->n_spheres; i++) {
        balls[i] = sph_grid_ball(grid, &scene->spheres[i]);
        if (balls[i].r < 1) return fail_zero(scene, profile, i, grid, err);
        *smallest = fmin(*smallest, scene->spheres[i].rad / grid->step);
    }
    return duplicates(scene, profile, grid->axes, balls, err);
}
