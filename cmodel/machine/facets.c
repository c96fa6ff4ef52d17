/* facets.c - see facets.h; lines are drawn in machine.def
 * SPDX-License-Identifier: Apache-2.0
 */
#include <string.h>

#include "machine/facets.h"

struct sph_counts sph_machine_count(const struct sph_machine *m) {
    uint32_t facets = (uint32_t)sph_machine_facets(m), base = (uint32_t)m->regs[SPH_REG_FACET_BASE];
    struct sph_counts n = {(uint32_t)m->regs[SPH_REG_N_PRIMS] - facets, 0, 0};
    for (uint32_t i = 0; i < facets; i++) {
        uint32_t kind = sph_field(sph_line(m, base + i), SPH_FACET_KIND_LSB, SPH_FACET_KIND_BITS);
        *(kind == SPH_PLANE ? &n.planes : &n.triangles) += 1;
    }
    return n;
}

/* v / 2^shift to nearest, halves away from zero; v * 2^-shift if shift < 0. */
static int64_t scale(int64_t v, int shift) {
    int64_t size = v < 0 ? -v : v;
    size = shift > 0 ? (size + (1ll << (shift - 1))) >> shift : size << -shift;
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

/* Bits first .. last of a line that are not 0. */
static int any_bit(const uint32_t *line, int first, int last) {
    for (int bit = first; bit <= last; bit++)
        if (line[bit / 32] >> bit % 32 & 1) return 1;
    return 0;
}

/* The vector of three fields of 24 bits from bit `at` on. */
static void vector(const uint32_t *line, int at, int32_t v[3]) {
    for (int i = 0; i < 3; i++)
        v[i] = sph_field_signed(line, at + SPH_LEAF_CTR_Y_LSB * i, SPH_LEAF_CTR_Y_BITS);
}

/* Whether a point lies on the grid of the profile. */
static int on_grid(const struct sph_machine *m, const int32_t v[3]) {
    int32_t half = 1 << (sph_machine_profile(m)->w - 1);
    for (int i = 0; i < 3; i++)
        if (v[i] < -half || v[i] >= half) return 0;
    return 1;
}

/* Checks what a triangle's line holds; its normal. */
static int check_triangle(const struct sph_machine *m, uint32_t line, int32_t normal[3],
                          struct sph_error *err) {
    static const int at[3] = {SPH_TRIANGLE_V0_X_LSB, SPH_TRIANGLE_V1_X_LSB, SPH_TRIANGLE_V2_X_LSB};
    int32_t v[3][3];
    for (int i = 0; i < 3; i++) {
        vector(sph_line(m, line), at[i], v[i]);
        if (!on_grid(m, v[i]))
            return sph_fail(err, "line %u: corner %d of the triangle is not on the grid", line, i);
    }
    if (!sph_triangle_normal((const int32_t(*)[3])v, normal))
        return sph_fail(err, "line %u: the triangle has no area", line);
    return 0;
}

/* Checks what a plane's line holds; its normal. */
static int check_plane(const struct sph_machine *m, uint32_t line, int32_t normal[3],
                       struct sph_error *err) {
    const uint32_t *words = sph_line(m, line);
    const int end = SPH_PLANE_N_Z_LSB + SPH_PLANE_N_Z_BITS;
    int32_t p[3];
    vector(words, SPH_PLANE_P_X_LSB, p);
    vector(words, SPH_PLANE_N_X_LSB, normal);
    if (!on_grid(m, p))
        return sph_fail(err, "line %u: the point of the plane is not on the grid", line);
    if (!normal[0] && !normal[1] && !normal[2])
        return sph_fail(err, "line %u: the normal of the plane is zero", line);
    for (int i = 0; i < 3; i++) /* it is turned where it looks along a ray */
        if (normal[i] == -(1 << (SPH_PLANE_N_X_BITS - 1)))
            return sph_fail(err, "line %u: the normal of the plane cannot be turned", line);
    if (any_bit(words, end, SPH_FACET_ID_LSB - 1) ||
        any_bit(words, SPH_FACET_BEFORE_LSB, SPH_FACET_KIND_LSB - 1))
        return sph_fail(err, "line %u: bits of the plane that must be 0 are not", line);
    return 0;
}

/* Checks the primitive record of a facet: its normal and nothing else where a sphere has its own.
 */
static int check_prim(const struct sph_machine *m, uint32_t id, const int32_t normal[3],
                      struct sph_error *err) {
    const uint32_t *prim = sph_line(m, (uint32_t)m->regs[SPH_REG_PRIM_BASE] + id);
    int32_t stored[3];
    vector(prim, SPH_LEAF_CTR_X_LSB, stored);
    if (memcmp(stored, normal, sizeof stored) != 0)
        return sph_fail(err, "primitive %u: the normal is not that of its facet", id);
    if (sph_field(prim, SPH_LEAF_RAD_LSB, SPH_LEAF_RAD_BITS))
        return sph_fail(err, "primitive %u: a facet with a radius", id);
    if (sph_field(prim, SPH_LEAF_ID_LSB, SPH_LEAF_ID_BITS) != id)
        return sph_fail(err, "primitive %u: another id", id);
    return 0;
}

/* Checks line i of the table. */
static int check_facet(const struct sph_machine *m, uint32_t i, struct sph_error *err) {
    uint32_t line = (uint32_t)m->regs[SPH_REG_FACET_BASE] + i;
    uint32_t id = (uint32_t)m->regs[SPH_REG_N_SPHERES] + i, n = (uint32_t)m->regs[SPH_REG_N_PRIMS];
    const uint32_t *words = sph_line(m, line);
    uint32_t kind = sph_field(words, SPH_FACET_KIND_LSB, SPH_FACET_KIND_BITS);
    uint32_t before = sph_field(words, SPH_FACET_BEFORE_LSB, SPH_FACET_BEFORE_BITS);
    uint32_t after = sph_field(words, SPH_FACET_AFTER_LSB, SPH_FACET_AFTER_BITS);
    int32_t normal[3];
    if (kind != SPH_TRIANGLE && kind != SPH_PLANE)
        return sph_fail(err, "line %u: facet of kind %u", line, kind);
    if (sph_field(words, SPH_FACET_ID_LSB, SPH_FACET_ID_BITS) != id)
        return sph_fail(err, "line %u: not the facet %u", line, id);
    if (before > i || id + after >= n)
        return sph_fail(err, "line %u: the polygon of facet %u is %u..%u, facets are %u..%u", line,
                        id, id - before, id + after, id - i, n - 1);
    if (kind == SPH_TRIANGLE ? check_triangle(m, line, normal, err)
                             : check_plane(m, line, normal, err))
        return -1;
    return check_prim(m, id, normal, err);
}

int sph_validate_facets(const struct sph_machine *m, struct sph_error *err) {
    uint32_t spheres = (uint32_t)m->regs[SPH_REG_N_SPHERES], n = (uint32_t)m->regs[SPH_REG_N_PRIMS];
    for (uint32_t id = 0; id < n; id++) {
        const uint32_t *prim = sph_line(m, (uint32_t)m->regs[SPH_REG_PRIM_BASE] + id);
        uint32_t facet = sph_field(prim, SPH_PRIM_FACET_LSB, SPH_PRIM_FACET_BITS);
        if (facet != (id >= spheres) || any_bit(prim, SPH_PRIM_FACET_LSB + 1, SPH_PRIM_RED_LSB - 1))
            return sph_fail(err, "primitive %u: not marked as a %s", id,
                            id < spheres ? "sphere" : "facet");
    }
    for (uint32_t i = 0; i < n - spheres; i++)
        if (check_facet(m, i, err)) return -1;
    return 0;
}

int sph_validate_leaf_line(const struct sph_machine *m, uint32_t line, uint32_t *id,
                           struct sph_error *err) {
    const uint32_t *words = sph_line(m, line);
    uint32_t spheres = (uint32_t)m->regs[SPH_REG_N_SPHERES], n = (uint32_t)m->regs[SPH_REG_N_PRIMS];
    uint32_t kind = sph_field(words, SPH_FACET_KIND_LSB, SPH_FACET_KIND_BITS);
    *id = kind ? sph_field(words, SPH_FACET_ID_LSB, SPH_FACET_ID_BITS)
               : sph_field(words, SPH_LEAF_ID_LSB, SPH_LEAF_ID_BITS);
    if (kind ? *id < spheres || *id >= n : *id >= spheres)
        return sph_fail(err, "line %u: leaf id %u of kind %u, there are %u spheres, then %u facets",
                        line, *id, kind, spheres, n - spheres);
    if (!kind && any_bit(words, SPH_LEAF_ID_LSB + SPH_LEAF_ID_BITS, SPH_LINE_WORDS * 32 - 1))
        return sph_fail(err, "line %u: more than a sphere in its leaf line", line);
    uint32_t table = (uint32_t)m->regs[SPH_REG_FACET_BASE] + *id - spheres;
    if (kind && memcmp(words, sph_line(m, table), SPH_LINE_WORDS * sizeof *words) != 0)
        return sph_fail(err, "line %u: facet %u differs from its line in the table", line, *id);
    return 0;
}
