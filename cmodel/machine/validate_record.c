/* validate_record.c - a register, and a leaf record of any tree; see validate.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <string.h>

#include "machine/facets.h"
#include "machine/validate.h"

int sph_validate_register(const struct sph_machine *m, int number, const char *name, int64_t lo,
                          int64_t hi, struct sph_error *err) {
    int32_t v = m->regs[number];
    if (v >= lo && v <= hi) return 0;
    return sph_fail(err, "register %s is %d, not in %lld..%lld", name, v, (long long)lo,
                    (long long)hi);
}

int sph_validate_record(const struct sph_machine *m, uint32_t line, int half, uint8_t *found,
                        struct sph_error *err) {
    const uint32_t *leaf = sph_line(m, line) + half * SPH_LEAF_STRIDE / 32;
    uint32_t id = sph_field(leaf, SPH_LEAF_ID_LSB, SPH_LEAF_ID_BITS);
    int whole = sph_machine_effect(m, SPH_EFFECT_FACETS);
    if (whole && sph_validate_leaf_line(m, line, &id, err)) return -1;
    if (whole && id >= (uint32_t)m->regs[SPH_REG_N_SPHERES])
        return found[id]++ ? sph_fail(err, "line %u: primitive %u stands twice", line, id) : 0;
    if (id >= (uint32_t)m->regs[SPH_REG_N_PRIMS])
        return sph_fail(err, "line %u: leaf id %u, there are %d primitives", line, id,
                        m->regs[SPH_REG_N_PRIMS]);
    if (memcmp(leaf, sph_line(m, (uint32_t)m->regs[SPH_REG_PRIM_BASE] + id), SPH_LEAF_STRIDE / 8) !=
        0)
        return sph_fail(err, "line %u: leaf %u differs from its primitive record", line, id);
    if (!sph_field(leaf, SPH_LEAF_RAD_LSB, SPH_LEAF_RAD_BITS))
        return sph_fail(err, "line %u: leaf %u has no radius", line, id);
    if (found[id]++) return sph_fail(err, "line %u: primitive %u stands twice", line, id);
    return 0;
}
