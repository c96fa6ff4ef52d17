/* prims.c - see prims.h; lines are drawn in machine.def
 * SPDX-License-Identifier: Apache-2.0
 */
#include "validate/prims.h"

#include <stdio.h>
#include <string.h>

#include "prim/kinds.h"
#include "shade/smooth.h"
#include "machine/kinds.h"

/* The record of primitive id. */
static const uint32_t *prim_line(const struct sph_machine *m, uint32_t id) {
    return sph_line(m, (uint32_t)m->regs[SPH_REG_PRIM_BASE] + (size_t)id);
}

struct sph_counts sph_machine_count(const struct sph_machine *m) {
    struct sph_counts n = {{0}, 0};
    for (uint32_t id = 0; id < (uint32_t)m->regs[SPH_REG_N_PRIMS]; id++) {
        uint32_t kind = sph_prim_kind(m, prim_line(m, id));
        n.of[kind]++;
        n.loose += (uint32_t)sph_kind_unbounded(kind);
    }
    return n;
}

void sph_counts_text(const struct sph_counts *counts, char *text, size_t size) {
    size_t used = 0;
    for (uint32_t kind = 0; kind < SPH_KINDS && used < size; kind++)
        if (!kind || counts->of[kind])
            used += (size_t)snprintf(text + used, size - used, "%s%u %ss", kind ? ", " : "",
                                     counts->of[kind], sph_kind_name(kind));
}

/* Checks line i of the table and the record of its primitive. */
static int check_facet(const struct sph_machine *m, uint32_t i, struct sph_error *err) {
    uint32_t line = (uint32_t)m->regs[SPH_REG_FACET_BASE] + i;
    uint32_t id = (uint32_t)m->regs[SPH_REG_N_SPHERES] + i, n = (uint32_t)m->regs[SPH_REG_N_PRIMS];
    const uint32_t *words = sph_line(m, line), *prim = prim_line(m, id);
    uint32_t kind = sph_record_kind(1, words);
    struct sph_facet_leaf f = sph_facet_head(words, (int)kind);
    if (kind == SPH_SPHERE || kind >= SPH_KINDS)
        return sph_fail(err, "line %u: facet of kind %u", line, kind);
    if (kind != sph_prim_kind(m, prim))
        return sph_fail(err, "primitive %u: of kind %u, its leaf line is of kind %u", id,
                        sph_prim_kind(m, prim), kind);
    if (f.id != id) return sph_fail(err, "line %u: not the facet %u", line, id);
    if (f.before > i || id + f.after >= n)
        return sph_fail(err, "line %u: the polygon of facet %u is %u..%u, facets are %u..%u", line,
                        id, id - f.before, id + f.after, id - i, n - 1);
    return sph_prim_of(kind)->validate(m, line, words, id, prim, err);
}

/* Checks the record of a facet's normals, if it has one. */
static int check_smooth(const struct sph_machine *m, uint32_t id, struct sph_error *err) {
    const uint32_t *prim = prim_line(m, id), *record;
    uint32_t number = sph_field(prim, SPH_PRIM_SMOOTH_LSB, SPH_PRIM_SMOOTH_BITS);
    int outside, on = sph_machine_effect(m, SPH_EFFECT_SMOOTH);
    if (!number) return 0;
    const struct sph_prim *is = sph_prim_of(sph_prim_kind(m, prim));
    if (!on || !is->flat ||
        sph_kind_unbounded(
            sph_prim_kind(m, prim))) /* a sphere has a radius there, a plane has no corners */
        return sph_fail(err, "primitive %u: a facet with a radius", id);
    record = sph_smooth_record(m, prim, &outside);
    if (outside)
        return sph_fail(err, "primitive %u: its normals are record %u, behind the end of memory",
                        id, number - 1);
    if (!sph_on_grid(m, record, SPH_SMOOTH_B_X_LSB))
        return sph_fail(err, "primitive %u: its normals start at no point of the grid", id);
    return sph_any_bit(record, SPH_SMOOTH_N_Z_LSB + SPH_SMOOTH_N_Z_BITS, 255)
               ? sph_fail(err, "primitive %u: bits of its normals that must be 0 are not", id)
               : 0;
}

int sph_validate_facets(const struct sph_machine *m, struct sph_error *err) {
    uint32_t spheres = (uint32_t)m->regs[SPH_REG_N_SPHERES], n = (uint32_t)m->regs[SPH_REG_N_PRIMS];
    for (uint32_t id = 0; id < n; id++) {
        uint32_t kind = sph_prim_kind(m, prim_line(m, id));
        if ((kind == SPH_SPHERE) != (id < spheres) || kind >= SPH_KINDS)
            return sph_fail(err, "primitive %u: not marked as a %s", id,
                            id < spheres ? "sphere" : "facet");
    }
    for (uint32_t i = 0; i < n - spheres; i++)
        if (check_facet(m, i, err) || check_smooth(m, spheres + i, err)) return -1;
    return 0;
}

int sph_validate_leaf(const struct sph_machine *m, uint32_t line, const uint32_t *record,
                      uint32_t *id, struct sph_error *err) {
    uint32_t n = (uint32_t)m->regs[SPH_REG_N_PRIMS];
    int whole = sph_machine_effect(m, SPH_EFFECT_FACETS);
    uint32_t spheres = whole ? (uint32_t)m->regs[SPH_REG_N_SPHERES] : n;
    uint32_t kind = sph_record_kind(whole, record);
    int facet = kind != SPH_SPHERE;
    *id = facet ? sph_field(record, SPH_FACET_ID_LSB, SPH_FACET_ID_BITS)
                : sph_field(record, SPH_LEAF_ID_LSB, SPH_LEAF_ID_BITS);
    if (!whole && *id >= n)
        return sph_fail(err, "line %u: leaf id %u, there are %u primitives", line, *id, n);
    if (facet ? *id < spheres || *id >= n : *id >= spheres)
        return sph_fail(err, "line %u: leaf id %u of kind %u, there are %u spheres, then %u facets",
                        line, *id, kind, spheres, n - spheres);
    if (!facet) return sph_prim_of(kind)->validate(m, line, record, *id, prim_line(m, *id), err);
    uint32_t table = (uint32_t)m->regs[SPH_REG_FACET_BASE] + *id - spheres;
    if (memcmp(record, sph_line(m, table), SPH_LINE_WORDS * sizeof *record) != 0)
        return sph_fail(err, "line %u: facet %u differs from its line in the table", line, *id);
    return 0;
}
