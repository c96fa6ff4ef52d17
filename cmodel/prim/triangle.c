/* triangle.c - a triangle behind the interface of primitives; see prim.h
 * SPDX-License-Identifier: Apache-2.0                                    RTL: rtl/prim/rt_facet.v
 */
#include "prim/facet.h"

#include "prim/prim.h"

static const int corner_lsb[3] = {SPH_TRIANGLE_V0_X_LSB, SPH_TRIANGLE_V1_X_LSB,
                                  SPH_TRIANGLE_V2_X_LSB};

struct sph_facet_leaf sph_triangle_read(const struct sph_profile *p, const uint32_t *line) {
    struct sph_facet_leaf f = sph_facet_head(line, SPH_TRIANGLE);
    for (int i = 0; i < 3; i++)
        sph_vector_read(line, corner_lsb[i], p->w, f.v[i]);
    return f;
}

static int test(const struct sph_ray_query *query, const uint32_t *record, struct sph_hit *hit) {
    struct sph_facet_leaf f = sph_triangle_read(query->p, record);
    return sph_facet_visit(query, &f, hit);
}

/* v / 2^shift to nearest, halves away from zero, and to 0 only if it is 0: the signs of a normal
 * are exact. v * 2^-shift if shift < 0. */
static int64_t scale(int64_t v, int shift) {
    int64_t size = v < 0 ? -v : v;
    size = shift > 0 ? (size + (1ll << (shift - 1))) >> shift : size << -shift;
    if (v && !size) size = 1;
    return v < 0 ? -size : size;
}

int sph_triangle_normal(const int32_t (*v)[3], int32_t normal[3]) {
    int64_t a[3], b[3], n[3], most = 0; /* s(W+1), n: s(2W+2) */
    for (int i = 0; i < 3; i++) {
        a[i] = (int64_t)v[1][i] - v[0][i];
        b[i] = (int64_t)v[2][i] - v[0][i];
    }
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        n[i] = a[j] * b[k] - a[k] * b[j];
        int64_t size = n[i] < 0 ? -n[i] : n[i];
        if (size > most) most = size;
    }
    if (!most) return 0;
    int64_t top = 1ll << (SPH_LEAF_CTR_X_BITS - 1);
    int shift = SPH_LEAF_CTR_X_BITS - 1;
    shift = 64 - __builtin_clzll((unsigned long long)most) - shift;
    if (scale(most, shift) >= top) shift++;
    for (int i = 0; i < 3; i++)
        normal[i] = (int32_t)scale(n[i], shift);
    return 1;
}

static int validate(const struct sph_machine *m, uint32_t line, const uint32_t *record, uint32_t id,
                    const uint32_t *prim, struct sph_error *err) {
    int32_t v[3][3], normal[3];
    for (int k = 0; k < 3; k++) {
        if (!sph_on_grid(m, record, corner_lsb[k]))
            return sph_fail(err, "line %u: corner %d of the triangle is not on the grid", line, k);
        for (int i = 0; i < 3; i++)
            v[k][i] = sph_field_signed(record, corner_lsb[k] + SPH_LEAF_CTR_Y_LSB * i,
                                       SPH_LEAF_CTR_Y_BITS);
    }
    if (!sph_triangle_normal((const int32_t(*)[3])v, normal))
        return sph_fail(err, "line %u: the triangle has no area", line);
    if (sph_any_bit(record, SPH_FACET_AFTER_LSB + SPH_FACET_AFTER_BITS, SPH_FACET_KIND_LSB - 1))
        return sph_fail(err, "line %u: a bit of the triangle that must be 0 is not", line);
    return sph_validate_normal(id, prim, normal, err);
}

const struct sph_prim sph_prim_triangle = {1, test, sph_stored_normal, validate, sph_triangle_read};
