/* quantise.c - spheres on the grid, and which of them are lost there; see grid.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "builder/grid/grid.h"
#include "scene/record.h"

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

/* What spheres are looked at for. */
struct task {
    const struct sph_scene *scene;
    const struct sph_profile *profile;
    const struct sph_grid *grid;
    struct sph_ball *balls;
    uint8_t *lost;
    struct sph_finer finer; /* n is -1 before it is asked for */
};

static const struct sph_finer *finer_of(struct task *t) {
    if (t->finer.n < 0) sph_finer_of(t->scene, t->profile, t->grid->axes, &t->finer);
    return &t->finer;
}

/* Spheres i and j are one on the grid: j is lost, or a finer profile tells them apart. */
static int merge(struct task *t, uint32_t i, uint32_t j, struct sph_error *err) {
    const struct sph_sphere *s = t->scene->spheres;
    const struct sph_finer *finer = finer_of(t);
    for (int k = 0; k < finer->n; k++) {
        struct sph_ball a = sph_grid_ball(&finer->grid[k], &s[i]);
        struct sph_ball b = sph_grid_ball(&finer->grid[k], &s[j]);
        char first[SPH_PLACE], second[SPH_PLACE];
        if (!same(&a, &b))
            return sph_fail(err,
                            "%s: the grid of profile %s merges this sphere with that of %s: "
                            "profile %s separates them",
                            sph_record_place(second, t->scene->path, s[j].line, "sphere", j),
                            t->profile->name, sph_record_line(first, s[i].line, "sphere", i),
                            sph_profiles[finer->profile[k]].name);
    }
    t->lost[j] = SPH_READ_SPHERE_GRID;
    return 0;
}

/* Sphere i is nothing on the grid: it is lost, or a finer profile has it. */
static int vanish(struct task *t, uint32_t i, struct sph_error *err) {
    const struct sph_sphere *s = &t->scene->spheres[i];
    const struct sph_finer *finer = finer_of(t);
    char text[SPH_PLACE];
    for (int k = 0; k < finer->n; k++)
        if (s->rad / finer->grid[k].step >= 0.5)
            return sph_fail(err,
                            "%s: radius %g is nothing on the grid of profile %s (step %g): "
                            "profile %s would do",
                            sph_record_place(text, t->scene->path, s->line, "sphere", i), s->rad,
                            t->profile->name, t->grid->step, sph_profiles[finer->profile[k]].name);
    t->lost[i] = SPH_READ_SPHERE_SMALL;
    return 0;
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
static int duplicates(struct task *t, struct sph_error *err) {
    uint32_t n = t->scene->n_spheres;
    uint64_t size = 4;
    while (size < 2ull * n)
        size *= 2;
    uint32_t *table = calloc(size, sizeof *table); /* index + 1 */
    if (!table) return sph_fail(err, "out of memory for %u spheres", n);
    int result = 0;
    for (uint32_t i = 0; i < n && !result; i++) {
        uint64_t at = hash(&t->balls[i]) & (size - 1);
        for (; table[at] && !t->lost[i] && !result; at = (at + 1) & (size - 1))
            if (same(&t->balls[table[at] - 1], &t->balls[i]))
                result = merge(t, table[at] - 1, i, err);
        if (!t->lost[i]) table[at] = i + 1;
    }
    free(table);
    return result;
}

int sph_grid_spheres(const struct sph_grid *grid, const struct sph_scene *scene,
                     const struct sph_profile *profile, struct sph_ball *balls, uint8_t *lost,
                     double *smallest, struct sph_error *err) {
    struct task t = {scene, profile, grid, balls, lost, {.n = -1}};
    *smallest = scene->n_spheres ? INFINITY : 0;
    for (uint32_t i = 0; i < scene->n_spheres; i++) {
        balls[i] = sph_grid_ball(grid, &scene->spheres[i]);
        if (balls[i].r < 1 && vanish(&t, i, err)) return -1;
        *smallest = fmin(*smallest, scene->spheres[i].rad / grid->step);
    }
    if (duplicates(&t, err)) return -1;
    for (uint32_t i = 0; i < scene->n_spheres; i++)
        if (lost[i]) return 1;
    return 0;
}
