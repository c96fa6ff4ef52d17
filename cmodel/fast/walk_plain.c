/* walk_plain.c - the walk in plain C, for processors of any kind; see walk.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "machine/layout.h"
#include "math/fx.h"
#include "trace/ray.h"

#include "fast/decoded.h"

enum { KEY_NONE = INT32_MAX };

struct lanes {
    int32_t org[3], u[3];
    int axis, sign, any;
};

/* near * 4 + child */
typedef struct {
    int32_t at[4];
} keys;

static struct lanes lanes_of(const struct sph_ray *ray) {
    struct lanes l = {.axis = ray->axis, .sign = ray->negative ? -1 : 1, .any = sph_ray_any(ray)};
    for (int i = 0; i < 3; i++) {
        l.org[i] = ray->forg[i];
        l.u[i] = ray->unit.u[i];
    }
    return l;
}

static keys no_keys(void) {
    return (keys){{KEY_NONE, KEY_NONE, KEY_NONE, KEY_NONE}};
}

static int32_t first(keys k) {
    return k.at[0];
}

static uint32_t key_child(int32_t key) {
    return (uint32_t)key & 3;
}

static int32_t key_near(int32_t key) {
    return key;
}

static int32_t near_of(int32_t depth) {
    return depth * 4 + 3;
}

/* They are sorted, and the key is the first one. */
static keys without(keys k, int32_t key) {
    (void)key;
    return (keys){{k.at[1], k.at[2], k.at[3], KEY_NONE}};
}

/* sph_filter() of four children; the order of the inner ones. */
static unsigned children(const struct lanes *l, const struct sph_fast_node *n, int32_t depth_max,
                         keys *order) {
    const int32_t *u = l->u;
    int32_t near[4];
    unsigned met = 0;
    int count = 0;
    for (int i = 0; i < 4; i++) {
        int32_t oc[3];
        for (int k = 0; k < 3; k++)
            oc[k] = n->ctr[k][i] - l->org[k];
        int64_t x = sph_round((int64_t)oc[1] * u[2] - (int64_t)oc[2] * u[1], 14);
        int64_t y = sph_round((int64_t)oc[2] * u[0] - (int64_t)oc[0] * u[2], 14);
        int64_t z = sph_round((int64_t)oc[0] * u[1] - (int64_t)oc[1] * u[0], 14);
        int64_t rad = n->rad[i];
        int32_t depth = l->sign * oc[l->axis];
        near[i] = depth - n->rad[i];
        met |= (unsigned)(x * x + y * y + z * z <= rad * rad * 16 && depth + n->rad[i] >= 0 &&
                          near[i] <= depth_max)
               << i;
    }
    met &= n->valid;
    *order = no_keys();
    for (int i = 0; i < n->n_inner; i++) {
        if (!(met >> i & 1)) continue;
        int32_t key = (l->any ? INT16_MIN : near[i]) * 4 + i;
        int at = count++;
        for (; at > 0 && key < order->at[at - 1]; at--)
            order->at[at] = order->at[at - 1];
        order->at[at] = key;
    }
    return met;
}

#include "fast/walk.h"

struct sph_hit sph_fast_walk_plain(const struct sph_fast *f, const struct sph_ray *ray,
                                   struct sph_counters *c, uint32_t *visits, uint32_t *errors) {
    return walk(f, ray, c, visits, errors);
}
