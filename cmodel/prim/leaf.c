/* leaf.c - see leaf.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "prim/leaf.h"

#include "math/isqrt.h"

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
