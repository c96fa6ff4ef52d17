/* leaf_unit.c - see leaf_unit.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "trace/leaf_unit.h"

#include "trace/node.h"

/* A hit that comes first replaces *best. */
static void keep(struct sph_hit *best, struct sph_hit hit) {
    if (!best->key || hit.key < best->key || (hit.key == best->key && hit.id < best->id))
        *best = hit;
}

/* Exact test of one sphere, its key of pr root bits. */
static void sphere_visit(const struct sph_ray *ray, const struct sph_leaf *leaf, int pr,
                         struct sph_hit *best, struct sph_counters *c) {
    struct sph_leaf_result r = sph_leaf_test(ray, leaf);
    c->count[SPH_COUNT_LEAF_TESTS]++;
    if (!r.hit) return;
    uint64_t key =
        ray->kind == SPH_SHADOW ? 1 : sph_leaf_key_bits(&r, pr, &c->count[SPH_COUNT_ROOTS]);
    keep(best, (struct sph_hit){key, leaf->id, r.far});
}

/* Exact test of what a leaf line of a machine with FACETS holds; of no kind: a miss and an error.
 */
static void line_visit(const struct sph_profile *p, const struct sph_ray *ray, const uint32_t *line,
                       struct sph_hit *best, struct sph_counters *c, uint32_t *errors) {
    int kind = sph_leaf_kind(line);
    if (kind > SPH_PLANE) {
        *errors |= 1u << SPH_ERROR_BAD_NODE;
        return;
    }
    if (!kind) {
        struct sph_leaf sphere = sph_leaf_read(line, 0, p->w);
        sphere_visit(ray, &sphere, p->pr, best, c);
        return;
    }
    struct sph_facet_leaf facet = sph_facet_read(line, p->w);
    struct sph_facet_result r = sph_facet_test(p, ray, &facet);
    c->count[SPH_COUNT_FACET_TESTS]++;
    if (!r.hit) return;
    uint64_t key =
        ray->kind == SPH_SHADOW ? 1 : sph_facet_key(ray, &r, &c->count[SPH_COUNT_DIVISIONS]);
    keep(best, (struct sph_hit){key, facet.id, r.far});
}

void sph_leaf_visit(const struct sph_profile *p, const struct sph_ray *ray, const uint32_t *line,
                    int half, int whole, struct sph_hit *best, struct sph_counters *c,
                    uint32_t *errors) {
    if (whole) {
        line_visit(p, ray, line, best, c, errors);
    } else {
        struct sph_leaf sphere = sph_leaf_read(line, half, p->w);
        sphere_visit(ray, &sphere, p->pr, best, c);
    }
}
