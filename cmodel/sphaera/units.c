/* units.c - what single units of the hardware give: see sphaera.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <string.h>

#include "math/arith.h"
#include "prim/sphere.h"
#include "sphaera/opaque.h"
#include "texture/texel.h"
#include "trace/filter.h"

enum {
    COORDINATE = 24, /* bits at most */
    DIRECTION = 31,
    ROOT_HIGH = 60, /* bits of the upper word of a radicand */
    ROOT_BITS = 61,
    COMPONENT = 32, /* of a unit vector's operand */
    LEAST_COMPONENT = 9,
    QUOTIENT = 32,
    FILTER = 14,
    SHARE = 18 /* s0.17 */
};

/* Is value a number of so many bits, two's complement? */
static int check_signed(const char *name, int64_t value, int bits, struct sph_error *err) {
    int64_t most = ((int64_t)1 << (bits - 1)) - 1;
    return sph_api_whole(name, value, -most - 1, most, err);
}

static int check_three(const char *name, const int64_t v[3], int bits, struct sph_error *err) {
    return check_signed(name, v[0], bits, err) || check_signed(name, v[1], bits, err) ||
           check_signed(name, v[2], bits, err);
}

static int check_bits(const char *name, uint64_t value, int bits, struct sph_error *err) {
    if (bits == 64 || value >> bits == 0) return 0;
    return sph_fail(err, "%s has more than %d bits", name, bits);
}

int sphaera_model_unit_vector(int bits, const int64_t v[3], int32_t u[3], uint32_t *scale,
                              int *shift, sphaera_error *error) {
    struct sph_error err = {""};
    if (sph_api_null(v, "v", error) || sph_api_null(u, "u", error) ||
        sph_api_null(scale, "scale", error) || sph_api_null(shift, "shift", error))
        return -1;
    if (sph_api_whole("bits", bits, LEAST_COMPONENT, COMPONENT, &err) ||
        check_three("v", v, bits, &err))
        return sph_api_failed(&err, error);
    uint64_t vv = 0;
    for (int i = 0; i < 3; i++)
        vv += (uint64_t)(v[i] * v[i]);
    struct sph_unit unit = sph_unit(v, vv, bits);
    memcpy(u, unit.u, sizeof unit.u);
    *scale = unit.y;
    *shift = unit.h;
    return 0;
}

int sphaera_model_root(uint64_t high, uint64_t low, int bits, uint64_t *root, int *inexact,
                       sphaera_error *error) {
    struct sph_error err = {""};
    if (sph_api_null(root, "root", error) || sph_api_null(inexact, "inexact", error)) return -1;
    if (check_bits("high", high, ROOT_HIGH, &err) ||
        sph_api_whole("bits", bits, 0, ROOT_BITS, &err))
        return sph_api_failed(&err, error);
    *root = sph_isqrt_bits((sph_u128)high << 64 | low, bits, inexact);
    return 0;
}

int sphaera_model_quotient(uint64_t key, int key_bits, uint64_t a, int a_bits, int pq,
                           uint32_t *mant, int *exp, sphaera_error *error) {
    struct sph_error err = {""};
    if (sph_api_null(mant, "mant", error) || sph_api_null(exp, "exp", error)) return -1;
    if (sph_api_whole("key_bits", key_bits, 1, 64, &err) ||
        sph_api_whole("a_bits", a_bits, 1, 64, &err) ||
        sph_api_whole("pq", pq, 1, QUOTIENT, &err) || check_bits("key", key, key_bits, &err) ||
        check_bits("a", a, a_bits, &err) || (!key && sph_fail(&err, "key is 0")) ||
        (!a && sph_fail(&err, "a is 0")))
        return sph_api_failed(&err, error);
    struct sph_quotient q = sph_quotient(key, key_bits, a, a_bits, pq);
    *mant = q.mant;
    *exp = q.exp;
    return 0;
}

