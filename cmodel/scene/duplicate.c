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

static uint64_t hash(const struct sph_sphere *s) {
    uint64_t h = mix(bits(s->ctr.x) + 0x9e3779b97f4a7c15u);
    h = mix(h + bits(s->ctr.y));
    h = mix(h + bits(s->ctr.z));
    return mix(h + bits(s->rad));
}

static int same(const struct sph_sphere *p, const struct sph_sphere *q) {
    return p->ctr.x == q->ctr.x && p->ctr.y == q->ctr.y && p->ctr.z == q->ctr.z && p->rad == q->rad;
}

int sph_scene_duplicate(const struct sph_scene *scene, uint32_t *first, uint32_t *second,
                        struct sph_error *err) {
    size_t places = 16;
    while (places < 2 * (size_t)scene->n_spheres)
        places *= 2;
    uint32_t *table = malloc(places * sizeof *table);
    if (!table)
        return sph_fail(err, "%s: no memory to compare %u spheres", scene->path, scene->n_spheres);
    memset(table, 0xff, places * sizeof *table);
    int found = 0;
    for (uint32_t i = 0; i < scene->n_spheres && !found; i++) {
        size_t place = (size_t)hash(&scene->spheres[i]) & (places - 1);
        while (table[place] != EMPTY && !found) {
            if (same(&scene->spheres[table[place]], &scene->spheres[i])) {
                *first = table[place];
                *second = i;
                found = 1;
            }
            place = (place + 1) & (places - 1);
        }
        table[place] = i;
    }
    free(table);
    return found;
}
