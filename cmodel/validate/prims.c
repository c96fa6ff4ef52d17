/* prims.c - see prims.h; lines are drawn in machine.def
 * SPDX-License-Identifier: Apache-2.0
 */
#include "validate/prims.h"

#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "machine/records.h"
#include "prim/prim.h"
#include "shade/surface.h"
#include "texture/texel.h"
#include "validate/check.h"

/* ---- a register, and a leaf record of any tree; see check.h ---- */

int sph_validate_register(const struct sph_machine *m, int number, const char *name, int64_t lo,
                          int64_t hi, struct sph_error *err) {
    int32_t v = m->regs[number];
    if (v >= lo && v <= hi) return 0;
    return sph_fail(err, "register %s is %d, not in %lld..%lld", name, v, (long long)lo,
                    (long long)hi);
}

int sph_validate_record(const struct sph_machine *m, uint32_t base, uint32_t i, uint8_t *found,
                        struct sph_error *err) {
    int whole = sph_whole(m);
    uint32_t id, line = base + (whole ? i : i / 2);
    if (sph_validate_leaf(m, line, sph_record(m, whole, base, i), &id, err)) return -1;
    return found[id]++ ? sph_fail(err, "line %u: primitive %u stands twice", line, id) : 0;
}

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

/* ---- materials ---- */

enum { ONE = 256 }; /* a share, u1.8 */

int sph_validate_optics(const struct sph_machine *m, struct sph_error *err) {
    int wd = sph_machine_profile(m)->wd;
    if (!sph_machine_effect(m, SPH_EFFECT_REFRACT) || wd <= SPH_REFRACT_WD) return 0;
    return sph_fail(err, "register EFFECTS is %d: REFRACT with WD %d, at most %d",
                    m->regs[SPH_REG_EFFECTS], wd, SPH_REFRACT_WD);
}

/* A field of the record of primitive id lies in low..high. */
static int in_range(uint32_t id, const char *name, uint32_t value, uint32_t low, uint32_t high,
                    struct sph_error *err) {
    if (value >= low && value <= high) return 0;
    return sph_fail(err, "primitive %u: %s is %u, not in %u..%u", id, name, value, low, high);
}

#define FIELD(name) sph_field(prim, SPH_PRIM_##name##_LSB, SPH_PRIM_##name##_BITS)

static int check_prim(const uint32_t *prim, uint32_t id, struct sph_error *err) {
    uint32_t kr = FIELD(KR), kt = FIELD(KT), sum = FIELD(SUM);
    if (in_range(id, "kr", kr, 0, ONE, err) || in_range(id, "kt", kt, 0, ONE, err) ||
        in_range(id, "ka", FIELD(KA), 0, ONE, err) || in_range(id, "kd", FIELD(KD), 0, ONE, err))
        return -1;
    if (!sum && in_range(id, "kr + kt", kr + kt, 0, ONE, err)) return -1;
    if (FIELD(KS) && in_range(id, "power", FIELD(POWER), SPH_POWER_ONE * SPH_SHINE_MIN,
                              SPH_POWER_ONE * SPH_SHINE_MAX, err))
        return -1;
    return kt ? in_range(id, "index", FIELD(INDEX), SPH_INDEX_MIN, SPH_INDEX_MAX, err) : 0;
}

int sph_validate_materials(const struct sph_machine *m, struct sph_error *err) {
    if (!sph_machine_effect(m, SPH_EFFECT_REFRACT) && !sph_machine_effect(m, SPH_EFFECT_SUM))
        return 0;
    for (uint32_t id = 0; id < (uint32_t)m->regs[SPH_REG_N_PRIMS]; id++) {
        size_t line = (size_t)m->regs[SPH_REG_PRIM_BASE] + id;
        if (check_prim(sph_line(m, line), id, err)) return -1;
    }
    return 0;
}

/* ---- textures ---- */

/* First line behind primitive records and the table of facets. */
static uint32_t first_line(const struct sph_machine *m) {
    const int32_t *r = m->regs;
    uint32_t n = (uint32_t)r[SPH_REG_N_PRIMS], end = (uint32_t)r[SPH_REG_PRIM_BASE] + n;
    if (sph_machine_effect(m, SPH_EFFECT_FACETS))
        end = (uint32_t)r[SPH_REG_FACET_BASE] + n - (uint32_t)r[SPH_REG_N_SPHERES];
    return end;
}

static int check_image(const struct sph_machine *m, uint32_t line, struct sph_error *err) {
    const uint32_t *head = sph_line(m, line);
    struct sph_mip mip = {.width = (int)sph_field(head, SPH_IMAGE_W_LSB, SPH_IMAGE_W_BITS) + 1,
                          .height = (int)sph_field(head, SPH_IMAGE_H_LSB, SPH_IMAGE_H_BITS) + 1,
                          .levels =
                              (int)sph_field(head, SPH_IMAGE_LEVELS_LSB, SPH_IMAGE_LEVELS_BITS)};
    uint32_t end = 0;
    if (mip.width > SPH_TEXTURE_SIDE || mip.height > SPH_TEXTURE_SIDE)
        return sph_fail(err, "line %u: image of %d x %d texels", line, mip.width, mip.height);
    if (mip.levels != sph_mip_levels(mip.width, mip.height))
        return sph_fail(err, "line %u: image of %d x %d texels has %d levels", line, mip.width,
                        mip.height, mip.levels);
    for (int l = 0; l < mip.levels; l++) {
        uint32_t first = 0;
        if (l)
            first = sph_field(head, SPH_IMAGE_FIRST_LSB + SPH_IMAGE_FIRST_BITS * (l - 1),
                              SPH_IMAGE_FIRST_BITS);
        if (first != end)
            return sph_fail(err, "line %u: level %d starts at line %u of the image, not %u", line,
                            l, first, end);
        end += sph_level_lines(sph_level_size((uint32_t)mip.width, l),
                               sph_level_size((uint32_t)mip.height, l));
    }
    if ((uint64_t)line + 1 + end > m->lines)
        return sph_fail(err, "line %u: image of %u lines, memory has %u in all", line, end,
                        m->lines);
    return 0;
}

static int check_map(const struct sph_machine *m, uint32_t line, struct sph_error *err) {
    const uint32_t *map = sph_line(m, line);
    uint32_t kind = sph_field(map, SPH_MAP_KIND_LSB, SPH_MAP_KIND_BITS);
    uint32_t image = sph_field(map, SPH_MAP_IMAGE_LSB, SPH_MAP_IMAGE_BITS);
    if (kind > 1) return sph_fail(err, "line %u: mapping of kind %u", line, kind);
    if (image < first_line(m) || image >= m->lines)
        return sph_fail(err, "line %u: image at line %u, not in %u..%u", line, image, first_line(m),
                        m->lines - 1);
    return check_image(m, image, err);
}

int sph_validate_textures(const struct sph_machine *m, struct sph_error *err) {
    uint32_t n = (uint32_t)m->regs[SPH_REG_N_PRIMS], first = first_line(m), last = 0;
    for (uint32_t id = 0; id < n; id++) {
        const uint32_t *prim = sph_line(m, (uint32_t)m->regs[SPH_REG_PRIM_BASE] + id);
        uint32_t map = sph_field(prim, SPH_PRIM_TEX_LSB, SPH_PRIM_TEX_BITS);
        if (!map || map == last) continue;
        if (map < first || map >= m->lines)
            return sph_fail(err, "primitive %u: mapping at line %u, not in %u..%u", id, map, first,
                            m->lines - 1);
        if (check_map(m, map, err)) return -1;
        last = map;
    }
    return 0;
}