int sphaera_model_leaf(const sphaera_leaf *leaf, sphaera_leaf_result *result,
                       sphaera_error *error) {
    struct sph_error err = {""};
    if (sph_api_null(leaf, "leaf", error) || sph_api_null(result, "result", error)) return -1;
    if (check_three("origin", leaf->origin, COORDINATE, &err) ||
        check_three("direction", leaf->direction, DIRECTION, &err) ||
        check_three("centre", leaf->centre, COORDINATE, &err) ||
        sph_api_whole("radius", leaf->radius, 0, ((int64_t)1 << COORDINATE) - 1, &err) ||
        sph_api_whole("pr", leaf->pr, 0, ROOT_BITS, &err))
        return sph_api_failed(&err, error);
    struct sph_ray ray = {.kind = leaf->shadow ? SPH_SHADOW : SPH_PRIMARY,
                          .skip = {leaf->skip_id, leaf->skip_inside != 0},
                          .inside = leaf->inside_on != 0};
    struct sph_leaf sphere = {.rad = leaf->radius, .id = leaf->id};
    memcpy(ray.org, leaf->origin, sizeof ray.org);
    memcpy(ray.dir, leaf->direction, sizeof ray.dir);
    memcpy(sphere.ctr, leaf->centre, sizeof sphere.ctr);
    for (int i = 0; i < 3; i++)
        ray.a += (uint64_t)(ray.dir[i] * ray.dir[i]);
    struct sph_leaf_result r = sph_leaf_test(&ray, &sphere);
    sph_u128 disc = r.hit && !r.exit ? (sph_u128)r.disc : 0;
    uint64_t roots = 0;
    *result = (sphaera_leaf_result){.hit = r.hit,
                                    .far = r.far,
                                    .exit = r.exit,
                                    .b = r.b,
                                    .disc_low = (uint64_t)disc,
                                    .disc_high = (uint64_t)(disc >> 64),
                                    .key = r.hit ? sph_leaf_key_bits(&r, leaf->pr, &roots) : 0};
    return 0;
}

static int check_words(const char *name, const int32_t v[3], int bits, struct sph_error *err) {
    const int64_t wide[3] = {v[0], v[1], v[2]};
    return check_three(name, wide, bits, err);
}

int sphaera_model_filter(const sphaera_filter *filter, int *pass, int32_t *near_depth,
                         sphaera_error *error) {
    struct sph_error err = {""};
    if (sph_api_null(filter, "filter", error) || sph_api_null(pass, "pass", error) ||
        sph_api_null(near_depth, "near_depth", error))
        return -1;
    if (check_words("origin", filter->origin, FILTER, &err) ||
        sph_api_whole("least", filter->least, 0, 2, &err) ||
        check_signed("p_a", filter->p_a, SHARE, &err) ||
        check_signed("p_b", filter->p_b, SHARE, &err) || check_words("q", filter->q, SHARE, &err) ||
        sph_api_whole("axis", filter->axis, 0, 2, &err) ||
        sph_api_whole("depth_max", filter->depth_max, 0, (2 << FILTER) - 1, &err) ||
        check_words("centre", filter->centre, FILTER, &err) ||
        sph_api_whole("radius", filter->radius, 0, (1 << FILTER) - 1, &err))
        return sph_api_failed(&err, error);
    struct sph_ray ray = {.axis = filter->axis, .negative = filter->negative != 0};
    struct sph_child child = {.rad = filter->radius};
    ray.across = (struct sph_across){.axis_a = filter->least == 0,
                                     .axis_b = filter->least == 2 ? 1 : 2,
                                     .p_a = filter->p_a,
                                     .p_b = filter->p_b};
    memcpy(ray.across.q, filter->q, sizeof ray.across.q);
    memcpy(ray.forg, filter->origin, sizeof ray.forg);
    memcpy(child.ctr, filter->centre, sizeof child.ctr);
    *pass = sph_filter(&ray, &child, filter->depth_max, near_depth);
    return 0;
}

int sphaera_model_texel(const uint32_t near_texels[4], const uint32_t far_texels[4],
                        const int near_weights[2], const int far_weights[2], int level,
                        uint32_t *texel, sphaera_error *error) {
    enum { MOST = 255 };
    struct sph_error err = {""};
    uint32_t near[4], far[4];
    if (sph_api_null(near_texels, "near_texels", error) ||
        sph_api_null(far_texels, "far_texels", error) ||
        sph_api_null(near_weights, "near_weights", error) ||
        sph_api_null(far_weights, "far_weights", error) || sph_api_null(texel, "texel", error))
        return -1;
    for (int i = 0; i < 2; i++)
        if (sph_api_whole("near_weights", near_weights[i], 0, MOST, &err) ||
            sph_api_whole("far_weights", far_weights[i], 0, MOST, &err))
            return sph_api_failed(&err, error);
    if (sph_api_whole("level", level, 0, MOST, &err)) return sph_api_failed(&err, error);
    sph_filter_bilinear(near_texels, (uint32_t)near_weights[0], (uint32_t)near_weights[1], near);
    sph_filter_bilinear(far_texels, (uint32_t)far_weights[0], (uint32_t)far_weights[1], far);
    *texel = sph_filter_levels(near, far, (uint32_t)level) & 0xffffff;
    return 0;
}
