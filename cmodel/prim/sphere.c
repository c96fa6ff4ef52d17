/* sphere.c - a sphere behind the interface of primitives; see prim.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "prim/sphere.h"

#include <string.h>

#include "core/stages.h"
#include "math/arith.h"
#include "prim/prim.h"

/* ---- leaf ---- */

struct sph_leaf_result sph_leaf_test(const struct sph_ray *ray, const struct sph_leaf *leaf) {
    struct sph_leaf_result r = {0};
    const int64_t *d = ray->dir;
    int64_t oc[3], a = (int64_t)ray->a;
    for (int i = 0; i < 3; i++)
        oc[i] = leaf->ctr[i] - ray->org[i];
    r.b = oc[0] * d[0] + oc[1] * d[1] + oc[2] * d[2];
    r.k = leaf->rad * leaf->rad - (oc[0] * oc[0] + oc[1] * oc[1] + oc[2] * oc[2]);
    r.disc = (sph_i128)r.k * a + (sph_i128)r.b * r.b;

    int own = leaf->id == ray->skip.id;
    if (ray->inside ? own && !ray->skip.inside : own || r.k >= 0) return r;
    r.far = r.k >= 0 || own; /* own: the origin is inside whatever rounding did to k */
    if (sph_ray_ends(ray)) {
        int64_t k_light = r.k + 2 * r.b - a; /* rad^2 - |light - ctr|^2, s(2W+3) */
        if (own)
            r.hit = k_light < 0;
        else if (r.k < 0)
            r.hit = r.disc > 0 && r.b > 0 && (r.b < a || k_light > 0);
        else
            r.hit = (r.k > 0 || r.b > 0) && k_light < 0;
    } else {
        int ahead = r.disc > 0 && (r.b > 0 || r.k > 0);
        r.exit = own && !ahead;
        r.hit = ahead || own;
    }
    return r;
}

uint64_t sph_leaf_root(const struct sph_leaf_result *r, int pr, int *inexact) {
    return (uint64_t)sph_isqrt_bits((sph_u128)r->disc, pr, inexact);
}

uint64_t sph_leaf_key_bits(const struct sph_leaf_result *r, int pr, uint64_t *roots) {
    if (r->exit) return 1;
    int inexact;
    int64_t root = (int64_t)sph_leaf_root(r, pr, &inexact);
    ++*roots;
    int64_t key = r->far ? r->b + root + inexact : r->b - root;
    return pr && r->far && key < 1 ? 1 : (uint64_t)key; /* < 1: the lost bits outweigh the rest */
}

static void note(const struct sph_ray_query *query, const struct sph_leaf *sphere,
                 const struct sph_leaf_result *r) {
    struct sph_stages *s = query->ray->stages;
    SPH_NOTE(s, SPH_STAGE_SPHERE, sphere->id, SPH_THREE(sphere->ctr), sphere->rad, r->b, r->k,
             r->disc, r->hit, r->far);
    if (!r->hit || r->exit || query->ray->kind == SPH_SHADOW) return;
    int inexact;
    uint64_t root = sph_leaf_root(r, query->p->pr, &inexact);
    SPH_NOTE(s, SPH_STAGE_ROOT, sphere->id, (sph_i128)root, inexact);
}

static int test(const struct sph_ray_query *query, const uint32_t *record, struct sph_hit *hit) {
    const struct sph_profile *p = query->p;
    struct sph_leaf sphere = sph_sphere_read(record, p->w);
    struct sph_leaf_result r = sph_leaf_test(query->ray, &sphere);
    uint64_t *roots = &query->c->count[SPH_COUNT_ROOTS];
    query->c->count[SPH_COUNT_LEAF_TESTS]++;
    if (query->ray->stages) note(query, &sphere, &r);
    if (!r.hit) return 0;
    uint64_t key = query->ray->kind == SPH_SHADOW ? 1 : sph_leaf_key_bits(&r, p->pr, roots);
    *hit = (struct sph_hit){key, sphere.id, r.far != 0, 0};
    return 1;
}

/* From the centre to the point. */
static void normal(const struct sph_profile *p, const uint32_t *prim, const int64_t guarded[3],
                   int64_t normal[3]) {
    struct sph_leaf sphere = sph_sphere_read(prim, p->w);
    sph_sphere_normal(p, &sphere, guarded, normal);
}

static int validate(const struct sph_machine *m, uint32_t line, const uint32_t *record, uint32_t id,
                    const uint32_t *prim, struct sph_error *err) {
    if (sph_machine_effect(m, SPH_EFFECT_FACETS) &&
        (sph_any_bit(record, SPH_LEAF_ID_LSB + SPH_LEAF_ID_BITS, SPH_LEAF_CLEAR_LSB - 1) ||
         sph_any_bit(record, SPH_LEAF_CLEAR_LSB + 1, SPH_LINE_WORDS * 32 - 1)))
        return sph_fail(err, "line %u: more than a sphere in its leaf line", line);
    if (memcmp(record, prim, SPH_LEAF_STRIDE / 8) != 0)
        return sph_fail(err, "line %u: leaf %u differs from its primitive record", line, id);
    if (!sph_field(record, SPH_LEAF_RAD_LSB, SPH_LEAF_RAD_BITS))
        return sph_fail(err, "line %u: leaf %u has no radius", line, id);
    return 0;
}

const struct sph_prim sph_prim_sphere = {0, test, normal, validate, NULL};
