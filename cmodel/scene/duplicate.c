/* duplicate.c - finds spheres that are exactly the same; see edit.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * Open addressing: a table of sphere numbers with at least two places for every sphere. The
 * table holds 4 bytes a place, so 16 million spheres take 128 MiB.
 */
#include "scene/edit.h"

#include <stdlib.h>
#include <string.h>

#define EMPTY UINT32_MAX

/* The finishing step of SplitMix64: spreads every bit over the word. */
static uint64_t mix(uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/* The bits of a number; both zeros give the same bits, as they compare equal. */
static uint64_t bits(double value) {
    double sum = value + 0.0;
    uint64_t word;
    memcpy(&word, &sum, sizeof word);
    return word;
}

/* Spheres seen so far, by what counts as the same. */
struct seen {
    const struct sph_scene *scene;
    int with_rad; /* same centre and radius; 0: same centre */
    size_t places;
    uint32_t *table;
};

static int open_seen(struct seen *seen, struct sph_error *err) {
    uint32_t n = seen->scene->n_spheres;
    seen->places = 16;
    while (seen->places < 2 * (size_t)n)
        seen->places *= 2;
    seen->table = malloc(seen->places * sizeof *seen->table);
    if (!seen->table)
        return sph_fail(err, "%s: no memory to compare %u spheres", seen->scene->path, n);
    memset(seen->table, 0xff, seen->places * sizeof *seen->table);
    return 0;
}

static uint64_t hash(const struct seen *seen, const struct sph_sphere *s) {
    uint64_t h = mix(bits(s->ctr.x) + 0x9e3779b97f4a7c15u);
    h = mix(h + bits(s->ctr.y));
    h = mix(h + bits(s->ctr.z));
    return seen->with_rad ? mix(h + bits(s->rad)) : h;
}

static int same(const struct seen *seen, const struct sph_sphere *p, const struct sph_sphere *q) {
    return p->ctr.x == q->ctr.x && p->ctr.y == q->ctr.y && p->ctr.z == q->ctr.z &&
           (!seen->with_rad || p->rad == q->rad);
}

/* The sphere seen before that is the same as number i; if there is none, i itself, which counts
 * as seen from then on. */
static uint32_t see(struct seen *seen, uint32_t i) {
    const struct sph_sphere *all = seen->scene->spheres;
    size_t place = (size_t)hash(seen, &all[i]) & (seen->places - 1);
    while (seen->table[place] != EMPTY) {
        if (same(seen, &all[seen->table[place]], &all[i])) return seen->table[place];
        place = (place + 1) & (seen->places - 1);
    }
    return seen->table[place] = i;
}

int sph_scene_duplicate(const struct sph_scene *scene, uint32_t *first, uint32_t *second,
                        struct sph_error *err) {
    struct seen seen = {.scene = scene, .with_rad = 1};
    int found = 0;
    if (open_seen(&seen, err)) return -1;
    for (uint32_t i = 0; i < scene->n_spheres && !found; i++) {
        uint32_t same_as = see(&seen, i);
        if (same_as == i) continue;
        *first = same_as;
        *second = i;
        found = 1;
    }
    free(seen.table);
    return found;
}

int sph_scene_drop_twice(struct sph_scene *scene, enum sph_read kind, struct sph_error *err) {
    struct seen seen = {.scene = scene, .with_rad = kind == SPH_READ_SPHERE_TWICE};
    enum sph_read was = seen.with_rad ? SPH_READ_SPHERE : SPH_READ_ATOM;
    uint64_t *used = &scene->ledger.row[was].n;
    uint32_t n_kept = 0;
    int rc = 0;
    if (open_seen(&seen, err)) return -1;
    for (uint32_t i = 0; i < scene->n_spheres && !rc; i++) {
        scene->spheres[n_kept] = scene->spheres[i]; /* spheres after n_kept are not in the table */
        uint32_t same_as = see(&seen, n_kept);
        if (same_as == n_kept)
            n_kept++;
        else
            rc = sph_ledger_add(&scene->ledger, kind, 1, scene->path, scene->spheres[n_kept].line,
                                scene->spheres[same_as].line, err);
    }
    *used -= *used >= scene->n_spheres - n_kept ? scene->n_spheres - n_kept : 0;
    scene->n_spheres = n_kept;
    free(seen.table);
    return rc;
}
